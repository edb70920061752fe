//! How long a file unit is.

use super::{Extents, Stance};
use crate::infer::TYPICAL_PERSON_M;
use crate::skeleton::LengthUnit;

/// How tall or wide a recorded person can be, in metres.
const PERSON_M: std::ops::RangeInclusive<f64> = 0.7..=2.6;

/// Beyond these a stated unit cannot be right for anything that markers are put on, in metres.
const POSSIBLE_M: std::ops::RangeInclusive<f64> = 0.05..=20.0;

/// Units with their names in files and in words, likely ones first.
const UNITS: [(&str, f64, &str); 10] = [
    ("mm", 0.001, "millimetres"),
    ("m", 1.0, "metres"),
    ("cm", 0.01, "centimetres"),
    ("in", 0.0254, "inches"),
    ("ft", 0.3048, "feet"),
    ("dm", 0.1, "decimetres"),
    ("millimeters", 0.001, "millimetres"),
    ("meters", 1.0, "metres"),
    ("centimeters", 0.01, "centimetres"),
    ("inches", 0.0254, "inches"),
];

/// How tall or wide a person is where the unit is guessed from that alone: no two guesses make one of the same numbers.
const GUESSED_PERSON_M: std::ops::RangeInclusive<f64> = 0.88..=2.2;

/// How many units are tried where a file does not say; of those that few files
/// have nobody can be certain.
const GUESSES: usize = 6;
const CERTAIN_GUESSES: usize = 3;

/// Returns what files call the unit of so many metres.
pub(crate) fn unit_name(metres: f64) -> Option<&'static str> {
    UNITS.iter().find(|(_, known, _)| (known / metres - 1.0).abs() < 1e-9).map(|(name, ..)| *name)
}

/// Returns the unit that `who` ("the file") states, unless that is absurd; else the one in which the markers are a
/// person's.
pub(crate) fn unit(stated: &str, who: &str, extents: Option<Extents>) -> LengthUnit {
    let stated = stated.trim();
    let known = UNITS.iter().find(|(name, ..)| name.eq_ignore_ascii_case(stated));
    let size = extents.map(|extents| extents.size.max_element()).filter(|size| *size > 0.0);
    let Some(size) = size else {
        let (metres, what) =
            known.map_or((0.001, "millimetres, as most files have"), |(_, metres, words)| (*metres, *words));
        let reason = format!("{what}; there are too few markers to see how large they are");
        return LengthUnit { metres, reason, is_certain: false };
    };
    let length = |metres: f64| format!("the markers are {:.2} m across", size * metres);
    let is_guess = |(_, (_, metres, _)): &(usize, &(_, f64, _))| GUESSED_PERSON_M.contains(&(size * metres));
    let guess = UNITS.iter().enumerate().take(GUESSES).find(is_guess);
    let stance = extents.map_or(Stance::Unclear, |extents| extents.tallest().1);
    let Some((_, stated_m, stated_words)) = known else {
        return guess.map_or_else(
            || unknown(size, stance),
            |(index, (_, metres, words))| LengthUnit {
                metres: *metres,
                reason: format!("{words}: {}; the file does not say", length(*metres)),
                // What does not stand upright may be no person.
                is_certain: index < CERTAIN_GUESSES && stance != Stance::Unclear,
            },
        );
    };
    let stated_size = size * stated_m;
    match guess {
        _ if PERSON_M.contains(&stated_size) => LengthUnit {
            metres: *stated_m,
            reason: format!("{stated_words}, as {who} says: {}", length(*stated_m)),
            is_certain: true,
        },
        // What stands like a person is one; anything else may well be a hand or a hall.
        Some((_, (_, metres, words))) if stance == Stance::OnTheFloor || !POSSIBLE_M.contains(&stated_size) => {
            LengthUnit {
                metres: *metres,
                reason: format!(
                    "{words}: {}; {who} says {stated_words}, but then {}",
                    length(*metres),
                    length(*stated_m)
                ),
                is_certain: false,
            }
        }
        None if stance != Stance::Unclear && !POSSIBLE_M.contains(&stated_size) => {
            as_person(size, &format!("{who} says {stated_words}, but then {}", length(*stated_m)))
        }
        _ => LengthUnit {
            metres: *stated_m,
            reason: format!("{stated_words}, as {who} says; but {}", length(*stated_m)),
            is_certain: false,
        },
    }
}

/// Returns what is taken where neither the file nor any usual unit says one: what stands like a person becomes as tall as
/// one, anything else has the unit that most files have.
fn unknown(size: f64, stance: Stance) -> LengthUnit {
    if stance != Stance::Unclear {
        return as_person(size, "the file does not say");
    }
    let metres = 0.001;
    let across = size * metres;
    let reason =
        format!("millimetres, as most files have, though the markers are {across:.2} m across; the file does not say");
    LengthUnit { metres, reason, is_certain: false }
}

/// Returns the unit that makes something a person that is one in no usual unit.
fn as_person(size: f64, why: &str) -> LengthUnit {
    let reason = format!("no usual unit makes the markers a person: taken as {TYPICAL_PERSON_M:.2} m tall; {why}");
    LengthUnit { metres: TYPICAL_PERSON_M / size, reason, is_certain: false }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DVec3;

    #[test]
    fn the_stated_unit_counts_unless_it_is_absurd() {
        let wide = |x| Some(Extents::of_size(DVec3::new(x, x, x / 2.0)));
        let tall = |z| Some(Extents::of_size(DVec3::new(z / 4.0, z / 5.0, z)));
        let table = [
            ("mm", tall(1700.0), 0.001, true, "millimetres, as the file says: the markers are 1.70 m across"),
            ("M ", tall(1.7), 1.0, true, "metres, as the file says: the markers are 1.70 m across"),
            ("", tall(1.7), 1.0, true, "metres: the markers are 1.70 m across; the file does not say"),
            ("", wide(1.2), 1.0, false, "metres: the markers are 1.20 m across; the file does not say"),
            ("", tall(66.0), 0.0254, false, "inches: the markers are 1.68 m across; the file does not say"),
            (
                "",
                tall(17_000.0),
                1.65 / 17_000.0,
                false,
                "no usual unit makes the markers a person: taken as 1.65 m tall; the file does not say",
            ),
            (
                "",
                wide(300.0),
                0.001,
                false,
                "millimetres, as most files have, though the markers are 0.30 m across; the file does not say",
            ),
            ("mm", wide(200.0), 0.001, false, "millimetres, as the file says; but the markers are 0.20 m across"),
            (
                "mm",
                tall(170.0),
                0.01,
                false,
                "centimetres: the markers are 1.70 m across; the file says millimetres, but then the markers are 0.17 m across",
            ),
            (
                "mm",
                tall(1.7),
                1.0,
                false,
                "metres: the markers are 1.70 m across; the file says millimetres, but then the markers are 0.00 m across",
            ),
            (
                "m",
                tall(170_000.0),
                1.65 / 170_000.0,
                false,
                "no usual unit makes the markers a person: taken as 1.65 m tall; the file says metres, but then the markers are 170000.00 m across",
            ),
            ("mm", tall(17_000.0), 0.001, false, "millimetres, as the file says; but the markers are 17.00 m across"),
            ("cm", None, 0.01, false, "centimetres; there are too few markers to see how large they are"),
            ("furlong", None, 0.001, false, "millimetres, as most files have; there are too few markers to see how large they are"),
        ];
        for (stated, extents, metres, is_certain, reason) in table {
            let unit = unit(stated, "the file", extents);
            assert_eq!((unit.metres, unit.is_certain, unit.reason.as_str()), (metres, is_certain, reason));
        }
    }
}
