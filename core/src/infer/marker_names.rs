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

/// Longer words are none of those that are known.
const LONGEST: usize = 12;

/// How sides are written. The long words come first: they begin like the short ones.
const SIDES: [(&str, Side); 4] = [("left", Side::Left), ("right", Side::Right), ("l", Side::Left), ("r", Side::Right)];

/// Where a marker is by a word of laboratories, in lower case.
fn end_of(word: &[u8]) -> Option<(Region, End)> {
    Some(match word {
        b"asi" | b"asis" | b"ias" | b"fwt" => (Region::Pelvis, End::Front),
        b"psi" | b"psis" | b"ips" | b"bwt" | b"sac" | b"sacr" | b"sacrum" | b"vsac" => (Region::Pelvis, End::Back),
        b"clav" | b"strn" | b"ster" | b"sternum" => (Region::Chest, End::Front),
        b"c7" | b"cv7" | b"t10" => (Region::Chest, End::Back),
        b"toe" | b"toes" | b"toebase" | b"mt" | b"met" => (Region::Foot, End::Front),
        b"hee" | b"heel" | b"hel" | b"cal" | b"calc" | b"ank" | b"ankle" | b"mal" | b"mall" => {
            (Region::Foot, End::Back)
        }
        _ => return None,
    })
}

/// Whether a word in lower case is for both sides of the trunk, which no step and no gesture carries along.
fn is_on_trunk(word: &[u8]) -> bool {
    let pelvis = matches!(word, b"asi" | b"asis" | b"ias" | b"fwt" | b"psi" | b"psis" | b"ips" | b"bwt");
    // Not `femur`: where markers are the ends of bones, that is the knee, which a step carries along.
    let hips = matches!(word, b"hip" | b"hipjoint" | b"hjc" | b"upleg");
    let shoulders = matches!(word, b"sho" | b"should" | b"shoulder" | b"acr" | b"acromion" | b"acromium" | b"clavicle");
    pelvis || hips || shoulders
}

/// Finds markers whose names differ in nothing but the side, left and right, as indices: those on the trunk, and where
/// there are none, all. `L` may begin any word: what has no counterpart is no side.
pub(super) fn pairs<'a>(names: impl Iterator<Item = (usize, &'a str)> + Clone) -> Vec<[usize; 2]> {
    let on_trunk = pairs_of(names.clone(), |rest| meaning(rest, |word| is_on_trunk(word).then_some(())).is_some());
    if on_trunk.is_empty() {
        pairs_of(names, |_| true)
    } else {
        on_trunk
    }
}

fn pairs_of<'a>(names: impl Iterator<Item = (usize, &'a str)>, is_wanted: impl Fn(&str) -> bool) -> Vec<[usize; 2]> {
    let mut sides: HashMap<(&str, bool, &str), [Option<usize>; 2]> = HashMap::new();
    let mut keys = Vec::new();
    for (index, name) in names {
        let (subject, own) = split(name);
        for (is_behind, (side, rest)) in sides_of(own).filter(|(_, (_, rest))| is_wanted(rest)) {
            let key = (subject, is_behind, rest);
            // Of several of one name, the first counts.
            let both = sides.entry(key).or_insert_with(|| {
                keys.push(key);
                [None; 2]
            });
            both[usize::from(side == Side::Right)].get_or_insert(index);
        }
    }
    let pair = |key| {
        let [left, right] = *sides.get(key)?;
        Some([left?, right?])
    };
    keys.iter().filter_map(pair).collect()
}

/// Returns at which end of which region a marker of that name is; `None` for all others.
pub(super) fn end(name: &str) -> Option<(Region, End)> {
    let (_, own) = split(name);
    meaning(own, end_of).or_else(|| sides_of(own).find_map(|(_, (_, rest))| meaning(rest, end_of)))
}

/// Asks what the first word of a name means, as it is, and without the number behind it.
fn meaning<T>(own: &str, of: impl Fn(&[u8]) -> Option<T>) -> Option<T> {
    let word = own.split(|c: char| !c.is_alphanumeric()).next()?.as_bytes();
    let mut lower = [0; LONGEST];
    let lower = lower.get_mut(..word.len())?;
    lower.copy_from_slice(word);
    lower.make_ascii_lowercase();
    let mut bare: &[u8] = lower;
    while let [rest @ .., b'0'..=b'9'] = bare {
        bare = rest;
    }
    of(lower).or_else(|| of(bare))
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
        for names in [
            "LASI RASI",
            "L.ASIS R.ASIS",
            "l_asis r_asis",
            "A:ASISl A:ASISr",
            "LeftShoulder RightShoulder",
            "should.L should.R",
            "hip_left hip_right",
            "LWRA RWRA",
            "KneeL KneeR",
        ] {
            assert_eq!(pairs(names.split(' ').enumerate()), [[0, 1]], "{names}");
        }
        let none: [[usize; 2]; 0] = [];
        for names in ["LASI RPSI", "A:LASI B:RASI", "L R", "LBAK", "ARML ARMR", "ARMl ARMm", "Left Right", "é ß"] {
            assert_eq!(pairs(names.split(' ').enumerate()), none, "{names}");
        }
    }

    #[test]
    fn pairs_on_the_trunk_go_before_others_and_the_first_of_one_name_before_the_next() {
        let names = ["RKNE", "LKNE", "RKNE", "LKNE"];
        assert_eq!(pairs(names.into_iter().enumerate()), [[1, 0]]);
        let names = ["RKNE", "LKNE", "RASI", "LASI"];
        assert_eq!(pairs(names.into_iter().enumerate()), [[3, 2]]);
        // The ends of an Acclaim skeleton's bones: that of the thigh is the knee.
        let names = ["lfemur", "rfemur", "lhipjoint", "rhipjoint", "lclavicle", "rclavicle"];
        assert_eq!(pairs(names.into_iter().enumerate()), [[2, 3], [4, 5]]);
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
