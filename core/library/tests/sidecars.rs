//! What sidecars tell the library.

mod common;

use common::{bvh, Stage};
use motion_theater_library::catalogue::{Edit, Field};
use motion_theater_library::sidecar::Field as Line;

const HUMAN: &str = include_str!("../../src/pairing/default_skeleton.asf");
const AMC: &str = ":FULLY-SPECIFIED\n:DEGREES\n1\nroot 0 0 0 0 0 0\nlfemur 1 2 3\n2\nroot 0 0 0 0 0 0\nlfemur 1 2 3\n";

/// Subject, date, cleaned or not, usable segments.
type InForce = (Option<String>, Option<String>, Option<bool>, Vec<(i64, i64)>);

fn in_force(stage: &Stage, name: &str) -> InForce {
    let clip = stage.clip(name);
    (clip.subject, clip.recorded_on, clip.cleaned, clip.segments)
}

fn said(subject: &str) -> String {
    format!("Subject: {subject}\r\nDatum: 31.5.2004\r\nCleaned: ja\r\nUsable segments: 2-4 (slow)\r\n")
}

#[test]
fn a_sidecar_tells_of_the_clips_of_its_name_and_is_read_again_once_it_changes() {
    let stage = Stage::with(&[
        ("a/walk.bvh", &bvh(10, 0)),
        ("a/walk.2.bvh", &bvh(10, 1)),
        ("a/walker.bvh", &bvh(10, 2)),
        ("a/walk.i3d", &said("Jo")),
    ]);
    stage.scan();
    let told = (Some("Jo".to_owned()), Some("2004-05-31".to_owned()), Some(true), vec![(2, 4)]);
    assert_eq!(in_force(&stage, "a/walk.bvh"), told);
    assert!(stage.clip("a/walk.bvh").sources.contains(&("subject".to_owned(), "SIDECAR".to_owned())));
    for other in ["a/walk.2.bvh", "a/walker.bvh"] {
        assert_eq!(in_force(&stage, other), (None, None, None, vec![]), "{other}");
    }
    assert_eq!(stage.find("a/walk.i3d"), None, "a sidecar is no clip");

    stage.put("a/walk.i3d", "Subject: Ann\n");
    let again = stage.scan();
    assert_eq!((again.total, again.changed), (0, 0), "the clip itself is not read for that");
    assert_eq!(in_force(&stage, "a/walk.bvh"), (Some("Ann".to_owned()), None, None, vec![(2, 4)]));

    std::fs::remove_file(stage.path("a/walk.i3d")).unwrap();
    stage.scan();
    assert_eq!(in_force(&stage, "a/walk.bvh"), (None, None, None, vec![(2, 4)]));
}

#[test]
fn what_the_user_says_stays_above_what_the_sidecar_says() {
    let stage = Stage::with(&[("07_01.bvh", &bvh(10, 0)), ("07_01.i3d", &said("Jo"))]);
    stage.scan();
    let id = stage.clip("07_01.bvh").id;
    stage.library.edit(&[id], &[Edit::Field(Field::Subject, Some("Ann".to_owned()))]).unwrap();
    stage.put("07_01.i3d", &said("Someone else"));
    stage.scan();
    assert_eq!(stage.clip("07_01.bvh").subject.as_deref(), Some("Ann"));
    stage.library.edit(&[id], &[Edit::Field(Field::Subject, None)]).unwrap();
    assert_eq!(stage.clip("07_01.bvh").subject.as_deref(), Some("Someone else"));
    std::fs::remove_file(stage.path("07_01.i3d")).unwrap();
    stage.scan();
    assert_eq!(stage.clip("07_01.bvh").subject.as_deref(), Some("07"), "what the name says was below it");
}

#[test]
fn a_clip_that_moves_without_its_sidecar_leaves_it_behind_and_one_that_comes_meets_it() {
    let stage = Stage::with(&[("walk.bvh", &bvh(10, 0)), ("walk.i3d", &said("Jo"))]);
    stage.scan();
    stage.rename("walk.bvh", "run.bvh");
    stage.scan();
    assert_eq!(stage.clip("run.bvh").subject, None);
    stage.put("walk.bvh", &bvh(3, 5));
    stage.scan();
    assert_eq!(stage.clip("walk.bvh").subject.as_deref(), Some("Jo"));
    stage.rename("walk.bvh", "jump.bvh");
    stage.rename("walk.i3d", "jump.i3d");
    stage.scan();
    assert_eq!(stage.clip("jump.bvh").subject.as_deref(), Some("Jo"));
}

#[test]
fn a_sidecar_that_comes_to_name_a_skeleton_pairs_the_motion_with_it() {
    let stage = Stage::with(&[("01.asf", HUMAN), ("01_02.amc", AMC), ("far/off/mine.asf", HUMAN)]);
    stage.scan();
    assert_eq!(stage.clip("01_02.amc").skeleton_reason.as_deref(), Some("it is of the same subject, 01"));
    stage.put("01_02.i3d", "ASF file: far\\off\\mine.asf\n");
    assert_eq!(stage.scan().total, 1);
    let clip = stage.clip("01_02.amc");
    assert_eq!(clip.skeleton_reason.as_deref(), Some("named in the sidecar"));
    assert_eq!(clip.skeleton_path, Some(stage.path("far/off/mine.asf")));
    std::fs::remove_file(stage.path("01_02.i3d")).unwrap();
    stage.scan();
    assert_eq!(stage.clip("01_02.amc").skeleton_reason.as_deref(), Some("it is of the same subject, 01"));
}

#[test]
fn what_is_written_to_a_sidecar_is_taken_in_at_once_and_what_was_emptied_does_not_come_back() {
    let stage = Stage::with(&[("07_01.bvh", &bvh(10, 0)), ("07_01.i3d", &said("Jo"))]);
    stage.scan();
    let id = stage.clip("07_01.bvh").id;
    let text = || std::fs::read_to_string(stage.path("07_01.i3d")).unwrap();
    let edit = |field, value: Option<&str>| {
        stage.library.edit(&[id], &[Edit::Field(field, value.map(str::to_owned))]).unwrap();
    };
    edit(Field::Description, Some("waves"));
    stage.library.write_sidecar(id, &[], "2026-01-01", "ann").unwrap();
    assert!(text().contains("Comment: waves"), "{}", text());
    edit(Field::Description, None);
    assert_eq!(stage.clip("07_01.bvh").description.as_deref(), Some("waves"), "the sidecar says it too");

    edit(Field::Subject, None);
    stage.library.write_sidecar(id, &[Line::Comment, Line::Subject], "2026-01-01", "ann").unwrap();
    assert!(text().contains("Comment:\r\n") && text().contains("Subject:\r\n"), "{}", text());
    let clip = stage.clip("07_01.bvh");
    assert_eq!((clip.description, clip.subject.as_deref()), (None, Some("07")), "the name of the file says it still");
    let again = stage.scan();
    assert_eq!((again.total, stage.clip("07_01.bvh").description), (0, None));
}

#[test]
fn a_sidecar_that_was_edited_by_the_user_goes_before_what_the_user_said_earlier() {
    let stage = Stage::with(&[("07_01.bvh", &bvh(10, 0)), ("07_01.i3d", &said("Jo"))]);
    stage.scan();
    let id = stage.clip("07_01.bvh").id;
    for (field, value) in [(Field::Subject, "Ann"), (Field::Description, "kept")] {
        stage.library.edit(&[id], &[Edit::Field(field, Some(value.to_owned()))]).unwrap();
    }
    stage.put("07_01.i3d", "Subject: Eva\nUsable segments: 1-3\nComment: other\n");
    stage.library.read_sidecar(id, &[Line::Subject, Line::UsableSegments]).unwrap();
    let clip = stage.clip("07_01.bvh");
    assert_eq!((clip.subject.as_deref(), clip.description.as_deref()), (Some("Eva"), Some("kept")));
    assert_eq!(clip.segments, [(1, 3)]);
    assert!(stage.library.read_sidecar(99, &[]).is_err());
}

#[test]
fn a_new_sidecar_of_a_clip_begins_with_what_the_library_knows() {
    let stage = Stage::with(&[("07_01.bvh", &bvh(10, 0))]);
    stage.scan();
    let id = stage.clip("07_01.bvh").id;
    stage.library.edit(&[id], &[Edit::Field(Field::Description, Some("waves".to_owned()))]).unwrap();
    stage.library.set_segments(id, &[(2, 4)]).unwrap();
    let new = stage.library.sidecar(id).unwrap();
    let value = |line| new.sidecar.get(line).unwrap_or_default();
    assert_eq!((value(Line::Subject), value(Line::Comment), value(Line::UsableSegments)), ("07", "waves", "2-4"));
    assert!(!new.is_on_disk() && !stage.path("07_01.i3d").exists());
    assert!(!value(Line::Date).is_empty(), "the day of the last change, for the user to see");
    stage.library.write_sidecar(id, &[], "2026-01-01", "ann").unwrap();
    assert_eq!(
        stage.library.sidecar(id).unwrap().sidecar.get(Line::Date),
        Some(""),
        "nobody said when it was recorded"
    );
    assert_eq!(stage.clip("07_01.bvh").recorded_on, None);
    stage.put("07_01.i3d", "Comment: by hand\n");
    assert_eq!(stage.library.sidecar(id).unwrap().sidecar.get(Line::Comment), Some("by hand"));
}
