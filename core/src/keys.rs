//! Keys of one channel over scene frames, as a stack entry finds them and leaves them.

use crate::value::Value;

/// How a channel gets from one key to the next; the numbers are Blender's own.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[repr(i32)]
pub enum Interpolation {
    /// The key's value holds until the next key.
    Constant = 0,
    /// A straight line (rotations: slerp).
    #[default]
    Linear = 1,
    /// The host's own easing curve.
    Bezier = 2,
}

/// Two keys nearer than this (in frames) stand at the same frame.
pub const SAME_FRAME: f64 = 1e-6;

/// One key.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Key<V> {
    /// The scene frame.
    pub frame: f64,
    /// The value there.
    pub value: V,
    /// What follows it.
    pub interpolation: Interpolation,
}

/// Keys in ascending order of frames.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Keys<V>(pub Vec<Key<V>>);

impl<V: Value> Keys<V> {
    /// Returns the first and the last frame, or `None` without keys.
    pub fn range(&self) -> Option<(f64, f64)> {
        Some((self.0.first()?.frame, self.0.last()?.frame))
    }

    /// Returns true where `frame` lies within the first and the last key.
    pub fn covers(&self, frame: f64) -> bool {
        self.range().is_some_and(|(first, last)| first - SAME_FRAME <= frame && frame <= last + SAME_FRAME)
    }

    /// Returns the value at a frame: a key's own at the key, the nearest key's beyond the ends; `None` without keys.
    ///
    /// Between Bezier keys the host decides; a smooth step stands in for it.
    pub fn at(&self, frame: f64) -> Option<V> {
        let after = self.0.partition_point(|key| key.frame <= frame + SAME_FRAME);
        let Some(left) = after.checked_sub(1).and_then(|index| self.0.get(index)) else {
            return self.0.first().map(|key| key.value);
        };
        let Some(right) = self.0.get(after) else { return Some(left.value) };
        let span = right.frame - left.frame;
        if frame - left.frame <= SAME_FRAME || span <= 0.0 {
            return Some(left.value);
        }
        let t = (frame - left.frame) / span;
        Some(match left.interpolation {
            Interpolation::Constant => left.value,
            Interpolation::Linear => left.value.mix(right.value, t),
            Interpolation::Bezier => left.value.mix(right.value, t * t * (3.0 - 2.0 * t)),
        })
    }

    /// Splits off what lies before `start` and after `end`; what lies between is dropped.
    pub fn outside(&self, start: f64, end: f64) -> (&[Key<V>], &[Key<V>]) {
        let before = self.0.partition_point(|key| key.frame < start - SAME_FRAME);
        let after = self.0.partition_point(|key| key.frame <= end + SAME_FRAME);
        (&self.0[..before], &self.0[after.max(before)..])
    }

    /// Puts a key on every whole frame that an easing or a hold leaves open, so that a window sees evenly spaced values.
    pub fn fill_whole_frames(&mut self) {
        let is_open = |pair: &[Key<V>]| pair[1].frame - pair[0].frame > 1.0 + SAME_FRAME;
        if !self.0.windows(2).any(is_open) {
            return;
        }
        let mut filled = Vec::with_capacity(self.0.len());
        for pair in self.0.windows(2) {
            filled.push(Key { interpolation: Interpolation::Linear, ..pair[0] });
            if is_open(pair) {
                filled.extend(whole_frames_between(pair[0].frame, pair[1].frame).filter_map(|frame| {
                    Some(Key { frame, value: self.at(frame)?, interpolation: Interpolation::Linear })
                }));
            }
        }
        filled.extend(self.0.last().copied());
        self.0 = filled;
    }
}

/// Returns the whole frames strictly between two frames.
pub fn whole_frames_between(start: f64, end: f64) -> impl Iterator<Item = f64> {
    let first = (start + SAME_FRAME).floor() as i64 + 1;
    let last = (end - SAME_FRAME).ceil() as i64 - 1;
    (first..=last).map(|frame| frame as f64)
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DVec3;

    fn keys(frames: &[f64], interpolation: Interpolation) -> Keys<DVec3> {
        Keys(frames.iter().map(|&frame| Key { frame, value: DVec3::splat(frame), interpolation }).collect())
    }

    #[test]
    fn a_key_gives_its_own_value_and_the_ends_hold() {
        let keys = keys(&[1.0, 2.0, 4.0], Interpolation::Linear);
        assert_eq!(keys.at(2.0), Some(DVec3::splat(2.0)));
        assert_eq!(keys.at(3.0), Some(DVec3::splat(3.0)));
        assert_eq!((keys.at(-9.0), keys.at(9.0)), (Some(DVec3::splat(1.0)), Some(DVec3::splat(4.0))));
        assert_eq!(Keys::<DVec3>::default().at(1.0), None);
    }

    #[test]
    fn a_constant_key_holds_and_a_bezier_key_eases() {
        assert_eq!(keys(&[0.0, 4.0], Interpolation::Constant).at(3.0), Some(DVec3::ZERO));
        assert_eq!(keys(&[0.0, 4.0], Interpolation::Bezier).at(1.0), Some(DVec3::splat(0.625)));
    }

    #[test]
    fn open_frames_are_filled_with_what_is_seen_there() {
        let mut open = keys(&[1.0, 2.0, 5.5, 6.0], Interpolation::Linear);
        let seen: Vec<_> = [3.0, 4.0, 5.0].map(|frame| open.at(frame)).to_vec();
        open.fill_whole_frames();
        assert_eq!(open.0.iter().map(|key| key.frame).collect::<Vec<_>>(), [1.0, 2.0, 3.0, 4.0, 5.0, 5.5, 6.0]);
        assert_eq!([3.0, 4.0, 5.0].map(|frame| open.at(frame)).to_vec(), seen);
    }

    #[test]
    fn outside_keeps_neither_border() {
        let keys = keys(&[1.0, 2.0, 3.0, 4.0], Interpolation::Linear);
        let (before, after) = keys.outside(2.0, 3.0);
        assert_eq!((before.len(), after.len()), (1, 1));
    }
}
