//! One rule, one line: the grammar, rows that are no frames, and what channels mean.

use super::*;
use crate::pose::pose;
use glam::{DQuat, DVec3};
use std::f64::consts::FRAC_PI_2;

const HIPS: &str = "HIERARCHY\nROOT Hips\n{\n OFFSET 1 2 3\n CHANNELS 2 Xposition Zrotation\n}\n";

fn angle_between(a: DQuat, b: DQuat) -> f64 {
    2.0 * (a.conjugate() * b).xyz().length()
}

/// A root with these lines in it, and a motion of these rows.
fn file(body: &str, rows: &str) -> String {
    format!("HIERARCHY\nROOT Hips\n{{\n{body}\n}}\nMOTION\nFrames: 1\nFrame Time: 0.1\n{rows}\n")
}

fn parse(text: &str) -> Bvh {
    Bvh::parse(text.as_bytes()).unwrap_or_else(|error| panic!("{error}\n{text}"))
}

fn message(text: &str) -> String {
    Bvh::parse(text.as_bytes()).expect_err(text).to_string()
}

fn rows_of(text: &str) -> Vec<f64> {
    parse(text).motion.expect("a motion").values
}

fn notices_of(text: &str) -> Vec<String> {
    parse(text).notices()
}

#[test]
fn broken_files_are_met_with_place_and_words() {
    let table = [
        ("", "line 1, column 1: expected a BVH motion (.bvh), found an empty file"),
        ("HIERARCHY", "line 1, column 10: expected `ROOT`, found the end of the file"),
        ("HIERARCHY\nMOTION", "line 2, column 1: expected `ROOT`, found `MOTION`"),
        ("ROOT a { OFFSET 0 0 0 }", "line 1, column 1: expected `HIERARCHY`, found `ROOT`"),
        ("HIERARCHY\nROOT a\nOFFSET", "line 3, column 1: expected `{`, found `OFFSET`"),
        ("HIERARCHY\nROOT a\n{\n}", "line 4, column 1: expected `OFFSET` in joint `a`, found `}`"),
        (
            "HIERARCHY\nROOT a\n{\nOFFSET 0 0 0\n",
            "line 5, column 1: expected `OFFSET`, `CHANNELS`, `JOINT`, `End Site` or `}` in joint `a`, found the end of the file",
        ),
        (
            "HIERARCHY\nROOT a\n{\nOFFSET 0 0 0\nJIONT b",
            "line 5, column 1: expected `OFFSET`, `CHANNELS`, `JOINT`, `End Site` or `}` in joint `a`, found `JIONT`",
        ),
        ("HIERARCHY\nROOT a\n{\nOFFSET 0 x 0", "line 4, column 10: expected a number for `OFFSET` of `a`, found `x`"),
        (
            "HIERARCHY\nROOT a\n{\nOFFSET 0 nan 0",
            "line 4, column 10: expected a number for `OFFSET` of `a`, a finite number, found `nan`",
        ),
        (
            "HIERARCHY\nROOT a\n{\nOFFSET 0 0 0\nOFFSET 0 0 0",
            "line 5, column 1: expected one `OFFSET` in joint `a`, found a second one",
        ),
        (
            "HIERARCHY\nROOT a\n{\nCHANNELS 1 Xrotatoin",
            "line 4, column 12: expected a channel such as `Xrotation`, found `Xrotatoin`",
        ),
        (
            "HIERARCHY\nROOT a\n{\nCHANNELS 3 Xrotation\nYrotation",
            "line 5, column 10: expected a channel such as `Xrotation`, found the end of the file",
        ),
        (
            "HIERARCHY\nROOT a\n{\nCHANNELS 4000000000 Xrotation",
            "line 4, column 30: expected a channel such as `Xrotation`, found the end of the file",
        ),
        (
            "HIERARCHY\nROOT a\n{\nCHANNELS 1 Xrotation Yrotation",
            "line 4, column 22: expected 1 channels, as the line says, and no more, found `Yrotation`",
        ),
        ("HIERARCHY\nROOT a\n{\nCHANNELS -1", "line 4, column 10: expected the number of channels, found `-1`"),
        (
            "HIERARCHY\nROOT a\n{\nEnd Site\n{\nOFFSET 0 0 0\nJOINT",
            "line 7, column 1: expected `}`, found `JOINT`",
        ),
        ("HIERARCHY\nROOT a\n{\nOFFSET 0 0 0\n}\n}", "line 6, column 1: expected `ROOT`, `MOTION` or the end of the file, found `}`"),
        (&format!("{HIPS}MOTION\nFrames: many"), "line 8, column 9: expected a whole number of frames, found `many`"),
        (&format!("{HIPS}MOTION\nFrames: 1.5"), "line 8, column 9: expected a whole number of frames, found `1.5`"),
        (
            &format!("{HIPS}MOTION\nFrames: 1\nFrame Time: fast"),
            "line 9, column 13: expected a number of seconds for `Frame Time`, found `fast`",
        ),
        (
            &format!("{HIPS}MOTION\nFrames: 2\nFrame Time: 1\n1 2\n3 4,5\n"),
            "line 11, column 3: expected a number for `Zrotation` of joint `Hips`, found `4,5`",
        ),
        (
            &format!("{HIPS}MOTION\nFrames: 1\nFrame Time: 1\nnan 2\n"),
            "line 10, column 1: expected a number for `Xposition` of joint `Hips`, a finite number, found `nan`",
        ),
    ];
    for (text, expected) in table {
        assert_eq!(message(text), expected, "{text}");
    }
}

#[test]
fn a_hierarchy_is_read_however_it_is_laid_out() {
    let plain = parse("HIERARCHY\nROOT a b\n{\nOFFSET 1 2 3\nCHANNELS 1 Xrotation\nEnd Site\n{\nOFFSET 4 5 6\n}\n}\n");
    for text in [
        "\u{feff}HIERARCHY\r\nROOT a b\r\n{\r\n\tOFFSET\t1 2 3\r\n\tCHANNELS 1 Xrotation\r\n\tEnd Site\r\n\t{\r\n\t\tOFFSET 4 5 6\r\n\t}\r\n}",
        "HIERARCHY ROOT a b { OFFSET 1 2 3 CHANNELS 1 Xrotation End Site { OFFSET 4 5 6 } }",
        "hierarchy\nroot a b{\nchannels 1 XROTATION\noffset 1.0 2e0 .3e1\nEND SITE{offset 4 5 6}}",
        "HIERARCHY\rROOT a b\r{\rOFFSET 1\r2\r3\rCHANNELS 1\rXrotation\rEnd\rSite\r{\rOFFSET 4 5 6\r}\r}\r",
        "\n\nHIERARCHY\n\n\nROOT   a b  \n\n{ End Site { OFFSET 4 5 6 } OFFSET 1 2 3 CHANNELS 1 Xrotation }\n\n",
    ] {
        assert_eq!(parse(text), plain, "{text}");
    }
}

#[test]
fn a_file_may_hold_several_roots_and_any_channels() {
    let bvh = parse(
        "HIERARCHY ROOT a\n{ OFFSET 0 0 0 CHANNELS 0 End tip\n{ OFFSET 0 1 0 } JOINT b\n{ OFFSET 0 0 0 } \
         End Site tip 2\n{ OFFSET 0 2 0 } } ROOT c\n{ OFFSET 0 0 0 \
         CHANNELS 7 Zrotation Xposition Zrotation Yrotation Xposition Zposition Yposition }",
    );
    let names: Vec<_> = bvh.joints.iter().map(|joint| (joint.name.as_str(), joint.parent)).collect();
    assert_eq!(names, [("a", None), ("b", Some(0)), ("c", None)]);
    let ends: Vec<_> = bvh.joints[0].end_sites.iter().map(|end| (end.name.as_str(), end.offset[1])).collect();
    assert_eq!(ends, [("tip", 1.0), ("tip 2", 2.0)]);
    assert_eq!((bvh.width(), bvh.joints[2].channels[0]), (7, Channel::Rotation(2)));
    assert_eq!(bvh.motion, None);
    assert_eq!(bvh.notices(), ["The file holds a hierarchy and no motion"]);
}

#[test]
fn the_lines_before_the_values_may_be_spaced_in_any_way() {
    for head in [
        "Frames: 2\nFrame Time: 0.5",
        "FRAMES:2\r\nFRAME TIME:0.5\r",
        "Frames :\t2\n\n  Frame   Time\t:\t.5\t",
        "Frame Time: 5e-1\nFrames: 2.0",
        "frames 2 frametime 0.5",
        "Frames:\n2\nFrame Time:\n0.5",
    ] {
        let bvh = parse(&format!("{HIPS}MOTION\n{head}\n1 2\n3 4\n"));
        let motion = bvh.motion.clone().expect("a motion");
        assert_eq!((motion.frame_count, motion.frame_time_s), (2, Some(0.5)), "{head}");
        assert_eq!((motion.values, bvh.notices()), (vec![1.0, 2.0, 3.0, 4.0], vec![]), "{head}");
    }
}

#[test]
fn a_frame_time_that_is_none_is_no_rate() {
    for (head, said, rate, notice) in [
        ("Frame Time: 0", Some(0.0), None, "A frame time of 0 s is none: the rate is not known"),
        ("Frame Time: -1", Some(-1.0), None, "A frame time of -1 s is none: the rate is not known"),
        ("Frame Time: 1e-9", Some(1e-9), None, "A frame time of 0.000000001 s is none: the rate is not known"),
        ("Frame Time:", None, None, "The file does not say its frame time: the rate is not known"),
        ("", None, None, "The file does not say its frame time: the rate is not known"),
        ("Frame Time: 30", Some(30.0), Some(30.0), "A frame time of 30 s is taken as 30 frames per second"),
    ] {
        let bvh = parse(&format!("{HIPS}MOTION\nFrames: 2\n{head}\n1 2\n3 4\n"));
        let motion = bvh.motion.as_ref().expect("a motion");
        assert_eq!((motion.frame_time_s, motion.rate_hz()), (said, rate), "{head}");
        assert_eq!(bvh.motion().and_then(|motion| motion.rate_hz), rate, "{head}");
        assert_eq!(bvh.notices(), [notice], "{head}");
    }
}

#[test]
fn rows_are_lines_or_else_values_one_after_the_other() {
    for (rows, values, notice) in [
        ("1 2\n3 4", "1 2 3 4", "The file says `Frames: 1` but holds 2: these are used"),
        ("  1\t2  \n\n\n3 4\n\n", "1 2 3 4", "The file says `Frames: 1` but holds 2: these are used"),
        ("1\n2\n3\n4", "1 2 3 4", "The file says `Frames: 1` but holds 2: these are used"),
        ("1 2 3 4", "1 2 3 4", "The file says `Frames: 1` but holds 2: these are used"),
        ("", "", "The file says `Frames: 1` but holds 0: these are used"),
        ("1 2\n3", "1 2", "The last frame holds 1 of its 2 values and is left out"),
        ("1\n", "", "The last frame holds 1 of its 2 values and is left out"),
        (
            "1 2\n3 4\n5\n6 7\n8 9",
            "1 2 3 4 3 4 6 7 8 9",
            "Line 12 holds 1 of the 2 values of a frame: the frame before it is shown instead",
        ),
        (
            "1\n6 7\n8 9",
            "0 0 6 7 8 9",
            "Line 10 holds 1 of the 2 values of a frame: the frame before it is shown instead",
        ),
        ("1 2\n3 4 5\n6 7", "1 2 3 4 6 7", "Line 11 holds 3 values where a frame has 2: those behind are left out"),
        (
            "1 2\n3 4 5\n6 7\n8 9 9\n1 1",
            "1 2 3 4 6 7 8 9 1 1",
            "Line 11 (and another like it) holds 3 values where a frame has 2: those behind are left out",
        ),
    ] {
        let text = format!("{HIPS}MOTION\nFrames: 1\nFrame Time: 1\n{rows}");
        let values: Vec<f64> = values.split_whitespace().filter_map(|word| word.parse().ok()).collect();
        assert_eq!(rows_of(&text), values, "{rows}");
        assert!(notices_of(&text).iter().any(|found| found == notice), "{rows}: {:?}", notices_of(&text));
    }
    assert_eq!(
        notices_of(&format!("{HIPS}MOTION\nFrame Time: 1\n1 2")),
        ["The file does not say how many frames it has: it holds 1"]
    );
    assert_eq!(notices_of(&format!("{HIPS}MOTION\nFrames: 1\nFrame Time: 1\n1 2")), [""; 0]);
    let without_channel = "There are values, but no joint has a channel for them: they are left out";
    assert_eq!(notices_of(&file("OFFSET 0 0 0", "1"))[1], without_channel);
}

#[test]
fn a_file_of_many_rows_is_read_on_all_threads_as_on_one() {
    let rows: String =
        (0..60_000).map(|i| format!("{}.25 -{i}\n{}", i % 7, if i % 1000 == 0 { "\n" } else { "" })).collect();
    let expected: Vec<f64> = (0..60_000).flat_map(|i| [f64::from(i % 7) + 0.25, -f64::from(i)]).collect();
    assert_eq!(rows_of(&format!("{HIPS}MOTION\nFrames: 60000\nFrame Time: 1\n{rows}")), expected);
}

#[test]
fn rotations_compose_in_the_order_of_the_channels() {
    let [x, y, z] = DVec3::AXES.map(|axis| move |degrees: f64| DQuat::from_axis_angle(axis, degrees.to_radians()));
    let table: [(&str, &str, DQuat, Option<[f64; 3]>); 6] = [
        ("3 Zrotation Xrotation Yrotation", "10 20 30", z(10.0) * x(20.0) * y(30.0), Some([20.0, 30.0, 10.0])),
        ("3 Xrotation Yrotation Zrotation", "10 20 30", x(10.0) * y(20.0) * z(30.0), Some([10.0, 20.0, 30.0])),
        ("2 Yrotation Xrotation", "10 20", y(10.0) * x(20.0), Some([20.0, 10.0, 0.0])),
        ("1 Zrotation", "10", z(10.0), Some([0.0, 0.0, 10.0])),
        ("3 Xrotation Yrotation Xrotation", "10 20 30", x(10.0) * y(20.0) * x(30.0), None),
        (
            "4 Xrotation Yposition Zrotation Yrotation",
            "10 5 20 30",
            x(10.0) * z(20.0) * y(30.0),
            Some([10.0, 30.0, 20.0]),
        ),
    ];
    for (channels, row, expected, angles) in table {
        let bvh = parse(&file(&format!("OFFSET 0 0 0\nCHANNELS {channels}"), row));
        let motion = bvh.motion().expect("a motion");
        assert!(angle_between(motion.bones[0].rotations[0], expected) < 1e-12, "{channels}");
        let degrees = motion.bones[0].angles.first().map(|angles| angles.map(|angle| angle.to_degrees().round()));
        assert_eq!(degrees, angles, "{channels}");
        let order = bvh.skeleton().bones[0].order;
        assert!(motion.bones[0].angles.iter().all(|angles| angle_between(order.quat(*angles), expected) < 1e-12));
    }
}

#[test]
fn a_rotation_about_an_axis_that_the_bone_lacks_is_written_too() {
    let bvh = parse(&file("OFFSET 0 0 0\nCHANNELS 2 Zrotation Xrotation", "0 0"));
    let (skeleton, mut motion) = (bvh.skeleton(), bvh.motion().expect("a motion"));
    let blended = [0.3, 0.2, -0.4];
    motion.bones[0].rotations = vec![skeleton.bones[0].order.quat(blended)];
    motion.bones[0].angles = vec![blended];
    let written = Bvh::from_motion(&skeleton, &motion);
    assert_eq!(written.joints[0].channels.iter().filter(|channel| matches!(channel, Channel::Rotation(_))).count(), 3);
    let back = written.motion().expect("a motion").bones[0].rotations[0];
    assert!(angle_between(back, motion.bones[0].rotations[0]) < 1e-9);
}

#[test]
fn a_position_stands_in_for_its_part_of_the_offset() {
    let body =
        "OFFSET 1 2 3\nCHANNELS 1 Zrotation\nJOINT b\n{\nOFFSET 4 5 6\nCHANNELS 3 Yposition Xrotation Yposition\n}";
    let bvh = parse(&file(body, "90 100 0 7"));
    let (skeleton, motion) = (bvh.skeleton(), bvh.motion().expect("a motion"));
    assert_eq!(motion.bones[1].translations, [DVec3::new(0.0, 2.0, 0.0)]);
    let heads = pose(&skeleton, &motion, 1.0).heads;
    let expected = DVec3::new(1.0, 2.0, 3.0) + DQuat::from_rotation_z(FRAC_PI_2) * DVec3::new(4.0, 7.0, 6.0);
    assert!((heads[1] - expected).length() < 1e-12, "{heads:?}");
    assert_eq!((motion.first_frame, motion.frame_count, motion.rate_hz), (1, 1, Some(10.0)));
}

#[test]
fn a_bone_ends_at_its_end_site_or_where_its_children_start() {
    let joint = |name: &str, x: f64, y: f64, inner: &str| format!("JOINT {name}\n{{\nOFFSET {x} {y} 0\n{inner}\n}}\n");
    let leg = |x: f64| joint("leg", x, -1.0, "End Site\n{\nOFFSET 0 -9 0\n}");
    let spine = joint("spine", 0.0, 2.0, &joint("chest", 0.0, 0.0, &joint("head", 0.0, 1.0, "")));
    let hips = joint("hips", 0.0, 0.0, &(leg(1.0) + &leg(-1.0) + &spine));
    let bvh = parse(&format!("HIERARCHY\nROOT root\n{{\nOFFSET 0 0 0\n{hips}\n}}"));
    let tails: Vec<_> = bvh.skeleton().bones.iter().map(|bone| (bone.name.clone(), bone.tail.y)).collect();
    let expected =
        [("root", 0.0), ("hips", 2.0), ("leg", -9.0), ("leg.001", -9.0), ("spine", 0.0), ("chest", 1.0), ("head", 0.0)];
    assert_eq!(tails, expected.map(|(name, y)| (name.to_owned(), y)));
    let both = parse("HIERARCHY\nROOT a\n{\nOFFSET 0 0 0\nJOINT b\n{\nOFFSET 0 0 2\n}\nJOINT c\n{\nOFFSET 0 2 0\n}\n}");
    assert_eq!(both.skeleton().bones[0].tail, DVec3::new(0.0, 1.0, 1.0));
}

#[test]
fn joints_of_one_name_are_kept_apart_and_named_to_the_user() {
    let joints: String = (0..8).map(|_| "JOINT a\n{\nOFFSET 0 0 0\n}\n").collect();
    let bvh = parse(&format!("HIERARCHY\nROOT a\n{{\nOFFSET 0 0 0\n{joints}}}"));
    let notice = "Joints whose name is missing or not the only one of its kind are called a.001, a.002, a.003, a.004, a.005 and 3 more";
    assert_eq!(bvh.notices()[0], notice);
    assert_eq!(bvh.skeleton().bones[8].name, "a.008");
    assert!(bvh.joints.iter().all(|joint| joint.name == "a"));
}

#[test]
fn names_in_old_encodings_survive() {
    let bvh = Bvh::parse(b"HIERARCHY\nROOT H\xFCfte\n{\nOFFSET 0 0 0\n}\n").expect("Latin-1");
    assert_eq!(bvh.joints[0].name, "H\u{fc}fte");
    assert_eq!(Bvh::parse(&bvh.to_bytes()), Ok(bvh));
}
