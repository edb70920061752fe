//! Sidecars on a real disk, and on one that fails.

use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use tempfile::TempDir;

use super::*;

const OLD: &[u8] = b"Subject: J\xF6rg\r\nWeather: rain\r\n";

/// The same with a comment.
const COMMENTED: &[u8] = b"Subject: J\xF6rg\r\nComment: new\r\nWeather: rain\r\n";

fn folder() -> TempDir {
    tempfile::tempdir().unwrap()
}

fn old_one(folder: &TempDir) -> (PathBuf, SidecarFile) {
    let path = folder.path().join("02_03.i3d");
    fs::write(&path, OLD).unwrap();
    let opened = SidecarFile::open(&path).unwrap();
    (path, opened)
}

fn our_clip(folder: &Path) -> PathBuf {
    let data = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../testdata");
    fs::copy(data.join("human.asf"), folder.join("02.asf")).unwrap();
    fs::copy(data.join("wave.amc"), folder.join("02_03.amc")).unwrap();
    folder.join("02_03.amc")
}

fn names(folder: &TempDir) -> Vec<String> {
    let entries = fs::read_dir(folder.path()).unwrap();
    let mut names: Vec<_> = entries.map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
    names.sort();
    names
}

#[test]
fn a_new_one_has_what_the_clip_tells_and_is_on_disk_once_it_is_saved() {
    let folder = folder();
    let clip = our_clip(folder.path());
    let mut new = SidecarFile::beside(&clip).unwrap();
    assert_eq!((new.path(), new.is_on_disk(), new.is_edited()), (&*folder.path().join("02_03.i3d"), false, true));
    let told = [Field::Subject, Field::Duration, Field::FrameRate, Field::AsfFile, Field::Comment];
    assert_eq!(told.map(|field| new.sidecar.get(field).unwrap()), ["02", "2", "60", "02.asf", ""]);
    assert_eq!(new.sidecar.get(Field::Date).map(str::len), Some("2004-05-31".len()));
    assert!(!new.path().exists());
    new.save().unwrap();
    let text = fs::read_to_string(new.path()).unwrap();
    assert_eq!(text.lines().count(), 11);
    assert!(!SidecarFile::beside(&clip).unwrap().is_edited());
}

#[test]
fn a_skeleton_of_the_folder_above_is_named_from_the_clip() {
    let folder = folder();
    let clip = our_clip(folder.path());
    fs::create_dir(folder.path().join("takes")).unwrap();
    let moved = folder.path().join("takes/02_03.amc");
    fs::rename(clip, &moved).unwrap();
    let mut new = SidecarFile::beside(&moved).unwrap();
    assert_eq!(new.sidecar.get(Field::AsfFile), Some("../02.asf"));
    new.save().unwrap();
    // Found again by what the sidecar says.
    let notices = Loaded::read(&moved, None).unwrap().notices;
    assert!(notices.iter().any(|notice| notice.ends_with("02.asf, because named in the sidecar")), "{notices:?}");
}

#[test]
fn an_edit_is_saved_and_everything_else_stays() {
    let folder = folder();
    let (path, mut opened) = old_one(&folder);
    opened.save().unwrap();
    opened.sidecar.set(Field::Subject, "Jörn").unwrap();
    assert_eq!(fs::read(&path).unwrap(), OLD, "nothing is written before it is saved");
    opened.stamp("2004-06-01", "jo").unwrap();
    opened.save().unwrap();
    let wanted = b"Subject: J\xF6rn\r\nLast changed on: 2004-06-01\r\nModified by: jo\r\nWeather: rain\r\n";
    assert_eq!(fs::read(&path).unwrap(), wanted);
    assert_eq!(names(&folder), ["02_03.i3d"]);
}

#[test]
fn what_the_user_says_of_the_change_is_not_stamped_over() {
    let folder = folder();
    let (_, mut opened) = old_one(&folder);
    opened.stamp("2004-06-01", "jo").unwrap();
    assert!(!opened.is_edited(), "nothing was changed");
    opened.sidecar.set(Field::ModifiedBy, "Ann").unwrap();
    opened.stamp("2004-06-01", "jo").unwrap();
    assert_eq!(opened.sidecar.get(Field::ModifiedBy), Some("Ann"));
    assert_eq!(opened.sidecar.get(Field::LastChange), Some("2004-06-01"));
}

#[test]
fn a_disk_that_fills_up_leaves_the_old_file_and_nothing_else() {
    let folder = folder();
    let (path, mut opened) = old_one(&folder);
    opened.sidecar.set(Field::Comment, "new").unwrap();
    for written in [0, 1, OLD.len()] {
        let full = |file: &mut fs::File, bytes: &[u8]| {
            file.write_all(&bytes[..written])?;
            Err(io::Error::from(io::ErrorKind::StorageFull))
        };
        let message = opened.save_with(full).unwrap_err().to_string();
        assert_eq!(message, format!("{}: not saved, and left as it was: no storage space", path.display()));
        assert_eq!((fs::read(&path).unwrap(), names(&folder)), (OLD.to_vec(), vec!["02_03.i3d".to_owned()]));
    }
    opened.save().unwrap();
    assert_eq!(fs::read(&path).unwrap(), COMMENTED);
}

#[test]
fn a_read_only_file_is_left_alone() {
    let folder = folder();
    let (path, mut opened) = old_one(&folder);
    let mut permissions = fs::metadata(&path).unwrap().permissions();
    permissions.set_readonly(true);
    fs::set_permissions(&path, permissions).unwrap();
    opened.sidecar.set(Field::Comment, "new").unwrap();
    let message = opened.save().unwrap_err().to_string();
    assert_eq!(message, format!("{}: not saved, for the file is read-only", path.display()));
    assert_eq!(fs::read(&path).unwrap(), OLD);
}

#[test]
fn what_someone_else_wrote_meanwhile_is_not_overwritten() {
    let folder = folder();
    let (path, mut opened) = old_one(&folder);
    opened.sidecar.set(Field::Comment, "mine").unwrap();
    fs::write(&path, b"Comment: theirs\n").unwrap();
    assert!(matches!(opened.save(), Err(SidecarError::ChangedMeanwhile(_))));
    assert_eq!(fs::read(&path).unwrap(), b"Comment: theirs\n");

    let clip = our_clip(folder.path());
    let other = folder.path().join("03_01.amc");
    fs::rename(clip, &other).unwrap();
    let mut new = SidecarFile::beside(&other).unwrap();
    fs::write(folder.path().join("03_01.i3d"), b"Comment: theirs\n").unwrap();
    assert!(matches!(new.save(), Err(SidecarError::ChangedMeanwhile(_))));
}

#[cfg(unix)]
#[test]
fn permissions_stay_and_a_link_stays_a_link() {
    use std::os::unix::fs::{symlink, PermissionsExt};
    let folder = folder();
    let (path, _) = old_one(&folder);
    fs::set_permissions(&path, fs::Permissions::from_mode(0o640)).unwrap();
    let link = folder.path().join("link.i3d");
    symlink("02_03.i3d", &link).unwrap();
    let mut opened = SidecarFile::open(&link).unwrap();
    opened.sidecar.set(Field::Comment, "new").unwrap();
    opened.save().unwrap();
    assert!(fs::symlink_metadata(&link).unwrap().is_symlink());
    assert_eq!(fs::metadata(&path).unwrap().permissions().mode() & 0o777, 0o640);
    assert_eq!(fs::read(&path).unwrap(), COMMENTED);

    symlink("nowhere/b.i3d", folder.path().join("away.i3d")).unwrap();
    symlink("circle.i3d", folder.path().join("circle.i3d")).unwrap();
    for broken in ["away.i3d", "circle.i3d"] {
        let opened = SidecarFile::open(&folder.path().join(broken));
        assert!(matches!(opened, Err(SidecarError::NotRead { .. })));
    }
}

#[test]
fn what_is_no_sidecar_by_its_size_is_refused() {
    let folder = folder();
    let path = folder.path().join("a.i3d");
    fs::write(&path, vec![b'x'; 2 << 20]).unwrap();
    let message = SidecarFile::open(&path).unwrap_err().to_string();
    assert_eq!(message, format!("{}: this is no sidecar, it has more than 1048576 bytes", path.display()));
    assert!(matches!(SidecarFile::beside(&path), Err(SidecarError::TooLarge(_))));
}

#[test]
fn the_catalogue_is_told_what_it_can_keep() {
    let text = "Date: 31.5.2004\nGroup: dance\nSubject: 07\nCleaned: ja\nComment: a: b\nDuration: 9\n";
    let wanted = [
        ("subject", "07"),
        ("recorded_on", "2004-05-31"),
        ("session_group", "dance"),
        ("description", "a: b"),
        ("cleaned", "1"),
    ];
    let said = told(&Sidecar::parse(text.as_bytes()));
    assert_eq!(said.iter().map(|(name, value)| (*name, value.as_str())).collect::<Vec<_>>(), wanted);
    assert_eq!(told(&Sidecar::parse(b"Date: soon\nCleaned: perhaps\nGroup:\n")), []);
}

#[test]
fn segments_are_written_as_they_are_read() {
    use motion_theater_core::sidecar::{segments, Segment};
    let pieces = [
        Segment { first_frame: 20, last_frame: 180, note: String::new() },
        Segment { first_frame: 200, last_frame: 316, note: "walks on".to_owned() },
    ];
    assert_eq!(segments_text(&pieces), "20-180, 200-316 (walks on)");
    assert_eq!(segments(&segments_text(&pieces)), pieces);
    let below_zero = [(-10, -2), (-1, 0), (0, 0), (0, 5)].map(|(first_frame, last_frame)| Segment {
        first_frame,
        last_frame,
        note: String::new(),
    });
    assert_eq!(segments_text(&below_zero), "-10 to -2, -1 to 0, 0-0, 0-5");
    assert_eq!(segments(&segments_text(&below_zero)), below_zero);
}
