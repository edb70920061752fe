//! What scans make of folders: new, changed, moved, missing and broken files.

mod common;

use std::collections::HashMap;
use std::sync::{Arc, Mutex};

use common::{bvh, Stage};
use motion_theater_core::loaded::Loaded;
use motion_theater_library::catalogue::{Edit, Field};
use motion_theater_library::query::{Order, Query};
use motion_theater_library::scan::{Options, Previews, Scan};
use motion_theater_library::LibraryError;

const ASF: &str = include_str!("../../src/pairing/default_skeleton.asf");
const AMC: &str = ":FULLY-SPECIFIED\n:DEGREES\n1\nroot 0 0 0 0 0 0\nlfemur 1 2 3\n2\nroot 0 0 0 0 0 0\nlfemur 1 2 3\n";

fn texts(edits: &[(Field, &str)]) -> Vec<Edit> {
    edits.iter().map(|(field, text)| Edit::Field(*field, Some((*text).to_owned()))).collect()
}

#[test]
fn a_scan_tells_what_is_in_files() {
    let stage = Stage::with(&[("a/walk.bvh", &bvh(10, 0)), ("notes.md", "# none"), (".git/x.bvh", &bvh(2, 0))]);
    let progress = stage.scan();
    assert_eq!((progress.new, progress.total, progress.done, progress.broken), (1, 1, 1, 0));
    let clip = stage.clip("a/walk.bvh");
    assert_eq!((clip.name.as_str(), clip.folder.as_str(), clip.format.as_str()), ("walk.bvh", "clips/a", "bvh"));
    assert_eq!((clip.frames, clip.first_frame, clip.rate_hz), (Some(10), Some(1), Some(50.0)));
    assert_eq!((clip.duration_s, clip.joints, clip.markers), (Some(0.2), Some(2), None));
    assert_eq!((clip.error, clip.is_missing, clip.unit_m, clip.up.as_deref()), (None, false, Some(0.01), Some("Y")));
    let bytes = std::fs::read(stage.path("a/walk.bvh")).unwrap();
    assert_eq!(clip.content_hash, Some(blake3::hash(&bytes).into()));
    assert_eq!(clip.size, bytes.len() as i64);
    assert_eq!(clip.skeleton_fingerprint.map(|text| text.len()), Some(16));
}

#[test]
fn motion_is_known_by_its_content_whatever_it_is_called() {
    let stage =
        Stage::with(&[("walk.txt", &bvh(3, 0)), ("walk", &bvh(4, 0)), ("text.txt", "a text"), ("b.c3d", "no C3D")]);
    stage.scan();
    assert_eq!(stage.clip("walk.txt").format, "bvh");
    assert_eq!(stage.clip("walk").frames, Some(4));
    assert_eq!(stage.find("text.txt"), None);
    let broken = stage.clip("b.c3d");
    assert_eq!((broken.format.as_str(), broken.frames), ("c3d", None));
    assert!(broken.error.is_some_and(|error| error.starts_with("byte 0x1: expected a C3D marker file")));
}

#[test]
fn only_what_changed_is_read_again() {
    let names: Vec<String> = (0..30).map(|i| format!("{}/take_{i}.bvh", i % 3)).collect();
    let texts: Vec<String> = (0..30).map(|i| bvh(5, i)).collect();
    let files: Vec<(&str, &str)> = names.iter().map(String::as_str).zip(texts.iter().map(String::as_str)).collect();
    let stage = Stage::with(&files);
    assert_eq!(stage.scan().new, 30);

    let again = stage.scan();
    assert_eq!((again.total, again.done, again.unchanged), (0, 0, 30));

    (0..10).for_each(|i| stage.put(&names[i], &bvh(7, 100 + i)));
    let changed = stage.scan();
    assert_eq!((changed.total, changed.changed, changed.new, changed.unchanged), (10, 10, 0, 20));
    assert_eq!(stage.clip(&names[0]).frames, Some(7));

    let ids: Vec<i64> = (10..20).map(|i| stage.clip(&names[i]).id).collect();
    (10..20).for_each(|i| stage.rename(&names[i], &format!("moved/{i}.bvh")));
    let moved = stage.scan();
    assert_eq!((moved.total, moved.moved, moved.new, moved.missing), (10, 10, 0, 0));
    let after: Vec<i64> = (10..20).map(|i| stage.clip(&format!("moved/{i}.bvh")).id).collect();
    assert_eq!(after, ids);
    assert_eq!(stage.library.count().unwrap(), 30);

    (20..30).for_each(|i| std::fs::remove_file(stage.path(&names[i])).unwrap());
    let deleted = stage.scan();
    assert_eq!((deleted.total, deleted.missing, deleted.unchanged), (0, 10, 20));
    assert!(stage.clip(&names[20]).is_missing);
    assert_eq!((stage.library.count().unwrap(), stage.scan().missing), (30, 0));
}

#[test]
fn a_moved_clip_keeps_what_people_said_of_it() {
    let stage = Stage::with(&[("a.bvh", &bvh(5, 0)), ("b.bvh", &bvh(5, 1))]);
    stage.scan();
    let id = stage.clip("a.bvh").id;
    stage.library.edit(&[id], &texts(&[(Field::Subject, "Ada")])).unwrap();
    stage.library.edit(&[id], &[Edit::Rating(4), Edit::Favourite(true)]).unwrap();
    stage.library.tag(&[id], &["walk".to_owned()], &[]).unwrap();
    stage.library.set_segments(id, &[(2, 4)]).unwrap();
    stage.rename("a.bvh", "deep/er/c.bvh");
    assert_eq!(stage.scan().moved, 1);
    let clip = stage.clip("deep/er/c.bvh");
    assert_eq!((clip.id, clip.subject.as_deref(), clip.rating, clip.is_favourite), (id, Some("Ada"), 4, true));
    assert_eq!(
        (clip.tags, clip.segments, clip.folder.as_str()),
        (vec!["walk".to_owned()], vec![(2, 4)], "clips/deep/er")
    );
    assert_eq!(stage.find("a.bvh"), None);
}

#[test]
fn a_copy_is_a_clip_of_its_own() {
    let stage = Stage::with(&[("a.bvh", &bvh(5, 0))]);
    stage.scan();
    stage.put("b.bvh", &bvh(5, 0));
    let progress = stage.scan();
    assert_eq!((progress.new, progress.moved), (1, 0));
    assert_ne!(stage.clip("a.bvh").id, stage.clip("b.bvh").id);
}

#[test]
fn a_missing_clip_that_comes_back_is_the_same() {
    let stage = Stage::with(&[("a.bvh", &bvh(5, 0)), ("b.bvh", &bvh(5, 1))]);
    stage.scan();
    let id = stage.clip("a.bvh").id;
    let away = stage.clips.parent().unwrap().join("away.bvh");
    std::fs::rename(stage.path("a.bvh"), &away).unwrap();
    assert_eq!(stage.scan().missing, 1);
    std::fs::rename(&away, stage.path("a.bvh")).unwrap();
    let progress = stage.scan();
    assert_eq!((progress.total, progress.missing), (0, 0));
    let clip = stage.clip("a.bvh");
    assert_eq!((clip.id, clip.is_missing), (id, false));
}

#[test]
fn a_rescan_never_overwrites_what_the_user_wrote() {
    let csm = |actor: &str| format!("$Actor {actor}\n$Rate 60\n$Order a\n$Points\n1 0 0 0\n2 0 0 1\n");
    let stage = Stage::with(&[("a.csm", &csm("Ada"))]);
    stage.scan();
    let clip = stage.clip("a.csm");
    assert_eq!(clip.subject.as_deref(), Some("Ada"));
    assert_eq!(clip.sources, [("subject".to_owned(), "FILE".to_owned())]);
    stage.library.edit(&[clip.id], &texts(&[(Field::Subject, "Grace"), (Field::Cleaned, "1")])).unwrap();
    stage.put("a.csm", &csm("Alan B."));
    assert_eq!(stage.scan().changed, 1);
    let clip = stage.clip("a.csm");
    assert_eq!((clip.subject.as_deref(), clip.cleaned), (Some("Grace"), Some(true)));
    stage.library.edit(&[clip.id], &[Edit::Field(Field::Subject, None), Edit::Field(Field::Cleaned, None)]).unwrap();
    let clip = stage.clip("a.csm");
    assert_eq!((clip.subject.as_deref(), clip.cleaned), (Some("Alan B."), None), "what was below it shows again");
}

#[test]
fn a_sidecar_goes_before_the_file_and_the_user_before_both() {
    let csm = "$Actor Ada\n$Rate 60\n$Order a\n$Points\n1 0 0 0\n2 0 0 1\n";
    let stage = Stage::with(&[("a.csm", csm), ("a.i3d", "Subject: Grace\nCleaned: Yes\nDate: 2004-05-31\n")]);
    assert_eq!(stage.scan().new, 1);
    let clip = stage.clip("a.csm");
    assert_eq!((clip.subject.as_deref(), clip.cleaned), (Some("Grace"), Some(true)));
    assert_eq!(clip.recorded_on.as_deref(), Some("2004-05-31"));
    assert_eq!(clip.sources[2], ("subject".to_owned(), "SIDECAR".to_owned()));
    assert_eq!(stage.scan().total, 0);
    stage.library.edit(&[clip.id], &texts(&[(Field::Subject, "Alan")])).unwrap();
    stage.put("a.i3d", "Subject: Mary\n");
    let progress = stage.scan();
    assert_eq!((progress.total, progress.changed), (0, 0), "the motion is what it was");
    let clip = stage.clip("a.csm");
    assert_eq!((clip.subject.as_deref(), clip.cleaned), (Some("Alan"), None));
    std::fs::remove_file(stage.path("a.i3d")).unwrap();
    stage.library.edit(&[clip.id], &[Edit::Field(Field::Subject, None)]).unwrap();
    assert_eq!(stage.scan().total, 0);
    assert_eq!(stage.clip("a.csm").subject.as_deref(), Some("Ada"));
}

#[test]
fn clips_are_found_by_their_words_as_soon_as_they_are_scanned() {
    let csm = "$Actor Ada\n$Rate 60\n$Order a\n$Points\n1 0 0 0\n2 0 0 1\n";
    let stage = Stage::with(&[("slow/walk.bvh", &bvh(5, 0)), ("run.csm", csm)]);
    stage.scan();
    let found = |words: &str| {
        let query = Query::parse(words).unwrap();
        let clips = stage.library.clips(&stage.library.search(&query, Order::default()).unwrap()).unwrap();
        clips.into_iter().map(|clip| clip.name).collect::<Vec<_>>()
    };
    assert_eq!(
        (found("walk"), found("slow wa"), found("ada")),
        (vec!["walk.bvh".into()], vec!["walk.bvh".into()], vec!["run.csm".into()])
    );
    stage.rename("slow/walk.bvh", "fast/jog.bvh");
    stage.put("run.csm", &csm.replace("Ada", "Grace"));
    stage.scan();
    assert_eq!(
        (found("walk"), found("jog"), found("ada"), found("grace")),
        (vec![], vec!["jog.bvh".into()], vec![], vec!["run.csm".into()])
    );
    let run = stage.clip("run.csm").id;
    stage.library.tag(&[run], &["quick".to_owned()], &[]).unwrap();
    assert_eq!(found("quick"), ["run.csm"], "what keeps the words up to date is awake again");
}

#[test]
fn a_motion_is_paired_anew_when_its_skeleton_comes() {
    let stage = Stage::with(&[("01_01.amc", AMC)]);
    stage.scan();
    let clip = stage.clip("01_01.amc");
    assert_eq!((clip.skeleton_path, clip.subject.as_deref()), (None, Some("01")));
    stage.put("01.asf", ASF);
    let progress = stage.scan();
    assert_eq!((progress.new, progress.total, progress.changed), (1, 2, 0));
    let clip = stage.clip("01_01.amc");
    assert_eq!(clip.skeleton_path, Some(stage.path("01.asf")));
    assert_eq!(clip.skeleton_reason.as_deref(), Some("it is of the same subject, 01"));
    assert_eq!(clip.height_m, stage.clip("01.asf").height_m);
    assert_eq!(stage.scan().total, 0);
}

#[test]
fn a_clip_belongs_to_the_innermost_folder() {
    let stage = Stage::with(&[("a.bvh", &bvh(5, 0)), ("in/b.bvh", &bvh(5, 1))]);
    stage.scan();
    let counts = || {
        let folders = stage.library.folders().unwrap();
        folders.into_iter().map(|folder| folder.clips).collect::<Vec<_>>()
    };
    assert_eq!((counts(), stage.clip("in/b.bvh").folder.as_str()), (vec![2], "clips/in"));
    stage.library.add_folder(&stage.path("in")).unwrap();
    assert_eq!((counts(), stage.clip("in/b.bvh").folder.as_str()), (vec![1, 1], "in"));
    assert_eq!(stage.scan().unchanged, 2, "no file is looked at twice");
    stage.library.remove_folder(&stage.path("in")).unwrap();
    assert_eq!((counts(), stage.clip("in/b.bvh").folder.as_str()), (vec![2], "clips/in"));
    stage.library.remove_folder(&stage.clips).unwrap();
    assert_eq!((counts(), stage.library.count().unwrap()), (vec![], 0));
}

#[cfg(unix)]
#[test]
fn names_that_are_no_text_are_kept() {
    use std::ffi::OsStr;
    use std::os::unix::ffi::OsStrExt;
    let stage = Stage::with(&[]);
    let path = stage.clips.join(OsStr::from_bytes(b"M\xFCller.bvh"));
    std::fs::write(&path, bvh(5, 0)).unwrap();
    assert_eq!(stage.scan().new, 1);
    assert_eq!(stage.scan().unchanged, 1);
    let id = stage.library.find(&path).unwrap().expect("a clip");
    let clip = stage.library.clips(&[id]).unwrap().remove(0);
    assert_eq!((clip.path, clip.name.as_str()), (path, "M\u{FFFD}ller.bvh"));
}

#[test]
fn two_scans_at_once_find_everything_once() {
    let names: Vec<String> = (0..60).map(|i| format!("take_{i}.bvh")).collect();
    let texts: Vec<String> = (0..60).map(|i| bvh(50, i)).collect();
    let files: Vec<(&str, &str)> = names.iter().map(String::as_str).zip(texts.iter().map(String::as_str)).collect();
    let stage = Stage::with(&files);
    std::thread::scope(|scope| {
        let scans = [scope.spawn(|| stage.scan()), scope.spawn(|| stage.scan())];
        // Readers go on meanwhile.
        for _ in 0..50 {
            stage.library.folders().unwrap();
        }
        for scan in scans {
            scan.join().expect("no scan fails");
        }
    });
    assert_eq!(stage.library.count().unwrap(), 60);
    assert_eq!(stage.scan().unchanged, 60);
}

/// Remembers what it was asked to draw.
#[derive(Default)]
struct Sketchbook(Mutex<HashMap<[u8; 32], usize>>);

impl Previews for Sketchbook {
    fn missing(&self, hashes: &[[u8; 32]]) -> Result<Vec<[u8; 32]>, LibraryError> {
        let drawn = self.0.lock().unwrap();
        Ok(hashes.iter().filter(|hash| !drawn.contains_key(*hash)).copied().collect())
    }

    fn make(&self, hash: &[u8; 32], loaded: &Loaded) -> Result<(), LibraryError> {
        self.0.lock().unwrap().insert(*hash, loaded.frame_count());
        Ok(())
    }
}

#[test]
fn previews_are_drawn_once_and_find_what_looking_over_does_not() {
    // Right after the frames that say how a figure stands, a number with two exponents.
    let damaged = bvh(200, 0).replacen("1.5 2 3 0.25", "1e2e3 2 3 0.25", 1);
    let stage = Stage::with(&[("a.bvh", &bvh(5, 0)), ("copy.bvh", &bvh(5, 0)), ("damaged.bvh", &damaged)]);
    let book = Arc::new(Sketchbook::default());
    let options = || Options { previews: Some(book.clone()), ..Options::default() };
    let scan = || {
        let scan = Scan::start(&stage.library, &options()).unwrap();
        assert!(scan.wait(None));
        scan.progress()
    };
    let first = scan();
    assert_eq!((first.new, first.previews_total, first.previews_done, first.broken), (3, 2, 2, 1));
    assert_eq!(book.0.lock().unwrap().values().copied().collect::<Vec<_>>(), [5]);
    let error = stage.clip("damaged.bvh").error.expect("the damage was found");
    assert!(error.contains("found `1e2e3`"), "{error}");
    let second = scan();
    assert_eq!((second.total, second.previews_total), (0, 0));
    stage.put("damaged.bvh", &bvh(6, 9));
    let mended = scan();
    assert_eq!((mended.changed, mended.previews_done, stage.clip("damaged.bvh").error), (1, 1, None));
}

#[test]
fn a_scan_that_is_cancelled_keeps_what_was_read() {
    let names: Vec<String> = (0..50).map(|i| format!("take_{i}.bvh")).collect();
    let texts: Vec<String> = (0..50).map(|i| bvh(2000, i)).collect();
    let files: Vec<(&str, &str)> = names.iter().map(String::as_str).zip(texts.iter().map(String::as_str)).collect();
    let stage = Stage::with(&files);
    let scan = Scan::start(&stage.library, &Options { jobs: Some(1), ..Options::default() }).unwrap();
    scan.cancel();
    assert!(scan.wait(None));
    let so_far = u64::from(stage.library.count().unwrap());
    assert!(so_far < 50);
    let rest = stage.scan();
    assert_eq!((rest.new, rest.unchanged), (50 - so_far, so_far));
}
