//! The motion files of a folder, those of its folders too.

use std::path::{Path, PathBuf};

use motion_theater_core::error::words;
use motion_theater_core::read::Format;

/// What a path stands for.
pub enum Found {
    /// A file, or nothing that is there: reading it will tell.
    File(PathBuf),
    /// The motion files of a folder, in alphabetical order, each with its path below the folder.
    Folder(Vec<(PathBuf, PathBuf)>),
}

/// Looks at a path. In a folder files count whose extension is that of a known format; what lies below `except` does not.
///
/// # Errors
/// Where a folder cannot be listed, in words.
pub fn look(path: &Path, except: Option<&Path>) -> Result<Found, String> {
    if !path.is_dir() {
        return Ok(Found::File(path.to_owned()));
    }
    let except = except.and_then(|folder| folder.canonicalize().ok());
    let mut files = Vec::new();
    collect(path, Path::new(""), except.as_deref(), &mut files)?;
    Ok(Found::Folder(files))
}

fn collect(
    folder: &Path,
    below: &Path,
    except: Option<&Path>,
    files: &mut Vec<(PathBuf, PathBuf)>,
) -> Result<(), String> {
    let wrong = |error| format!("{}: {}", folder.display(), words(&error));
    let mut entries = folder.read_dir().map_err(wrong)?.collect::<Result<Vec<_>, _>>().map_err(wrong)?;
    entries.sort_by_key(std::fs::DirEntry::file_name);
    for entry in entries {
        let (path, below) = (entry.path(), below.join(entry.file_name()));
        // Links to folders are not followed: they may lead back.
        if entry.file_type().is_ok_and(|kind| kind.is_dir()) {
            let is_excepted = except.is_some() && path.canonicalize().ok().as_deref() == except;
            if !is_excepted {
                collect(&path, &below, except, files)?;
            }
        } else if format_of(&path).is_some() && path.is_file() {
            files.push((path, below));
        }
    }
    Ok(())
}

/// Returns the format that a path's extension says.
pub fn format_of(path: &Path) -> Option<Format> {
    Format::from_extension(path.extension()?.to_str()?)
}
