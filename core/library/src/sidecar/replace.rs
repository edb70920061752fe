//! A file replaced as a whole.

use std::fs::{self, File};
use std::io;
use std::path::{Path, PathBuf};

use tempfile::NamedTempFile;

use super::SidecarError;

/// Links that lead to links are followed so many times.
const MOST_LINKS: usize = 40;

/// Puts new bytes in the place of a file: written beside it under another name, brought to the disk, and renamed. On an
/// error nothing is left behind and the file is what it was. `write` writes the bytes.
pub(super) fn replace(
    path: &Path,
    bytes: &[u8],
    write: impl FnOnce(&mut File, &[u8]) -> io::Result<()>,
) -> Result<(), SidecarError> {
    let not_saved = |source| SidecarError::NotSaved { path: path.to_owned(), source };
    let target = target_of(path).map_err(not_saved)?;
    let old = fs::metadata(&target).ok().map(|metadata| metadata.permissions());
    if old.as_ref().is_some_and(fs::Permissions::readonly) {
        return Err(SidecarError::ReadOnly(path.to_owned()));
    }
    let write_all = || {
        let folder = target.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
        let mut unfinished = unfinished_in(folder)?;
        write(unfinished.as_file_mut(), bytes)?;
        if let Some(old) = old {
            unfinished.as_file().set_permissions(old)?;
        }
        unfinished.as_file().sync_all()?;
        unfinished.persist(&target).map_err(|error| error.error)?;
        Ok(())
    };
    write_all().map_err(not_saved)
}

/// Makes a file that is removed again unless it takes the place of another. Whoever may read any new file may read it, where
/// `tempfile` by itself makes one for its owner alone.
fn unfinished_in(folder: &Path) -> io::Result<NamedTempFile> {
    let mut code = None;
    let create = |path: &Path| File::create_new(path).inspect_err(|error| code = error.raw_os_error());
    let made = tempfile::Builder::new().prefix(".sidecar-").suffix(".part").make_in(folder, create);
    // What the system said comes back inside a message with a name that tells nobody anything.
    made.map_err(|error| code.map_or(error, io::Error::from_raw_os_error))
}

/// Returns the file that a path stands for, through links, also where the last of them leads to nothing yet.
fn target_of(path: &Path) -> io::Result<PathBuf> {
    let mut target = path.to_owned();
    for _ in 0..MOST_LINKS {
        match fs::read_link(&target) {
            Ok(next) => target = target.parent().unwrap_or(Path::new("")).join(next),
            Err(_) => return Ok(target),
        }
    }
    Err(io::Error::other("links that lead in a circle"))
}
