//! Lists as people write them.

use super::*;
use proptest::prelude::*;

/// What a list says: `which: field value, ...`, one line for each row.
fn told(list: &str) -> Vec<String> {
    let shown = |row: Row| {
        let says: Vec<_> = row.says.iter().map(|(field, value)| format!("{} {value}", field.name())).collect();
        let which = row.file.unwrap_or_else(|| format!("{:?}", row.numbers.unwrap_or_default()));
        format!("{which}: {}", says.join(", "))
    };
    read(list.as_bytes(), None).map_or_else(|error| vec![error], |rows| rows.into_iter().map(shown).collect())
}

#[test]
fn columns_are_known_by_what_stands_over_them() {
    assert_eq!(
        told("Subject,Motion,Description,FPS\r\n2,1,\"walk, slowly\",120\r\n"),
        ["(2, 1): description walk, slowly"]
    );
    assert_eq!(
        told("File name;Date;Session;Cleaned;Actor\na.bvh;31.5.2004;A;ja;Jo\nb.bvh;soon;;perhaps;7\n"),
        ["a.bvh: subject Jo, recorded_on 2004-05-31, session_group A, cleaned 1", "b.bvh: subject 7"]
    );
    assert_eq!(told("file,subject,note\n2_1,02,a\n2_1,5,b\n"), ["2_1: description a", "2_1: subject 5, description b"]);
    assert_eq!(told("Our clips\n\nTrial\tSubject\tComments\n3\t07\tjump\n"), ["(7, 3): description jump"]);
}

#[test]
fn a_list_without_a_header_has_the_clip_first() {
    let list =
        "Motion capture of our studio\n\nSubject #1 (climbs)\n01_01\tforward jumps, turn around\n\t01_02 \tclimb\n";
    assert_eq!(told(list), ["01_01: description forward jumps, turn around", "01_02: description climb"]);
    assert_eq!(told("walk.bvh walks and stops\nnothing here\n"), ["walk.bvh: description walks and stops"]);
}

#[test]
fn columns_can_be_named() {
    let columns = |pairs: &[(&str, &str)]| pairs.iter().map(|(a, b)| ((*a).to_owned(), (*b).to_owned())).collect();
    let list = "Nr,Was\nwalk,geht\n".as_bytes();
    let rows = read(list, Some(&columns(&[("file", "nr"), ("description", "Was")]))).expect("two columns");
    assert_eq!(rows[0].says, [(Field::Description, "geht".to_owned())]);
    let error = |pairs: &[(&str, &str)]| read(list, Some(&columns(pairs))).expect_err("a wrong mapping");
    assert_eq!(error(&[("file", "Name")]), "no column is called `Name`: there are Nr, Was");
    assert!(error(&[("weight", "Nr")]).ends_with("cleaned, found `weight`"));
    assert!(error(&[("file", "Nr")]).starts_with("expected a column `file`, or"));
}

#[test]
fn a_file_that_is_no_list_is_refused() {
    assert!(told("some notes\nof mine\n")[0].starts_with("expected a header"));
    assert!(told("")[0].starts_with("expected a header"));
}

#[test]
fn rows_find_clips_by_name_by_path_and_by_numbers() {
    let clips =
        ["/c/02/02_01.amc", "/c/02/02_01.bvh", "/c/x/Walk.BVH", "/c/y/walk.bvh", "/c/09_06-run.amc", "/c/v1.2.c3d"];
    let names = Names::of(clips.iter().enumerate().map(|(id, path)| (id as i64, (*path).to_owned())));
    for (file, expected) in [
        ("02_01", vec![0, 1]),
        ("02_01.AMC", vec![0]),
        ("walk", vec![2, 3]),
        ("x\\walk.bvh", vec![2]),
        ("./y/walk", vec![3]),
        ("9_6", vec![4]),
        ("v1.2", vec![5]),
        ("alk", vec![]),
    ] {
        let mut meant = names.meant(Some(file), names::numbers(names::stem(file)));
        meant.sort_unstable();
        assert_eq!(meant, expected, "{file}");
    }
    assert_eq!(names.meant(None, Some((2, 1))), [0, 1]);
}

#[test]
fn lists_are_known_by_their_names() {
    for name in ["index.csv", "cmu-mocap-index-text.txt", "Mocap_Index.TSV"] {
        assert!(is_index(Path::new(name)), "{name}");
    }
    for name in ["indexes.csv", "index.bvh", "walk.csv", "index", "index/walk.csv"] {
        assert!(!is_index(Path::new(name)), "{name}");
    }
}

proptest! {
    #[test]
    fn no_bytes_make_it_panic(bytes: Vec<u8>, list in "((file|subject|trial|date|02_01|a.bvh|[,;\t\n\"])){0,40}") {
        let _ = (read(&bytes, None), read(list.as_bytes(), None));
    }
}
