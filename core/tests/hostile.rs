//! Files that no reader should trust: each gives one message or a result that holds together, and none takes more time
//! or memory than its size allows.

use motion_theater_core::formats::{amc::Amc, asf::Asf, AngleUnit};
use motion_theater_core::read::{read_bytes, read_path};
use motion_theater_core::ReadError;
use std::fmt::Write;
use std::path::Path;

const SKELETON: &str = "# small\r\n:version 1.10\r\n:name small\r\n:units\r\n  mass 1.0\r\n  length 0.45\r\n  angle deg\r\n\
    :documentation\r\n  two bones\r\n:root\r\n  order TX TY TZ RX RY RZ\r\n  axis XYZ\r\n  position 0 0 0\r\n  orientation 0 0 0\r\n\
    :bonedata\r\n  begin\r\n    id 1\r\n    name thigh\r\n    direction 0.34202 -0.939693 0\r\n    length 7.1578\r\n\
    axis 0 0 20 XYZ\r\n    dof rx ry rz\r\n    limits (-160.0 20.0)\r\n           (-70.0 70.0)\r\n           (-60.0 70.0)\r\n  end\r\n\
    begin\r\n    id 2\r\n    name shin\r\n    direction 0.34202 -0.939693 0\r\n    length 7.49137\r\n    axis 0 0 20 XYZ\r\n\
    dof rx\r\n    limits (-10.0 170.0)\r\n  end\r\n:hierarchy\r\n  begin\r\n    root thigh\r\n    thigh shin\r\n  end\r\n";

const MOTION: &str = "#!OML:ASF small.ASF\r\n:FULLY-SPECIFIED\r\n:DEGREES\r\n1\r\nroot 9.37216 17.8693 -17.3198 -2.01677 -7.59696 -3.23164\r\n\
    thigh -0.629535 4.65229 22.5467\r\nshin 3.64024e-015\r\n2\r\nroot 9.37285 17.8666 -17.3192 -2.06376 -7.58832 -3.1009\r\n\
    thigh -0.610476 4.56991 22.3851\r\nshin -20.5\r\n";

/// Reads bytes as whatever they are; what can be read must also survive being written, built and moved.
fn use_fully(source: &[u8], name: &str) -> Result<(), String> {
    let small = Asf::parse(SKELETON.as_bytes()).unwrap().skeleton();
    if let Ok(asf) = Asf::parse(source) {
        assert_eq!(Asf::parse(&asf.to_bytes()).as_ref(), Ok(&asf));
        let skeleton = asf.skeleton();
        assert_eq!(skeleton.bones.len(), asf.bones.len() + 1);
        assert!(Asf::from_skeleton(&skeleton).bones.len() >= asf.bones.len());
    }
    if let Ok(amc) = Amc::parse(source) {
        assert_eq!(Amc::parse(&amc.to_bytes()).as_ref(), Ok(&amc));
        if let Ok((motion, _)) = amc.motion(&small) {
            assert_eq!(motion.bones.len(), small.bones.len());
            assert_eq!(Amc::from_motion(&small, &motion, AngleUnit::Radians).frame_count, amc.frame_count);
        }
    }
    read_bytes(source, Path::new(name), Some(&small)).map(|_| ()).map_err(|error| error.to_string())
}

#[test]
fn a_skeleton_cut_at_any_byte_is_refused_unless_only_blanks_are_lost() {
    for length in 0..=SKELETON.len() {
        let is_whole = length >= SKELETON.trim_end().len();
        assert_eq!(use_fully(&SKELETON.as_bytes()[..length], "cut.asf").is_ok(), is_whole, "{length}");
    }
}

#[test]
fn a_motion_cut_at_any_byte_is_refused_unless_whole_frames_are_left() {
    let second = MOTION.find("\r\n2\r\n").unwrap();
    // A frame's last number may be cut and is still a number: `-20.5`, `-20.`, `-20`, `-2`.
    let last_number = MOTION.rfind("-20.5").unwrap();
    let first_last = MOTION.find("3.64024e-015").unwrap();
    for length in 0..=MOTION.len() {
        let text = &MOTION[..length];
        let ends_in_first = (text.ends_with("shin 3") || length > first_last && length <= second + 2)
            && !text.ends_with('e')
            && !text.ends_with("e-");
        // In the first frame a cut between bones leaves a file with fewer bones.
        let first_frame = length > MOTION.find("root").unwrap() && length < first_last;
        let ends_in_last = length > last_number + 1;
        let result = use_fully(text.as_bytes(), "cut.amc");
        if !first_frame {
            assert_eq!(result.is_ok(), ends_in_first || ends_in_last, "{text:?}");
        }
    }
}

#[test]
fn what_is_no_motion_capture_is_called_by_its_name() {
    let utf_16: Vec<u8> = [0xFF, 0xFE].into_iter().chain(SKELETON.bytes().flat_map(|byte| [byte, 0])).collect();
    let noise: Vec<u8> = (0..4000_u32).map(|i| (i.wrapping_mul(2_654_435_761) >> 13) as u8).collect();
    let wanted = "an Acclaim skeleton (.asf), a motion (.amc, .bvh) or markers (.c3d, .csm, .trc)";
    let table: [(&str, &[u8], &str, &str); 13] = [
        ("a.bin", b"", wanted, "an empty file"),
        ("a.bin", b"\n \n", wanted, "text of an unknown kind"),
        ("a.bin", &noise, wanted, "binary data"),
        ("a.asf", &noise, "an Acclaim skeleton (.asf)", "binary data"),
        ("a.AMC", &noise, "an Acclaim motion (.amc)", "binary data"),
        ("a.asf", &utf_16, "an Acclaim skeleton (.asf)", "UTF-16 text; save it as UTF-8"),
        ("a.asf", &utf_16[2..], "an Acclaim skeleton (.asf)", "UTF-16 text; save it as UTF-8"),
        ("a.amc", &utf_16[3..], "an Acclaim motion (.amc)", "UTF-16 text; save it as UTF-8"),
        ("a.amc", b"<!DOCTYPE html><html>", "an Acclaim motion (.amc)", "a web page (HTML)"),
        ("a.bvh", &noise, "a BVH motion (.bvh)", "binary data"),
        (
            "a.asf",
            b"version https://git-lfs.github.com/spec/v1\n",
            "an Acclaim skeleton (.asf)",
            "a Git LFS pointer instead of the file itself",
        ),
        ("a.amc", b"PK\x03\x04\x14\x00", "an Acclaim motion (.amc)", "a ZIP archive"),
        ("a.txt", b"Dear Sir,\n", wanted, "text of an unknown kind"),
    ];
    for (name, source, expected, found) in table {
        assert_eq!(
            use_fully(source, name),
            Err(format!("{name}, line 1, column 1: expected {expected}, found {found}"))
        );
    }
}

#[test]
fn a_file_is_known_by_its_content_first() {
    for name in ["small.amc", "small.txt", "small"] {
        assert_eq!(use_fully(SKELETON.as_bytes(), name), Ok(()), "{name}");
    }
    assert_eq!(use_fully(MOTION.as_bytes(), "motion.asf"), Ok(()));
    assert_eq!(use_fully(b"7\nroot 1 2 3 4 5 6\n", "motion"), Ok(()));
}

#[test]
fn what_the_disk_refuses_is_an_error_of_the_disk() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR"));
    for path in [folder.join("no such file.asf"), folder.to_owned()] {
        match read_path(&path, None) {
            Err(ReadError::Io { path: named, .. }) => assert_eq!(named, path),
            other => panic!("{other:?}"),
        }
    }
}

#[test]
fn huge_but_bearable_numbers_go_all_the_way() {
    let skeleton = SKELETON.replace("7.1578", "1e15").replace("20 XYZ", "1e15 XYZ").replace("0 0 0", "1e15 -1e15 1e15");
    assert_eq!(use_fully(skeleton.as_bytes(), "huge.asf"), Ok(()));
    let motion = MOTION.replace("17.8693", "1e15").replace("-0.629535", "-1e15");
    assert_eq!(use_fully(motion.as_bytes(), "huge.amc"), Ok(()));
}

#[test]
fn a_deep_hierarchy_is_read_without_recursion() {
    const DEPTH: usize = 100_000;
    let (mut bones, mut hierarchy) = (String::new(), "root b0\n".to_owned());
    for i in 0..DEPTH {
        writeln!(bones, "begin\nname b{i}\ndirection 0 1 0\nlength 1\nend").unwrap();
        writeln!(hierarchy, "b{i} b{}", i + 1).unwrap();
    }
    let last_line = hierarchy.rfind(&format!("b{} ", DEPTH - 1)).unwrap();
    let chain = format!(":bonedata\n{bones}:hierarchy\n{}", &hierarchy[..last_line]);
    assert_eq!(Asf::parse(chain.as_bytes()).unwrap().skeleton().rest_heads()[DEPTH].y, (DEPTH - 1) as f64);
    let circle = chain.replacen("root b0", &format!("b{} b0", DEPTH - 1), 1);
    let message = "line 2, column 1: expected bone `b0` to be connected with `root` by `:hierarchy`, \
        found that its parents lead in a circle";
    assert_eq!(Asf::parse(circle.as_bytes()).unwrap_err().to_string(), message);
}

#[test]
fn many_bones_on_one_parent_are_read_and_moved() {
    let names: Vec<_> = (0..50_000).map(|i| format!("b{i}")).collect();
    let (mut bones, mut frame) = (String::new(), String::new());
    for name in names.iter().rev() {
        writeln!(bones, "begin\nname {name}\ndirection 0 1 0\nlength 1\ndof rx\nend").unwrap();
        writeln!(frame, "{name} 5 0 0").unwrap();
    }
    let skeleton = Asf::parse(format!(":bonedata\n{bones}:hierarchy\nroot {}\n", names.join(" ")).as_bytes());
    let amc = Amc::parse(format!(":FORCE-ALL-JOINTS-BE-3DOF\n:DEGREES\n1\n{frame}").as_bytes()).unwrap();
    let (motion, _) = amc.motion(&skeleton.unwrap().skeleton()).unwrap();
    assert!(motion.bones[1..].iter().all(|bone| bone.angles == [[5.0_f64.to_radians(), 0.0, 0.0]]));
}

#[test]
fn what_the_fuzzer_found_stays_harmless() {
    let corpus = Path::new(env!("CARGO_MANIFEST_DIR")).join("fuzz/corpus");
    for (folder, least_readable) in [("asf", 4), ("amc", 5)] {
        let files: Vec<_> =
            std::fs::read_dir(corpus.join(folder)).unwrap().map(|entry| entry.unwrap().path()).collect();
        let named = files.iter().filter(|path| path.extension().is_some());
        let readable = named.filter(|path| {
            let source = std::fs::read(path).unwrap();
            let _ = use_fully(&source, &path.to_string_lossy());
            Asf::parse(&source).is_ok() || Amc::parse(&source).is_ok()
        });
        assert!(readable.count() >= least_readable, "{folder}");
    }
}

#[test]
fn a_motion_of_very_many_bones_or_values_is_read() {
    let bones: String = (0..50_000).fold(String::new(), |text, i| text + "b" + &i.to_string() + " 1\n");
    let amc = Amc::parse(format!(":DEGREES\n1\n{bones}2\n{bones}").as_bytes()).unwrap();
    assert_eq!((amc.bones.len(), amc.frame_count, amc.values.len()), (50_000, 2, 100_000));
    let line = format!("root {}\n", "1 ".repeat(200_000));
    let amc = Amc::parse(format!(":DEGREES\n1\n{line}2\n{line}").as_bytes()).unwrap();
    assert_eq!((amc.width(), amc.frame_count), (200_000, 2));
}
