//! Filters, and stacks of tracks and filters.

mod common;

use common::{apart, Clips};

const STACK: &str = r#"
skeleton = "human.asf"

[[entries]]
kind = "TRACK"
source = "step_and_jump.amc"

[[entries]]
kind = "TRACK"
name = "Wave"
source = "wave.amc"
bones = ["lhumerus", "lradius"]
cut_end = 60

[[entries]]
kind = "FILTER"
filter_kind = "MEDIAN"
depth = 3
bones = ["rhumerus"]
"#;

/// The lines of a bone's values, frame after frame.
fn values(clips: &Clips, file: &str, bone: &str) -> Vec<String> {
    let text = String::from_utf8(clips.read(file)).unwrap();
    let start = format!("{bone} ");
    text.lines().filter(|line| line.starts_with(&start)).map(str::to_owned).collect()
}

#[test]
fn a_filter_changes_its_bones_and_leaves_every_digit_of_the_others() {
    let clips = Clips::new();
    clips.succeed("filter {}/wave.amc {}/soft.amc --kind weighted --depth 7 --bones rhumerus,rradius");
    for bone in ["root", "lhumerus", "lfemur", "head"] {
        assert_eq!(values(&clips, "soft.amc", bone), values(&clips, "wave.amc", bone), "{bone}");
    }
    let (before, after) = (values(&clips, "wave.amc", "rhumerus"), values(&clips, "soft.amc", "rhumerus"));
    assert_eq!(before.len(), after.len());
    assert_eq!((&before[0], &before[119]), (&after[0], &after[119]));
    assert!(before[1..119].iter().zip(&after[1..119]).any(|(a, b)| a != b));
    let (distance, _) = apart(&clips.pose("wave.amc", "60"), &clips.pose("soft.amc", "60"));
    assert!(distance > 0.0 && distance < 0.05, "{distance}");
}

#[test]
fn a_skeleton_is_written_beside_only_where_its_degrees_of_freedom_are_not_enough() {
    let clips = Clips::new();
    clips.succeed("filter {}/wave.amc {}/soft.amc --kind weighted --depth 5 --bones rhand,rhumerus");
    assert!(!clips.has("soft.asf"), "a trace about a third axis is no reason");
    clips.succeed("filter {}/wave.amc {}/softer.amc --kind average --depth 61");
    assert!(clips.has("softer.asf"));
    clips.succeed("pose {}/softer.amc --skeleton {}/softer.asf");
}

#[test]
fn markers_are_filtered_too() {
    let clips = Clips::new();
    clips.succeed("convert {}/wave.amc {}/wave.csm");
    clips.succeed("filter {}/wave.csm {}/soft.csm --kind average --depth 5 --bones rhand");
    let (before, after) = (clips.pose("wave.csm", "60"), clips.pose("soft.csm", "60"));
    let moved: Vec<_> = before.iter().zip(&after).filter(|(a, b)| a != b).map(|(a, _)| a.0.as_str()).collect();
    assert_eq!(moved, ["rhand"]);
}

#[test]
fn a_filter_without_sense_is_refused() {
    let clips = Clips::new();
    for (arguments, code, words) in [
        ("--kind median --depth 4", 2, "the depth of a filter is an odd number of at least 3, not 4"),
        ("--kind mean --depth 3", 2, "mean"),
        ("--kind median --depth 3 --bones rhand,tail", 1, "wave.amc: there is no bone `tail`: they are root, "),
    ] {
        let ended = clips.run(&format!("filter {{}}/wave.amc {{}}/out.amc {arguments}"));
        assert_eq!(ended.code, code, "{arguments}");
        assert!(ended.err.contains(words), "{arguments}: {}", ended.err);
    }
    assert!(!clips.has("out.amc"));
}

#[test]
fn a_stack_lays_tracks_and_filters_one_over_the_other() {
    let clips = Clips::new();
    clips.write("stack.toml", STACK.as_bytes());
    let ended = clips.succeed("combine {}/stack.toml {}/out.amc");
    assert!(ended.out.contains("out.amc: 113 frames, 1 to 113\n"), "{}", ended.out);
    assert_eq!(values(&clips, "out.amc", "root"), values(&clips, "step_and_jump.amc", "root"));
    let arm = values(&clips, "out.amc", "lhumerus");
    assert_eq!(arm[..60], values(&clips, "wave.amc", "lhumerus")[..60]);
    assert_eq!(arm[60..], values(&clips, "step_and_jump.amc", "lhumerus")[60..]);
    assert!(!clips.has("out.asf"), "the skeleton that the clips have is enough");

    // The same stack as JSON, to another format and at another rate.
    let recipe = motion_theater_core::recipe::Recipe::parse(STACK, std::path::Path::new("stack")).unwrap();
    let half = motion_theater_core::recipe::Recipe { rate_hz: 30.0, ..recipe };
    clips.write("stack.json", half.to_json().as_bytes());
    clips.succeed("combine {}/stack.json {}/out.bvh");
    let info = clips.succeed("info --json {}/out.bvh").json().remove(0);
    assert_eq!((&info["frames"], info["rate_hz"].as_f64()), (&57.into(), Some(30.0)));
}

#[test]
fn a_track_of_another_skeleton_is_laid_on_bones_of_the_same_names() {
    let clips = Clips::new();
    clips.succeed("convert {}/wave.amc {}/wave.bvh");
    clips.write("stack.toml", b"skeleton = \"human.asf\"\n[[entries]]\nsource = \"wave.bvh\"\n");
    clips.succeed("combine {}/stack.toml {}/out.amc");
    let (distance, count) = apart(&clips.pose("wave.amc", "60"), &clips.pose("out.amc", "60"));
    assert!(distance < 1e-5 && count == 31, "{distance}");
}

#[test]
fn notices_of_the_combiner_are_told_with_their_entry() {
    let clips = Clips::new();
    let stack = STACK.replace("cut_end = 60", "cut_end = 60\nblend_depth = 100");
    clips.write("stack.toml", stack.as_bytes());
    let ended = clips.succeed("combine {}/stack.toml {}/out.amc");
    assert!(ended.out.contains("\n  Wave: Blend depth 100 reduced to "), "{}", ended.out);
}

#[test]
fn a_stack_that_cannot_be_made_is_told_in_words() {
    let clips = Clips::new();
    for (stack, words) in [
        ("[[entries]]\nsource = \"none.amc\"\n", "none.amc: No such file or directory"),
        ("[[entries]]\ncut = 3\n", "stack.toml, line 2, column 1: unknown field `cut`"),
        ("[[entries]]\nkind = \"FILTER\"\n", "stack.toml: the stack has no track"),
        (
            "[[entries]]\nsource = \"wave.amc\"\ncut_start = 200\n",
            "stack.toml: wave.amc: the cut ends at frame 120, before it starts",
        ),
        ("[[entries]]\nsource = \"wave.amc\"\nbones = [\"tail\"]\n", "wave.amc: there is no bone `tail`"),
        ("[[entries]]\nsource = \"wave.amc\"\nbones = []\n", "the result has no frames"),
        ("[[entries]]\nname = \"Wave\"\n", "Wave: there is no source"),
        ("skeleton = \"wave.amc\"\n", "wave.amc: there is no skeleton in it"),
    ] {
        clips.write("stack.toml", stack.as_bytes());
        let ended = clips.run("combine {}/stack.toml {}/out.amc");
        assert_eq!((ended.code, ended.err.lines().count()), (1, 1), "{stack}");
        assert!(ended.err.contains(words), "{stack}: {}", ended.err);
    }
    clips.write("stack.toml", b"\xFF\xFE");
    assert_eq!(clips.run("combine {}/stack.toml {}/out.amc").code, 1);
    assert_eq!(clips.run("combine {}/stack.toml {}/out.fbx").code, 2);
    assert!(!clips.has("out.amc"));
}
