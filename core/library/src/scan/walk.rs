//! Which files of a folder may be motion.

use std::fs::Metadata;
use std::io::ErrorKind;
use std::path::{Path, PathBuf};
use std::time::UNIX_EPOCH;

use motion_theater_core::read::Format;
use walkdir::{DirEntry, WalkDir};

/// Extensions of files that are never motion: they are not opened to see. In lower case.
const NEVER: &[&str] = &[
    "7z", "abc", "avi", "blend", "blend1", "bmp", "csv", "db", "dll", "doc", "docx", "exe", "exr", "fbx", "flac",
    "gif", "glb", "gltf", "gz", "hdr", "htm", "html", "i3d", "iso", "jpeg", "jpg", "json", "log", "ma", "max", "mb",
    "md", "mkv", "mov", "mp3", "mp4", "mpg", "npy", "npz", "obj", "ogg", "pdf", "pkl", "png", "psd", "py", "rar", "so",
    "sqlite", "svg", "tar", "tga", "tif", "tiff", "usd", "usda", "usdc", "wav", "webm", "webp", "wmv", "xls", "xlsx",
    "xml", "zip",
];

/// A file as the disk lists it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Found {
    pub(super) path: PathBuf,
    /// In bytes.
    pub(super) size: i64,
    /// When it was last changed, in nanoseconds since 1970.
    pub(super) modified_ns: i64,
}

/// What a walk comes by.
pub(super) enum Step {
    /// A file.
    File(Found),
    /// A folder that cannot be listed: what is in it is not known.
    Closed(PathBuf),
}

/// Returns the files in a folder and the folders below it, in alphabetical order. Hidden ones (their names begin with a
/// point) are left out, and links to folders are not followed: they may lead back.
pub(super) fn files(folder: &Path) -> impl Iterator<Item = Step> {
    let is_shown = |entry: &DirEntry| entry.depth() == 0 || !entry.file_name().as_encoded_bytes().starts_with(b".");
    let entries = WalkDir::new(folder).sort_by_file_name().into_iter().filter_entry(is_shown);
    entries.filter_map(|entry| match entry {
        Ok(entry) if entry.file_type().is_dir() => None,
        Ok(entry) => {
            // A link counts as the file that it leads to.
            let metadata = if entry.file_type().is_symlink() {
                std::fs::metadata(entry.path()).ok()
            } else {
                entry.metadata().ok()
            };
            let metadata = metadata.filter(Metadata::is_file)?;
            Some(Step::File(Found::new(entry.into_path(), &metadata)))
        }
        Err(error) => {
            let is_gone = error.io_error().is_some_and(|error| error.kind() == ErrorKind::NotFound);
            let path = error.path().filter(|_| !is_gone)?;
            Some(Step::Closed(path.to_owned()))
        }
    })
}

impl Found {
    pub(super) fn new(path: PathBuf, metadata: &Metadata) -> Self {
        let modified = metadata.modified().unwrap_or(UNIX_EPOCH);
        let modified_ns = match modified.duration_since(UNIX_EPOCH) {
            Ok(since) => i64::try_from(since.as_nanos()).unwrap_or(i64::MAX),
            Err(before) => i64::try_from(before.duration().as_nanos()).map_or(i64::MIN, |ns| -ns),
        };
        Self { path, size: i64::try_from(metadata.len()).unwrap_or(i64::MAX), modified_ns }
    }

    /// Returns whether the file may be motion, by its extension; `None` where only its content can tell.
    pub(super) fn may_be_motion(&self) -> Option<bool> {
        let extension = self.path.extension().and_then(|extension| extension.to_str()).map(str::to_ascii_lowercase);
        match extension {
            Some(known) if Format::from_extension(&known).is_some() => Some(true),
            Some(other) if NEVER.contains(&other.as_str()) => Some(false),
            _ => None,
        }
    }
}

/// Returns whether a file is motion by how it begins.
pub(super) fn begins_as_motion(path: &Path) -> bool {
    matches!(Format::of_path(path), Ok(Some(_)))
}
