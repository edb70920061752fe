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
    let mut words = Words::of(name.rsplit(':').next().unwrap_or(name));
    let side = words.take_sides();
    let found = words.tails().find_map(part_of).map(|part| (part, side)).or_else(|| {
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

/// The words of a name in lower case, without digits: it is divided at signs, and where a capital begins a new one.
struct Words {
    /// One after the other.
    letters: String,
    /// Where each begins.
    starts: Vec<usize>,
}

impl Words {
    fn of(name: &str) -> Self {
        let mut words = Self { letters: String::with_capacity(name.len()), starts: Vec::new() };
        let mut characters = name.chars().take(LONGEST).peekable();
        let (mut before, mut is_new) = (None, true);
        while let Some(character) = characters.next() {
            let is_low = |c: &char| c.is_lowercase();
            is_new |= character.is_uppercase()
                && (before.as_ref().is_some_and(is_low) || characters.peek().is_some_and(is_low));
            if character.is_alphabetic() {
                if is_new {
                    words.starts.push(words.letters.len());
                }
                words.letters.extend(character.to_lowercase());
            }
            is_new = !character.is_alphabetic();
            before = Some(character);
        }
        words
    }

    /// Takes out the words for sides; returns the last of them.
    fn take_sides(&mut self) -> Side {
        let mut side = Side::Middle;
        for index in (0..self.starts.len()).rev() {
            let Some(&start) = self.starts.get(index) else { continue };
            let end = self.starts.get(index + 1).copied().unwrap_or(self.letters.len());
            let found = match self.letters.get(start..end) {
                Some("left" | "l") => Side::Left,
                Some("right" | "r") => Side::Right,
                _ => continue,
            };
            if side == Side::Middle {
                side = found;
            }
            self.letters.replace_range(start..end, "");
            self.starts.remove(index);
            for later in self.starts.iter_mut().skip(index) {
                *later -= end - start;
            }
        }
        side
    }

    /// Returns all words as one, then without the first, and so on.
    fn tails(&self) -> impl Iterator<Item = &str> {
        self.starts.iter().filter_map(|start| self.letters.get(*start..))
    }

    fn last(&self) -> Option<&str> {
        self.letters.get(*self.starts.last()?..)
    }
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
