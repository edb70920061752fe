//! Clips as the library knows them.

use std::path::PathBuf;

use rusqlite::{Connection, OptionalExtension, Row};

use serde::{Serialize, Serializer};

use super::{paths, Library};
use crate::error::LibraryError;

/// Everything that is known of a clip. What nobody knows is `None`.
#[derive(Debug, Clone, PartialEq, Default, Serialize)]
pub struct ClipRow {
    /// The clip's number in this library: it stays, wherever the file moves.
    pub id: i64,
    /// Where the file is: an absolute path.
    #[serde(serialize_with = "as_text")]
    pub path: PathBuf,
    /// The name of the file.
    pub name: String,
    /// The folder of the library in which it lies, and the folders below it, with `/` between them.
    pub folder: String,
    /// In bytes.
    pub size: i64,
    /// When the file was last changed, in nanoseconds since 1970.
    pub modified_ns: i64,
    /// The BLAKE3 hash of the file's bytes; `None` where they cannot be read.
    #[serde(serialize_with = "as_digits")]
    pub content_hash: Option<[u8; 32]>,
    /// The format by its extension: `bvh`.
    pub format: String,
    /// How many frames there are.
    pub frames: Option<i64>,
    /// The file's own number of the first frame.
    pub first_frame: Option<i64>,
    /// Frames per second; assumed where the file does not say, as a notice tells.
    pub rate_hz: Option<f64>,
    /// How long all frames last: `frames / rate_hz`.
    pub duration_s: Option<f64>,
    /// How many joints or bones move.
    pub joints: Option<i64>,
    /// How many markers there are.
    pub markers: Option<i64>,
    /// Equal where names and hierarchy of two skeletons are.
    pub skeleton_fingerprint: Option<String>,
    /// The height of the skeleton's rest pose.
    pub height_m: Option<f64>,
    /// Metres per file unit.
    pub unit_m: Option<f64>,
    /// The axis that points up in the file: `Y`, `-Z`.
    pub up: Option<String>,
    /// The skeleton of a motion that has none of its own.
    #[serde(serialize_with = "as_text_if_any")]
    pub skeleton_path: Option<PathBuf>,
    /// Why that skeleton, or why none.
    pub skeleton_reason: Option<String>,
    /// Who was recorded.
    pub subject: Option<String>,
    /// When: a year, a month or a day (`2004-05-31`).
    pub recorded_on: Option<String>,
    /// What happens.
    pub description: Option<String>,
    /// The session, or another group of clips that belong together.
    pub session_group: Option<String>,
    /// Whether the capture was cleaned.
    pub cleaned: Option<bool>,
    /// From 1 to 5 stars; 0 for none.
    pub rating: u8,
    /// Whether it is among the favourites.
    pub is_favourite: bool,
    /// When it was last used, in seconds since 1970.
    pub used_at: Option<i64>,
    /// What is odd in the file, and what was inferred, a sentence each.
    pub notices: Vec<String>,
    /// Why the file cannot be read.
    pub error: Option<String>,
    /// Whether the file was gone at the last scan.
    pub is_missing: bool,
    /// The user's words on it, by name.
    pub tags: Vec<String>,
    /// The usable pieces: first and last frame, in the file's own numbers.
    pub segments: Vec<(i64, i64)>,
    /// Which source says the field that is in force, by the names of both: `("subject", "USER")`.
    pub sources: Vec<(String, String)>,
}

fn as_text<S: Serializer>(path: &std::path::Path, serializer: S) -> Result<S::Ok, S::Error> {
    serializer.serialize_str(&path.to_string_lossy())
}

#[allow(clippy::ref_option)] // So it is asked for.
fn as_text_if_any<S: Serializer>(path: &Option<PathBuf>, serializer: S) -> Result<S::Ok, S::Error> {
    path.as_ref().map(|path| path.to_string_lossy()).serialize(serializer)
}

#[allow(clippy::ref_option)] // So it is asked for.
fn as_digits<S: Serializer>(hash: &Option<[u8; 32]>, serializer: S) -> Result<S::Ok, S::Error> {
    hash.map(|bytes| blake3::Hash::from(bytes).to_hex().to_string()).serialize(serializer)
}

impl Library {
    /// Returns clips by their numbers, in that order; those that are not there are left out.
    ///
    /// # Errors
    /// Where the library cannot be read.
    pub fn clips(&self, ids: &[i64]) -> Result<Vec<ClipRow>, LibraryError> {
        self.read(|db| ids.iter().filter_map(|id| clip(db, *id).transpose()).collect())
    }

    /// Returns how many clips there are, missing and broken ones too.
    ///
    /// # Errors
    /// Where the library cannot be read.
    pub fn count(&self) -> Result<u32, LibraryError> {
        self.read(|db| Ok(db.query_row("SELECT count(*) FROM clip", (), |row| row.get(0))?))
    }

    /// Returns the number of the clip at an absolute path.
    ///
    /// # Errors
    /// Where the library cannot be read.
    pub fn find(&self, path: &std::path::Path) -> Result<Option<i64>, LibraryError> {
        let text = paths::to_text(path);
        self.read(|db| Ok(db.query_row("SELECT id FROM clip WHERE path = ?", [text], |row| row.get(0)).optional()?))
    }
}

fn clip(db: &Connection, id: i64) -> Result<Option<ClipRow>, LibraryError> {
    let found = db.prepare_cached("SELECT * FROM clip WHERE id = ?")?.query_row([id], of_row).optional()?;
    let Some(mut clip) = found else { return Ok(None) };
    clip.tags = pairs(db, "SELECT name, 0 FROM tag JOIN clip_tag ON tag_id = id WHERE clip_id = ? ORDER BY name", id)?
        .into_iter()
        .map(|(name, _): (String, i64)| name)
        .collect();
    clip.segments = pairs(db, "SELECT first_frame, last_frame FROM segment WHERE clip_id = ? ORDER BY 1, 2", id)?;
    clip.sources = pairs(
        db,
        "SELECT field, CASE max(CASE source WHEN 'USER' THEN 3 WHEN 'SIDECAR' THEN 2 WHEN 'INDEX' THEN 1 ELSE 0 END)
             WHEN 3 THEN 'USER' WHEN 2 THEN 'SIDECAR' WHEN 1 THEN 'INDEX' ELSE 'FILE' END
         FROM told WHERE clip_id = ? GROUP BY field ORDER BY field",
        id,
    )?;
    Ok(Some(clip))
}

fn pairs<A: rusqlite::types::FromSql, B: rusqlite::types::FromSql>(
    db: &Connection,
    sql: &str,
    id: i64,
) -> Result<Vec<(A, B)>, LibraryError> {
    let mut rows = db.prepare_cached(sql)?;
    let pairs = rows.query_map([id], |row| Ok((row.get(0)?, row.get(1)?)))?.collect::<Result<_, _>>()?;
    Ok(pairs)
}

fn of_row(row: &Row<'_>) -> rusqlite::Result<ClipRow> {
    let path = |text: String| paths::to_path(&text);
    Ok(ClipRow {
        id: row.get("id")?,
        path: path(row.get("path")?),
        name: row.get("name")?,
        folder: row.get("folder")?,
        size: row.get("size")?,
        modified_ns: row.get("modified_ns")?,
        content_hash: row.get("content_hash")?,
        format: row.get("format")?,
        frames: row.get("frames")?,
        first_frame: row.get("first_frame")?,
        rate_hz: row.get("rate_hz")?,
        duration_s: row.get("duration_s")?,
        joints: row.get("joints")?,
        markers: row.get("markers")?,
        skeleton_fingerprint: row.get("skeleton_fingerprint")?,
        height_m: row.get("height_m")?,
        unit_m: row.get("unit_m")?,
        up: row.get("up")?,
        skeleton_path: row.get::<_, Option<String>>("skeleton_path")?.map(path),
        skeleton_reason: row.get("skeleton_reason")?,
        subject: row.get("subject")?,
        recorded_on: row.get("recorded_on")?,
        description: row.get("description")?,
        session_group: row.get("session_group")?,
        cleaned: row.get("cleaned")?,
        rating: row.get("rating")?,
        is_favourite: row.get("is_favourite")?,
        used_at: row.get("used_at")?,
        notices: serde_json::from_str(&row.get::<_, String>("notices")?).unwrap_or_default(),
        error: row.get("error")?,
        is_missing: row.get("is_missing")?,
        ..ClipRow::default()
    })
}
