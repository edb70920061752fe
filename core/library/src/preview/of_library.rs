//! Previews of the clips of a library.

use super::{unpack, ContentHash, Frames, PreviewCache};
use crate::catalogue::Library;
use crate::error::LibraryError;
use rusqlite::OptionalExtension;
use std::sync::Arc;

/// A moving strip, unpacked.
#[derive(Debug, Clone, PartialEq)]
pub struct Strip {
    /// The pictures.
    pub frames: Frames,
    /// How many make a second.
    pub rate_hz: f64,
    /// The file's own number of the frame that the still shows.
    pub still_frame: i64,
}

impl Library {
    /// Returns where previews are kept: beside the library. It is opened when it is needed for the first time.
    ///
    /// # Errors
    /// Where it cannot be written.
    pub fn previews(&self) -> Result<&Arc<PreviewCache>, LibraryError> {
        if let Some(known) = self.previews.get() {
            return Ok(known);
        }
        let opened = Arc::new(PreviewCache::beside(self.path())?);
        Ok(self.previews.get_or_init(|| opened))
    }

    /// Returns the still of a clip; `None` where it has not been drawn.
    ///
    /// # Errors
    /// Where there is no such clip, or a database fails.
    pub fn still(&self, id: i64) -> Result<Option<Frames>, LibraryError> {
        let Some(hash) = self.content_hash(id)? else { return Ok(None) };
        Ok(self.previews()?.still(&hash)?.and_then(|still| unpack(&still, 1)))
    }

    /// Returns the moving strip of a clip; `None` where it has not been drawn.
    ///
    /// # Errors
    /// Where there is no such clip, or a database fails.
    pub fn strip(&self, id: i64) -> Result<Option<Strip>, LibraryError> {
        let Some(hash) = self.content_hash(id)? else { return Ok(None) };
        let Some(preview) = self.previews()?.get(&hash)? else { return Ok(None) };
        let frames = unpack(&preview.strip, preview.strip_frames as usize);
        Ok(frames.map(|frames| Strip { frames, rate_hz: preview.strip_rate_hz, still_frame: preview.frame }))
    }

    fn content_hash(&self, id: i64) -> Result<Option<ContentHash>, LibraryError> {
        self.read(|db| {
            let mut find = db.prepare_cached("SELECT content_hash FROM clip WHERE id = ?")?;
            let found = find.query_row([id], |row| row.get(0)).optional()?;
            found.ok_or_else(|| LibraryError::Asked(format!("the library has no clip {id}")))
        })
    }
}
