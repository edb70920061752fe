//! Opening files that are libraries and files that are not.

use super::*;

fn folder() -> tempfile::TempDir {
    tempfile::tempdir().expect("a folder for the test")
}

#[test]
fn a_library_is_made_and_opened_again() {
    let folder = folder();
    let path = folder.path().join("clips.sqlite");
    let count =
        |library: &Library| library.read(|db| Ok(db.query_row("SELECT count(*) FROM clip", (), |row| row.get(0))?));
    for _ in 0..2 {
        let clips: i64 = count(&Library::open(&path).expect("a library")).expect("a table of clips");
        assert_eq!(clips, 0);
    }
}

#[test]
fn a_new_library_that_several_threads_open_at_once_is_made_once_and_is_theirs() {
    for _ in 0..20 {
        let folder = folder();
        let path = folder.path().join("clips.sqlite");
        std::thread::scope(|scope| {
            let opening: Vec<_> = (0..6).map(|_| scope.spawn(|| Library::open(&path)?.folders())).collect();
            for thread in opening {
                assert_eq!(thread.join().expect("no panic").expect("a library"), []);
            }
        });
    }
}

#[test]
fn files_that_are_no_library_are_left_alone() {
    let folder = folder();
    let text = folder.path().join("notes.txt");
    std::fs::write(&text, "no database, but longer than the header of one. ".repeat(20)).unwrap();
    let other = folder.path().join("other.sqlite");
    Connection::open(&other).unwrap().execute_batch("CREATE TABLE songs (name TEXT)").unwrap();
    for (path, found) in [(&text, "a file of another kind"), (&other, "the database of another program")] {
        let before = std::fs::read(path).unwrap();
        let message = Library::open(path).expect_err("no library").to_string();
        assert_eq!(message, format!("{}: {found}, not a library of clips; it was left as it is", path.display()));
        assert_eq!(std::fs::read(path).unwrap(), before);
    }
    let message = Library::open(folder.path()).expect_err("a folder").to_string();
    assert!(message.contains("a folder, not a library of clips"), "{message}");
}

#[test]
fn a_library_of_a_later_version_is_left_alone() {
    let folder = folder();
    let path = folder.path().join("clips.sqlite");
    drop(Library::open(&path).unwrap());
    Connection::open(&path).unwrap().pragma_update(None, "user_version", 7).unwrap();
    let before = std::fs::read(&path).unwrap();
    let error = Library::open(&path).expect_err("a later version");
    assert!(matches!(error, LibraryError::Newer { found: 7, known: 1, .. }), "{error}");
    assert_eq!(std::fs::read(&path).unwrap(), before);
}

#[test]
fn a_change_that_fails_changes_nothing() {
    let folder = folder();
    let library = Library::open(&folder.path().join("clips.sqlite")).unwrap();
    let failed: Result<(), LibraryError> = library.write(|transaction| {
        transaction.execute("INSERT INTO folder (path, added_at) VALUES ('/clips', 0)", ())?;
        Err(LibraryError::Asked("no".to_owned()))
    });
    assert!(failed.is_err());
    let folders: i64 =
        library.read(|db| Ok(db.query_row("SELECT count(*) FROM folder", (), |row| row.get(0))?)).unwrap();
    assert_eq!(folders, 0);
}
