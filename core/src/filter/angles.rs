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

#[cfg(test)]
mod tests {
    use std::f64::consts::PI;

    use super::*;

    const KINDS: [FilterKind; 3] = [FilterKind::Median, FilterKind::Average, FilterKind::Weighted];

    #[test]
    fn a_channel_that_wraps_at_half_a_turn_shows_no_spike() {
        let wrapped = |frame: i32| {
            let angle = f64::from(frame) * 0.1;
            [0.0, angle - TAU * (angle / TAU).round(), -angle + TAU * (angle / TAU).round()]
        };
        let angles: Vec<_> = (0..200).map(wrapped).collect();
        assert!(angles.windows(2).any(|pair| (pair[1][1] - pair[0][1]).abs() > PI), "the input does wrap");
        for kind in KINDS {
            for depth in [3, 5, 7] {
                let mut result = vec![[0.0; 3]; angles.len()];
                filter_angles(&angles, &mut result, kind, Depth::try_from(depth).unwrap());
                for (frame, triple) in result.iter().enumerate() {
                    let expected = frame as f64 * 0.1;
                    assert_eq!(triple[0], 0.0);
                    assert!((triple[1] - expected).abs() < 1e-12, "{kind:?} {depth} {frame}");
                    assert!((triple[2] + expected).abs() < 1e-12, "{kind:?} {depth} {frame}");
                }
            }
        }
    }

    #[test]
    fn channels_that_do_not_wrap_keep_their_bits() {
        let angles = [[-0.0, 3.0, 100.0], [0.1, 0.0, 100.0], [0.2, -3.0, 103.0]];
        let mut unwrapped = angles;
        unwrap_angles(&mut unwrapped);
        assert_eq!(unwrapped.map(|triple| triple.map(f64::to_bits)), angles.map(|triple| triple.map(f64::to_bits)));
    }

    #[test]
    fn unwrapping_passes_over_values_that_are_no_numbers() {
        let mut angles = [[3.0; 3], [f64::NAN; 3], [f64::INFINITY; 3], [-3.0; 3]];
        unwrap_angles(&mut angles);
        assert_eq!(angles[3], [TAU - 3.0; 3]);
    }

    #[test]
    fn no_frames_are_no_frames() {
        filter_angles(&[], &mut [], FilterKind::Average, Depth::try_from(3).unwrap());
    }
}
