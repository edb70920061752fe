//! What markers are, by their names: `LASI`, `L.ASIS`, `l_asis` and `ASISl` are one and the same.

use super::names::Side;
use std::collections::HashMap;

/// A part of the body that has markers before and behind it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Region {
    Chest,
    Pelvis,
    Foot,
}

/// Which end of a region.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum End {
    Front,
    Back,
}

/// The words of laboratories, without side and number behind.
const WORDS: [(&str, Region, End); 33] = [
    ("asi", Region::Pelvis, End::Front),
    ("asis", Region::Pelvis, End::Front),
    ("ias", Region::Pelvis, End::Front),
    ("fwt", Region::Pelvis, End::Front),
    ("psi", Region::Pelvis, End::Back),
    ("psis", Region::Pelvis, End::Back),
    ("ips", Region::Pelvis, End::Back),
    ("bwt", Region::Pelvis, End::Back),
    ("sac", Region::Pelvis, End::Back),
    ("sacr", Region::Pelvis, End::Back),
    ("sacrum", Region::Pelvis, End::Back),
    ("vsac", Region::Pelvis, End::Back),
    ("clav", Region::Chest, End::Front),
    ("strn", Region::Chest, End::Front),
    ("ster", Region::Chest, End::Front),
    ("sternum", Region::Chest, End::Front),
    ("c7", Region::Chest, End::Back),
    ("cv7", Region::Chest, End::Back),
    ("t10", Region::Chest, End::Back),
    ("toe", Region::Foot, End::Front),
    ("toes", Region::Foot, End::Front),
    ("toebase", Region::Foot, End::Front),
    ("mt", Region::Foot, End::Front),
    ("met", Region::Foot, End::Front),
    ("hee", Region::Foot, End::Back),
    ("heel", Region::Foot, End::Back),
    ("hel", Region::Foot, End::Back),
    ("cal", Region::Foot, End::Back),
    ("calc", Region::Foot, End::Back),
    ("ank", Region::Foot, End::Back),
    ("ankle", Region::Foot, End::Back),
    ("mal", Region::Foot, End::Back),
    ("mall", Region::Foot, End::Back),
];

/// Words for both sides of the trunk, which no step and no gesture carries along; without number behind.
const SIDES_OF_TRUNK: [&str; 18] = [
    "asi", "asis", "ias", "fwt", "psi", "psis", "ips", "bwt", "hip", "hjc", "sho", "should", "shoulder", "acr",
    "acromion", "acromium", "upleg", "femur",
];

/// How sides are written. The long words come first: they begin like the short ones.
const SIDES: [(&str, Side); 4] = [("left", Side::Left), ("right", Side::Right), ("l", Side::Left), ("r", Side::Right)];

/// Two markers on either side of the body, as indices.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Pair {
    pub(super) left: usize,
    pub(super) right: usize,
    /// Whether they are on the trunk, and not on arms, legs or head.
    pub(super) is_on_trunk: bool,
}

/// Finds markers whose names differ in nothing but the side. `L` may begin any word: what has no counterpart is no side.
pub(super) fn pairs<'a>(names: impl Iterator<Item = (usize, &'a str)>) -> Vec<Pair> {
    let mut sides: HashMap<(&str, bool, &str), [Option<usize>; 2]> = HashMap::new();
    let mut rests = Vec::new();
    for (index, name) in names {
        let (subject, own) = split(name);
        for (is_behind, (side, rest)) in sides_of(own) {
            let place = usize::from(side == Side::Right);
            let key = (subject, is_behind, rest);
            // Of several of one name, the first counts.
            let both = sides.entry(key).or_insert_with(|| {
                rests.push(key);
                [None; 2]
            });
            both[place].get_or_insert(index);
        }
    }
    let pair = |key: &(&str, bool, &str)| {
        let [left, right] = *sides.get(key)?;
        let is_on_trunk = is_listed(key.2, |word| SIDES_OF_TRUNK.iter().any(|known| known.eq_ignore_ascii_case(word)));
        Some(Pair { left: left?, right: right?, is_on_trunk })
    };
    rests.iter().filter_map(pair).collect()
}

/// Returns at which end of which region a marker of that name is; `None` for all others.
pub(super) fn end(name: &str) -> Option<(Region, End)> {
    let (_, own) = split(name);
    let known = |own: &str| {
        let mut found = None;
        is_listed(own, |word| {
            found = WORDS.iter().find(|(known, ..)| known.eq_ignore_ascii_case(word));
            found.is_some()
        });
        found.map(|(_, region, end)| (*region, *end))
    };
    known(own).or_else(|| sides_of(own).find_map(|(_, (_, rest))| known(rest)))
}

/// Asks for the first word of a name as it is, and without the number behind it.
fn is_listed(own: &str, mut is_known: impl FnMut(&str) -> bool) -> bool {
    let word = own.split(|c: char| !c.is_alphanumeric()).next().unwrap_or(own);
    let bare = word.trim_end_matches(|c: char| c.is_ascii_digit());
    is_known(word) || (bare.len() < word.len() && is_known(bare))
}

/// Splits a name into subject and own name.
fn split(name: &str) -> (&str, &str) {
    name.rsplit_once(':').unwrap_or(("", name))
}

/// Returns the sides that a name may say, with the rest of it: before that, and behind (true).
fn sides_of(own: &str) -> impl Iterator<Item = (bool, (Side, &str))> {
    before(own).map(|found| (false, found)).into_iter().chain(behind(own).map(|found| (true, found)))
}

fn before(own: &str) -> Option<(Side, &str)> {
    let cut = |word: &str| {
        let (head, rest) = own.split_at_checked(word.len())?;
        head.eq_ignore_ascii_case(word).then(|| rest.trim_start_matches(|c: char| !c.is_alphanumeric()))
    };
    let found = SIDES.iter().find_map(|(word, side)| Some((*side, cut(word)?)));
    found.filter(|(_, rest)| !rest.is_empty())
}

/// Behind a name a side is a word of its own: after a sign, or in the other case.
fn behind(own: &str) -> Option<(Side, &str)> {
    let cut = |word: &str| {
        let (rest, tail) = own.split_at_checked(own.len().checked_sub(word.len())?)?;
        let first = tail.chars().next()?;
        let last = rest.chars().next_back()?;
        let begins = !last.is_alphabetic() || last.is_uppercase() != first.is_uppercase();
        (begins && tail.eq_ignore_ascii_case(word)).then(|| rest.trim_end_matches(|c: char| !c.is_alphanumeric()))
    };
    let found = SIDES.iter().find_map(|(word, side)| Some((*side, cut(word)?)));
    found.filter(|(_, rest)| !rest.is_empty())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_that_differ_in_the_side_alone_are_a_pair() {
        let table = [
            ("LASI RASI", true),
            ("L.ASIS R.ASIS", true),
            ("l_asis r_asis", true),
            ("A:ASISl A:ASISr", true),
            ("LeftShoulder RightShoulder", true),
            ("should.L should.R", true),
            ("hip_left hip_right", true),
            ("LWRA RWRA", false),
            ("KneeL KneeR", false),
        ];
        for (names, is_on_trunk) in table {
            let found = pairs(names.split(' ').enumerate());
            assert_eq!(found, [Pair { left: 0, right: 1, is_on_trunk }], "{names}");
        }
        for names in ["LASI RPSI", "A:LASI B:RASI", "L R", "LBAK", "ARML ARMR", "ARMl ARMm", "Left Right", "é ß"] {
            assert_eq!(pairs(names.split(' ').enumerate()), [], "{names}");
        }
    }

    #[test]
    fn of_several_of_one_name_the_first_is_taken() {
        let names = ["RKNE", "LKNE", "RKNE", "LKNE"];
        assert_eq!(pairs(names.into_iter().enumerate()), [Pair { left: 1, right: 0, is_on_trunk: false }]);
    }

    #[test]
    fn names_of_many_laboratories_mean_front_and_back() {
        use {End::*, Region::*};
        let table = [
            (Pelvis, Front, "LASI R.ASIS r_asis ASISr RFWT A22:LASI RASI1"),
            (Pelvis, Back, "LPSI L.PSIS SACR VSAC sacrum SACR1 LBWT"),
            (Chest, Front, "CLAV STRN Sternum"),
            (Chest, Back, "C7 c7 T10 Daphnee:T10"),
            (Foot, Front, "LTOE R.Toe.Tip L.Toe RMT5 r_met RMET1 LeftToeBase"),
            (Foot, Back, "LHEE L.Heel LHEL LCAL r_mall RANK r_ankle heel_L"),
        ];
        for (region, side, names) in table {
            for name in names.split(' ') {
                assert_eq!(end(name), Some((region, side)), "{name}");
            }
        }
        for name in ["RHEA", "LCALF", "RTHI", "C8", "T100", "M1", "", ":", "L", "*39", "toé"] {
            assert_eq!(end(name), None, "{name}");
        }
    }
}
