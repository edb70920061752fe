//! BVH files that no reader should trust: each gives one message or a result that holds together, and none takes more
//! time or memory than its size allows.

use motion_theater_core::formats::bvh::Bvh;
use motion_theater_core::pose::pose;
use motion_theater_core::read::{read_bytes, Format};
use std::fmt::Write;
use std::path::Path;

const SMALL: &str = "HIERARCHY\r\nROOT Hips\r\n{\r\n\tOFFSET 0.00 90.5 0.00\r\n\tCHANNELS 6 Xposition Yposition Zposition Zrotation \
    Xrotation Yrotation\r\n\tJOINT Left Leg\r\n\t{\r\n\t\tOFFSET 10 -4 0\r\n\t\tCHANNELS 3 Zrotation Xrotation Yrotation\r\n\t\tEnd Site\r\n\
    \t\t{\r\n\t\t\tOFFSET 0 -45 0\r\n\t\t}\r\n\t}\r\n}\r\nMOTION\r\nFrames: 2\r\nFrame Time: .0083333\r\n0 90 0 1e-5 2 3 4 5 6\r\n1 91 -.5 1 2 3 -4 5 -66.5\r\n";

/// Reads bytes; what can be read must also survive being written, built, inferred and moved.
fn use_fully(source: &[u8]) -> Result<Bvh, String> {
    let bvh = Bvh::parse(source).map_err(|error| error.to_string())?;
    let again = Bvh::parse(&bvh.to_bytes()).expect("what was written can be read");
    assert_eq!((&again.joints, &again.motion), (&bvh.joints, &bvh.motion));
    let (skeleton, motion) = bvh.skeleton_and_motion();
    assert_eq!(skeleton.bones.len(), bvh.joints.len());
    assert!(skeleton.unit.metres > 0.0 && skeleton.unit.metres.is_finite());
    if let Some(motion) = motion {
        assert_eq!(bvh.motion.as_ref().map(|motion| motion.values.len()), Some(motion.frame_count * bvh.width()));
        assert!(pose(&skeleton, &motion, 1.0).heads.iter().all(|head| head.is_finite()));
        assert_eq!(Bvh::from_motion(&skeleton, &motion).joints.len(), bvh.joints.len());
    }
    bvh.notices();
    Ok(bvh)
}

fn hips(body: &str, rows: &str) -> String {
    format!("HIERARCHY\nROOT Hips\n{{\nOFFSET 0 0 0\n{body}\n}}\nMOTION\nFrames: 1\nFrame Time: 1\n{rows}")
}

#[test]
fn a_hierarchy_cut_at_any_byte_is_refused_and_a_motion_keeps_its_whole_frames() {
    let motion = SMALL.find("MOTION").unwrap();
    let first_row = SMALL.find("0 90 0").unwrap();
    for length in 0..=SMALL.len() {
        let text = &SMALL[..length];
        match use_fully(text.as_bytes()) {
            Ok(bvh) => {
                assert!(text.trim_end().ends_with("}\r\n}") || length >= motion + "MOTION".len(), "{text}");
                let whole_rows = text.get(first_row..).map_or(0, |rows| {
                    rows.lines().filter(|row| row.split(' ').count() == 9 && !row.ends_with(' ')).count()
                });
                let frame_count = bvh.motion.as_ref().map_or(0, |motion| motion.frame_count);
                assert!(frame_count == whole_rows || text.ends_with(['e', '-']), "{text}");
            }
            Err(message) => assert!(length < motion + "MOTION".len() || message.contains("number"), "{message}"),
        }
    }
}

#[test]
fn files_that_the_fuzzer_starts_from_are_read_and_used() {
    let corpus = Path::new(env!("CARGO_MANIFEST_DIR")).join("fuzz/corpus/bvh");
    let files = std::fs::read_dir(corpus).unwrap().map(|entry| entry.unwrap().path());
    let mut named: Vec<_> = files.filter(|path| path.extension().is_some()).collect();
    named.sort();
    let readable = named.iter().filter(|path| use_fully(&std::fs::read(path).unwrap()).is_ok());
    assert!(readable.count() >= 6, "{named:?}");
}

#[test]
fn a_file_is_known_by_its_content_first() {
    for name in ["small.bvh", "small.BVH", "small.amc", "small.txt", "small"] {
        let clip = read_bytes(SMALL.as_bytes(), Path::new(name), None).unwrap();
        assert_eq!(
            (clip.format, clip.frame_count(), clip.first_frame(), clip.rate_hz()),
            (Format::Bvh, 2, 1, Some(120.0))
        );
        assert_eq!(clip.names(), ["Hips", "Left Leg"]);
    }
}

#[test]
fn a_chain_of_a_million_joints_is_read_without_recursion() {
    const DEPTH: usize = 1_000_000;
    let mut text = "HIERARCHY\nROOT a\n{\nOFFSET 0 0 0\n".to_owned();
    for _ in 1..DEPTH {
        text.push_str("JOINT a\n{\nOFFSET 0 1 0\n");
    }
    text.push_str(&"}\n".repeat(DEPTH));
    let bvh = Bvh::parse(text.as_bytes()).unwrap();
    let skeleton = bvh.skeleton();
    assert_eq!((bvh.joints.len(), skeleton.height()), (DEPTH, DEPTH as f64 - 1.0));
    assert_eq!(skeleton.bones[DEPTH - 1].name, "a.999999");
    assert_eq!(Bvh::parse(&bvh.to_bytes()), Ok(bvh));
}

#[test]
fn very_many_joints_on_one_line_or_channels_on_one_joint_are_read() {
    let joints = "JOINT b { OFFSET 0 0 0 CHANNELS 0 } ".repeat(100_000);
    let star = format!("HIERARCHY ROOT a {{ OFFSET 0 0 0 {joints} }}");
    assert_eq!(use_fully(star.as_bytes()).unwrap().joints.len(), 100_001);
    let channels = format!("CHANNELS 200000{}", " Xrotation".repeat(200_000));
    let bvh = use_fully(hips(&channels, &"1 ".repeat(400_000)).as_bytes()).unwrap();
    assert_eq!((bvh.width(), bvh.motion.unwrap().frame_count), (200_000, 2));
}

#[test]
fn counts_and_blank_lines_cost_nothing() {
    let claims = [
        hips("CHANNELS 1 Xrotation", "1\n").replace("Frames: 1", "Frames: 900000000000000"),
        hips(&format!("CHANNELS 3000{}", " Xrotation".repeat(3000)), &"\n".repeat(1_000_000)),
        hips("CHANNELS 0", &"\n".repeat(1_000_000)),
        hips("", "").replace("Frames: 1", "Frames: 900000000000000"),
        hips("CHANNELS 1 Xrotation", &format!("{}1\n", " ".repeat(1_000_000))),
    ];
    for text in claims {
        let motion = use_fully(text.as_bytes()).unwrap().motion.unwrap();
        assert!(motion.values.capacity() <= text.len(), "{} values of room", motion.values.capacity());
        assert!(motion.frame_count <= 1);
    }
    let message = use_fully(b"HIERARCHY ROOT a { CHANNELS 18446744073709551615 Xrotation").unwrap_err();
    assert_eq!(message, "line 1, column 59: expected a channel such as `Xrotation`, found the end of the file");
}

#[test]
fn names_full_of_braces_and_blanks_take_no_more_time_than_others() {
    let mut text = String::new();
    for name in [
        "{ ".repeat(200_000),
        format!("a{}", "{".repeat(400_000)),
        format!("{}{}", " ".repeat(200_000), "a{".repeat(200_000)),
    ] {
        text.clear();
        write!(text, "HIERARCHY\nROOT {name}\n{{\nOFFSET 0 0 0\n}}\n").unwrap();
        assert!(use_fully(text.as_bytes()).is_ok() || name.starts_with('{'));
    }
}

#[test]
fn huge_but_bearable_numbers_go_all_the_way() {
    let huge =
        SMALL.replace("90.5", "1e15").replace("-45", "-1e15").replace(" 91 ", " -1e15 ").replace("-66.5", "1e15");
    assert_eq!(use_fully(huge.as_bytes()).map(|bvh| bvh.joints[0].offset[1]), Ok(1e15));
    let message = use_fully(SMALL.replace("90.5", "1e16").as_bytes()).unwrap_err();
    assert_eq!(
        message,
        "line 4, column 14: expected a number for `OFFSET` of `Hips` between -1e15 and 1e15, found `1e16`"
    );
}
