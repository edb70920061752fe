//! Filters on Euler angles, channel by channel: the classic way.

use std::f64::consts::TAU;

use super::components::by_component;
use super::{filter_values, Depth, FilterKind};

/// Filters each of three Euler channels by itself, after [unwrapping](unwrap_angles) it.
///
/// The result is unwrapped: a channel that went from 179 to -179 degrees goes on to 181.
///
/// # Panics
///
/// If `out` is not as long as `angles`.
pub fn filter_angles(angles: &[[f64; 3]], out: &mut [[f64; 3]], kind: FilterKind, depth: Depth) {
    assert_eq!(angles.len(), out.len(), "one result per frame");
    let mut unwrapped = angles.to_vec();
    unwrap_angles(&mut unwrapped);
    out.copy_from_slice(&by_component(&unwrapped, |channel, out| filter_values(channel, out, kind, depth)));
}

/// Adds whole turns to each channel so that it never moves by more than half a turn from one frame to the next.
///
/// Radians. A channel without such a move is left as it is, bit for bit. Values that are no numbers are passed over.
pub fn unwrap_angles(angles: &mut [[f64; 3]]) {
    for axis in 0..3 {
        let mut last: Option<f64> = None;
        for triple in angles.iter_mut() {
            let angle = &mut triple[axis];
            if !angle.is_finite() {
                continue;
            }
            let turns = last.map_or(0.0, |last| ((last - *angle) / TAU).round());
            if turns != 0.0 {
                *angle += turns * TAU;
            }
            last = Some(*angle);
        }
    }
}
