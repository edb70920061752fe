//! Which axis points up.

use super::{Extents, Stance};
use crate::markers::UpAxis;
use glam::DVec3;

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

/// Returns the axis that is stated (and by what), or else the one along which the markers reach farthest.
///
/// Screens are not rooms: `Y_SCREEN` names the axis of a view, and is wrong about one file in twenty. Markers that stand on
/// the floor along another axis are believed more.
pub(crate) fn up(stated: Option<(DVec3, &str)>, extents: Option<Extents>) -> UpAxis {
    let tallest = extents.map(|extents| extents.tallest());
    let along = |axis: DVec3| format!("{}, along which the markers reach farthest", axis_name(axis));
    let (axis, reason, is_certain) = match (stated, tallest) {
        (Some((axis, place)), Some((tall, stance))) if stance != Stance::Unclear && tall.dot(axis).abs() < 0.5 => {
            if stance == Stance::OnTheFloor {
                (tall, format!("{} and stand on the floor; {place} says {}", along(tall), axis_name(axis)), false)
            } else {
                let but = format!("the markers reach farthest along {}", axis_name(tall));
                (axis, format!("{}, as {place} says, though {but}", axis_name(axis)), false)
            }
        }
        (Some((axis, place)), _) => (axis, format!("{}, as {place} says", axis_name(axis)), true),
        (None, Some((axis, stance))) => {
            (axis, format!("{}; the file does not say", along(axis)), stance != Stance::Unclear)
        }
        (None, None) => (DVec3::Z, "+Z, as in most laboratories".to_owned(), false),
    };
    UpAxis { axis, reason, is_certain }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_stated_axis_counts_and_is_doubted_where_the_body_lies() {
        let standing = Extents::of_size(DVec3::new(500.0, 400.0, 1700.0));
        let stated = Some((DVec3::Z, "`Y_SCREEN`"));
        assert_eq!(up(stated, Some(standing)).reason, "+Z, as `Y_SCREEN` says");
        assert!(up(stated, Some(standing)).is_certain);
        let other = up(Some((DVec3::Y, "`Y_SCREEN`")), Some(standing));
        let reason = "+Z, along which the markers reach farthest and stand on the floor; `Y_SCREEN` says +Y";
        assert_eq!((other.axis, other.is_certain, other.reason.as_str()), (DVec3::Z, false, reason));
        let lying = Extents { low: DVec3::splat(900.0), high: DVec3::splat(900.0) + standing.size, ..standing };
        let other = up(Some((DVec3::Y, "`Y_SCREEN`")), Some(lying));
        let reason = "+Y, as `Y_SCREEN` says, though the markers reach farthest along +Z";
        assert_eq!((other.axis, other.is_certain, other.reason.as_str()), (DVec3::Y, false, reason));
        let inferred = up(None, Some(standing));
        assert_eq!((inferred.axis, inferred.is_certain), (DVec3::Z, true));
        let hanging = Extents { low: -standing.size, high: DVec3::ZERO, ..standing };
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
