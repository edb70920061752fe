//! What joints are, by their names: `LeftUpLeg`, `lfemur`, `Bip01_L_Thigh` and `upperleg01.L` are one and the same.

/// A part of the body that says something about size or direction.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub(super) enum Part {
    Head,
    Neck,
    Hand,
    Thigh,
    Foot,
    Toe,
    /// Only animals have one.
    Tail,
}

/// Which side of the body.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub(super) enum Side {
    Left,
    Right,
    Middle,
}

/// The words for parts as capture systems and animation programs write them, without side and number. A `hip` on one
/// side is where the thigh begins.
const WORDS: &[(&str, Part)] = &[
    ("head", Part::Head),
    ("atlas", Part::Head),
    ("neck", Part::Neck),
    ("hand", Part::Hand),
    ("wrist", Part::Hand),
    ("thigh", Part::Thigh),
    ("femur", Part::Thigh),
    ("upleg", Part::Thigh),
    ("upperleg", Part::Thigh),
    ("hip", Part::Thigh),
    ("foot", Part::Foot),
    ("ankle", Part::Foot),
    ("toe", Part::Toe),
    ("toes", Part::Toe),
    ("toebase", Part::Toe),
    ("ball", Part::Toe),
    ("bale", Part::Toe),
    ("tail", Part::Tail),
];

/// Parts that come as a pair.
const PAIRED: [Part; 4] = [Part::Hand, Part::Thigh, Part::Foot, Part::Toe];

/// No name is longer; what is behind that is not looked at.
const LONGEST: usize = 80;

/// Returns what a joint of that name is; `None` for everything that is not asked for here.
pub(super) fn classify(name: &str) -> Option<(Part, Side)> {
    let mut words = words(name.rsplit(':').next().unwrap_or(name));
    let mut side = Side::Middle;
    words.retain(|word| {
        let found = match word.as_str() {
            "left" | "l" => Side::Left,
            "right" | "r" => Side::Right,
            _ => return true,
        };
        side = found;
        false
    });
    let part = (0..words.len()).find_map(|start| part_of(&words.get(start..)?.concat()));
    let found = part.map(|part| (part, side)).or_else(|| {
        // `lfemur`: the side is stuck to the word.
        let word = words.last().filter(|_| side == Side::Middle)?;
        let rest = word.strip_prefix('l').map(|rest| (rest, Side::Left));
        let (rest, side) = rest.or(word.strip_prefix('r').map(|rest| (rest, Side::Right)))?;
        Some((part_of(rest)?, side))
    })?;
    (PAIRED.contains(&found.0) == (found.1 != Side::Middle)).then_some(found)
}

fn part_of(word: &str) -> Option<Part> {
    WORDS.iter().find(|(known, _)| *known == word).map(|(_, part)| *part)
}

/// Splits a name into words in lower case, without digits: at signs, and where a capital begins a new one.
fn words(name: &str) -> Vec<String> {
    let characters: Vec<char> = name.chars().take(LONGEST).collect();
    let mut words = vec![String::new()];
    for (at, &character) in characters.iter().enumerate() {
        let before = at.checked_sub(1).and_then(|before| characters.get(before));
        let after = characters.get(at + 1);
        let begins = character.is_uppercase()
            && (before.is_some_and(|c| c.is_lowercase()) || after.is_some_and(|c| c.is_lowercase()));
        if begins || !character.is_alphabetic() {
            words.push(String::new());
        }
        if let Some(word) = words.last_mut().filter(|_| character.is_alphabetic()) {
            word.extend(character.to_lowercase());
        }
    }
    words.retain(|word| !word.is_empty());
    words
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_of_many_programs_mean_the_same_parts() {
        use {Part::*, Side::*};
        let table = [
            (Head, Middle, "Head head HEAD mixamorig:Head Character1_Head Bip01_Head"),
            (Neck, Middle, "Neck Neck1 LowerNeck neck NECK#"),
            (Hand, Left, "LeftHand lHand LEFT_HAND# Hand_L J_L_Hand LeftWrist wrist.L lhand"),
            (
                Thigh,
                Right,
                "RightUpLeg rThigh rfemur RightHip J_R_Hip RIGHT_HIP# upperleg01.R UpLeg_R Bip01_R_Thigh UpperLeg_R",
            ),
            (Foot, Left, "LeftFoot lfoot LeftAnkle foot.L Foot_L Bip01_L_Foot mixamorig:LeftFoot LEFT_FOOT l_foot"),
            (Toe, Right, "RightToeBase rtoes RightToe Toes_R J_R_Bale toe1-1.R Toe_R"),
            (Tail, Middle, "Tail Tail1 BN_Tail_01"),
        ];
        for (part, side, names) in table {
            for name in names.split(' ') {
                assert_eq!(classify(name), Some((part, side)), "{name}");
            }
        }
    }

    #[test]
    fn names_of_other_joints_mean_nothing() {
        let names =
            "Hips hip pelvis LHipJoint LeftLeg lowerback RightInHandIndex LeftHandThumb1 HeadTop_End LeftFootEnd \
            lButtock foot Foot Root levator05.l forehead Ltd";
        for name in names.split_whitespace().chain(["", ":", "   "]) {
            assert_eq!(classify(name), None, "{name}");
        }
    }
}
