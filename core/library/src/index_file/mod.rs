//! Lists that describe the clips of a folder, such as CMU's: which row is which clip, and what it says of it.
//!
//! A scan looks for them by name ([`is_index`]); any other file can be read with [`Library::import_index`]. What a list
//! says is kept as [`Source::Index`](crate::catalogue::Source), below sidecars and the user.

mod columns;
mod names;
mod table;

#[cfg(test)]
mod tests;

pub use columns::Column;
pub use table::{read, Row};

use std::collections::{BTreeMap, HashMap};
use std::path::{Path, PathBuf};

use rusqlite::{params, Connection};

use crate::catalogue::told::{put_in_force, tell};
use crate::catalogue::{paths, Field, Library, Source};
use crate::error::LibraryError;
use names::Names;

/// No list is longer, in bytes: CMU's of 2,600 clips has 200 kB.
const LONGEST: u64 = 64 << 20;

/// Returns whether a file is a list by its name: `.csv`, `.tsv` or `.txt`, with a word `index` in it, as in `index.csv` and
/// `cmu-mocap-index-text.txt`.
pub fn is_index(path: &Path) -> bool {
    let part = |part: Option<&std::ffi::OsStr>| part.and_then(|part| part.to_str()).unwrap_or_default().to_lowercase();
    let extension = part(path.extension());
    let is_table = ["csv", "tsv", "txt"].contains(&extension.as_str());
    is_table && part(path.file_stem()).split(|c: char| !c.is_alphanumeric()).any(|word| word == "index")
}

impl Library {
    /// Reads a list that describes clips, and returns how many it describes: of the folder that it lies in and those below,
    /// or of the whole library where it lies elsewhere. `columns` maps `file`, `subject`, `trial`, `description`, `date`,
    /// `group` and `cleaned` to what stands over these columns; without it that is guessed.
    ///
    /// # Errors
    /// Where the file cannot be read, does not say which clips it means, or the library cannot be written.
    pub fn import_index(&self, path: &Path, columns: Option<&BTreeMap<String, String>>) -> Result<usize, LibraryError> {
        let path = paths::plain(path).map_err(|source| LibraryError::io(path, source))?;
        let rows = load(&path, columns)?;
        let folder = path.parent().unwrap_or(&path);
        let is_within = self.folders()?.iter().any(|known| folder.starts_with(&known.path));
        self.write(|db| {
            let mut says = Says::new();
            gather(db, is_within.then_some(folder), &rows, &mut says)?;
            write(db, &says)
        })
    }
}

/// Reads a list from the disk.
fn load(path: &Path, columns: Option<&BTreeMap<String, String>>) -> Result<Vec<Row>, LibraryError> {
    let io = |source| LibraryError::io(path, source);
    let wrong = |text: String| LibraryError::Asked(format!("{}: {text}", path.display()));
    if std::fs::metadata(path).map_err(io)?.len() > LONGEST {
        return Err(wrong(format!("expected a list of at most {} MB", LONGEST >> 20)));
    }
    read(&std::fs::read(path).map_err(io)?, columns).map_err(wrong)
}

/// Writes what the lists that a scan came by say. Of one clip, a list further in is believed before those around it. A list
/// that cannot be read says nothing.
pub(crate) fn apply_all(library: &Library, mut found: Vec<PathBuf>) -> Result<(), LibraryError> {
    found.sort_by_cached_key(|path| (path.components().count(), path.clone()));
    let lists: Vec<_> = found.iter().filter_map(|path| Some((path.parent()?, load(path, None).ok()?))).collect();
    if lists.is_empty() {
        return Ok(());
    }
    library.write(|db| {
        let mut says = Says::new();
        for (folder, rows) in &lists {
            gather(db, Some(folder), rows, &mut says)?;
        }
        write(db, &says).map(drop)
    })
}

/// What lists say, by the number of the clip and the name of the field.
type Says<'a> = HashMap<i64, BTreeMap<&'static str, &'a str>>;

/// Finds what rows say of the clips in a folder and below it; `None`: of all.
fn gather<'a>(
    db: &Connection,
    folder: Option<&Path>,
    rows: &'a [Row],
    says: &mut Says<'a>,
) -> Result<(), LibraryError> {
    let (from, to) = folder.map_or((String::new(), None), |folder| {
        let (from, to) = paths::below(&paths::to_text(folder));
        (from, Some(to))
    });
    let mut clips = db.prepare_cached("SELECT id, path FROM clip WHERE path >= ?1 AND (?2 IS NULL OR path < ?2)")?;
    let clips = clips.query_map(params![from, to], |row| Ok((row.get(0)?, row.get(1)?)))?;
    let names = Names::of(clips.collect::<Result<Vec<(i64, String)>, _>>()?.into_iter());
    for row in rows.iter().filter(|row| !row.says.is_empty()) {
        for clip in names.meant(row.file.as_deref(), row.numbers) {
            says.entry(clip).or_default().extend(row.says.iter().map(|(field, value)| (field.name(), value.as_str())));
        }
    }
    Ok(())
}

/// Writes what lists say in place of what they said before, and returns of how many clips. Clips of which they say the same
/// as before are not touched.
fn write(db: &Connection, says: &Says<'_>) -> Result<usize, LibraryError> {
    let mut told = db.prepare_cached("SELECT field, value FROM told WHERE clip_id = ? AND source = ?")?;
    for (clip, says) in says {
        let before = told.query_map(params![clip, Source::Index.name()], |row| Ok((row.get(0)?, row.get(1)?)))?;
        let before = before.collect::<Result<BTreeMap<String, String>, _>>()?;
        let is_same = before.len() == says.len()
            && says.iter().all(|(field, value)| before.get(*field).is_some_and(|before| before == value));
        if !is_same {
            let now = Field::ALL.map(|field| (field, says.get(field.name()).map(|value| (*value).to_owned())));
            tell(db, *clip, Source::Index, &now)?;
            put_in_force(db, *clip)?;
        }
    }
    Ok(says.len())
}
