//! What is in files, and where everything is at a frame.

mod common;

use std::io;
use std::sync::atomic::AtomicBool;

use common::Clips;
use motion_theater_cli::{run, Console};

#[test]
fn json_has_one_object_per_file_in_the_order_of_the_files() {
    let clips = Clips::new();
    let infos = clips.succeed("info --json {}/wave.amc {}/human.asf {}/step_and_jump.amc").json();
    let paths: Vec<_> = infos.iter().map(|info| info["path"].as_str().unwrap().rsplit('/').next().unwrap()).collect();
    assert_eq!(paths, ["wave.amc", "human.asf", "step_and_jump.amc"]);

    let wave = &infos[0];
    assert_eq!((&wave["format"], &wave["frames"], &wave["first_frame"]), (&"amc".into(), &120.into(), &1.into()));
    assert_eq!((wave["rate_hz"].as_f64(), wave["duration_s"].as_f64()), (Some(60.0), Some(2.0)));
    assert_eq!((&wave["joints"][0], wave["joints"].as_array().unwrap().len()), (&"root".into(), 29));
    assert_eq!((&wave["up"], &wave["error"]), (&"Y".into(), &serde_json::Value::Null));
    assert!((wave["unit_m"].as_f64().unwrap() - 0.0254 / 0.45).abs() < 1e-15);
    assert!(wave["notices"][0].as_str().unwrap().ends_with("human.asf, because named in the motion file"));

    let human = &infos[1];
    assert_eq!((&human["format"], &human["frames"], human["rate_hz"].as_f64()), (&"asf".into(), &0.into(), None));
    assert_eq!(human["joints"].as_array().unwrap().len(), 31);
}

#[test]
fn a_bad_file_is_told_on_its_line_and_stops_no_other() {
    let clips = Clips::new();
    clips.write("bad.amc", b":DEGREES\n1\nroot 1 2 x 4 5 6\n");
    let ended = clips.run("info --json {}/bad.amc {}/missing.bvh {}/wave.amc");
    let infos = ended.json();
    assert_eq!((ended.code, infos.len()), (1, 3));
    assert!(infos[0]["error"].as_str().unwrap().contains("bad.amc, line 3, column 10: expected"), "{}", infos[0]);
    assert!(infos[1]["error"].as_str().unwrap().ends_with("missing.bvh: No such file or directory"));
    assert!(infos[2]["error"].is_null());

    let ended = clips.run("info {}/missing.bvh {}/wave.amc");
    assert_eq!((ended.code, ended.err.lines().count()), (1, 1));
    assert!(ended.out.contains("wave.amc: AMC, 120 frames at 60 Hz, 2.00 s, 29 joints, unit 0.056444 m, Y up\n"));
}

/// What is said where the built-in default skeleton stands in.
const GUESS: &str = "No skeleton was found; the built-in default skeleton is used: sizes are a guess";

#[test]
fn an_amc_without_its_skeleton_is_taken_to_have_the_default_one_which_every_command_says() {
    let clips = Clips::new();
    clips.write("alone/deep/wave.amc", &clips.read("wave.amc"));
    let info = clips.succeed("info --json {}/alone/deep/wave.amc").json().remove(0);
    assert_eq!((info["unit_m"].as_f64(), &info["skeleton"]), (Some(0.0254 / 0.45), &serde_json::Value::Null));
    assert!(info["notices"].as_array().unwrap().contains(&GUESS.into()), "{info}");

    let pose = clips.succeed("pose --json {}/alone/deep/wave.amc").json().remove(0);
    assert_eq!(pose["warning"], GUESS);
    let table = clips.succeed("pose {}/alone/deep/wave.amc").out;
    assert_eq!((table.lines().nth(1), table.lines().count()), (Some(format!("  {GUESS}").as_str()), 33));
    clips.write("alone/stack.toml", b"[[entries]]\nsource = \"deep/wave.amc\"\n");
    for command in [
        "convert {}/alone/deep/wave.amc {}/alone/wave.bvh",
        "filter {}/alone/deep/wave.amc {}/alone/soft.bvh --kind median --depth 3",
        "combine {}/alone/stack.toml {}/alone/combined.bvh",
    ] {
        let out = clips.succeed(command).out;
        assert_eq!(out.matches(GUESS).count(), 1, "{command}: {out}");
    }
    let asked = clips.succeed("pose --json {}/alone/deep/wave.amc --skeleton {}/human.asf").json().remove(0);
    assert_eq!(asked.get("warning"), None);
}

#[test]
fn an_amc_that_no_skeleton_fits_is_told_of_and_has_no_pose() {
    let clips = Clips::new();
    let other = String::from_utf8(clips.read("wave.amc")).unwrap().replace("lfemur", "lthigh");
    clips.write("alone/deep/wave.amc", other.as_bytes());
    let human = String::from_utf8(clips.read("human.asf")).unwrap().replace("lfemur", "lthigh");
    clips.write("human.asf", human.as_bytes());
    let info = clips.succeed("info --json {}/alone/deep/wave.amc").json().remove(0);
    assert_eq!((&info["frames"], info["unit_m"].as_f64()), (&120.into(), None));
    let ended = clips.run("pose {}/alone/deep/wave.amc --json");
    assert_eq!(ended.code, 1);
    assert!(ended.err.contains("wave.amc: needs its skeleton, to be named with --skeleton"), "{}", ended.err);
    clips.succeed("pose {}/alone/deep/wave.amc --skeleton {}/human.asf");
}

#[test]
fn a_folder_stands_for_its_motion_files() {
    let clips = Clips::new();
    clips.write("deep/er/wave.amc", &clips.read("wave.amc"));
    clips.write("notes.txt", b"no motion");
    assert_eq!(clips.succeed("info --json {} --skeleton {}/human.asf").json().len(), 4);
    clips.write("empty/notes.txt", b"no motion");
    let ended = clips.run("info {}/empty");
    assert_eq!((ended.code, ended.err.ends_with("empty: no motion file is in it\n")), (1, true));
}

#[test]
fn a_pose_is_in_metres_with_z_up_and_in_the_files_own_frame() {
    let clips = Clips::new();
    let pose = clips.succeed("pose {}/wave.amc --frame 1 --json").json().remove(0);
    let root = pose["names"].as_array().unwrap().iter().position(|name| name == "root").unwrap();
    let file = [0, 1, 2].map(|axis| pose["positions_file"][root][axis].as_f64().unwrap());
    let metres = [0, 1, 2].map(|axis| pose["positions_m"][root][axis].as_f64().unwrap());
    let text = String::from_utf8(clips.read("wave.amc")).unwrap();
    let line = text.lines().find(|line| line.starts_with("root ")).unwrap();
    let numbers: Vec<f64> = line.split(' ').skip(1).map(|word| word.parse().unwrap()).collect();
    assert_eq!(&numbers[..3], file);
    let unit = 0.0254 / 0.45;
    for (got, wanted) in metres.into_iter().zip([file[0] * unit, -file[2] * unit, file[1] * unit]) {
        assert!((got - wanted).abs() < 1e-12);
    }
    // Half way between two frames, and at the end of the bone that an Acclaim file names.
    assert_eq!(clips.pose("wave.amc", "1.5").len(), 31);
    let (distance, count) = common::apart(&clips.pose("human.asf", "1"), &clips.pose("wave.amc", "1"));
    assert!(distance > 0.1 && count == 31);
}

#[test]
fn a_frame_that_is_not_there_is_refused_with_those_that_are() {
    let clips = Clips::new();
    for frame in ["0", "121", "-3", "1e99"] {
        let ended = clips.run(&format!("pose {{}}/wave.amc --frame {frame}"));
        assert_eq!(ended.code, 1, "{frame}");
        assert!(ended.err.contains("wave.amc: its frames are 1 to 120, without "), "{}", ended.err);
    }
    assert_eq!(clips.run("pose {}/wave.amc --frame NaN").code, 1);
    assert_eq!(clips.run("pose {}/wave.amc --frame soon").code, 2);
}

#[test]
fn a_table_of_a_pose_has_a_line_per_joint() {
    let clips = Clips::new();
    let out = clips.succeed("pose {}/wave.amc").out;
    assert!(out.lines().next().unwrap().ends_with("wave.amc: frame 1, metres, Z up"));
    assert_eq!(out.lines().count(), 32);
}

#[test]
fn wrong_use_ends_with_2_and_help_with_0() {
    let clips = Clips::new();
    for arguments in ["", "info", "pose", "frobnicate", "info --frames {}/wave.amc", "info --jobs 0 {}/wave.amc"] {
        let ended = clips.run(arguments);
        assert_eq!((ended.code, ended.out.as_str()), (2, ""), "{arguments}");
        assert!(!ended.err.is_empty());
    }
    for arguments in ["--help", "info --help", "--version"] {
        assert!(!clips.succeed(arguments).out.is_empty());
    }
}

/// A reader that has gone away.
struct Gone;

impl io::Write for Gone {
    fn write(&mut self, _: &[u8]) -> io::Result<usize> {
        Err(io::ErrorKind::BrokenPipe.into())
    }

    fn flush(&mut self) -> io::Result<()> {
        Err(io::ErrorKind::BrokenPipe.into())
    }
}

#[test]
fn a_broken_pipe_is_quiet() {
    let clips = Clips::new();
    let path = clips.0.join("wave.amc").display().to_string();
    for command in ["info", "pose"] {
        let arguments = ["motion-theater", command, &path].map(std::ffi::OsString::from);
        assert_eq!(run(arguments, &Console::new(Gone, Gone), &AtomicBool::new(false)), 0, "{command}");
    }
}
