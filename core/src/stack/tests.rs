//! The rules of a stack as an animator would state them.

use std::sync::Arc;

use glam::{DQuat, DVec3};
use proptest::prelude::*;

use super::*;
use crate::combine::{Alignment, KeySpacing, Span};
use crate::filter::{Depth, FilterKind};
use crate::motion::{BoneMotion, Motion};
use crate::sample::Sampling;
use crate::skeleton::EulerOrder;
use crate::value::{Blend, EulerFrame, FilterChannels, Turn, Value};

fn rig(bones: usize, rate_hz: f64) -> Rig {
    let bone = |index: usize| RigBone {
        name: format!("bone{index}"),
        parent: index.checked_sub(1),
        rest_rotation: DQuat::from_rotation_x(0.7),
        rest_head: DVec3::new(0.0, 0.0, 1.0),
        mode: Mode::Quaternion,
        angles: EulerFrame::default(),
    };
    Rig { bones: (0..bones).map(bone).collect(), up: DVec3::Z, rate_hz }
}

/// A wavy motion of `bones` bones, frames `first..first + count` at 60 Hz; the root travels.
fn clip(bones: usize, first: i64, count: usize, phase: f64) -> Arc<Source> {
    let bone = |index: usize| {
        let at = |frame: usize| frame as f64 * 0.05 + phase + index as f64;
        let angles: Vec<[f64; 3]> = (0..count).map(|frame| [at(frame).sin(), 0.3 * at(frame).cos(), 0.2]).collect();
        BoneMotion {
            rotations: angles.iter().map(|angles| EulerOrder::Xyz.quat(*angles)).collect(),
            angles,
            translations: if index == 0 {
                (0..count).map(|frame| DVec3::new(0.01 * frame as f64 + phase, at(frame).cos(), 0.2)).collect()
            } else {
                Vec::new()
            },
            stretches: Vec::new(),
        }
    };
    Arc::new(Source::new(Motion {
        bones: (0..bones).map(bone).collect(),
        first_frame: first,
        frame_count: count,
        rate_hz: Some(60.0),
    }))
}

fn track(source: &Arc<Source>) -> Track {
    Track {
        source: Arc::clone(source),
        label: "clip".into(),
        bones: None,
        cut: Span::default(),
        scale: Span::default(),
        blend_depth: None,
        preserve: None,
        discard: false,
        blend: Blend::Slerp,
        sampling: Sampling::Linear,
        spacing: KeySpacing::Frames,
        rate_hz: None,
    }
}

fn span(start: i64, end: i64) -> Span {
    Span { start: Some(start), end: Some(end) }
}

fn filter(kind: FilterKind, depth: usize) -> Entry {
    Entry::Filter(FilterEntry {
        label: "filter".into(),
        bones: None,
        kind,
        depth: Depth::try_from(depth).unwrap(),
        channels: FilterChannels::Rotation,
    })
}

fn find(evaluation: &Evaluation, bone: usize, channel: Channel) -> &ResultChannel {
    evaluation.channels.iter().find(|found| found.bone == bone && found.channel == channel).unwrap()
}

/// Frame and components of one key.
fn key(channel: &ResultChannel, index: usize) -> (f32, Vec<f32>) {
    let row = |component: usize| component * 2 * channel.key_count + 2 * index;
    let components = 0..channel.channel.components();
    (channel.coordinates[row(0)], components.map(|component| channel.coordinates[row(component) + 1]).collect())
}

#[test]
fn the_tutorial_comes_out_as_told() {
    let (step, wave) = (clip(3, 1, 113, 0.0), clip(3, 1, 90, 2.0));
    let legs = Track { bones: Some(vec![0, 1]), ..track(&step) };
    let arms = Track { bones: Some(vec![2]), cut: span(1, 55), scale: span(1, 66), ..track(&wave) };
    let back = Track { bones: Some(vec![2]), cut: span(67, 113), blend_depth: Some(10), ..track(&step) };
    let smooth = FilterEntry {
        label: String::new(),
        bones: Some(vec![2]),
        kind: FilterKind::Weighted,
        depth: Depth::try_from(7).unwrap(),
        channels: FilterChannels::Rotation,
    };
    let entries = [Entry::Track(legs), Entry::Track(arms), Entry::Track(back), Entry::Filter(smooth)];
    let evaluate = |count: usize| evaluate(&rig(3, 60.0), &[], &entries[..count]).unwrap();

    let legs_only = evaluate(1);
    assert_eq!(legs_only.range, Some((1.0, 113.0)));
    assert!(legs_only.channels.iter().all(|channel| channel.bone < 2));

    let with_wave = evaluate(2);
    assert_eq!(find(&with_wave, 2, Channel::RotationQuaternion).key_range(), Some((1.0, 66.0)));

    let joined = evaluate(3);
    let arm = find(&joined, 2, Channel::RotationQuaternion);
    assert_eq!((arm.key_range(), arm.key_count), (Some((1.0, 113.0)), 113));
    assert_eq!(joined.notices, [Notice { entry: 2, text: "Blend depth 10 reduced to 0 after frame 67".into() }]);
    assert_eq!(key(arm, 40), key(find(&with_wave, 2, Channel::RotationQuaternion), 40));

    let filtered = evaluate(4);
    assert_eq!(find(&filtered, 0, Channel::Location), find(&joined, 0, Channel::Location));
    assert_ne!(find(&filtered, 2, Channel::RotationQuaternion), arm);
}

#[test]
fn an_euler_bone_gets_the_files_own_numbers() {
    let mut euler = rig(1, 60.0);
    euler.bones[0].mode = Mode::Euler(EulerOrder::Xyz);
    let source = clip(1, 1, 50, 0.4);
    let evaluation = evaluate(&euler, &[], &[Entry::Track(track(&source))]).unwrap();
    let channel = find(&evaluation, 0, Channel::RotationEuler);
    for (index, angles) in source.motion().bones[0].angles.iter().enumerate() {
        assert_eq!(key(channel, index).1, angles.map(|angle| angle as f32));
    }
}

#[test]
fn another_scene_rate_keeps_the_speed() {
    let source = clip(1, 1, 601, 0.0);
    let evaluation = evaluate(&rig(1, 24.0), &[], &[Entry::Track(track(&source))]).unwrap();
    assert_eq!(evaluation.range, Some((1.0, 241.0)));
    let samples = Track { spacing: KeySpacing::Samples, ..track(&source) };
    let evaluation = evaluate(&rig(1, 24.0), &[], &[Entry::Track(samples)]).unwrap();
    let channel = find(&evaluation, 0, Channel::Location);
    assert_eq!((channel.key_count, channel.key_range()), (601, Some((1.0, 241.0))));
}

#[test]
fn preserving_continues_from_the_old_root_and_moves_what_follows() {
    let rig = rig(1, 60.0);
    let (old, new) = (clip(1, 1, 200, 0.0), clip(1, 1, 50, 1.7));
    let over = Track {
        scale: span(80, 129),
        preserve: Some(Alignment { full_rotation: true, height: true }),
        blend_depth: Some(4),
        ..track(&new)
    };
    let evaluation = evaluate(&rig, &[], &[Entry::Track(track(&old)), Entry::Track(over)]).unwrap();
    assert_eq!(evaluation.notices.len(), 1, "{:?}", evaluation.notices);
    assert!(evaluation.notices[0].text.contains("Blending is off"));
    for channel in [Channel::RotationQuaternion, Channel::Location] {
        let channel = find(&evaluation, 0, channel);
        for (before, after) in [(79, 80), (129, 130)] {
            let (a, b) = (key(channel, before - 1).1, key(channel, after - 1).1);
            let jump: f32 = a.iter().zip(&b).map(|(a, b)| (a - b).abs()).sum();
            assert!(jump < 1e-5, "frame {after}: {a:?} {b:?}");
        }
    }
}

#[test]
fn a_sparse_base_keeps_its_shape_up_to_the_track() {
    let frames: Vec<f64> = (1..=100).map(f64::from).collect();
    let values = frames.iter().flat_map(|frame| [frame.sqrt(), 0.0, 0.0]).collect();
    let is_key = frames.iter().map(|&frame| frame == 1.0 || frame == 100.0).collect();
    let base = BaseChannel { bone: 0, channel: Channel::Location, frames, values, is_key };
    let over = Track { cut: span(40, 60), ..track(&clip(1, 1, 100, 0.0)) };
    let evaluation = evaluate(&rig(1, 60.0), &[base], &[Entry::Track(over)]).unwrap();
    let channel = find(&evaluation, 0, Channel::Location);
    assert_eq!((channel.start, channel.end), (1.0, 99.0));
    assert_eq!(key(channel, 24), (25.0, vec![5.0, 0.0, 0.0]));
    assert_eq!(channel.key_count, 99);
}

#[test]
fn discarding_removes_what_the_bones_had_and_nothing_else() {
    let base = |bone: usize| BaseChannel {
        bone,
        channel: Channel::Location,
        frames: vec![1.0, 200.0],
        values: vec![1.0; 6],
        is_key: Vec::new(),
    };
    let over = Track { bones: Some(vec![1]), discard: true, ..track(&clip(2, 1, 100, 0.0)) };
    let evaluation = evaluate(&rig(2, 60.0), &[base(0), base(1)], &[Entry::Track(over)]).unwrap();
    assert!(evaluation.channels.iter().all(|channel| channel.bone == 1));
    let location = find(&evaluation, 1, Channel::Location);
    assert_eq!((location.key_count, location.start, location.end), (0, 1.0, 200.0));
    assert_eq!(find(&evaluation, 1, Channel::RotationQuaternion).key_count, 100);
}

#[test]
fn bones_without_data_and_unknown_rates_are_said() {
    let mut motion = Motion::clone(clip(2, 1, 10, 0.0).motion());
    motion.bones[1] = BoneMotion::default();
    motion.rate_hz = None;
    let over = Track { bones: Some(vec![1]), ..track(&Arc::new(Source::new(motion))) };
    let evaluation = evaluate(&rig(2, 120.0), &[], &[Entry::Track(over), filter(FilterKind::Median, 3)]).unwrap();
    let texts: Vec<&str> = evaluation.notices.iter().map(|notice| notice.text.as_str()).collect();
    assert_eq!(
        texts,
        [
            "The clip does not say its rate: 120 Hz assumed",
            "The clip has no data for bone1",
            "There is nothing to filter: the bones have no keys"
        ]
    );
}

#[test]
fn a_wrong_cut_names_the_entry() {
    let over = Track { cut: span(50, 40), ..track(&clip(1, 1, 100, 0.0)) };
    let error = evaluate(&rig(1, 60.0), &[], &[Entry::Track(over)]).unwrap_err();
    assert_eq!(error.0, "clip: the cut ends at frame 40, before it starts at frame 50");
}

fn any_entry() -> impl Strategy<Value = Entry> {
    let tracks = (1i64..80, 0i64..60, prop::option::of(1u32..20), any::<[bool; 3]>(), 0.0..6.0f64, 0usize..4).prop_map(
        |(start, len, blend_depth, [preserve, discard, euler], phase, bone)| {
            Entry::Track(Track {
                bones: (bone < 3).then(|| vec![bone]),
                scale: span(start, start + len),
                blend_depth,
                preserve: preserve.then(Alignment::default),
                discard,
                blend: if euler { Blend::Euler } else { Blend::Slerp },
                ..track(&clip(3, 1, 60, phase))
            })
        },
    );
    let filters = (0..3usize, 1usize..5).prop_map(|(kind, half)| {
        filter([FilterKind::Median, FilterKind::Average, FilterKind::Weighted][kind], 2 * half + 1)
    });
    prop_oneof![3 => tracks, 1 => filters]
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn evaluating_again_gives_the_same_bits(entries in prop::collection::vec(any_entry(), 0..5)) {
        let rig = rig(3, 60.0);
        prop_assert_eq!(evaluate(&rig, &[], &entries).unwrap(), evaluate(&rig, &[], &entries).unwrap());
    }

    #[test]
    fn bones_that_no_entry_names_are_not_in_the_result(mut entries in prop::collection::vec(any_entry(), 0..5)) {
        for entry in &mut entries {
            match entry {
                Entry::Track(track) => track.bones = Some(vec![1]),
                Entry::Filter(filter) => filter.bones = Some(vec![1]),
            }
        }
        let evaluation = evaluate(&rig(3, 60.0), &[], &entries).unwrap();
        prop_assert!(evaluation.channels.iter().all(|channel| channel.bone == 1));
    }

    #[test]
    fn every_result_is_finite_sorted_and_of_unit_length(entries in prop::collection::vec(any_entry(), 0..6)) {
        let evaluation = evaluate(&rig(3, 60.0), &[], &entries).unwrap();
        for channel in &evaluation.channels {
            let keys: Vec<_> = (0..channel.key_count).map(|index| key(channel, index)).collect();
            prop_assert!(keys.windows(2).all(|pair| pair[0].0 < pair[1].0));
            prop_assert!(keys.iter().all(|(_, components)| components.iter().all(|value| value.is_finite())));
            if channel.channel == Channel::RotationQuaternion {
                for (_, components) in &keys {
                    let length: f32 = components.iter().map(|value| value * value).sum();
                    prop_assert!((length - 1.0).abs() < 1e-5);
                }
                let linear = |index: usize| channel.interpolation.as_ref().is_none_or(|found| found[index] == 1);
                for (index, pair) in keys.windows(2).enumerate().filter(|(index, _)| linear(*index)) {
                    let dot: f32 = pair[0].1.iter().zip(&pair[1].1).map(|(a, b)| a * b).sum();
                    prop_assert!(dot > -1e-6, "key {}: {:?}", index, pair);
                }
            }
        }
    }

    #[test]
    fn frames_outside_a_track_and_its_blend_are_untouched(
        start in 20i64..80, len in 0i64..40, depth in prop::option::of(1u32..15),
    ) {
        let rig = rig(1, 60.0);
        let below = Entry::Track(track(&clip(1, 1, 150, 0.3)));
        let over = Entry::Track(Track {
            scale: span(start, start + len), blend_depth: depth, ..track(&clip(1, 1, 60, 2.0))
        });
        let was = evaluate(&rig, &[], std::slice::from_ref(&below)).unwrap();
        let is = evaluate(&rig, &[], &[below, over]).unwrap();
        let reach = f64::from(depth.unwrap_or(0));
        for channel in [Channel::RotationQuaternion, Channel::Location] {
            let (was, is) = (find(&was, 0, channel), find(&is, 0, channel));
            prop_assert_eq!(was.key_count, is.key_count);
            for index in 0..was.key_count {
                let (frame, _) = key(was, index);
                let frame = f64::from(frame);
                if frame < start as f64 - reach || frame > (start + len) as f64 + reach {
                    prop_assert_eq!(key(was, index), key(is, index));
                }
            }
        }
    }
}

#[test]
fn angle_by_angle_a_blend_is_one_pose_whether_a_bone_keeps_angles_or_not() {
    let order = EulerOrder::Xyz;
    let between = |a: [f64; 3], b: [f64; 3]| {
        let turn = |angles| Turn { rotation: order.quat(angles), angles };
        turn(a).mix(turn(b), 0.5)
    };
    // Half way between two samples, where the rotation is not that of the angles between.
    let old = [between([0.1, 0.2, 0.3], [0.9, -0.4, 1.2])];
    let new = [between([0.5, 0.1, -0.2], [-0.6, 0.7, 0.4])];
    let frame = EulerFrame { order, ..EulerFrame::default() };
    let kept = Turn::crossfade(&old, &new, &[0.4], Blend::Euler, &frame)[0].rotation;
    let plain = DQuat::crossfade(&[old[0].rotation], &[new[0].rotation], &[0.4], Blend::Euler, &frame)[0];
    assert!(kept.angle_between(plain) < 1e-9, "{kept} {plain}");
}
