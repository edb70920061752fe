use super::*;
use crate::figure::tests::{legs, markers, walk};
use glam::{DQuat, DVec3};
use motion_theater_core::{Bone, BoneMotion, Motion};
use proptest::prelude::*;

/// Stands for two seconds, and then swings its left leg for one. It has the head that `legs` lack, for the height.
fn kick() -> Motion {
    let angle = |frame: usize| (frame as f64 - 120.0).max(0.0) / 60.0;
    let rotations = (0..180).map(|frame| DQuat::from_rotation_x(-1.5 * angle(frame))).collect();
    let mut bones = vec![BoneMotion::default(); 8];
    bones[2].rotations = rotations;
    Motion { bones, first_frame: 1, frame_count: 180, rate_hz: Some(60.0) }
}

fn still(preview: &Preview) -> Frames {
    unpack(&preview.still, 1).unwrap()
}

fn strip(preview: &Preview) -> Frames {
    unpack(&preview.strip, preview.strip_frames as usize).unwrap()
}

/// Returns where on the picture something of a colour is, mostly, and how many pixels there are.
fn find(frames: &Frames, colour: [u8; 3]) -> ([f64; 2], usize) {
    let is_near = |pixel: &[u8]| pixel[3] > 200 && (0..3).all(|part| pixel[part].abs_diff(colour[part]) < 24);
    let pixels = frames.rgba.chunks_exact(4).take(frames.width * frames.height).enumerate();
    let places: Vec<[f64; 2]> = pixels
        .filter(|(_, pixel)| is_near(pixel))
        .map(|(at, _)| [(at % frames.width) as f64, (at / frames.width) as f64])
        .collect();
    let mean = |axis: usize| places.iter().map(|place| place[axis]).sum::<f64>() / places.len() as f64;
    ([mean(0), mean(1)], places.len())
}

const BLUE: [u8; 3] = [79, 160, 255];
const ORANGE: [u8; 3] = [255, 138, 56];

fn is_empty(frames: &Frames) -> bool {
    frames.rgba.chunks_exact(4).all(|pixel| pixel[3] == 0)
}

#[test]
fn a_figure_is_drawn_upright_within_the_picture() {
    let (mut skeleton, motion) = (legs(), kick());
    let head = Bone { name: "Head".to_owned(), offset: DVec3::Y * 60.0, ..skeleton.bones[6].clone() };
    skeleton.bones.push(head);
    let picture = still(&draw(&Actor::of_skeleton(&skeleton, Some(&motion))));
    assert_eq!((picture.width, picture.height), (SIZE, SIZE));
    let opaque = |at: usize| picture.rgba[at * 4 + 3] > 200;
    let edge = (0..SIZE).flat_map(|i| [i, (SIZE - 1) * SIZE + i, i * SIZE, i * SIZE + SIZE - 1]);
    assert!(edge.into_iter().all(|at| !opaque(at)), "nothing is cut off");
    let rows: Vec<usize> = (0..SIZE).filter(|y| (0..SIZE).any(|x| opaque(y * SIZE + x))).collect();
    assert!(rows.len() > SIZE * 3 / 4, "it fills the picture: {} rows", rows.len());
    let ([_, grey], count) = find(&picture, [205, 205, 205]);
    let ([_, orange], _) = find(&picture, ORANGE);
    assert!(count > 10 && grey < orange, "the trunk is above the legs");
}

#[test]
fn left_is_blue_and_right_is_orange_seen_from_the_front() {
    let skeleton = legs();
    let picture = still(&draw(&Actor::of_skeleton(&skeleton, None)));
    let ([left, _], left_count) = find(&picture, BLUE);
    let ([right, _], right_count) = find(&picture, ORANGE);
    assert!(left_count > 50 && right_count > 50);
    assert!(left > right + 5.0, "who looks at the viewer has the left at the viewer's right");
}

#[test]
fn the_still_is_the_height_of_the_move_and_frames_of_the_strip_differ() {
    let (skeleton, motion) = (legs(), kick());
    let preview = draw(&Actor::of_skeleton(&skeleton, Some(&motion)));
    assert!(preview.frame > 160, "frame {}", preview.frame);
    let frames = strip(&preview);
    let size = frames.rgba.len() / frames.count;
    let picture = |index: usize| &frames.rgba[index * size..(index + 1) * size];
    assert_eq!(picture(0), picture(1), "it stands");
    assert_ne!(picture(frames.count - 2), picture(frames.count - 1), "it kicks");
}

#[test]
fn a_strip_lasts_three_seconds_at_the_speed_of_the_clip() {
    let (skeleton, mut motion) = (legs(), walk(2000));
    for (rate_hz, expected_hz) in [(120.0, 12.0), (30.0, 15.0), (100.0, 12.5), (10.0, 10.0)] {
        motion.rate_hz = Some(rate_hz);
        let preview = draw(&Actor::of_skeleton(&skeleton, Some(&motion)));
        assert_eq!(preview.strip_rate_hz, expected_hz);
        let seconds = f64::from(preview.strip_frames) / expected_hz;
        assert!((2.9..3.1).contains(&seconds), "{seconds} s at {rate_hz} Hz");
    }
    let mut short = walk(30);
    short.rate_hz = Some(30.0);
    assert_eq!(draw(&Actor::of_skeleton(&skeleton, Some(&short))).strip_frames, 15);
}

#[test]
fn the_liveliest_part_of_a_long_clip_is_shown() {
    // Half a minute of waiting, in the middle of which it kicks for a second.
    let mut motion = kick();
    let swing = |frame: usize| if (900..960).contains(&frame) { (frame as f64 * 0.3).sin() } else { 0.0 };
    motion.bones[2].rotations = (0..1800).map(|frame| DQuat::from_rotation_x(swing(frame))).collect();
    motion.frame_count = 1800;
    let skeleton = legs();
    let preview = draw(&Actor::of_skeleton(&skeleton, Some(&motion)));
    assert!((900..=960).contains(&preview.frame), "frame {}", preview.frame);
}

#[test]
fn a_first_frame_with_the_arms_held_out_is_not_shown() {
    let mut motion = kick();
    let angle = |frame: usize| if frame == 0 { 3.0 } else { 0.3 * (frame as f64 / 20.0).sin() };
    motion.bones[2].rotations = (0..180).map(|frame| DQuat::from_rotation_x(angle(frame))).collect();
    let skeleton = legs();
    let preview = draw(&Actor::of_skeleton(&skeleton, Some(&motion)));
    assert_ne!(preview.frame, 1);
}

#[test]
fn the_camera_follows_who_goes_far() {
    let (skeleton, mut motion) = (legs(), walk(180));
    motion.bones[0].translations = (0..180).map(|frame| DVec3::Z * 10.0 * f64::from(frame)).collect();
    let near = strip(&draw(&Actor::of_skeleton(&skeleton, Some(&motion))));
    let standing = strip(&draw(&Actor::of_skeleton(&skeleton, Some(&kick()))));
    let (_, walking) = find(&near, ORANGE);
    let (_, standing) = find(&standing, ORANGE);
    assert!(walking * 2 > standing, "it is not much smaller: {walking} and {standing} pixels");
}

#[test]
fn markers_are_drawn_and_a_stray_one_does_not_make_them_small() {
    let still_at = |x: f64, y: f64, z: f64| vec![[x, y, z]; 20];
    let names = ["LA", "LB", "RA", "RB", "HEAD", "C"];
    let body = [
        still_at(0.3, 0.01, 0.1),
        still_at(0.3, 0.01, 0.9),
        still_at(-0.3, 0.01, 0.1),
        still_at(-0.3, 0.01, 0.9),
        still_at(0.01, 0.0, 1.7),
        still_at(0.01, 0.0, 1.4),
    ];
    let whole = still(&draw(&Actor::of_markers(&markers(&names, &body))));
    let (_, blue) = find(&whole, BLUE);
    assert!(blue > 20, "{blue}");
    let with_stray: Vec<_> = body.iter().cloned().chain([still_at(40.0, 3.0, 9.0)]).collect();
    let names = ["LA", "LB", "RA", "RB", "HEAD", "C", "*7"];
    let (_, with_stray) = find(&still(&draw(&Actor::of_markers(&markers(&names, &with_stray)))), BLUE);
    assert!(with_stray * 3 > blue * 2, "{with_stray} of {blue} pixels");
}

#[test]
fn of_what_is_not_seen_there_is_an_empty_picture() {
    let gaps = markers(&["A", "B"], &[vec![[f64::NAN; 3]; 40], vec![[f64::NAN; 3]; 40]]);
    for markers in [markers(&[], &[]), gaps] {
        let preview = draw(&Actor::of_markers(&markers));
        assert!(is_empty(&still(&preview)) && is_empty(&strip(&preview)));
    }
}

#[test]
fn a_single_point_is_drawn_as_a_dot() {
    for place in [[0.1, 0.0, 1.0], [1e30, -1e30, 1e30]] {
        let one = markers(&["A"], &[vec![place; 3]]);
        let preview = draw(&Actor::of_markers(&one));
        assert!(!is_empty(&still(&preview)), "{place:?}");
    }
}

#[test]
fn more_bones_than_anybody_has_are_drawn_in_part() {
    let mut skeleton = legs();
    let last = skeleton.bones[5].clone();
    skeleton.bones.extend((8..40_000).map(|index| Bone { parent: Some(index - 1), ..last.clone() }));
    assert!(!is_empty(&still(&draw(&Actor::of_skeleton(&skeleton, None)))));
}

/// A coordinate as no laboratory has it, but a file may.
fn coordinate() -> impl Strategy<Value = f64> {
    prop_oneof![-2.0..2.0, Just(f64::NAN), Just(f64::INFINITY), -1e300..1e300, -1e-300..1e-300, Just(1e38)]
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(48))]
    #[test]
    fn whatever_the_numbers_are_there_are_pictures(
        trajectories in prop::collection::vec(prop::collection::vec([coordinate(), coordinate(), coordinate()], 5), 1..6),
        rate_hz in prop_oneof![Just(None), (1e-300..1e300_f64).prop_map(Some), (1.0..200.0_f64).prop_map(Some)],
    ) {
        let names: Vec<&str> = ["LA", "RA", "HEAD", "B", "C"].into_iter().take(trajectories.len()).collect();
        let mut markers = markers(&names, &trajectories);
        markers.rate_hz = rate_hz;
        let preview = draw(&Actor::of_markers(&markers));
        prop_assert_eq!(still(&preview).rgba.len(), SIZE * SIZE * 4);
        prop_assert_eq!(strip(&preview).count, preview.strip_frames as usize);
    }
}
