//! Rules of the format, a line or two each, and the messages for files that break them.

use super::*;
use crate::error::Position;
use crate::formats::asf::Asf;
use crate::skeleton::Skeleton;
use glam::{DQuat, DVec3};

const SMALL: &str = "#!OML:ASF C:\\takes\\small one.ASF\n:FULLY-SPECIFIED\n:DEGREES\n:SAMPLES-PER-SECOND 120\n\
    1\nroot 1 2 3 4 5 6\nthigh 10 20 30\nshin 40\n2\nroot -1 .5 3. +4 5e0 6E-1\nthigh 11 21 31\nshin 41\n";

fn parsed(text: &str) -> Amc {
    Amc::parse(text.as_bytes()).unwrap_or_else(|error| panic!("{error} in\n{text}"))
}

/// A thigh with `rx ry rz`, a shin with `rx`, and whatever else is given.
fn skeleton(more: &str) -> Skeleton {
    let bone = |name: &str, fields: &str| format!("begin\nname {name}\ndirection 0 -1 0\nlength 7\n{fields}\nend\n");
    let bones = bone("thigh", "axis 0 0 90 XYZ\ndof rx ry rz") + &bone("shin", "dof rx") + &bone("foot", more);
    let text = format!(":bonedata\n{bones}:hierarchy\nroot thigh\nthigh shin\nshin foot\n");
    Asf::parse(text.as_bytes()).unwrap().skeleton()
}

#[test]
fn header_and_frames_are_read() {
    let amc = parsed(SMALL);
    assert_eq!(amc.header.skeleton_hint.as_deref(), Some("C:\\takes\\small one.ASF"));
    assert!(amc.header.is_fully_specified && !amc.header.is_forced_to_3dof);
    assert_eq!((amc.header.angle, amc.header.rate_hz), (Some(AngleUnit::Degrees), Some(120.0)));
    assert_eq!((amc.first_frame, amc.frame_count, amc.width()), (1, 2, 10));
    assert_eq!(amc.values[10..], [-1.0, 0.5, 3.0, 4.0, 5.0, 0.6, 11.0, 21.0, 31.0, 41.0]);
    assert!(amc.notices().is_empty());
}

#[test]
fn layout_does_not_matter() {
    let wanted = parsed(SMALL);
    let layouts = [
        SMALL.replace('\n', "\r\n"),
        SMALL.replace('\n', "\r"),
        SMALL.replace("thigh ", " \tthigh\t  "),
        SMALL.replace('\n', "  \n").replace("one.ASF  ", "one.ASF"),
        SMALL.replace("shin", "# a comment\n\nshin"),
        SMALL.replace("31\n", "31 # a comment\n"),
        SMALL.trim_end().to_owned(),
        format!("\u{FEFF}{SMALL}"),
        SMALL.replace(":DEGREES", ":degrees").replace(":FULLY-SPECIFIED\n", "") + "\n\n",
        SMALL.replace("thigh 11 21 31\nshin 41\n", "shin 41\nthigh 11 21 31\n"),
        SMALL.replace("\n2\n", "\n+2\n"),
    ];
    for layout in layouts {
        let mut amc = parsed(&layout);
        amc.header.is_fully_specified = true;
        assert_eq!(amc, wanted, "{layout}");
    }
}

#[test]
fn header_keywords_come_in_any_order_and_unknown_ones_are_kept() {
    let amc = parsed(":SAMPLES-PER-SECOND 59.94\n:STYLE  brisk walk\n:FORCE-ALL-JOINTS-BE-3DOF\n:RADIANS\n1\nroot 1\n");
    assert_eq!((amc.header.rate_hz, amc.header.angle), (Some(59.94), Some(AngleUnit::Radians)));
    assert_eq!(
        (amc.header.is_forced_to_3dof, amc.header.others.as_slice()),
        (true, &[":STYLE  brisk walk".to_owned()][..])
    );
    assert_eq!(Amc::parse(&amc.to_bytes()), Ok(amc));
}

#[test]
fn frame_numbers_may_begin_anywhere_and_odd_ones_are_kept_with_a_notice() {
    let frames = |numbers: &[i64]| numbers.iter().map(|n| format!("{n}\nroot 1\n")).collect::<Vec<_>>().concat();
    for numbers in [[0, 1, 2], [-1, 0, 1], [244, 245, 246]] {
        let amc = parsed(&(":DEGREES\n".to_owned() + &frames(&numbers)));
        assert_eq!((amc.first_frame, amc.frame_numbers.len(), amc.notices().len()), (numbers[0], 0, 0));
    }
    let amc = parsed(&(":DEGREES\n".to_owned() + &frames(&[7, 8, 10])));
    assert_eq!((amc.first_frame, amc.frame_numbers.as_slice()), (7, &[7, 8, 10][..]));
    let notice =
        "Frame numbers do not ascend by one (after 8 comes 10): the 3 frames are taken one after the other from 7";
    assert_eq!(amc.notices(), [notice]);
    assert_eq!(Amc::parse(&amc.to_bytes()), Ok(amc));
}

#[test]
fn a_long_file_on_several_threads_is_what_the_clear_version_reads() {
    let frame = |n: i64| format!("{n}\nroot {n}.5 -2 1e-3\nlthumb 7\n");
    let text = (5..60_000).map(frame).collect::<String>();
    // A blank line is enough to leave the fast version.
    let clear = |text: &str| Amc::parse(format!(":DEGREES\n{}", text.replacen("6\n", "6\n\n", 1)).as_bytes());
    let pool = rayon::ThreadPoolBuilder::new().num_threads(3).build().unwrap();
    let fast = |text: &str| pool.install(|| Amc::parse(format!(":DEGREES\n{text}").as_bytes()));
    let amc = fast(&text).unwrap();
    assert_eq!((amc.frame_count, amc.values.len(), &amc.values[8..12]), (59_995, 239_980, &[7.5, -2.0, 1e-3, 7.0][..]));
    let other_number = text.replace("\n40000\n", "\n40001\n");
    let shuffled = text.replace("root 40000.5 -2 1e-3\nlthumb 7\n", "lthumb 7\nroot 40000.5 -2 1e-3\n");
    for text in [&text, text.trim_end(), &text.replace('\n', "\r\n"), &other_number, &shuffled] {
        assert_eq!(fast(text), clear(text));
    }
    for damaged in
        [text.replace("40000.5", "4x"), text.replace("\nroot 40000.5 -2", "\nroot 40000.5"), text + "60000\n"]
    {
        // The blank line stands before the damage.
        let (found, expected) = (fast(&damaged).unwrap_err(), clear(&damaged).unwrap_err());
        let line = |position| if let Position::Text { line, .. } = position { line } else { 0 };
        assert_eq!((line(found.position) + 1, &found.found), (line(expected.position), &expected.found));
    }
    let last = i64::MAX.to_string();
    assert_eq!(fast(&format!("{last}\nroot 1\n")).unwrap().first_frame, i64::MAX);
}

#[test]
fn a_bone_turns_about_its_own_axes() {
    let (motion, notices) = parsed(SMALL).motion(&skeleton("")).unwrap();
    assert!(notices.is_empty(), "{notices:?}");
    assert_eq!((motion.frame_count, motion.first_frame, motion.rate_hz), (2, 1, Some(120.0)));
    assert_eq!(motion.bones[0].translations[0], DVec3::new(1.0, 2.0, 3.0));
    assert_eq!(motion.bones[1].angles[0], [10.0_f64, 20.0, 30.0].map(f64::to_radians));
    let about = |axis: DVec3, degrees: f64| DQuat::from_axis_angle(axis, degrees.to_radians());
    // The thigh's own axes are turned by 90 degrees about Z: its X is Y, its Y is -X.
    let wanted = about(DVec3::Z, 30.0) * about(-DVec3::X, 20.0) * about(DVec3::Y, 10.0);
    assert!(motion.bones[1].rotations[0].angle_between(wanted) < 1e-7);
    assert!(motion.bones[3].rotations.is_empty() && motion.bones[3].angles.is_empty());
}

#[test]
fn translations_and_length_move_a_bone_along_its_own_axes() {
    let skeleton = skeleton("axis 0 0 90 XYZ\ndof ty l");
    let (motion, _) =
        parsed(":RADIANS\n1\nroot 0 0 0 0 0 0\nthigh 0 0 0\nshin 0\nfoot 2 0.25\n").motion(&skeleton).unwrap();
    let foot = &motion.bones[3];
    assert!(foot.translations[0].distance(DVec3::new(-2.0, 0.0, 0.0)) < 1e-15);
    assert_eq!((foot.stretches.as_slice(), foot.rotations.len()), (&[0.25][..], 0));
}

#[test]
fn neighbouring_rotations_lie_in_one_hemisphere() {
    let frames = (0..100).map(|i| format!("{i}\nshin {}\n", f64::from(i) * 25.0)).collect::<Vec<_>>().concat();
    let (motion, notices) = parsed(&(":DEGREES\n".to_owned() + &frames)).motion(&skeleton("")).unwrap();
    assert!(motion.bones[2].rotations.windows(2).all(|pair| pair[0].dot(pair[1]) > 0.9));
    assert_eq!(motion.bones[2].angles[99][0], 2475.0_f64.to_radians());
    assert_eq!(notices, ["Bones without motion stay at rest: root, thigh"]);
}

#[test]
fn names_may_differ_in_case_where_that_is_clear() {
    let (motion, notices) = parsed(&SMALL.replace("thigh", "Thigh")).motion(&skeleton("")).unwrap();
    assert_eq!(motion.bones[1].rotations.len(), 2);
    assert_eq!(notices, ["Bones found by names that differ in case: Thigh = thigh"]);
}

#[test]
fn all_bones_that_do_not_fit_are_named() {
    let text = ":DEGREES\n1\nroot 1 2 3\nleg 4\nTHIGH 1 2 3\nthigh 1 2 3\nshin 1 2\nfoot 1\n";
    let misfit = parsed(text).motion(&skeleton("")).unwrap_err();
    let wanted = [
        "root (needs 6 values: tx ty tz rx ry rz; the motion has 3)",
        "leg",
        "thigh (a second line for thigh)",
        "shin (needs 1 value: rx; the motion has 2)",
        "foot (needs 0 values: no degree of freedom; the motion has 1)",
    ];
    assert_eq!(misfit.bones, wanted);
}

#[test]
fn three_values_for_every_bone_are_what_the_data_say() {
    let motion = |shin: &str| {
        let text =
            format!(":FORCE-ALL-JOINTS-BE-3DOF\n:DEGREES\n1\nroot 1 2 3 4 5 6\nthigh 1 2 3\nshin {shin}\nfoot 0 0 0\n");
        parsed(&text).motion(&skeleton("")).unwrap()
    };
    let (padded, notices) = motion("90 0 0");
    assert_eq!(padded.bones[2].angles[0], [90.0_f64.to_radians(), 0.0, 0.0]);
    assert_eq!(notices, ["Three values for every bone: they are its degrees of freedom, filled up with zeros"]);
    let (free, notices) = motion("90 0 45");
    assert_eq!(free.bones[2].angles[0], [90.0, 0.0, 45.0_f64].map(f64::to_radians));
    assert_eq!(notices, ["Three values for every bone: taken as rx ry rz, also beyond degrees of freedom: shin"]);
}

#[test]
fn angles_are_degrees_where_the_file_does_not_say() {
    let amc = parsed("1\nshin 90\n2\nshin 91\n");
    assert_eq!(amc.notices(), ["The file does not say whether angles are degrees or radians: degrees assumed"]);
    assert_eq!(amc.motion(&skeleton("")).unwrap().0.bones[2].angles[0][0], std::f64::consts::FRAC_PI_2);
}

#[test]
fn wrong_files_are_refused_in_words() {
    let second = |lines: &str| format!(":DEGREES\n1\na 1 2\nb 3\nc 4\n2\n{lines}");
    let table = [
        (String::new(), "line 1, column 1: expected an Acclaim motion (.amc), found an empty file"),
        (":DEGREES\n".to_owned(), "line 2, column 1: expected the number of the first frame, alone on its line, found the end of the file"),
        (":version 1.10\n".to_owned(), "line 1, column 1: expected an Acclaim motion (.amc), found an Acclaim skeleton (.asf)"),
        ("HIERARCHY\nROOT a\n".to_owned(), "line 1, column 1: expected an Acclaim motion (.amc), found a BVH motion (.bvh)"),
        ("\u{FEFF}<!doctype HTML>\n".to_owned(), "line 1, column 1: expected an Acclaim motion (.amc), found a web page (HTML)"),
        ("hello\n".to_owned(), "line 1, column 1: expected the number of the first frame, alone on its line, found `hello`"),
        (":DEGREES\n:RADIANS\n".to_owned(), "line 2, column 1: expected nothing that contradicts an earlier line, found `:RADIANS`"),
        (":SAMPLES-PER-SECOND\n".to_owned(), "line 1, column 20: expected a number of samples per second, found the end of the line"),
        (":SAMPLES-PER-SECOND 0\n".to_owned(), "line 1, column 21: expected a number of samples per second from 0.001 to 1000000, found `0`"),
        (":DEGREES\n1\n".to_owned(), "line 3, column 1: expected a bone with its values, found the end of the file"),
        (":DEGREES\n1\n2\na 1\n".to_owned(), "line 3, column 1: expected a bone with its values in frame 1, found `2`"),
        (":DEGREES\n99999999999999999999\n".to_owned(), "line 2, column 1: expected a frame number of a bearable size, found `99999999999999999999`"),
        (":DEGREES\n1\na 1\na 2\n".to_owned(), "line 4, column 1: expected each bone once in frame 1, found `a` a second time"),
        (":DEGREES\n1\na 1 x\n".to_owned(), "line 3, column 5: expected a value of bone `a`, found `x`"),
        (":DEGREES\n1\na 1\n2 3\n".to_owned(), "line 4, column 1: expected a frame number alone on its line, or a bone with its values, found `2`"),
        (":DEGREES\n1\na nan\n".to_owned(), "line 3, column 3: expected a value of bone `a`, a finite number, found `nan`"),
        (second("a 1\nb 3\nc 4\n"), "line 7, column 1: expected 2 values for bone `a`, as in the first frame, found 1"),
        (second("a 1 2\nb 3 4\nc 4\n"), "line 8, column 1: expected 1 value for bone `b`, as in the first frame, found 2"),
        (second("a 1 2\nb 3e\nc 4\n"), "line 8, column 3: expected a value of bone `b`, found `3e`"),
        (second("a 1 2\nb inf\nc 4\n"), "line 8, column 3: expected a value of bone `b`, a finite number, found `inf`"),
        (second("a 1 2\nb 1e300\nc 4\n"), "line 8, column 3: expected a value of bone `b` between -1e15 and 1e15, found `1e300`"),
        (second("a 1 2\nd 3\nc 4\n"), "line 8, column 1: expected a bone that is in the first frame too, found `d`"),
        (second("a 1 2\na 3 4\nc 4\n"), "line 8, column 1: expected each bone once in frame 2, found `a` a second time"),
        (second("a 1 2\n3\na 1 2\n"), "line 8, column 1: expected the values of b, c in frame 2, found `3`"),
        (second("a 1 2\nb"), "line 8, column 1: expected 1 value for bone `b`, as in the first frame, found 0"),
        (second("a 1 2\nb 3\n"), "line 9, column 1: expected the values of c in frame 2, found the end of the file"),
        (second("a 1 2\nb 3\nc 4\nb 3\n"), "line 10, column 1: expected a frame number, found `b`"),
        (second("a 1 2\n:DEGREES\n"), "line 8, column 1: expected a frame number or a bone, for keywords come before the first frame, found `:DEGREES`"),
    ];
    for (text, message) in table {
        let error = Amc::parse(text.as_bytes()).map(|_| ()).expect_err(&text);
        assert_eq!(error.to_string(), message, "{text}");
    }
}
