//! How long a file unit is, and which way is up: what the file says, and what the size of a person says.

use super::{PointKind, Positions, UpAxis};
use crate::skeleton::LengthUnit;
use glam::DVec3;

/// How tall or wide a recorded person can be, in metres.
const PERSON_M: std::ops::RangeInclusive<f64> = 0.7..=2.6;

/// Beyond these a stated unit cannot be right for anything that markers are put on, in metres.
const POSSIBLE_M: std::ops::RangeInclusive<f64> = 0.05..=20.0;

/// At most so many frames are looked at.
const LOOKS: usize = 16;

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

/// Units that are tried where a file does not say, in metres; no two of them make a person of the same numbers.
const GUESSES: usize = 4;

/// Returns what files call the unit of so many metres.
pub(crate) fn unit_name(metres: f64) -> Option<&'static str> {
    UNITS.iter().find(|(_, known, _)| (known / metres - 1.0).abs() < 1e-9).map(|(name, ..)| *name)
}

/// Returns how far the markers of a frame usually lie apart along x, y and z, the lowest and the highest coordinate;
/// `None` where too few are seen.
pub(crate) fn extents(positions: &Positions, kinds: &[PointKind]) -> Option<Extents> {
    const FEWEST: usize = 3;
    let step = positions.frame_count().div_ceil(LOOKS).max(1);
    let markers: Vec<usize> =
        (0..kinds.len()).filter(|marker| kinds.get(*marker) == Some(&PointKind::Position)).collect();
    let mut frames: Vec<(DVec3, DVec3)> = Vec::with_capacity(LOOKS);
    for frame in (0..positions.frame_count()).step_by(step) {
        let seen = markers.iter().filter_map(|marker| positions.get(*marker, frame)).filter(|at| *at != DVec3::ZERO);
        let (mut count, mut low, mut high) = (0, DVec3::INFINITY, DVec3::NEG_INFINITY);
        for at in seen {
            (count, low, high) = (count + 1, low.min(at), high.max(at));
        }
        if count >= FEWEST && low.is_finite() && high.is_finite() {
            frames.push((low, high));
        }
    }
    if frames.is_empty() {
        return None;
    }
    let median = |of: &dyn Fn(&(DVec3, DVec3)) -> f64| {
        let mut values: Vec<f64> = frames.iter().map(of).collect();
        values.sort_by(f64::total_cmp);
        values.get(values.len() / 2).copied().unwrap_or(0.0)
    };
    let each = |of: fn(&(DVec3, DVec3)) -> DVec3| {
        DVec3::new(median(&|frame| of(frame).x), median(&|frame| of(frame).y), median(&|frame| of(frame).z))
    };
    Some(Extents { size: each(|(low, high)| *high - *low), low: each(|frame| frame.0), high: each(|frame| frame.1) })
}

/// How far the markers of a frame usually reach.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Extents {
    /// Along x, y and z, in file units.
    pub(crate) size: DVec3,
    low: DVec3,
    high: DVec3,
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
    let person = UNITS.iter().take(GUESSES).find(|(_, metres, _)| PERSON_M.contains(&(size * metres)));
    let length = |metres: f64| format!("the markers are {:.2} m across", size * metres);
    match (known, person) {
        (Some((_, metres, words)), _) if PERSON_M.contains(&(size * metres)) => LengthUnit {
            metres: *metres,
            reason: format!("{words}, as {who} says: {}", length(*metres)),
            is_certain: true,
        },
        (Some((_, metres, words)), person) if person.is_none() || POSSIBLE_M.contains(&(size * metres)) => LengthUnit {
            metres: *metres,
            reason: format!("{words}, as {who} says; but {}", length(*metres)),
            is_certain: false,
        },
        (_, Some((_, metres, words))) => LengthUnit {
            metres: *metres,
            reason: match known {
                Some((_, wrong, said)) => {
                    format!("{words}: {}; {who} says {said}, but then {}", length(*metres), length(*wrong))
                }
                None => format!("{words}: {}; the file does not say", length(*metres)),
            },
            is_certain: known.is_none(),
        },
        _ => LengthUnit {
            metres: 0.001,
            reason: format!("millimetres, as most files have, though {}; the file does not say", length(0.001)),
            is_certain: false,
        },
    }
}

/// The six axes with their names in files.
const AXES: [(&str, DVec3); 6] = [
    ("+X", DVec3::X),
    ("-X", DVec3::NEG_X),
    ("+Y", DVec3::Y),
    ("-Y", DVec3::NEG_Y),
    ("+Z", DVec3::Z),
    ("-Z", DVec3::NEG_Z),
];

/// Returns the axis of a name such as `+Z` or `z`.
pub(crate) fn axis_of(name: &str) -> Option<DVec3> {
    let name = name.trim();
    let is = |known: &str| {
        known.eq_ignore_ascii_case(name) || known.strip_prefix('+').is_some_and(|k| k.eq_ignore_ascii_case(name))
    };
    AXES.iter().find(|(known, _)| is(known)).map(|(_, axis)| *axis)
}

/// Returns what files call an axis.
pub(crate) fn axis_name(axis: DVec3) -> &'static str {
    AXES.iter().max_by(|a, b| a.1.dot(axis).total_cmp(&b.1.dot(axis))).map_or("+Z", |(name, _)| name)
}

/// By how much a person who stands is taller than wide, at least.
const TALL: f64 = 1.25;

/// Returns the axis that is stated (and by what), or else the one along which the markers reach farthest.
pub(crate) fn up(stated: Option<(DVec3, &str)>, extents: Option<Extents>) -> UpAxis {
    let tallest = extents.map(|extents| {
        let size = extents.size;
        let (axis, tall) = [(DVec3::X, size.x), (DVec3::Y, size.y), (DVec3::Z, size.z)]
            .into_iter()
            .fold((DVec3::Z, f64::NEG_INFINITY), |best, next| if next.1 > best.1 { next } else { best });
        let wide = (size - axis * tall).max_element();
        // Feet stay near the origin of the floor, heads do not.
        let is_upside_down = extents.low.dot(axis).abs() > 2.0 * extents.high.dot(axis).abs();
        (if is_upside_down { -axis } else { axis }, tall > TALL * wide)
    });
    match (stated, tallest) {
        (Some((axis, place)), Some((tall, true))) if tall.dot(axis).abs() < 0.5 => UpAxis {
            axis,
            reason: format!(
                "{}, as {place} says, though the markers reach farthest along {}",
                axis_name(axis),
                axis_name(tall)
            ),
            is_certain: false,
        },
        (Some((axis, place)), _) => {
            UpAxis { axis, reason: format!("{}, as {place} says", axis_name(axis)), is_certain: true }
        }
        (None, Some((axis, is_tall))) => UpAxis {
            axis,
            reason: format!("{}, along which the markers reach farthest; the file does not say", axis_name(axis)),
            is_certain: is_tall,
        },
        (None, None) => UpAxis { axis: DVec3::Z, reason: "+Z, as in most laboratories".to_owned(), is_certain: false },
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn body(size: DVec3) -> Extents {
        Extents { size, low: DVec3::ZERO, high: size }
    }

    #[test]
    fn the_stated_unit_counts_unless_it_is_absurd() {
        let tall = |z| Some(body(DVec3::new(z / 4.0, z / 5.0, z)));
        let table = [
            ("mm", tall(1700.0), 0.001, true, "millimetres, as the file says: the markers are 1.70 m across"),
            ("M ", tall(1.7), 1.0, true, "metres, as the file says: the markers are 1.70 m across"),
            ("", tall(1.7), 1.0, true, "metres: the markers are 1.70 m across; the file does not say"),
            ("", tall(66.0), 0.0254, true, "inches: the markers are 1.68 m across; the file does not say"),
            ("mm", tall(200.0), 0.001, false, "millimetres, as the file says; but the markers are 0.20 m across"),
            (
                "mm",
                tall(1.7),
                1.0,
                false,
                "metres: the markers are 1.70 m across; the file says millimetres, but then the markers are 0.00 m across",
            ),
            ("cm", None, 0.01, false, "centimetres; there are too few markers to see how large they are"),
            ("furlong", None, 0.001, false, "millimetres, as most files have; there are too few markers to see how large they are"),
        ];
        for (stated, extents, metres, is_certain, reason) in table {
            let unit = unit(stated, "the file", extents);
            assert_eq!((unit.metres, unit.is_certain, unit.reason.as_str()), (metres, is_certain, reason));
        }
    }

    #[test]
    fn the_stated_axis_counts_and_is_doubted_where_the_body_lies() {
        let standing = body(DVec3::new(500.0, 400.0, 1700.0));
        let stated = Some((DVec3::Z, "`Y_SCREEN`"));
        assert_eq!(up(stated, Some(standing)).reason, "+Z, as `Y_SCREEN` says");
        assert!(up(stated, Some(standing)).is_certain);
        let lying = up(Some((DVec3::Y, "Y_SCREEN")), Some(standing));
        assert_eq!((lying.axis, lying.is_certain), (DVec3::Y, false));
        let inferred = up(None, Some(standing));
        assert_eq!((inferred.axis, inferred.is_certain), (DVec3::Z, true));
        let hanging = Extents { size: standing.size, low: -standing.size, high: DVec3::ZERO };
        assert_eq!(up(None, Some(hanging)).axis, DVec3::NEG_Z);
        assert_eq!((up(None, None).axis, up(None, None).is_certain), (DVec3::Z, false));
    }

    #[test]
    fn names_of_axes_are_read_in_either_case_with_or_without_plus() {
        assert_eq!(
            (axis_of("+z "), axis_of("y"), axis_of("-X"), axis_of("w")),
            (Some(DVec3::Z), Some(DVec3::Y), Some(DVec3::NEG_X), None)
        );
        assert_eq!(AXES.map(|(_, axis)| axis_name(axis)), AXES.map(|(name, _)| name));
    }
}
