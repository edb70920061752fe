//! Borders between old and new motion, and the crossfade around them.
//!
//! Around a border `g` the blend covers the frames `g - before ..= g + after`; the weight of what comes rises in equal
//! steps `1 / (before + after + 2)`. Both motions must have every frame of it, so `before` and `after` shrink, each by
//! itself, to what both can supply. `after` is -1 where the old motion ends right before the border (and `before`
//! likewise at the end border): then the border frame itself is all new.

use super::place::Placement;
use crate::keys::SAME_FRAME;

/// Frames that a blend covers on the two sides of its border.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Depth {
    /// Frames before the border.
    pub before: i64,
    /// Frames after the border.
    pub after: i64,
}

/// A frame at which old and new motion meet.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Border {
    /// The first (start) or the last (end) frame of the new track.
    pub frame: f64,
    /// How far the blend reaches; `None` without blending.
    pub depth: Option<Depth>,
}

impl Border {
    /// The weight of what comes after the border, at any frame: rises from 0 to 1 in equal steps.
    fn rise(&self, frame: f64) -> Option<f64> {
        let depth = self.depth?;
        let steps = (depth.before + depth.after + 2) as f64;
        Some(((frame - (self.frame - depth.before as f64) + 1.0) / steps).clamp(0.0, 1.0))
    }
}

/// The borders of one track on one channel.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Borders {
    /// Where old motion goes over into the track.
    pub start: Option<Border>,
    /// Where the track goes over into old motion.
    pub end: Option<Border>,
}

impl Borders {
    /// Finds the borders of a track over an old motion of frames `old` (if there is any): `start` is one if the old
    /// motion has the frame before it, `end` if it has the frame after it.
    pub fn find(old: Option<(f64, f64)>, track: &Placement, blend_depth: Option<u32>) -> Self {
        let Some((first, last)) = old else { return Self::default() };
        let has = |frame: f64| first - SAME_FRAME <= frame && frame <= last + SAME_FRAME;
        let border = |frame: f64| {
            let depth = blend_depth.map(|asked| {
                let asked = i64::from(asked);
                let old_before = (frame - first + SAME_FRAME).floor() as i64;
                let old_after = (last - frame + SAME_FRAME).floor() as i64;
                Depth {
                    before: file_depth(track, frame, asked, -1.0).min(old_before).max(-1),
                    after: file_depth(track, frame, asked, 1.0).min(old_after).max(-1),
                }
            });
            Border { frame, depth }
        };
        Self {
            start: has(track.start - 1.0).then(|| border(track.start)),
            end: has(track.end + 1.0).then(|| border(track.end)),
        }
    }

    /// Returns the frames that the track changes.
    pub fn affected(&self, track: &Placement) -> (f64, f64) {
        let before = self.start.and_then(|border| border.depth).map_or(0, |depth| depth.before.max(0));
        let after = self.end.and_then(|border| border.depth).map_or(0, |depth| depth.after.max(0));
        (track.start - before as f64, track.end + after as f64)
    }

    /// Returns the share of the new motion at a frame, within 0..=1.
    pub fn weight(&self, frame: f64, track: &Placement) -> f64 {
        let hard = |inside: bool| f64::from(u8::from(inside));
        let coming = self.start.and_then(|border| border.rise(frame));
        let going = self.end.and_then(|border| border.rise(frame));
        let coming = coming.unwrap_or_else(|| hard(frame >= track.start - SAME_FRAME));
        let going = going.map_or_else(|| hard(frame <= track.end + SAME_FRAME), |rise| 1.0 - rise);
        coming.min(going)
    }
}

/// How many of `asked` frames the file can supply from a border towards `side` (-1 before, +1 after).
///
/// The file frame needed is the mapping at `frame + side * asked`; where the file ends earlier, at `q`, the depth
/// becomes `round((border - q) / (border - needed) * asked)`.
fn file_depth(track: &Placement, frame: f64, asked: i64, side: f64) -> i64 {
    let border = track.file_frame(frame);
    let needed = track.file_frame(frame + side * asked as f64);
    let q = if side < 0.0 { track.file_first } else { track.file_last };
    if (needed - q) * side <= SAME_FRAME {
        return asked;
    }
    ((border - q) / (border - needed) * asked as f64).round() as i64
}

#[cfg(test)]
mod tests {
    use super::super::place::{KeySpacing, Span};
    use super::*;
    use proptest::prelude::*;

    fn example(file_first: i64) -> Placement {
        let span = |start, end| Span { start: Some(start), end: Some(end) };
        Placement::new((file_first, 113), span(50, 113), span(50, 140), 1.0, KeySpacing::Frames).unwrap()
    }

    fn depths(borders: Borders) -> [Option<Depth>; 2] {
        [borders.start, borders.end].map(|border| border.and_then(|border| border.depth))
    }

    #[allow(clippy::unnecessary_wraps)] // reads as the depths that it is compared with
    const fn depth(before: i64, after: i64) -> Option<Depth> {
        Some(Depth { before, after })
    }

    #[test]
    fn worked_example_of_the_combiner() {
        let track = example(1);
        let borders = Borders::find(Some((45.0, 150.0)), &track, Some(5));
        assert_eq!(depths(borders), [depth(5, 5), depth(5, 0)]);
        assert_eq!(borders.affected(&track), (45.0, 140.0));
        let steps: Vec<f64> = (44..=56).map(|frame| borders.weight(f64::from(frame), &track)).collect();
        for (k, weight) in steps.iter().enumerate() {
            assert!((weight - k as f64 / 12.0).abs() < 1e-12, "frame {}: {weight}", 44 + k);
        }
        for (k, frame) in (135..=140).enumerate() {
            let old_share = 1.0 - borders.weight(f64::from(frame), &track);
            assert!((old_share - (k + 1) as f64 / 7.0).abs() < 1e-12, "frame {frame}: {old_share}");
        }
        assert_eq!(borders.weight(141.0, &track), 0.0);
    }

    #[test]
    fn an_old_motion_that_begins_late_shortens_the_left_side() {
        let track = example(1);
        let borders = Borders::find(Some((48.0, 150.0)), &track, Some(5));
        assert_eq!(depths(borders)[0], depth(2, 5));
        assert!((borders.weight(48.0, &track) - 1.0 / 9.0).abs() < 1e-12);
    }

    #[test]
    fn a_file_that_begins_late_shortens_the_left_side() {
        assert_eq!(depths(Borders::find(Some((45.0, 150.0)), &example(48), Some(5)))[0], depth(3, 5));
    }

    #[test]
    fn old_motion_that_ends_at_the_border_is_faded_out_before_it() {
        let cut = Span { start: Some(67), end: Some(113) };
        let track = Placement::new((1, 113), cut, Span::default(), 1.0, KeySpacing::Frames).unwrap();
        let borders = Borders::find(Some((1.0, 66.0)), &track, Some(10));
        assert_eq!(depths(borders), [depth(10, -1), None]);
        assert!((borders.weight(57.0, &track) - 1.0 / 11.0).abs() < 1e-12);
        assert!((borders.weight(66.0, &track) - 10.0 / 11.0).abs() < 1e-12);
        assert_eq!(borders.weight(67.0, &track), 1.0);
    }

    #[test]
    fn without_old_motion_next_to_it_there_is_no_border() {
        assert_eq!(Borders::find(None, &example(1), Some(5)), Borders::default());
        assert_eq!(Borders::find(Some((1.0, 48.0)), &example(1), Some(5)), Borders::default());
        assert!(Borders::find(Some((1.0, 49.0)), &example(1), None).start.is_some());
    }

    proptest! {
        #[test]
        fn weights_stay_within_bounds_and_are_monotone_up_then_down(
            old_first in -50i64..80, old_len in 0i64..300, start in 1i64..100, len in 0i64..120,
            asked in 1u32..60, file_first in -20i64..40, file_len in 0i64..150,
        ) {
            let file = (file_first, file_first + file_len);
            let scale = Span { start: Some(start), end: Some(start + len) };
            let track = Placement::new(file, Span::default(), scale, 1.0, KeySpacing::Frames).unwrap();
            let old = (old_first as f64, (old_first + old_len) as f64);
            let borders = Borders::find(Some(old), &track, Some(asked));
            let (from, to) = borders.affected(&track);
            let weights: Vec<f64> = (from as i64 - 2..=to as i64 + 2)
                .map(|frame| borders.weight(frame as f64, &track)).collect();
            prop_assert!(weights.iter().all(|weight| (0.0..=1.0).contains(weight)));
            let peak = weights.iter().copied().fold(0.0, f64::max);
            let top = weights.iter().position(|&weight| weight == peak).unwrap();
            prop_assert!(weights[..top].windows(2).all(|pair| pair[0] <= pair[1] + 1e-12));
            prop_assert!(weights[top..].windows(2).all(|pair| pair[1] <= pair[0] + 1e-12));
        }

        #[test]
        fn a_blend_never_needs_a_frame_that_the_old_motion_lacks(
            old_first in -50i64..80, old_len in 0i64..300, start in 1i64..100, len in 0i64..120, asked in 1u32..60,
        ) {
            let scale = Span { start: Some(start), end: Some(start + len) };
            let track = Placement::new((1, 90), Span::default(), scale, 1.0, KeySpacing::Frames).unwrap();
            let old = (old_first as f64, (old_first + old_len) as f64);
            let borders = Borders::find(Some(old), &track, Some(asked));
            for depth in depths(borders).into_iter().flatten() {
                prop_assert!(depth.before <= i64::from(asked) && depth.after <= i64::from(asked));
                prop_assert!(depth.before >= -1 && depth.after >= -1);
            }
            let (from, to) = borders.affected(&track);
            for frame in from as i64..=to as i64 {
                let weight = borders.weight(frame as f64, &track);
                if weight < 1.0 {
                    prop_assert!(old.0 <= frame as f64 && frame as f64 <= old.1, "frame {frame}: {weight}");
                }
            }
        }
    }
}
