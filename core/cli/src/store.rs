//! Files that are there whole or not at all.

use std::fs;
use std::path::{Path, PathBuf};

use motion_theater_core::error::words;

/// Writes a file under another name and renames it then, so that whoever looks sees the old file or the new one. Makes the
/// folders that it lies in.
pub fn store(path: &Path, bytes: &[u8]) -> Result<(), String> {
    let wrong = |error: std::io::Error| format!("{}: {}", path.display(), words(&error));
    if let Some(folder) = path.parent() {
        fs::create_dir_all(folder).map_err(wrong)?;
    }
    let unfinished = unfinished_name(path);
    let written = fs::write(&unfinished, bytes).and_then(|()| fs::rename(&unfinished, path));
    written.map_err(|error| {
        // What cannot be removed either is only a file without a use.
        let _ = fs::remove_file(&unfinished);
        wrong(error)
    })
}

/// A name in the same folder, of this process alone, with an extension that no format has.
fn unfinished_name(path: &Path) -> PathBuf {
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    path.with_file_name(format!(".{name}.{}.part", std::process::id()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_file_that_cannot_be_written_leaves_nothing_behind() {
        let folder = std::env::temp_dir().join(format!("motion-theater-store-{}", std::process::id()));
        fs::create_dir_all(folder.join("taken.bvh/inside")).unwrap();
        let error = store(&folder.join("taken.bvh"), b"text").unwrap_err();
        assert!(error.starts_with(&format!("{}: ", folder.join("taken.bvh").display())), "{error}");
        assert_eq!(fs::read_dir(&folder).unwrap().count(), 1);
        store(&folder.join("new/deep/a.bvh"), b"text").unwrap();
        assert_eq!(fs::read(folder.join("new/deep/a.bvh")).unwrap(), b"text");
        assert_eq!(fs::read_dir(folder.join("new/deep")).unwrap().count(), 1);
        fs::remove_dir_all(folder).unwrap();
    }
}
