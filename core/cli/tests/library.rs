//! `motion-theater library`: a scan, what it found, tags, tables.

mod common;

use common::{Clips, Ended};

fn run(clips: &Clips, arguments: &str) -> Ended {
    clips.run(&format!("library --library {{}}.sqlite {arguments}"))
}

/// Scans a folder of a skeleton, two motions and a broken file.
fn scanned() -> Clips {
    let clips = Clips::new();
    clips.write("broken.bvh", b"HIERARCHY\nROOT a\n");
    let ended = run(&clips, "scan {}");
    let folder = clips.0.display();
    let error = "line 3, column 1: expected `{`, found the end of the file";
    assert_eq!((ended.code, ended.err), (1, format!("{folder}/broken.bvh: {error}\n")));
    let said = "4 new, 0 changed, 0 moved, 0 missing, 0 as they were; 1 of those that were read cannot be used\n";
    assert_eq!(ended.out, said);
    clips
}

#[test]
fn a_scan_is_kept_and_the_next_one_reads_only_what_changed() {
    let clips = scanned();
    let again = run(&clips, "scan --json").json().remove(0);
    assert_eq!((&again["read"], &again["unchanged"], &again["new"]), (&0.into(), &4.into(), &0.into()));
}

#[test]
fn show_prints_what_is_known_of_clips_by_file_or_number() {
    let clips = scanned();
    let shown = run(&clips, "show {}/wave.amc --json").json().remove(0);
    assert_eq!(
        (&shown["format"], &shown["frames"], shown["rate_hz"].as_f64()),
        (&"amc".into(), &120.into(), Some(60.0))
    );
    assert_eq!(shown["skeleton_path"], clips.0.join("human.asf").display().to_string());
    let by_number = run(&clips, &format!("show {} --json", shown["id"])).json().remove(0);
    assert_eq!(by_number, shown);
    let text = run(&clips, "show {}/wave.amc").out;
    assert!(text.contains("\nframes:               120\n"), "{text}");
    let unknown = run(&clips, "show {}/none.bvh 99");
    assert_eq!((unknown.code, unknown.err.lines().count()), (1, 2));
}

#[test]
fn tags_are_put_on_and_taken_off() {
    let clips = scanned();
    assert_eq!(run(&clips, "tag {}/wave.amc {}/step_and_jump.amc --add arms,left").code, 0);
    assert_eq!(run(&clips, "tag {}/wave.amc --remove ARMS").code, 0);
    let tags = |name: &str| run(&clips, &format!("show {{}}/{name} --json")).json()[0]["tags"].to_string();
    assert_eq!(
        (tags("wave.amc"), tags("step_and_jump.amc")),
        (r#"["left"]"#.to_owned(), r#"["arms","left"]"#.to_owned())
    );
    assert_eq!(run(&clips, "tag {}/wave.amc").code, 2);
    assert_eq!(run(&clips, "tag {}/wave.amc nothing --add x").code, 1);
    assert_eq!(tags("wave.amc"), r#"["left"]"#, "all of them, or none");
}

#[test]
fn export_prints_a_row_for_each_clip() {
    let clips = scanned();
    run(&clips, "tag {}/wave.amc --add arms,left");
    let table = run(&clips, "export").out;
    let rows: Vec<&str> = table.lines().collect();
    assert_eq!((rows.len(), rows[0].split(',').next()), (5, Some("cleaned")));
    assert!(table.contains(",arms; left,"), "{table}");
    let objects = run(&clips, "export --json").json();
    assert_eq!(
        objects.iter().map(|clip| clip["name"].as_str().unwrap()).collect::<Vec<_>>(),
        ["broken.bvh", "human.asf", "step_and_jump.amc", "wave.amc"]
    );
}

#[test]
fn what_is_no_library_is_left_alone() {
    let clips = Clips::new();
    let before = clips.read("wave.amc");
    let ended = clips.run("library --library {}/wave.amc scan");
    assert_eq!(ended.code, 1);
    assert!(
        ended.err.ends_with("a file of another kind, not a library of clips; it was left as it is\n"),
        "{}",
        ended.err
    );
    assert_eq!(clips.read("wave.amc"), before);
}

#[test]
fn a_search_prints_what_a_query_gives_in_order() {
    let clips = scanned();
    let names = |arguments: &str| -> Vec<String> {
        let found = run(&clips, &format!("search --json {arguments}")).json();
        found.iter().map(|clip| clip["name"].as_str().unwrap_or_default().to_owned()).collect()
    };
    assert_eq!(names("format:amc"), ["step_and_jump.amc", "wave.amc"]);
    assert_eq!(names("format:amc --sort frames --descending --limit 1"), ["wave.amc"]);
    assert_eq!(names("broken:yes"), ["broken.bvh"]);
    assert_eq!(names("jump rate:60"), ["step_and_jump.amc"]);
    assert_eq!(names("-- -jump format:amc"), ["wave.amc"]);
    let line = run(&clips, "search wave").out;
    assert!(line.ends_with("wave.amc: AMC, 120 frames, 2.00 s\n"), "{line}");
    let wrong = run(&clips, "search rate>=fast");
    let message = "error: `rate>=fast`: expected a number of frames per second, such as rate>=100\n";
    assert_eq!((wrong.code, wrong.err.as_str()), (2, message));
}

#[test]
fn a_sidecar_is_printed_written_and_edited_and_the_library_knows_at_once() {
    let clips = scanned();
    let new = run(&clips, "sidecar {}/wave.amc").out;
    assert!(new.lines().next().unwrap().ends_with("wave.i3d (not written yet)"), "{new}");
    assert!(new.contains("\n  Framerate: 60\n") && new.contains("\n  ASF file: human.asf\n"), "{new}");
    assert!(!clips.0.join("wave.i3d").exists(), "printing writes nothing");

    let written =
        run(&clips, "sidecar {}/wave.amc --write --set subject=07 --set Comment=waves --json").json().remove(0);
    assert_eq!((&written["is_on_disk"], &written["fields"]["subject"]), (&true.into(), &"07".into()));
    let text = String::from_utf8(clips.read("wave.i3d")).unwrap();
    assert_eq!((text.lines().count(), text.contains("Subject: 07\n")), (11, true), "{text}");
    let shown = run(&clips, "show {}/wave.amc --json").json().remove(0);
    assert_eq!((&shown["subject"], &shown["description"]), (&"07".into(), &"waves".into()));

    clips.write("wave.i3d", b"Akteur: J\xF6rg\r\nweather rain\r\n");
    assert_eq!(run(&clips, "sidecar {}/wave.amc --set cleaned=Ja").code, 0);
    let text = clips.read("wave.i3d");
    assert!(text.starts_with(b"Akteur: J\xF6rg\r\nCleaned: Ja\r\n"), "{}", String::from_utf8_lossy(&text));
    assert!(text.ends_with(b"weather rain\r\n"), "{}", String::from_utf8_lossy(&text));
}

#[test]
fn what_a_line_cannot_hold_is_refused_and_the_sidecar_stays() {
    let clips = scanned();
    clips.write("wave.i3d", b"Comment: mine\n");
    let refused = run(&clips, "sidecar {}/wave.amc nothing --set cleaned=maybe");
    assert_eq!((refused.code, refused.err.lines().count()), (1, 2), "{}", refused.err);
    assert!(refused.err.starts_with("Cleaned is empty or one of J, Ja"), "{}", refused.err);
    assert_eq!(clips.read("wave.i3d"), b"Comment: mine\n");
    assert_eq!(run(&clips, "sidecar {}/wave.amc --set weather=rain").code, 2);
    assert_eq!(run(&clips, "sidecar {}/wave.amc --set subject").code, 2);
}
