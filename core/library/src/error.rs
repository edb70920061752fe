//! What can go wrong with a library, in words for the person who looks after it.

use std::path::{Path, PathBuf};

pub(crate) use motion_theater_core::error::words;

/// Why something could not be done with a library.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum LibraryError {
    /// The disk failed: no such folder, no permission.
    #[error("{}: {}", path.display(), words(source))]
    Io {
        /// The file or folder.
        path: PathBuf,
        /// What the system said.
        source: std::io::Error,
    },
    /// The file is something else than a library. It was left as it is.
    #[error("{}: {found}, not a library of clips; it was left as it is", path.display())]
    NotALibrary {
        /// The file.
        path: PathBuf,
        /// What it is instead.
        found: &'static str,
    },
    /// The library was written by a later version. It was left as it is.
    #[error(
        "{}: a library of version {found}, and this program knows versions up to {known}; it was left as it is. \
         A newer Motion Theater can open it",
        path.display()
    )]
    Newer {
        /// The file.
        path: PathBuf,
        /// The version of its tables.
        found: u32,
        /// The latest version that is known here.
        known: u32,
    },
    /// Another program has kept the library locked for longer than we wait.
    #[error("another program has kept the library busy for too long: try again when it is done")]
    Busy,
    /// The disk is full, or what belongs to the library cannot be written.
    #[error("the library cannot be written: {0}")]
    NotWritable(&'static str),
    /// The database is damaged.
    #[error("the library is damaged ({0}): move the file away, and scan the folders anew")]
    Damaged(String),
    /// The sidecar of a clip cannot be read or saved.
    #[error(transparent)]
    Sidecar(#[from] crate::sidecar::SidecarError),
    /// What was asked for makes no sense, with the reason.
    #[error("{0}")]
    Asked(String),
    /// Anything else that the database says.
    #[error("the library's database: {0}")]
    Database(rusqlite::Error),
}

impl LibraryError {
    /// Returns an error of the disk.
    pub(crate) fn io(path: &Path, source: std::io::Error) -> Self {
        Self::Io { path: path.to_owned(), source }
    }
}

impl From<rusqlite::Error> for LibraryError {
    fn from(error: rusqlite::Error) -> Self {
        use rusqlite::ErrorCode;
        match error.sqlite_error_code() {
            Some(ErrorCode::DatabaseBusy | ErrorCode::DatabaseLocked) => Self::Busy,
            Some(ErrorCode::DiskFull) => Self::NotWritable("the disk is full"),
            Some(ErrorCode::ReadOnly) => Self::NotWritable("the file or its folder is read-only"),
            Some(ErrorCode::CannotOpen) => Self::NotWritable("its folder is missing, or is read-only"),
            Some(ErrorCode::DatabaseCorrupt | ErrorCode::NotADatabase) => Self::Damaged(error.to_string()),
            _ => Self::Database(error),
        }
    }
}
