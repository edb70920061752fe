//! The second half of a scan: every clip without a preview is read in full and drawn.
//!
//! That also finds what looking over a file does not: a clip with a damaged number gets its error here.

use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Mutex, PoisonError};

use motion_theater_core::loaded::{Loaded, SkeletonFile};
use motion_theater_core::pairing::Known;
use motion_theater_core::read::Clip;
use rusqlite::params;

use super::plan::is_gone;
use super::progress::{count, State};
use crate::catalogue::{paths, Library};
use crate::error::LibraryError;
use crate::facts;

/// How previews are made and kept, by the BLAKE3 hash of a file's bytes.
pub trait Previews: Send + Sync {
    /// Returns which of the contents have none yet.
    ///
    /// # Errors
    /// Where they cannot be looked up.
    fn missing(&self, hashes: &[[u8; 32]]) -> Result<Vec<[u8; 32]>, LibraryError>;

    /// Draws what a file holds, and keeps it.
    ///
    /// # Errors
    /// Where it cannot be kept. A file in which there is nothing to draw is no error.
    fn make(&self, hash: &[u8; 32], loaded: &Loaded) -> Result<(), LibraryError>;
}

/// Larger files are read one at a time.
const USUAL_BYTES: i64 = 64 << 20;

/// So many clips are looked up at a time.
const PAGE: usize = 512;

/// A clip that needs a preview.
struct Undrawn {
    id: i64,
    path: PathBuf,
    hash: [u8; 32],
    size: i64,
    skeleton: Option<PathBuf>,
}

/// Draws all clips below some folders that have no preview, several at a time.
pub(super) fn draw_all(
    library: &Library,
    folders: &[PathBuf],
    previews: &dyn Previews,
    jobs: usize,
    state: &State,
) -> Result<(), LibraryError> {
    let undrawn = undrawn(library, folders, previews)?;
    state.previews_total.store(undrawn.len() as u64, Ordering::Relaxed);
    let next = AtomicUsize::new(0);
    let large = Mutex::new(());
    let failed = Mutex::new(None);
    let work = || {
        while !state.is_cancelled() {
            let Some(clip) = undrawn.get(next.fetch_add(1, Ordering::Relaxed)) else { break };
            state.take_up(&clip.path);
            let _one_at_a_time =
                (clip.size > USUAL_BYTES).then(|| large.lock().unwrap_or_else(PoisonError::into_inner));
            if let Err(error) = draw(library, clip, previews, state) {
                // The others would fail as well.
                next.store(undrawn.len(), Ordering::Relaxed);
                failed.lock().unwrap_or_else(PoisonError::into_inner).get_or_insert(error);
            }
            count(&state.previews_done);
        }
    };
    std::thread::scope(|scope| {
        for _ in 0..jobs.clamp(1, undrawn.len().max(1)) {
            scope.spawn(work);
        }
    });
    failed.into_inner().unwrap_or_else(PoisonError::into_inner).map_or(Ok(()), Err)
}

/// Returns the clips without a preview, in the order in which they are shown; copies of one file only once.
fn undrawn(library: &Library, folders: &[PathBuf], previews: &dyn Previews) -> Result<Vec<Undrawn>, LibraryError> {
    let mut found = Vec::new();
    library.read(|db| {
        for folder in folders {
            let (from, to) = paths::below(&paths::to_text(folder));
            // A motion without a skeleton cannot be drawn.
            let mut rows = db.prepare_cached(
                "SELECT id, path, content_hash, size, skeleton_path FROM clip
                 WHERE path >= ? AND path < ? AND error IS NULL AND is_missing = 0 AND content_hash IS NOT NULL
                    AND (format <> 'amc' OR skeleton_fingerprint IS NOT NULL)
                 GROUP BY content_hash ORDER BY name, path",
            )?;
            let row = |row: &rusqlite::Row<'_>| {
                Ok(Undrawn {
                    id: row.get(0)?,
                    path: paths::to_path(&row.get::<_, String>(1)?),
                    hash: row.get(2)?,
                    size: row.get(3)?,
                    skeleton: row.get::<_, Option<String>>(4)?.map(|text| paths::to_path(&text)),
                })
            };
            for clip in rows.query_map([from, to], row)? {
                found.push(clip?);
            }
        }
        Ok(())
    })?;
    let mut missing = std::collections::HashSet::new();
    for page in found.chunks(PAGE) {
        missing.extend(previews.missing(&page.iter().map(|clip| clip.hash).collect::<Vec<_>>())?);
    }
    found.retain(|clip| missing.remove(&clip.hash));
    Ok(found)
}

fn draw(library: &Library, clip: &Undrawn, previews: &dyn Previews, state: &State) -> Result<(), LibraryError> {
    let source = match std::fs::read(&clip.path) {
        Ok(source) => source,
        Err(_) if is_gone(&clip.path) => return Ok(()),
        Err(error) => return note(library, clip, &crate::error::words(&error), state),
    };
    // It was changed meanwhile: the next scan sees to it.
    if blake3::hash(&source) != clip.hash {
        return Ok(());
    }
    match facts::read(&source, &clip.path) {
        Ok((_, whole)) => previews.make(&clip.hash, &on_its_skeleton(&clip.path, whole, clip.skeleton.as_deref())),
        Err(message) => note(library, clip, &message, state),
    }
}

/// Puts a clip on the skeleton that the library knows for it.
fn on_its_skeleton(path: &Path, clip: Clip, skeleton: Option<&Path>) -> Loaded {
    let named = skeleton.and_then(|path| SkeletonFile::read(path).ok()).filter(|file| clip.fits(&file.skeleton));
    match named.map(|file| Loaded::with(path, clip.clone(), &file)) {
        Some(Ok(loaded)) => loaded,
        Some(Err(_)) | None => Loaded::among(path, clip, Known::default()),
    }
}

/// Notes what is wrong with a clip, and with all that have the same content.
fn note(library: &Library, clip: &Undrawn, message: &str, state: &State) -> Result<(), LibraryError> {
    count(&state.broken);
    library.write(|db| {
        let sql = "UPDATE clip SET error = ?1 WHERE content_hash = ?2 AND (id = ?3 OR error IS NULL)";
        db.execute(sql, params![message, clip.hash, clip.id])?;
        Ok(())
    })
}
