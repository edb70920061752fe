//! Which side of the body names belong to: `lfemur`, `LeftUpLeg`, `Bip01_L_Thigh`, `LASI`, `upperleg01.L`.

use std::collections::HashSet;

/// A side of the body.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Hash)]
pub enum Side {
    /// The figure's own left.
    Left,
    /// Neither, or it is not known.
    #[default]
    Middle,
    /// The figure's own right.
    Right,
}

impl Side {
    /// Returns -1 for left, 0 for the middle, 1 for right.
    pub fn number(self) -> i8 {
        match self {
            Self::Left => -1,
            Self::Middle => 0,
            Self::Right => 1,
        }
    }

    /// Returns the side of what is made of two pieces: theirs, or the only one there is.
    pub(super) fn with(self, other: Self) -> Self {
        match (self, other) {
            (Self::Middle, side) | (side, Self::Middle) => side,
            (a, b) if a == b => a,
            _ => Self::Middle,
        }
    }
}

/// No name is longer; what is behind that is not looked at.
const LONGEST: usize = 80;

/// Returns the side that each name says.
///
/// The words left and right are believed. A letter `l` or `r` at the beginning of a word is believed where there is the
/// same name with the other letter: `lfemur` has its `rfemur`, whereas `lowerback`, `root` and the vertebra `L5` have none.
pub(super) fn sides<'a>(names: impl Iterator<Item = &'a str> + Clone) -> Vec<Side> {
    let known: HashSet<String> = names.clone().map(|name| own_part(name).collect()).collect();
    names.map(|name| side(&own_part(name).collect::<Vec<_>>(), &known)).collect()
}

/// Returns a name without what stands before a colon: whom or which file it belongs to.
fn own_part(name: &str) -> impl Iterator<Item = char> + '_ {
    name.rsplit(':').next().unwrap_or(name).chars().take(LONGEST)
}

fn side(name: &[char], known: &HashSet<String>) -> Side {
    let lower: Vec<char> = name.iter().map(char::to_ascii_lowercase).collect();
    let begins_word = |at: &usize| {
        let before = at.checked_sub(1).and_then(|before| name.get(before));
        let is_upper = name.get(*at).is_some_and(|letter| letter.is_uppercase());
        before.is_none_or(|before| !before.is_alphabetic() || (before.is_lowercase() && is_upper))
    };
    let beginnings = (0..name.len()).filter(begins_word);
    let said = |at: usize, word: &str| {
        lower.iter().skip(at).zip(word.chars()).filter(|(a, b)| **a == *b).count() == word.len()
    };
    let by_word = beginnings.clone().find_map(|at| match (said(at, "left"), said(at, "right")) {
        (true, _) => Some(Side::Left),
        (_, true) => Some(Side::Right),
        _ => None,
    });
    let by_letter = beginnings.filter_map(|at| {
        let (side, other) = match name.get(at)? {
            'l' => (Side::Left, 'r'),
            'L' => (Side::Left, 'R'),
            'r' => (Side::Right, 'l'),
            'R' => (Side::Right, 'L'),
            _ => return None,
        };
        let mirrored: String =
            name.iter().enumerate().map(|(i, letter)| if i == at { other } else { *letter }).collect();
        known.contains(&mirrored).then_some(side)
    });
    by_word.or(by_letter.into_iter().next()).unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn sides_of(names: &str) -> Vec<i8> {
        sides(names.split(' ')).into_iter().map(Side::number).collect()
    }

    #[test]
    fn the_words_left_and_right_are_believed() {
        assert_eq!(sides_of("LeftArm rightFoot mixamorig:LEFT_HIP Hips Bright armLeft"), [-1, 1, -1, 0, 0, -1]);
    }

    #[test]
    fn a_letter_is_believed_where_the_other_side_has_the_same_name() {
        assert_eq!(sides_of("lfemur rfemur lowerback root"), [-1, 1, 0, 0]);
        assert_eq!(sides_of("S:LASI S:RASI S:L5 S:RBAK S:CLAV"), [-1, 1, 0, 0, 0]);
        assert_eq!(sides_of("Bip01_L_Thigh Bip01_R_Thigh toe1.R toe1.L handL handR"), [-1, 1, 1, -1, -1, 1]);
        assert_eq!(sides_of("LLEG RLEG Rl Ll"), [-1, 1, 1, -1]);
    }

    #[test]
    fn names_that_say_nothing_are_in_the_middle() {
        assert_eq!(sides_of("M1 M2  é *12"), [0, 0, 0, 0, 0]);
    }
}
