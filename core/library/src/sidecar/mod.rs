//! Sidecars on disk: opened or made for a clip, edited, saved whole or not at all.
//!
//! What is in them is `motion_theater_core::sidecar`.

mod known;
mod of_clip;
mod replace;
#[cfg(test)]
mod tests;
mod told;

use std::fs;
use std::io::{self, Read, Write};
use std::path::{Path, PathBuf};

use motion_theater_core::error::words;
use motion_theater_core::loaded::{LoadError, Loaded};
pub use motion_theater_core::sidecar::{cleaned, Field};
use motion_theater_core::sidecar::{path_beside, Sidecar, ValueError, MOST_BYTES};

pub use known::today;
pub use told::{segments_text, told};

/// Why a sidecar could not be opened, edited or saved. The file is always what it was.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum SidecarError {
    /// It cannot be read.
    #[error("{}: {}", path.display(), words(source))]
    NotRead {
        /// The sidecar.
        path: PathBuf,
        /// What the system said.
        source: io::Error,
    },
    /// It cannot be written: a full disk, a read-only folder.
    #[error("{}: not saved, and left as it was: {}", path.display(), words(source))]
    NotSaved {
        /// The sidecar.
        path: PathBuf,
        /// What the system said.
        source: io::Error,
    },
    /// The file itself is read-only.
    #[error("{}: not saved, for the file is read-only", .0.display())]
    ReadOnly(PathBuf),
    /// Someone else has written it since it was read.
    #[error("{}: not saved, for someone else has changed the file meanwhile: open it again", .0.display())]
    ChangedMeanwhile(PathBuf),
    /// It is too large to be one.
    #[error("{}: this is no sidecar, it has more than {MOST_BYTES} bytes", .0.display())]
    TooLarge(PathBuf),
    /// The clip that it is made for cannot be read.
    #[error(transparent)]
    Clip(#[from] LoadError),
    /// A field cannot hold a value.
    #[error(transparent)]
    Value(#[from] ValueError),
}

/// A sidecar and where it is kept.
#[derive(Debug, Clone)]
pub struct SidecarFile {
    path: PathBuf,
    /// What was read or written last; `None` where there is no file yet.
    on_disk: Option<Vec<u8>>,
    /// What is in it; edits are on disk once they are saved.
    pub sidecar: Sidecar,
}

impl SidecarFile {
    /// Opens a sidecar that is there.
    ///
    /// # Errors
    /// Where it cannot be read, or is far too large.
    pub fn open(path: &Path) -> Result<Self, SidecarError> {
        let bytes = read(path)?;
        Ok(Self { path: path.to_owned(), sidecar: Sidecar::parse(&bytes), on_disk: Some(bytes) })
    }

    /// Opens the sidecar beside a clip, or makes a new one with what the clip itself tells: date, subject, duration, frame
    /// rate and the skeleton that was found. A new one is on disk only once it is saved.
    ///
    /// # Errors
    /// Where the sidecar that is there cannot be read; where there is none, where the clip cannot.
    pub fn beside(clip: &Path) -> Result<Self, SidecarError> {
        let path = path_beside(clip);
        match Self::open(&path) {
            Err(SidecarError::NotRead { source, .. }) if source.kind() == io::ErrorKind::NotFound => {
                let sidecar = known::sidecar_of(&Loaded::read(clip, None)?);
                Ok(Self { path, on_disk: None, sidecar })
            }
            opened => opened,
        }
    }

    /// Returns where it is kept.
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// Returns whether there is a file.
    pub fn is_on_disk(&self) -> bool {
        self.on_disk.is_some()
    }

    /// Returns whether saving would change the file.
    pub fn is_edited(&self) -> bool {
        self.on_disk.as_ref().is_none_or(|bytes| *bytes != self.sidecar.to_bytes())
    }

    /// Says who changed it and when (an ISO date), if anything was changed and the user said nothing else of this.
    ///
    /// # Errors
    /// Where a text is more than one line.
    pub fn stamp(&mut self, today: &str, who: &str) -> Result<(), SidecarError> {
        if !self.is_edited() {
            return Ok(());
        }
        let before = self.on_disk.as_deref().map_or_else(Sidecar::default, Sidecar::parse);
        for (field, value) in [(Field::LastChange, today), (Field::ModifiedBy, who)] {
            let is_untouched = self.sidecar.get(field).unwrap_or_default() == before.get(field).unwrap_or_default();
            if is_untouched && !value.is_empty() {
                self.sidecar.set(field, value)?;
            }
        }
        Ok(())
    }

    /// Writes the file as a whole or not at all: whoever looks sees the old one or the new one. Its permissions stay, and a
    /// link to it stays a link. Without edits nothing is written.
    ///
    /// # Errors
    /// Where it cannot be written, or someone else changed it meanwhile. The file is what it was.
    pub fn save(&mut self) -> Result<(), SidecarError> {
        self.save_with(Write::write_all)
    }

    fn save_with(&mut self, write: impl FnOnce(&mut fs::File, &[u8]) -> io::Result<()>) -> Result<(), SidecarError> {
        if !self.is_edited() {
            return Ok(());
        }
        let present = match read(&self.path) {
            Ok(bytes) => Some(bytes),
            Err(SidecarError::NotRead { source, .. }) if source.kind() == io::ErrorKind::NotFound => None,
            Err(error) => return Err(error),
        };
        // Somebody may have written the very same, which is no harm.
        let bytes = self.sidecar.to_bytes();
        if present != self.on_disk && present.as_ref() != Some(&bytes) {
            return Err(SidecarError::ChangedMeanwhile(self.path.clone()));
        }
        replace::replace(&self.path, &bytes, write)?;
        self.on_disk = Some(bytes);
        Ok(())
    }
}

fn read(path: &Path) -> Result<Vec<u8>, SidecarError> {
    let not_read = |source| SidecarError::NotRead { path: path.to_owned(), source };
    let mut bytes = Vec::new();
    fs::File::open(path).map_err(not_read)?.take(MOST_BYTES + 1).read_to_end(&mut bytes).map_err(not_read)?;
    if bytes.len() as u64 > MOST_BYTES {
        return Err(SidecarError::TooLarge(path.to_owned()));
    }
    Ok(bytes)
}
