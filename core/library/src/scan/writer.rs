//! Writes what was read into the library: many files in a transaction, one writer.

use std::path::{Path, PathBuf};
use std::sync::atomic::Ordering;

use rusqlite::{params, params_from_iter, Connection, OptionalExtension, ToSql, Transaction};

use super::plan::{is_gone, Plan};
use super::progress::{count, State};
use super::reading::Reading;
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

/// Writes one file.
pub(super) fn write(
    db: &Transaction<'_>,
    roots: &[Root],
    plan: &Plan,
    reading: &Reading,
    state: &State,
) -> Result<(), LibraryError> {
    // Its folder was taken out of the library meanwhile.
    let Some(root) = innermost(roots, &reading.found.path) else { return Ok(()) };
    let path = paths::to_text(&reading.found.path);
    let place = place(db, &path, reading)?;
    if reading.outcome.is_err() {
        count(&state.broken);
    }
    let says = reading.outcome.as_ref().map_or(&[][..], |(facts, _)| &facts.says);
    match place {
        Place::New => {
            count(&state.new);
            put(db, INSERT, reading, root, &path, None)?;
            let id = db.last_insert_rowid();
            tell(db, id, Source::File, &says.iter().map(some).collect::<Vec<_>>())?;
            tell(db, id, Source::Sidecar, &reading.sidecar_says.iter().map(some).collect::<Vec<_>>())?;
        }
        Place::Same(id, is_changed) => {
            if is_changed {
                count(&state.changed);
            }
            put(db, UPDATE, reading, root, &path, Some(id))?;
            say(db, id, says, &reading.sidecar_says)?;
        }
        Place::Moved(id) => {
            count(&state.moved);
            if plan.gone.contains(&id) {
                state.missing.fetch_sub(1, Ordering::Relaxed);
            }
            put(db, UPDATE, reading, root, &path, Some(id))?;
            say(db, id, says, &reading.sidecar_says)?;
        }
    }
    Ok(())
}

/// Copies of one file may be many: so many of them are looked at, those that were missing before first.
const LOOKS: i64 = 16;

fn place(db: &Connection, path: &str, reading: &Reading) -> Result<Place, LibraryError> {
    let mut find = db.prepare_cached("SELECT id, content_hash IS NOT ?2 FROM clip WHERE path = ?1")?;
    let same =
        find.query_row(params![path, reading.hash], |row| Ok(Place::Same(row.get(0)?, row.get(1)?))).optional()?;
    if let Some(same) = same {
        return Ok(same);
    }
    let mut find =
        db.prepare_cached("SELECT id, path FROM clip WHERE content_hash = ? ORDER BY is_missing DESC, id LIMIT ?")?;
    let mut rows = find.query(params![reading.hash, LOOKS])?;
    while let Some(row) = rows.next()? {
        if is_gone(&paths::to_path(&row.get::<_, String>(1)?)) {
            return Ok(Place::Moved(row.get(0)?));
        }
    }
    Ok(Place::New)
}

fn some((field, value): &(Field, String)) -> (Field, Option<String>) {
    (*field, Some(value.clone()))
}

/// Replaces what the file itself and its sidecar say of a clip.
fn say(db: &Connection, id: i64, file: &[(Field, String)], sidecar: &[(Field, String)]) -> Result<(), LibraryError> {
    for (source, says) in [(Source::File, file), (Source::Sidecar, sidecar)] {
        let value = |field: Field| says.iter().find(|(known, _)| *known == field).map(|(_, value)| value.clone());
        tell(db, id, source, &Field::ALL.map(|field| (field, value(field))))?;
    }
    put_in_force(db, id)
}

const INSERT: &str = "INSERT INTO clip (
        id, folder_id, path, name, folder, size, modified_ns, content_hash, format, frames, first_frame, rate_hz,
        duration_s, joints, markers, skeleton_fingerprint, height_m, unit_m, up, skeleton_path, skeleton_reason, notices,
        error, facts_at, facts_by, sidecar_ns, subject, recorded_on, description, session_group, cleaned
    ) VALUES (?1, ?2, ?3, ?4, ?5, ?6, ?7, ?8, ?9, ?10, ?11, ?12, ?13, ?14, ?15, ?16, ?17, ?18, ?19, ?20, ?21, ?22, ?23,
        ?24, ?25, ?26, ?27, ?28, ?29, ?30, CAST(?31 AS INTEGER))";

const UPDATE: &str = "UPDATE clip SET
        folder_id = ?2, path = ?3, name = ?4, folder = ?5, size = ?6, modified_ns = ?7, content_hash = ?8, format = ?9,
        frames = ?10, first_frame = ?11, rate_hz = ?12, duration_s = ?13, joints = ?14, markers = ?15,
        skeleton_fingerprint = ?16, height_m = ?17, unit_m = ?18, up = ?19, skeleton_path = ?20, skeleton_reason = ?21,
        notices = ?22, error = ?23, facts_at = ?24, facts_by = ?25, sidecar_ns = ?26, is_missing = 0
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
        found.sidecar_ns,
    ];
    let mut statement = db.prepare_cached(sql)?;
    if id.is_some() {
        statement.execute(known)?;
    } else {
        // Nobody has said anything of a new clip but its sidecar and its file.
        let says = reading.sidecar_says.iter().chain(facts.into_iter().flat_map(|facts| &facts.says));
        let says = |field: Field| says.clone().find(|(said, _)| *said == field);
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
