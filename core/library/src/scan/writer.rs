//! Writes what was read into the library: many files in a transaction, one writer.

use std::path::{Path, PathBuf};
use std::sync::atomic::Ordering;

use rusqlite::{params, params_from_iter, Connection, OptionalExtension, ToSql, Transaction};

use super::plan::{is_gone, Plan};
use super::progress::{count, State};
use super::reading::Reading;
use super::sidecars;
use crate::catalogue::told::{put_in_force, tell};
use crate::catalogue::{now, paths, Field, Source};
use crate::error::LibraryError;
use crate::facts::{Facts, READER};

/// A folder of the library, to find the innermost that holds a file.
pub(super) struct Root {
    pub(super) id: i64,
    pub(super) path: PathBuf,
}

/// Marks the clips that are gone, and takes the mark from those that are back.
///
/// This comes before the first file is written: a file that was moved is known by its content among those that are gone.
pub(super) fn mark(db: &Transaction<'_>, plan: &Plan, state: &State) -> Result<(), LibraryError> {
    let mut update = db.prepare_cached("UPDATE clip SET is_missing = ? WHERE id = ? AND is_missing <> ?1")?;
    for id in &plan.gone {
        update.execute(params![true, id])?;
        count(&state.missing);
    }
    for id in &plan.back {
        update.execute(params![false, id])?;
    }
    Ok(())
}

/// What the library has for a file.
enum Place {
    /// A clip at the same path, and whether its content was another.
    Same(i64, bool),
    /// A clip with the same content that was elsewhere.
    Moved(i64),
    New,
}

/// Writes files: the new ones first, together, for their words are indexed much faster that way. The triggers that do that
/// for others must sleep.
pub(super) fn write_all(
    db: &Transaction<'_>,
    roots: &[Root],
    plan: &Plan,
    batch: &[Reading],
    state: &State,
) -> Result<(), LibraryError> {
    let mut known = Vec::new();
    let last: i64 = db.query_row("SELECT coalesce(max(id), 0) FROM clip", (), |row| row.get(0))?;
    let has_sidecars: bool = db.query_row("SELECT EXISTS (SELECT 1 FROM sidecar)", (), |row| row.get(0))?;
    for reading in batch {
        // Where there is none, its folder was taken out of the library meanwhile.
        let Some(root) = innermost(roots, &reading.found.path) else { continue };
        let path = paths::to_text(&reading.found.path);
        if reading.outcome.is_err() {
            count(&state.broken);
        }
        if has_sidecars {
            sidecars::forget(db, &reading.found.path)?;
        }
        match place(db, &path, reading)? {
            Place::New => {
                count(&state.new);
                put(db, INSERT, reading, root, &path, None)?;
                let says = says(reading).iter().map(|(field, value)| (*field, Some(value.clone())));
                tell(db, db.last_insert_rowid(), Source::File, &says.collect::<Vec<_>>())?;
            }
            place => known.push((place, reading, root, path)),
        }
    }
    index_words(db, last + 1, i64::MAX)?;
    for (place, reading, root, path) in known {
        let id = match place {
            Place::New => continue,
            Place::Same(id, is_changed) => {
                state.changed.fetch_add(u64::from(is_changed), Ordering::Relaxed);
                id
            }
            Place::Moved(id) => {
                count(&state.moved);
                state.missing.fetch_sub(u64::from(plan.gone.contains(&id)), Ordering::Relaxed);
                sidecars::leave(db, id)?;
                id
            }
        };
        db.prepare_cached("DELETE FROM clip_text WHERE rowid = ?")?.execute([id])?;
        put(db, UPDATE, reading, root, &path, Some(id))?;
        say(db, id, says(reading))?;
        index_words(db, id, id)?;
    }
    Ok(())
}

/// Puts the words of clips into the full-text index, from one number to another.
fn index_words(db: &Connection, first: i64, last: i64) -> Result<(), LibraryError> {
    let mut insert = db.prepare_cached(
        "INSERT INTO clip_text (rowid, name, folder, subject, description, session_group, tags)
         SELECT * FROM clip_words WHERE id BETWEEN ? AND ?",
    )?;
    insert.execute([first, last])?;
    Ok(())
}

fn says(reading: &Reading) -> &[(Field, String)] {
    reading.outcome.as_ref().map_or(&[][..], |(facts, _)| &facts.says)
}

/// Copies of one file may be many: some of them are looked at, those that were missing before first.
///
/// The limit is no parameter: with one, `SQLite` plans the statement anew whenever it is used.
const SAME_CONTENT: &str = "SELECT id, path FROM clip WHERE content_hash = ? ORDER BY is_missing DESC, id LIMIT 16";

fn place(db: &Connection, path: &str, reading: &Reading) -> Result<Place, LibraryError> {
    let mut find = db.prepare_cached("SELECT id, content_hash IS NOT ?2 FROM clip WHERE path = ?1")?;
    let same =
        find.query_row(params![path, reading.hash], |row| Ok(Place::Same(row.get(0)?, row.get(1)?))).optional()?;
    if let Some(same) = same {
        return Ok(same);
    }
    let mut find = db.prepare_cached(SAME_CONTENT)?;
    let mut rows = find.query([reading.hash])?;
    while let Some(row) = rows.next()? {
        if is_gone(&paths::to_path(&row.get::<_, String>(1)?)) {
            return Ok(Place::Moved(row.get(0)?));
        }
    }
    Ok(Place::New)
}

/// Replaces what the file itself says of a clip.
fn say(db: &Connection, id: i64, says: &[(Field, String)]) -> Result<(), LibraryError> {
    let value = |field: Field| says.iter().find(|(known, _)| *known == field).map(|(_, value)| value.clone());
    tell(db, id, Source::File, &Field::ALL.map(|field| (field, value(field))))?;
    put_in_force(db, id)
}

const INSERT: &str = "INSERT OR ROLLBACK INTO clip (
        id, folder_id, path, name, folder, size, modified_ns, content_hash, format, frames, first_frame, rate_hz,
        duration_s, joints, markers, skeleton_fingerprint, height_m, unit_m, up, skeleton_path, skeleton_reason, notices,
        error, facts_at, facts_by, subject, recorded_on, description, session_group, cleaned
    ) VALUES (?1, ?2, ?3, ?4, ?5, ?6, ?7, ?8, ?9, ?10, ?11, ?12, ?13, ?14, ?15, ?16, ?17, ?18, ?19, ?20, ?21, ?22, ?23,
        ?24, ?25, ?26, ?27, ?28, ?29, CAST(?30 AS INTEGER))";

const UPDATE: &str = "UPDATE OR ROLLBACK clip SET
        folder_id = ?2, path = ?3, name = ?4, folder = ?5, size = ?6, modified_ns = ?7, content_hash = ?8, format = ?9,
        frames = ?10, first_frame = ?11, rate_hz = ?12, duration_s = ?13, joints = ?14, markers = ?15,
        skeleton_fingerprint = ?16, height_m = ?17, unit_m = ?18, up = ?19, skeleton_path = ?20, skeleton_reason = ?21,
        notices = ?22, error = ?23, facts_at = ?24, facts_by = ?25, is_missing = 0
    WHERE id = ?1";

fn put(
    db: &Connection,
    sql: &str,
    reading: &Reading,
    root: &Root,
    path: &str,
    id: Option<i64>,
) -> Result<(), LibraryError> {
    let found = &reading.found;
    let facts = reading.outcome.as_ref().ok().map(|(facts, _)| facts);
    let failure = reading.outcome.as_ref().err();
    let paired = reading.outcome.as_ref().ok().and_then(|(_, paired)| paired.as_ref());
    let skeleton_path = paired.and_then(|paired| paired.path.as_deref()).map(paths::to_text);
    let skeleton = facts.and_then(|facts| facts.skeleton.as_ref());
    let format = facts.map(|facts| facts.format).or(failure.and_then(|failure| failure.format));
    let notices = facts.map_or_else(Vec::new, |facts| facts.notices.clone());
    let whole = |count: usize| i64::try_from(count).unwrap_or(i64::MAX);
    let known = params![
        id,
        root.id,
        path,
        found.path.file_name().unwrap_or_default().to_string_lossy(),
        paths::place(&found.path, &root.path),
        found.size,
        found.modified_ns,
        reading.hash,
        format.map_or("", motion_theater_core::read::Format::extension),
        facts.map(|facts| whole(facts.frames)),
        facts.and_then(|facts| facts.first_frame),
        facts.and_then(|facts| facts.rate_hz),
        facts.and_then(Facts::duration_s),
        facts.and_then(|facts| facts.joints).map(whole),
        facts.and_then(|facts| facts.markers).map(whole),
        skeleton.map(|skeleton| &skeleton.fingerprint),
        skeleton.map(|skeleton| skeleton.height_m),
        facts.and_then(|facts| facts.unit_m),
        facts.and_then(|facts| facts.up),
        skeleton_path,
        paired.map(|paired| &paired.reason),
        serde_json::to_string(&notices).unwrap_or_default(),
        failure.map(|failure| &failure.message),
        now(),
        READER,
    ];
    let mut statement = db.prepare_cached(sql)?;
    if id.is_some() {
        statement.execute(known)?;
    } else {
        // Nobody has said anything of a new clip but its file; its sidecar is read later.
        let says = |field: Field| facts.and_then(|facts| facts.says.iter().find(|(said, _)| *said == field));
        let said = Field::ALL.map(|field| says(field).map(|(_, value)| value));
        let said = said.iter().map(|value| value as &dyn ToSql);
        statement.execute(params_from_iter(known.iter().copied().chain(said)))?;
    }
    Ok(())
}

/// Returns the innermost folder of the library that holds a file.
fn innermost<'a>(roots: &'a [Root], path: &Path) -> Option<&'a Root> {
    let holding = roots.iter().filter(|root| path.starts_with(&root.path));
    holding.max_by_key(|root| root.path.as_os_str().len())
}
