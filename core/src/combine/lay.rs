//! Lays one track's channel over what that channel held before.

use super::blend::Borders;
use super::place::Placement;
use crate::keys::{whole_frames_between, Interpolation, Key, Keys, SAME_FRAME};
use crate::value::{Blend, EulerFrame, Value};

/// What a track does to one channel.
#[derive(Debug, Clone, PartialEq)]
pub struct Overlay<V> {
    /// The channel with the track in it.
    pub keys: Keys<V>,
    /// First and last frame at which it differs from before.
    pub affected: (f64, f64),
    /// Where old and new meet.
    pub borders: Borders,
}

/// How a track is laid.
#[derive(Debug, Clone, Copy)]
pub struct Manner<'a> {
    /// Where it goes.
    pub track: &'a Placement,
    /// The blend depth that was asked for; `None` is "not set".
    pub blend_depth: Option<u32>,
    /// How rotations are mixed.
    pub blend: Blend,
    /// The Euler angles of the channel's bone.
    pub frame: &'a EulerFrame,
}

/// Lays `new` (a function of file frames) over `old`. Keys outside the affected frames stay what they were.
///
/// Where old and new motion do not touch, the earlier one's last pose holds through the gap; with a blend depth the
/// gap is left to the host's easing.
pub fn lay_over<V: Value>(old: &Keys<V>, new: impl Fn(f64) -> Option<V>, manner: Manner<'_>) -> Overlay<V> {
    let Manner { track, blend_depth, blend, frame } = manner;
    let borders = Borders::find(old.range(), track, blend_depth);
    let (mut start, mut end) = borders.affected(track);
    let grid = track.keys(start, end).into_iter().filter_map(|(at, x)| Some((at, new(x)?)));
    let (frames, mut values): (Vec<f64>, Vec<V>) = grid.unzip();
    let (before, after) = old.outside(start, end);

    if let Some(neighbour) = before.last().or(after.first()) {
        V::go_on_from(&mut values, neighbour.value, frame);
    }
    let weights: Vec<f64> = frames.iter().map(|&at| borders.weight(at, track)).collect();
    crossfade(old, &frames, &mut values, &weights, blend, frame);
    if let Some(neighbour) = before.last() {
        V::go_on_from(&mut values, neighbour.value, frame);
    }

    let mut keys = Vec::with_capacity(before.len() + frames.len() + after.len());
    keys.extend_from_slice(before);
    if let Some(last) = before.last().copied() {
        let first_new = start;
        bridge(&mut keys, last, first_new, blend_depth.is_some(), &mut start);
    }
    keys.extend(frames.into_iter().zip(values).map(|(frame, value)| Key {
        frame,
        value,
        interpolation: Interpolation::Linear,
    }));
    if let (Some(last), Some(next)) = (keys.last().copied(), after.first()) {
        let mut gap_start = last.frame;
        bridge(&mut keys, last, next.frame, blend_depth.is_some(), &mut gap_start);
        if next.frame - last.frame > 1.0 + SAME_FRAME {
            end = next.frame - SAME_FRAME;
        }
        if let Some(seam) = keys.last_mut().filter(|seam| seam.value.is_seam(next.value)) {
            seam.interpolation = Interpolation::Constant;
        }
    }
    keys.extend_from_slice(after);
    Overlay { keys: Keys(keys), affected: (start, end), borders }
}

/// Mixes the old into the new values where the weights ask for it; the others stay.
fn crossfade<V: Value>(
    old: &Keys<V>,
    frames: &[f64],
    values: &mut [V],
    weights: &[f64],
    blend: Blend,
    frame: &EulerFrame,
) {
    let is_mixed = |index: &usize| weights[*index] < 1.0;
    let mut from = 0;
    while let Some(zone_start) = (from..weights.len()).find(is_mixed) {
        let zone_end = (zone_start..weights.len()).find(|index| !is_mixed(index)).unwrap_or(weights.len());
        let zone = zone_start..zone_end;
        let coming = &mut values[zone.clone()];
        let was: Vec<V> =
            frames[zone.clone()].iter().zip(&*coming).map(|(&at, &value)| old.at(at).unwrap_or(value)).collect();
        let mixed = V::crossfade(&was, coming, &weights[zone], blend, frame);
        coming.copy_from_slice(&mixed);
        from = zone_end;
    }
}

/// Closes the gap after `last`, the last key of `keys`, up to the key at `next`.
fn bridge<V: Value>(keys: &mut Vec<Key<V>>, last: Key<V>, next: f64, eases: bool, affected_start: &mut f64) {
    if next - last.frame <= 1.0 + SAME_FRAME {
        return;
    }
    *affected_start = last.frame;
    if eases {
        if let Some(key) = keys.last_mut() {
            key.interpolation = Interpolation::Bezier;
        }
    } else {
        keys.extend(whole_frames_between(last.frame, next).map(|frame| Key {
            frame,
            value: last.value,
            interpolation: Interpolation::Linear,
        }));
    }
}

#[cfg(test)]
mod tests {
    use super::super::place::{KeySpacing, Span};
    use super::*;
    use glam::{DQuat, DVec3};

    fn constant(frames: std::ops::RangeInclusive<i64>, value: f64) -> Keys<DVec3> {
        Keys(
            frames
                .map(|frame| Key {
                    frame: frame as f64,
                    value: DVec3::splat(value),
                    interpolation: Interpolation::Linear,
                })
                .collect(),
        )
    }

    fn place(start: i64, end: i64) -> Placement {
        let span = Span { start: Some(start), end: Some(end) };
        Placement::new((1, 200), span, Span::default(), 1.0, KeySpacing::Frames).unwrap()
    }

    fn lay(old: &Keys<DVec3>, track: &Placement, blend_depth: Option<u32>) -> Overlay<DVec3> {
        let frame = EulerFrame::default();
        let manner = Manner { track, blend_depth, blend: Blend::Slerp, frame: &frame };
        lay_over(old, |x| Some(DVec3::splat(1000.0 + x)), manner)
    }

    fn at(overlay: &Overlay<DVec3>, frame: f64) -> f64 {
        overlay.keys.at(frame).unwrap().x
    }

    #[test]
    fn without_blend_the_new_motion_replaces_the_old_on_its_frames() {
        let laid = lay(&constant(1..=100, 7.0), &place(40, 60), None);
        assert_eq!((laid.affected, laid.keys.0.len()), ((40.0, 60.0), 100));
        assert_eq!([39.0, 40.0, 60.0, 61.0].map(|frame| at(&laid, frame)), [7.0, 1040.0, 1060.0, 7.0]);
    }

    #[test]
    fn keys_outside_the_blend_stay_bit_identical() {
        let old = constant(1..=100, 0.1 + 0.2);
        let laid = lay(&old, &place(40, 60), Some(4));
        assert_eq!(laid.affected, (36.0, 64.0));
        for (was, is) in old.0.iter().zip(&laid.keys.0) {
            assert_eq!(was == is, was.frame < 36.0 || was.frame > 64.0, "frame {}", was.frame);
        }
        assert!((at(&laid, 40.0) - (0.5 * 0.3 + 0.5 * 1040.0)).abs() < 1e-9);
    }

    #[test]
    fn a_gap_holds_the_last_pose_of_the_earlier_motion() {
        let laid = lay(&constant(1..=10, 7.0), &place(15, 20), None);
        assert_eq!([11.0, 12.5, 14.0, 15.0].map(|frame| at(&laid, frame)), [7.0, 7.0, 7.0, 1015.0]);
        let laid = lay(&constant(30..=40, 7.0), &place(15, 20), None);
        assert_eq!([20.0, 21.0, 29.0, 30.0].map(|frame| at(&laid, frame)), [1020.0, 1020.0, 1020.0, 7.0]);
    }

    #[test]
    fn with_a_blend_depth_the_gap_is_left_to_the_hosts_easing() {
        let laid = lay(&constant(1..=10, 7.0), &place(15, 20), Some(5));
        assert_eq!(laid.keys.0[9].interpolation, Interpolation::Bezier);
        assert_eq!(laid.keys.0[10].frame, 15.0);
        assert_eq!(laid.affected, (10.0, 20.0));
    }

    #[test]
    fn a_track_over_nothing_is_just_itself() {
        let laid = lay(&Keys::default(), &place(15, 20), Some(5));
        assert_eq!((laid.affected, laid.keys.0.len(), laid.borders), ((15.0, 20.0), 6, Borders::default()));
    }

    #[test]
    fn rotations_go_on_in_the_hemisphere_of_the_old_motion() {
        let old = Keys(vec![Key { frame: 1.0, value: -DQuat::IDENTITY, interpolation: Interpolation::Linear }]);
        let track = place(2, 4);
        let frame = EulerFrame::default();
        let manner = Manner { track: &track, blend_depth: None, blend: Blend::Slerp, frame: &frame };
        let laid = lay_over(&old, |x| Some(DQuat::from_rotation_x(x * 0.1)), manner);
        assert!(laid.keys.0.windows(2).all(|pair| pair[0].value.dot(pair[1].value) > 0.0));
        assert_eq!(laid.keys.0[0], old.0[0]);
    }

    #[test]
    fn a_seam_in_sign_is_stepped_over_instead_of_turned_through() {
        let old = Keys(
            [(1.0, DQuat::IDENTITY), (9.0, -DQuat::IDENTITY)]
                .map(|(frame, value)| Key { frame, value, interpolation: Interpolation::Linear })
                .to_vec(),
        );
        let track = place(2, 8);
        let frame = EulerFrame::default();
        let manner = Manner { track: &track, blend_depth: None, blend: Blend::Slerp, frame: &frame };
        let laid = lay_over(&old, |_| Some(DQuat::IDENTITY), manner);
        assert_eq!(laid.keys.0[7].interpolation, Interpolation::Constant);
        assert_eq!(laid.keys.0[8], old.0[1]);
    }
}
