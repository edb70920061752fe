//! Other formats, whole folders, runs that go on where they stopped.

mod common;

use std::sync::atomic::AtomicBool;
use std::time::{Duration, SystemTime};

use common::{apart, Clips};
use motion_theater_cli::{run, Console};

#[test]
fn a_file_goes_to_bvh_and_back_with_every_joint_in_its_place() {
    let clips = Clips::new();
    let ended = clips.succeed("convert {}/wave.amc {}/out/wave.bvh");
    assert!(ended.out.ends_with("out/wave.bvh\n"), "{}", ended.out);
    let ended = clips.succeed("convert {}/out/wave.bvh {}/back/again.amc");
    assert!(ended.out.contains("again.amc, ") && ended.out.ends_with("again.asf\n"), "{}", ended.out);
    assert!(clips.has("back/again.asf") && !clips.has("out/wave.asf"));
    for frame in ["1", "60", "120"] {
        let (distance, count) = apart(&clips.pose("wave.amc", frame), &clips.pose("back/again.amc", frame));
        assert!(distance < 1e-5 && count == 31, "frame {frame}: {distance} m, {count} points");
    }
}

#[test]
fn in_its_own_format_every_byte_of_a_file_that_we_wrote_stays() {
    let clips = Clips::new();
    for name in ["wave.amc", "human.asf"] {
        clips.succeed(&format!("convert {{}}/{name} {{}}/one/{name}"));
        clips.succeed(&format!("convert {{}}/one/{name} {{}}/two/{name}"));
        assert_eq!(clips.read(&format!("one/{name}")), clips.read(&format!("two/{name}")));
    }
    assert!(!clips.has("one/wave.asf"));
}

#[test]
fn a_rate_changes_the_frames_and_keeps_the_duration() {
    let clips = Clips::new();
    clips.succeed("convert {}/wave.amc {}/slow.amc --rate 30");
    let info = clips.succeed("info --json {}/slow.amc").json().remove(0);
    assert_eq!((&info["frames"], info["rate_hz"].as_f64()), (&60.into(), Some(30.0)));
    let (distance, _) = apart(&clips.pose("wave.amc", "61"), &clips.pose("slow.amc", "31"));
    assert!(distance < 0.01, "{distance}");
}

#[test]
fn a_skeleton_in_motion_becomes_markers_at_its_joints() {
    let clips = Clips::new();
    for format in ["csm", "c3d", "trc"] {
        clips.succeed(&format!("convert {{}}/wave.amc {{}}/markers.{format}"));
        let info = clips.succeed(&format!("info --json {{}}/markers.{format}")).json().remove(0);
        assert_eq!(
            (&info["format"], &info["frames"], info["rate_hz"].as_f64()),
            (&format.into(), &120.into(), Some(60.0))
        );
        assert_eq!(info["markers"].as_array().unwrap().len(), 31, "{format}");
        let (distance, count) = apart(&clips.pose("wave.amc", "77"), &clips.pose(&format!("markers.{format}"), "77"));
        assert!(distance < 1e-5 && count == 31, "{format}: {distance} m, {count} points");
    }
    let ended = clips.run("convert {}/markers.csm {}/skeleton.bvh");
    assert_eq!(ended.code, 1);
    assert!(ended.err.ends_with("markers.csm: markers have no skeleton, so they cannot become BVH\n"), "{}", ended.err);
    clips.succeed("convert {}/markers.csm {}/again.trc --rate 30");
    let (distance, count) = apart(&clips.pose("markers.csm", "1"), &clips.pose("again.trc", "1"));
    assert!(distance < 1e-3 && count == 31, "{distance}");
}

#[test]
fn a_folder_is_mirrored_and_its_skeletons_stay_with_their_motions() {
    let clips = Clips::new();
    clips.write("in/a/wave.amc", &clips.read("wave.amc"));
    clips.write("in/a/human.asf", &clips.read("human.asf"));
    clips.write("in/b/c/jump.amc", &clips.read("step_and_jump.amc"));
    clips.write("in/b/c/human.asf", &clips.read("human.asf"));
    clips.write("in/b/c/bad.amc", b"1\nroot x\n");
    let ended = clips.run("convert {}/in {}/in/out --format bvh");
    assert_eq!(ended.code, 1);
    assert_eq!((ended.out.lines().last(), ended.err.lines().count()), (Some("2 converted, 0 skipped, 1 failed"), 1));
    assert!(clips.has("in/out/a/wave.bvh") && clips.has("in/out/b/c/jump.bvh"));
    assert!(!clips.has("in/out/a/human.bvh") && !clips.has("in/out/b/c/bad.bvh"));

    // The outputs lie in the folder that is read, and are not read themselves.
    let again = clips.run("convert {}/in {}/in/out --format bvh");
    assert_eq!(again.out.lines().last(), Some("0 converted, 2 skipped, 1 failed"));
    clips.succeed("convert {}/in/a {}/copy --format amc");
    assert!(clips.has("copy/wave.amc") && clips.has("copy/human.asf"));
}

#[test]
fn what_is_newer_than_its_input_is_skipped_unless_forced() {
    let clips = Clips::new();
    clips.succeed("convert {}/wave.amc {}/wave.bvh");
    let whole = clips.read("wave.bvh");
    clips.write("wave.bvh", b"changed");
    let ended = clips.succeed("convert {}/wave.amc {}/wave.bvh");
    assert!(ended.out.contains("wave.amc: skipped, ") && ended.out.contains("(--force writes it anew)"));
    assert_eq!(clips.read("wave.bvh"), b"changed");
    clips.succeed("convert --force {}/wave.amc {}/wave.bvh");
    assert_eq!(clips.read("wave.bvh"), whole);

    clips.write("wave.bvh", b"changed");
    let file = std::fs::File::options().append(true).open(clips.0.join("wave.bvh")).unwrap();
    file.set_modified(SystemTime::now() - Duration::from_secs(3600)).unwrap();
    clips.succeed("convert {}/wave.amc {}/wave.bvh");
    assert_eq!(clips.read("wave.bvh"), whole);
    assert_eq!(std::fs::read_dir(&clips.0).unwrap().count(), 4, "nothing unfinished is left");
}

#[test]
fn no_output_is_made_twice_and_no_input_overwritten() {
    let clips = Clips::new();
    clips.write("wave.bvh", b"HIERARCHY\nROOT a\n{\nOFFSET 0 0 0\nCHANNELS 0\n}\n");
    let ended = clips.run("convert {}/wave.amc {}/wave.bvh {}/out --format csm");
    assert_eq!(ended.code, 1);
    assert!(ended.err.contains("wave.bvh: not converted, for ") && ended.err.contains("wave.csm is made from "));
    let ended = clips.run("convert {}/wave.amc {}/wave.amc --force --rate 30");
    assert_eq!(ended.code, 1);
    assert!(ended.err.contains("wave.amc: not written, for ") && ended.err.contains("is read for it"), "{}", ended.err);
    let info = clips.succeed("info --json {}/wave.amc").json().remove(0);
    assert_eq!(info["frames"], 120);
}

#[test]
fn an_asf_alone_is_a_hierarchy_and_a_hierarchy_alone_no_motion() {
    let clips = Clips::new();
    clips.succeed("convert {}/human.asf {}/human.bvh");
    let info = clips.succeed("info --json {}/human.bvh").json().remove(0);
    assert_eq!((&info["frames"], &info["joints"][0], info["rate_hz"].as_f64()), (&0.into(), &"root".into(), None));
    let ended = clips.run("convert {}/human.bvh {}/human.csm");
    assert_eq!((ended.code, ended.err.ends_with("human.bvh: there is no motion in it\n")), (1, true));
}

#[test]
fn wrong_use_is_told_before_anything_is_written() {
    let clips = Clips::new();
    for (arguments, words) in [
        ("convert {}/wave.amc", "IN"),
        ("convert {}/wave.amc {}/wave.fbx", "asf, amc, bvh, c3d, csm, trc"),
        ("convert {}/wave.amc {}/out --format fbx", "the formats are asf, amc, bvh, c3d, csm, trc"),
        ("convert {}/wave.amc {}/human.asf {}/out", "--format says what they become"),
        ("convert {} {}/human.asf --format bvh", "human.asf is a file"),
        ("convert {}/wave.amc {}/wave.bvh --rate -1", "a rate is a number of frames per second above 0"),
    ] {
        let ended = clips.run(arguments);
        assert_eq!((ended.code, ended.out.as_str()), (2, ""), "{arguments}");
        assert!(ended.err.contains(words), "{arguments}: {}", ended.err);
    }
    assert!(!clips.has("out") && !clips.has("wave.bvh"));
}

#[test]
fn once_stopped_no_file_is_begun() {
    let clips = Clips::new();
    let folder = clips.0.display().to_string();
    let out = clips.0.join("out").display().to_string();
    let arguments = ["motion-theater", "convert", &folder, &out, "--format", "bvh"].map(std::ffi::OsString::from);
    assert_eq!(run(arguments, &Console::new(std::io::sink(), std::io::sink()), &AtomicBool::new(true)), 0);
    assert!(!clips.has("out"));
}

#[test]
fn what_markers_lose_is_said() {
    let clips = Clips::new();
    let recorded = include_bytes!("../../fuzz/corpus/c3d/intel_float.c3d");
    clips.write("a.c3d", recorded);
    let ended = clips.succeed("convert {}/a.c3d {}/same.c3d");
    assert!(!ended.out.contains("left out"), "{}", ended.out);
    assert_eq!(clips.read("same.c3d"), recorded);
    let ended = clips.succeed("convert {}/a.c3d {}/slow.c3d --rate 30");
    assert!(ended.out.ends_with("slow.c3d (left out: 2 analog channels, residuals)\n"), "{}", ended.out);
    let ended = clips.succeed("filter {}/a.c3d {}/soft.c3d --kind median --depth 3");
    assert!(!ended.out.contains("left out"), "{}", ended.out);
    let ended = clips.succeed("convert {}/a.c3d {}/a.trc");
    let lost = "1 point that is no position, 1 event, 2 analog channels, residuals";
    assert!(ended.out.ends_with(&format!("a.trc (left out: {lost})\n")), "{}", ended.out);

    // The group of its events under a name of its own: what programs keep there no other file of ours has.
    let at = recorded.windows(5).position(|name| name == b"EVENT").unwrap();
    let mut other = recorded.to_vec();
    other[at..at + 5].copy_from_slice(b"OTHER");
    clips.write("b.c3d", &other);
    let ended = clips.succeed("convert {}/b.c3d {}/b.csm");
    assert!(ended.out.ends_with("2 analog channels, residuals, parameters of OTHER)\n"), "{}", ended.out);
}
