//! Sidecars in a scan: those that are new, changed or gone, and those beside clips that were read, tell the clips beside
//! them what people say.

use std::collections::HashSet;
use std::path::{Path, PathBuf};

use motion_theater_core::sidecar::{self, segments, Field as Line, Sidecar};
use rusqlite::{params, Connection, OptionalExtension, Transaction};

use super::plan::is_gone;
use super::progress::State;
use super::walk::Found;
use crate::catalogue::told::{put_in_force, tell};
use crate::catalogue::{paths, Field, Library, Source};
use crate::error::LibraryError;
use crate::sidecar::told;

/// So many sidecars are written in one transaction.
const BATCH: usize = 256;

/// A sidecar that is not what the library has read.
pub(crate) struct Stale {
    path: PathBuf,
    /// What the disk lists; `None` where it is gone.
    found: Option<Found>,
}

/// A clip beside a sidecar.
pub(super) struct Beside {
    pub(super) id: i64,
    pub(super) found: Found,
    pub(super) format: String,
}

/// Returns whether a file is a sidecar, by its name.
pub(super) fn is_sidecar(path: &Path) -> bool {
    path.extension().is_some_and(|extension| extension.eq_ignore_ascii_case(sidecar::EXTENSION))
}

/// Returns the sidecars in folders that are new, changed or gone; `found` is what a walk came by.
pub(super) fn stale(db: &Connection, folders: &[PathBuf], found: &[Found]) -> Result<Vec<Stale>, LibraryError> {
    let mut stale = Vec::new();
    let mut find = db.prepare_cached("SELECT size = ?2 AND modified_ns = ?3 FROM sidecar WHERE path = ?1")?;
    for file in found {
        let values = params![paths::to_text(&file.path), file.size, file.modified_ns];
        let is_read: Option<bool> = find.query_row(values, |row| row.get(0)).optional()?;
        if is_read != Some(true) {
            stale.push(Stale { path: file.path.clone(), found: Some(file.clone()) });
        }
    }
    let present: HashSet<&Path> = found.iter().map(|file| file.path.as_path()).collect();
    let mut list = db.prepare_cached("SELECT path FROM sidecar WHERE path >= ? AND path < ?")?;
    for folder in folders {
        let (from, to) = paths::below(&paths::to_text(folder));
        let mut rows = list.query([from, to])?;
        while let Some(row) = rows.next()? {
            let path = paths::to_path(&row.get::<_, String>(0)?);
            if !present.contains(path.as_path()) && is_gone(&path) {
                stale.push(Stale { path, found: None });
            }
        }
    }
    Ok(stale)
}

/// Returns the clips beside a sidecar: those of its name, with any extension.
pub(super) fn beside(db: &Connection, stale: &Stale) -> Result<Vec<Beside>, LibraryError> {
    let name = stale.path.with_extension("");
    let text = paths::to_text(&name);
    let mut list = db.prepare_cached(
        "SELECT id, path, size, modified_ns, format FROM clip WHERE path = ?1 OR (path >= ?1 || '.' AND path < ?1 || '/')",
    )?;
    let mut rows = list.query([text])?;
    let mut clips = Vec::new();
    while let Some(row) = rows.next()? {
        let path = paths::to_path(&row.get::<_, String>(1)?);
        if path.with_extension("") == name {
            let found = Found { path, size: row.get(2)?, modified_ns: row.get(3)? };
            clips.push(Beside { id: row.get(0)?, found, format: row.get(4)? });
        }
    }
    Ok(clips)
}

/// Lets the sidecar of a clip be read again, for the clip is new, has changed or has moved here.
pub(super) fn forget(db: &Connection, clip: &Path) -> Result<(), LibraryError> {
    let mut forget = db.prepare_cached("DELETE FROM sidecar WHERE path = ?")?;
    for extension in [sidecar::EXTENSION.to_owned(), sidecar::EXTENSION.to_uppercase()] {
        forget.execute([paths::to_text(&clip.with_extension(extension))])?;
    }
    Ok(())
}

/// Takes back what a sidecar said of a clip that has left it.
pub(super) fn leave(db: &Connection, clip: i64) -> Result<(), LibraryError> {
    tell(db, clip, Source::Sidecar, &Field::ALL.map(|field| (field, None)))
}

/// Reads the sidecars that are not what they were, and tells the clips beside them.
pub(super) fn take_in(
    library: &Library,
    folders: &[PathBuf],
    found: &[Found],
    state: &State,
) -> Result<(), LibraryError> {
    let stale = library.read(|db| stale(db, folders, found))?;
    for batch in stale.chunks(BATCH) {
        if state.is_cancelled() {
            break;
        }
        let read: Vec<(&Stale, Option<Sidecar>)> =
            batch.iter().map(|stale| (stale, sidecar::read(&stale.path))).collect();
        library.write(|db| read.iter().try_for_each(|(stale, sidecar)| put(db, stale, sidecar.as_ref())))?;
    }
    Ok(())
}

/// Returns the sidecar of a clip as the disk lists it now.
pub(crate) fn of_clip(clip: &Path) -> Stale {
    let path = sidecar::path_beside(clip);
    let found = std::fs::metadata(&path).ok().map(|metadata| Found::new(path.clone(), &metadata));
    Stale { path, found }
}

/// Reads one sidecar, and tells the clips beside it.
pub(crate) fn take_in_one(db: &Transaction<'_>, stale: &Stale) -> Result<(), LibraryError> {
    put(db, stale, sidecar::read(&stale.path).as_ref())
}

fn put(db: &Transaction<'_>, stale: &Stale, sidecar: Option<&Sidecar>) -> Result<(), LibraryError> {
    if stale.found.is_some() && sidecar.is_none() {
        // It is there and cannot be read: what it said before stays, and the next scan tries again.
        return Ok(());
    }
    let says = sidecar.map(told).unwrap_or_default();
    let value = |field: Field| {
        let (_, value) = says.iter().find(|(name, _)| *name == field.name())?;
        field.checked(value).ok().flatten()
    };
    for clip in beside(db, stale)? {
        tell(db, clip.id, Source::Sidecar, &Field::ALL.map(|field| (field, value(field))))?;
        put_in_force(db, clip.id)?;
        put_segments(db, clip.id, sidecar)?;
    }
    let path = paths::to_text(&stale.path);
    match &stale.found {
        Some(found) => db
            .prepare_cached("INSERT OR REPLACE INTO sidecar (path, size, modified_ns) VALUES (?, ?, ?)")?
            .execute(params![path, found.size, found.modified_ns])?,
        None => db.prepare_cached("DELETE FROM sidecar WHERE path = ?")?.execute([path])?,
    };
    Ok(())
}

/// Takes over the usable segments where the user has marked none.
fn put_segments(db: &Transaction<'_>, clip: i64, sidecar: Option<&Sidecar>) -> Result<(), LibraryError> {
    let pieces = sidecar.and_then(|sidecar| sidecar.get(Line::UsableSegments)).map(segments).unwrap_or_default();
    let has_some: bool = db
        .prepare_cached("SELECT EXISTS (SELECT 1 FROM segment WHERE clip_id = ?)")?
        .query_row([clip], |row| row.get(0))?;
    if has_some {
        return Ok(());
    }
    let mut insert = db.prepare_cached(
        "INSERT INTO segment (clip_id, first_frame, last_frame, note) VALUES (?, ?, ?, ?) ON CONFLICT DO NOTHING",
    )?;
    for piece in pieces {
        insert.execute(params![clip, piece.first_frame, piece.last_frame, piece.note])?;
    }
    Ok(())
}
