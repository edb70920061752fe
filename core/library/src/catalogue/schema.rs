//! The versions of the database's tables, and opening a file that may be anything.

use std::path::Path;
use std::time::{Duration, Instant};

use rusqlite::{Connection, ErrorCode, OpenFlags, TransactionBehavior};

use crate::error::LibraryError;

/// Marks a file as a library, in the header of the database: `MTLb`.
const APPLICATION_ID: i32 = 0x4D54_4C62;

/// What leads from each version of the tables to the next; the first makes them.
const VERSIONS: [&str; 1] = [include_str!("schema/1.sql")];

/// How long to wait for another program that writes.
const PATIENCE: Duration = Duration::from_secs(20);

/// How much of the file a connection keeps in memory at most, in KiB: the indexes that searches over 100,000 clips go
/// through. `SQLite`'s usual 2 MB are read anew for every one.
const CACHE_KIB: i32 = 32 << 10;

/// Opens a connection to a file that is a library already, or is made into one where there is none or an empty one.
///
/// Anything else is an error, and is not touched.
pub(super) fn connect(path: &Path) -> Result<Connection, LibraryError> {
    let flags = OpenFlags::SQLITE_OPEN_READ_WRITE | OpenFlags::SQLITE_OPEN_CREATE | OpenFlags::SQLITE_OPEN_NO_MUTEX;
    let mut connection = Connection::open_with_flags(path, flags)?;
    connection.busy_timeout(PATIENCE)?;
    // Both of its questions are asked of one moment: another program may be making the tables right now.
    let moment = connection.unchecked_transaction()?;
    let version = version_of(&moment, path)?;
    drop(moment);
    // Readers go on while someone writes.
    until_free(|| connection.pragma_update(None, "journal_mode", "WAL"))?;
    // With a write-ahead log a crash of a program loses nothing, and one of the machine at most the last moments.
    connection.pragma_update(None, "synchronous", "NORMAL")?;
    connection.pragma_update(None, "foreign_keys", true)?;
    connection.pragma_update(None, "cache_size", -CACHE_KIB)?;
    if version < VERSIONS.len() {
        migrate(&mut connection, path)?;
    }
    Ok(connection)
}

/// Returns how many versions the tables have behind them: 0 for a new file.
fn version_of(connection: &Connection, path: &Path) -> Result<usize, LibraryError> {
    let not_a_library = |found| LibraryError::NotALibrary { path: path.to_owned(), found };
    let number = |pragma: &str| connection.pragma_query_value(None, pragma, |row| row.get::<_, i32>(0));
    let application = match number("application_id") {
        Err(error) if error.sqlite_error_code() == Some(ErrorCode::NotADatabase) => {
            return Err(not_a_library("a file of another kind"));
        }
        number => number?,
    };
    let tables: i64 = connection.query_row("SELECT count(*) FROM sqlite_schema", (), |row| row.get(0))?;
    if application != APPLICATION_ID {
        let is_new = application == 0 && tables == 0;
        return if is_new { Ok(0) } else { Err(not_a_library("the database of another program")) };
    }
    let found = u32::try_from(number("user_version")?).unwrap_or(u32::MAX);
    let known = VERSIONS.len() as u32;
    if found > known {
        return Err(LibraryError::Newer { path: path.to_owned(), found, known });
    }
    Ok(found as usize)
}

/// Brings the tables up to date in one step: whole, or not at all. Another program may do the same at the same moment.
fn migrate(connection: &mut Connection, path: &Path) -> Result<(), LibraryError> {
    let transaction = connection.transaction_with_behavior(TransactionBehavior::Immediate)?;
    let version = version_of(&transaction, path)?;
    for step in VERSIONS.iter().skip(version) {
        transaction.execute_batch(step)?;
    }
    transaction.pragma_update(None, "application_id", APPLICATION_ID)?;
    transaction.pragma_update(None, "user_version", VERSIONS.len() as u32)?;
    Ok(transaction.commit()?)
}

/// Tries again while the database is busy: a change of the journal does not wait by itself.
fn until_free(attempt: impl Fn() -> rusqlite::Result<()>) -> rusqlite::Result<()> {
    const PAUSE: Duration = Duration::from_millis(5);
    let deadline = Instant::now() + PATIENCE;
    loop {
        match attempt() {
            Err(error) if error.sqlite_error_code() == Some(ErrorCode::DatabaseBusy) && Instant::now() < deadline => {
                std::thread::sleep(PAUSE);
            }
            done => return done,
        }
    }
}
