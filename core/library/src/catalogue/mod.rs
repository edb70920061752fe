//! The database: which clips there are, what is in them and what people say of them.
//!
//! A library is one `SQLite` file. Every process, and every thread of one, has connections of its own: readers see the
//! state before a writer's transaction until that is done, writers wait for each other.

mod edits;
mod folders;
pub(crate) mod paths;
mod rows;
mod schema;
mod tags;
pub(crate) mod told;

pub use edits::Edit;
pub use folders::Folder;
pub use rows::ClipRow;
pub use told::{Field, Source};

use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, OnceLock, PoisonError};
use std::time::{SystemTime, UNIX_EPOCH};

use rusqlite::config::DbConfig;
use rusqlite::{Connection, OptionalExtension, Transaction, TransactionBehavior};

use crate::error::LibraryError;
use crate::preview::PreviewCache;

/// Connections that are kept for the next call.
const MOST_IDLE: usize = 4;

/// A catalogue of clips in a file. May be used by many threads at a time.
#[derive(Debug)]
pub struct Library {
    path: PathBuf,
    idle: Mutex<Vec<Connection>>,
    pub(crate) previews: OnceLock<Arc<PreviewCache>>,
}

impl Library {
    /// Opens a library, makes it where there is no file, and brings one of an earlier version up to date.
    ///
    /// # Errors
    /// Where the file is something else, or of a later version (it is left as it is then), or cannot be written.
    pub fn open(path: &Path) -> Result<Self, LibraryError> {
        let path = std::path::absolute(path).map_err(|source| LibraryError::io(path, source))?;
        if path.is_dir() {
            return Err(LibraryError::NotALibrary { path, found: "a folder" });
        }
        let connection = schema::connect(&path)?;
        Ok(Self { path, idle: Mutex::new(vec![connection]), previews: OnceLock::new() })
    }

    /// Returns where the library lies: an absolute path.
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// Looks at every page of the database, and returns what is wrong, a sentence each; nothing where all is well.
    ///
    /// # Errors
    /// Where the library cannot be read at all.
    pub fn check(&self) -> Result<Vec<String>, LibraryError> {
        self.read(|db| {
            let mut pages = db.prepare("PRAGMA integrity_check")?;
            let pages = pages.query_map((), |row| row.get(0))?.collect::<Result<Vec<String>, _>>()?;
            let mut links = db.prepare("PRAGMA foreign_key_check")?;
            let links = links
                .query_map((), |row| Ok(format!("a row of {} without what it belongs to", row.get::<_, String>(0)?)))?;
            let wrong = pages.into_iter().filter(|text| text != "ok").map(Ok).chain(links);
            Ok(wrong.collect::<Result<_, _>>()?)
        })
    }

    /// Reads with a connection of its own.
    pub(crate) fn read<T>(&self, task: impl FnOnce(&Connection) -> Result<T, LibraryError>) -> Result<T, LibraryError> {
        self.with_connection(|connection| task(connection))
    }

    /// Changes something as a whole, or not at all where `task` fails.
    pub(crate) fn write<T>(
        &self,
        task: impl FnOnce(&Transaction<'_>) -> Result<T, LibraryError>,
    ) -> Result<T, LibraryError> {
        self.with_connection(|connection| as_a_whole(connection, task))
    }

    /// Does much with one connection while the triggers that keep the full-text index sleep: whoever changes clips keeps it
    /// then. To put triggers to sleep makes the connection forget what it has prepared, which is too dear for every step.
    pub(crate) fn without_triggers<T>(
        &self,
        task: impl FnOnce(&mut Connection) -> Result<T, LibraryError>,
    ) -> Result<T, LibraryError> {
        self.with_connection(|connection| {
            connection.set_db_config(DbConfig::SQLITE_DBCONFIG_ENABLE_TRIGGER, false)?;
            let done = task(connection);
            connection.set_db_config(DbConfig::SQLITE_DBCONFIG_ENABLE_TRIGGER, true)?;
            done
        })
    }

    fn with_connection<T>(
        &self,
        task: impl FnOnce(&mut Connection) -> Result<T, LibraryError>,
    ) -> Result<T, LibraryError> {
        let idle = || self.idle.lock().unwrap_or_else(PoisonError::into_inner);
        let kept = idle().pop();
        let mut connection = kept.map_or_else(|| schema::connect(&self.path), Ok)?;
        let result = task(&mut connection);
        let mut idle = idle();
        if idle.len() < MOST_IDLE {
            idle.push(connection);
        }
        result
    }
}

/// Changes something as a whole, or not at all where `task` fails.
pub(crate) fn as_a_whole<T>(
    connection: &mut Connection,
    task: impl FnOnce(&Transaction<'_>) -> Result<T, LibraryError>,
) -> Result<T, LibraryError> {
    // Taken at once: a reader that becomes a writer later could be refused without waiting.
    let transaction = connection.transaction_with_behavior(TransactionBehavior::Immediate)?;
    let result = task(&transaction)?;
    transaction.commit()?;
    Ok(result)
}

/// Returns the seconds since 1970.
pub(crate) fn now() -> i64 {
    SystemTime::now().duration_since(UNIX_EPOCH).map_or(0, |since| since.as_secs() as i64)
}

/// Refuses the number of a clip that is not there.
fn check_clip(db: &Connection, id: i64) -> Result<(), LibraryError> {
    let found: Option<i64> =
        db.prepare_cached("SELECT 1 FROM clip WHERE id = ?")?.query_row([id], |row| row.get(0)).optional()?;
    found.map(drop).ok_or_else(|| LibraryError::Asked(format!("the library has no clip {id}")))
}

#[cfg(test)]
mod tests;
