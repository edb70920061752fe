//! Previews, kept in a database of their own beside the library.
//!
//! It is a cache: it may be thrown away at any time, and is where it is of no use. What was not looked at for longest goes
//! when there is no more room.

use super::{make, Preview, MADE_BY};
use crate::catalogue::now;
use crate::error::LibraryError;
use crate::scan::Previews;
use motion_theater_core::loaded::Loaded;
use rusqlite::{Connection, ErrorCode, OptionalExtension, Row, TransactionBehavior};
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Mutex, PoisonError};
use std::time::Duration;

/// How much room previews take on disk, usually.
pub const MOST_BYTES: u64 = 1 << 30;

/// What previews are kept by: the hash of all of a file's bytes.
pub type ContentHash = [u8; 32];

/// Marks a file as such a cache, in the header of the database: `MTLp`.
const APPLICATION_ID: i32 = 0x4D54_4C70;

/// How long to wait for another program that writes.
const PATIENCE: Duration = Duration::from_secs(5);

/// When a preview was used is noted once in this many seconds: to look must not mean to write.
const USE_STEP_S: i64 = 3600;

/// So many times it is looked whether there is room while it fills.
const LOOKS_AT_ROOM: u64 = 64;

/// Connections that are kept for the next call.
const MOST_IDLE: usize = 4;

/// Previews by the content of files. A cache that turns out to be damaged is thrown away. May be used by many threads, and
/// by several programs, at a time.
#[derive(Debug)]
pub struct PreviewCache {
    path: PathBuf,
    idle: Mutex<Vec<Connection>>,
    most_bytes: u64,
    /// How much has come since it was last looked whether there is room.
    added: AtomicU64,
}

impl PreviewCache {
    /// Opens the cache of a library: `NAME-previews.sqlite` for `NAME.sqlite`.
    ///
    /// # Errors
    /// Where it cannot be written.
    pub fn beside(library: &Path) -> Result<Self, LibraryError> {
        let mut name = library.file_stem().unwrap_or_default().to_owned();
        name.push("-previews.sqlite");
        Self::open(&library.with_file_name(name), MOST_BYTES)
    }

    /// Opens a cache whose pictures take about `most_bytes`, and makes it where there is none. A damaged one is made anew.
    ///
    /// # Errors
    /// Where it cannot be written, or the file is something else, which is left as it is.
    pub fn open(path: &Path, most_bytes: u64) -> Result<Self, LibraryError> {
        let connection = connect(path).or_else(|error| {
            if !matches!(error, LibraryError::Damaged(_)) {
                return Err(error);
            }
            discard(path)?;
            connect(path)
        })?;
        // At first the room is looked over, for another program may have filled it.
        let added = AtomicU64::new(most_bytes);
        Ok(Self { path: path.to_owned(), idle: Mutex::new(vec![connection]), most_bytes, added })
    }

    /// Returns the preview of a file with that content.
    ///
    /// # Errors
    /// Where the database fails.
    pub fn get(&self, hash: &ContentHash) -> Result<Option<Preview>, LibraryError> {
        self.with_connection(|db| {
            let sql = "SELECT frame, width, height, still, strip, strip_frames, strip_rate_hz, used_at FROM preview \
                       WHERE content_hash = ? AND made_by = ?";
            let found = db.prepare_cached(sql)?.query_row((hash, MADE_BY), |row| Ok((preview(row)?, row.get(7)?)));
            let Some((preview, used_at)) = found.optional()? else { return Ok(None) };
            note_use(db, hash, used_at);
            Ok(Some(preview))
        })
    }

    /// Returns the still alone, as a PNG.
    ///
    /// # Errors
    /// Where the database fails.
    pub fn still(&self, hash: &ContentHash) -> Result<Option<Vec<u8>>, LibraryError> {
        self.with_connection(|db| {
            let sql = "SELECT still, used_at FROM preview WHERE content_hash = ? AND made_by = ?";
            let found = db.prepare_cached(sql)?.query_row((hash, MADE_BY), |row| Ok((row.get(0)?, row.get(1)?)));
            let Some((still, used_at)) = found.optional()? else { return Ok(None) };
            note_use(db, hash, used_at);
            Ok(Some(still))
        })
    }

    /// Keeps a preview, and lets go of those that were not used for longest where there is no more room.
    ///
    /// # Errors
    /// Where the database fails.
    pub fn put(&self, hash: &ContentHash, made: &Preview) -> Result<(), LibraryError> {
        let bytes = (made.still.len() + made.strip.len()) as u64;
        let added = self.added.fetch_add(bytes, Ordering::Relaxed) + bytes;
        self.with_connection(|db| {
            let db = db.transaction_with_behavior(TransactionBehavior::Immediate)?;
            db.prepare_cached("INSERT OR REPLACE INTO preview VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?)")?.execute((
                hash,
                MADE_BY,
                made.frame,
                made.width,
                made.height,
                &made.still,
                &made.strip,
                made.strip_frames,
                made.strip_rate_hz,
                now(),
            ))?;
            // To add up the sizes of all takes longer than to keep one more.
            if added >= self.most_bytes / LOOKS_AT_ROOM {
                trim(&db, self.most_bytes)?;
                self.added.store(0, Ordering::Relaxed);
            }
            Ok(db.commit()?)
        })
    }

    fn with_connection<T>(
        &self,
        task: impl FnOnce(&mut Connection) -> Result<T, LibraryError>,
    ) -> Result<T, LibraryError> {
        let idle = || self.idle.lock().unwrap_or_else(PoisonError::into_inner);
        let kept = idle().pop();
        let mut connection = kept.map_or_else(|| connect(&self.path), Ok)?;
        let result = task(&mut connection);
        if matches!(result, Err(LibraryError::Damaged(_))) {
            drop(connection);
            idle().clear();
            discard(&self.path)?;
        } else if idle().len() < MOST_IDLE {
            idle().push(connection);
        }
        result
    }
}

impl Previews for PreviewCache {
    fn missing(&self, hashes: &[ContentHash]) -> Result<Vec<ContentHash>, LibraryError> {
        self.with_connection(|db| {
            let mut find = db.prepare_cached("SELECT 1 FROM preview WHERE content_hash = ? AND made_by = ?")?;
            let mut missing = Vec::new();
            for hash in hashes {
                if !find.exists((hash, MADE_BY))? {
                    missing.push(*hash);
                }
            }
            Ok(missing)
        })
    }

    fn make(&self, hash: &ContentHash, loaded: &Loaded) -> Result<(), LibraryError> {
        // A motion without a skeleton has no picture.
        make(loaded).map_or(Ok(()), |preview| self.put(hash, &preview))
    }
}

fn connect(path: &Path) -> Result<Connection, LibraryError> {
    let mut connection = Connection::open(path)?;
    connection.busy_timeout(PATIENCE)?;
    // All questions are asked of one moment: another program may be making the table right now.
    let moment = connection.unchecked_transaction()?;
    let number = |pragma: &str| moment.pragma_query_value(None, pragma, |row| row.get::<_, i32>(0));
    let application = match number("application_id") {
        Err(error) if error.sqlite_error_code() == Some(ErrorCode::NotADatabase) => return Err(foreign(path)),
        number => number?,
    };
    let tables: i64 = moment.query_row("SELECT count(*) FROM sqlite_schema", (), |row| row.get(0))?;
    drop(moment);
    if application != APPLICATION_ID && (application != 0 || tables > 0) {
        return Err(foreign(path));
    }
    connection.pragma_update(None, "journal_mode", "WAL")?;
    // What is lost when the machine fails is drawn again.
    connection.pragma_update(None, "synchronous", "OFF")?;
    if application != APPLICATION_ID {
        let whole = connection.transaction_with_behavior(TransactionBehavior::Immediate)?;
        whole.execute_batch(include_str!("preview.sql"))?;
        whole.pragma_update(None, "application_id", APPLICATION_ID)?;
        whole.commit()?;
    }
    Ok(connection)
}

fn foreign(path: &Path) -> LibraryError {
    LibraryError::NotALibrary { path: path.to_owned(), found: "a file of another kind" }
}

/// Removes a damaged cache with what belongs to it.
fn discard(path: &Path) -> Result<(), LibraryError> {
    for end in ["", "-wal", "-shm"] {
        let mut name = path.as_os_str().to_owned();
        name.push(end);
        match std::fs::remove_file(&name) {
            Err(source) if source.kind() != std::io::ErrorKind::NotFound => return Err(LibraryError::io(path, source)),
            _ => {}
        }
    }
    Ok(())
}

fn preview(row: &Row<'_>) -> rusqlite::Result<Preview> {
    Ok(Preview {
        frame: row.get(0)?,
        width: row.get(1)?,
        height: row.get(2)?,
        still: row.get(3)?,
        strip: row.get(4)?,
        strip_frames: row.get(5)?,
        strip_rate_hz: row.get(6)?,
    })
}

/// Notes that a preview is in use. Where that cannot be written just now, it may be forgotten a little earlier.
fn note_use(db: &Connection, hash: &ContentHash, used_at: i64) {
    let now = now();
    if now - used_at >= USE_STEP_S {
        let note = db.prepare_cached("UPDATE preview SET used_at = ? WHERE content_hash = ?");
        drop(note.and_then(|mut note| note.execute((now, hash))));
    }
}

/// Removes previews of other versions first, then those that were not used for longest.
fn trim(db: &Connection, most_bytes: u64) -> Result<(), LibraryError> {
    let sum = "SELECT coalesce(sum(length(still) + length(strip)), 0) FROM preview";
    let bytes: i64 = db.prepare_cached(sum)?.query_row((), |row| row.get(0))?;
    let mut surplus = bytes.saturating_sub(i64::try_from(most_bytes).unwrap_or(i64::MAX));
    if surplus <= 0 {
        return Ok(());
    }
    let mut oldest = db.prepare_cached(
        "SELECT content_hash, length(still) + length(strip) FROM preview ORDER BY made_by = ?, used_at, rowid",
    )?;
    let mut rows = oldest.query([MADE_BY])?;
    let mut gone: Vec<Vec<u8>> = Vec::new();
    while let Some(row) = rows.next()?.filter(|_| surplus > 0) {
        gone.push(row.get(0)?);
        surplus -= row.get::<_, i64>(1)?;
    }
    let mut delete = db.prepare_cached("DELETE FROM preview WHERE content_hash = ?")?;
    gone.iter().try_for_each(|hash| delete.execute([hash]).map(drop))?;
    Ok(())
}

#[cfg(test)]
mod tests;
