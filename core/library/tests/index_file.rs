//! Lists that describe the clips of a folder, found by scans and read on request.

mod common;

use common::{bvh, Stage};
use motion_theater_library::catalogue::{Edit, Field};

fn described(stage: &Stage, name: &str) -> Option<String> {
    stage.clip(name).description
}

#[test]
fn a_scan_finds_the_list_of_a_folder_and_what_it_says_anew() {
    let list = "Subject,Trial,Description\n2,1,walk\n2,2,jump\n";
    let stage = Stage::with(&[("02/02_01.bvh", &bvh(3, 0)), ("02/02_02.bvh", &bvh(3, 1)), ("index.csv", list)]);
    stage.scan();
    let clip = stage.clip("02/02_01.bvh");
    assert_eq!((clip.description.as_deref(), clip.subject.as_deref()), (Some("walk"), Some("02")));
    assert!(clip.sources.contains(&("description".to_owned(), "INDEX".to_owned())), "{:?}", clip.sources);

    stage.put("index.csv", "Subject,Trial,Description\n2,1,run\n");
    assert_eq!(stage.scan().done, 0);
    assert_eq!(described(&stage, "02/02_01.bvh").as_deref(), Some("run"));
    assert_eq!(described(&stage, "02/02_02.bvh").as_deref(), Some("jump"));
}

#[test]
fn a_list_further_in_is_believed_before_those_around_it() {
    let stage = Stage::with(&[
        ("a/b/walk.bvh", &bvh(3, 0)),
        ("a/index.csv", "file,description,session\nwalk,outer,studio\n"),
        ("a/b/walks-index.txt", "walk.bvh\tinner\n"),
    ]);
    stage.scan();
    let clip = stage.clip("a/b/walk.bvh");
    assert_eq!((clip.description.as_deref(), clip.session_group.as_deref()), (Some("inner"), Some("studio")));
}

#[test]
fn the_user_is_believed_before_a_list() {
    let stage = Stage::with(&[("walk.bvh", &bvh(3, 0)), ("index.csv", "file,description\nwalk,a list\n")]);
    stage.scan();
    let id = stage.clip("walk.bvh").id;
    let edit = |text: Option<&str>| {
        let edit = Edit::Field(Field::Description, text.map(str::to_owned));
        stage.library.edit(&[id], &[edit]).expect("an edit");
    };
    edit(Some("mine"));
    stage.scan();
    assert_eq!(described(&stage, "walk.bvh").as_deref(), Some("mine"));
    edit(None);
    assert_eq!(described(&stage, "walk.bvh").as_deref(), Some("a list"));
}

#[test]
fn a_list_that_makes_no_sense_stops_no_scan_and_is_refused_by_name() {
    let stage = Stage::with(&[("walk.bvh", &bvh(3, 0)), ("index.csv", "nothing of use\n")]);
    assert_eq!(stage.scan().new, 1);
    let message = stage.library.import_index(&stage.path("index.csv"), None).expect_err("no list").to_string();
    assert!(message.contains("index.csv: expected a header with a column for the file"), "{message}");
}

#[test]
fn a_list_from_elsewhere_describes_the_whole_library() {
    let stage = Stage::with(&[
        ("a/walk.bvh", &bvh(3, 0)),
        ("b/jump.bvh", &bvh(3, 1)),
        ("a/list.csv", "file,note\njump,up\nwalk,on\n"),
    ]);
    stage.scan();
    assert_eq!(stage.library.import_index(&stage.path("a/list.csv"), None).expect("a list"), 1);
    assert_eq!(described(&stage, "b/jump.bvh"), None);
    let elsewhere = tempfile::tempdir().expect("a folder");
    let path = elsewhere.path().join("list.csv");
    std::fs::write(&path, "file,note\njump,up\nwalk,on\n").expect("a list");
    assert_eq!(stage.library.import_index(&path, None).expect("a list"), 2);
    assert_eq!(described(&stage, "b/jump.bvh").as_deref(), Some("up"));
}

#[test]
fn what_a_list_says_goes_with_a_clip_that_moves() {
    let stage = Stage::with(&[("a/walk.bvh", &bvh(3, 0)), ("a/index.csv", "file,description\nwalk,a list\n")]);
    stage.scan();
    stage.rename("a/walk.bvh", "b/other.bvh");
    assert_eq!(stage.scan().moved, 1);
    assert_eq!(described(&stage, "b/other.bvh").as_deref(), Some("a list"));
}
