//! The folders that the user pointed at.
//!
//! One may lie within another: then a clip belongs to the innermost of them.

use std::path::{Path, PathBuf};

use rusqlite::{params, OptionalExtension, Transaction};

use super::{now, paths, Library};
use crate::error::LibraryError;

/// A folder of the library.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Folder {
    /// Where it is: an absolute path.
    pub path: PathBuf,
    /// How many clips belong to it, broken and missing ones too.
    pub clips: u32,
    /// How many of them cannot be read.
    pub broken: u32,
    /// How many of them are no longer there.
    pub missing: u32,
    /// When a scan of it was last complete, in seconds since 1970.
    pub scanned_at: Option<i64>,
}

impl Library {
    /// Returns the folders, by path.
    ///
    /// # Errors
    /// Where the library cannot be read.
    pub fn folders(&self) -> Result<Vec<Folder>, LibraryError> {
        self.read(|db| {
            let mut rows = db.prepare_cached(
                "SELECT path, scanned_at, count(clip.id), count(clip.error), coalesce(sum(clip.is_missing), 0)
                 FROM folder LEFT JOIN (SELECT id, folder_id, error, is_missing FROM clip) AS clip
                    ON clip.folder_id = folder.id
                 GROUP BY folder.id ORDER BY path",
            )?;
            let folder = |row: &rusqlite::Row<'_>| {
                Ok(Folder {
                    path: paths::to_path(&row.get::<_, String>(0)?),
                    scanned_at: row.get(1)?,
                    clips: row.get(2)?,
                    broken: row.get(3)?,
                    missing: row.get(4)?,
                })
            };
            let folders = rows.query_map((), folder)?.collect::<Result<_, _>>()?;
            Ok(folders)
        })
    }

    /// Adds a folder; one that is there already stays as it is. Its clips come with the next scan.
    ///
    /// # Errors
    /// Where there is no such folder, or the library cannot be written.
    pub fn add_folder(&self, folder: &Path) -> Result<PathBuf, LibraryError> {
        let path = paths::plain(folder).map_err(|source| LibraryError::io(folder, source))?;
        let entries = path.read_dir();
        entries.map_err(|source| LibraryError::io(&path, source))?;
        let text = paths::to_text(&path);
        self.write(|db| {
            let added = db.execute(
                "INSERT INTO folder (path, added_at) VALUES (?, ?) ON CONFLICT DO NOTHING",
                params![text, now()],
            )?;
            if added > 0 {
                hand_over(db, &text)?;
            }
            Ok(())
        })?;
        Ok(path)
    }

    /// Removes a folder and what is known of the clips in it; the files stay. Clips that lie in another folder of the
    /// library too belong to that one then.
    ///
    /// # Errors
    /// Where the folder is not in the library, or the library cannot be written.
    pub fn remove_folder(&self, folder: &Path) -> Result<(), LibraryError> {
        // A folder that is gone has no other path than the one it was added by.
        let path = paths::plain(folder).unwrap_or_else(|_| folder.to_owned());
        let text = paths::to_text(&path);
        self.write(|db| {
            let find = "SELECT id FROM folder WHERE path = ?";
            let id: Option<i64> = db.query_row(find, [&text], |row| row.get(0)).optional()?;
            let id = id.ok_or_else(|| LibraryError::Asked(format!("{}: not in the library", path.display())))?;
            let outer = path.ancestors().skip(1).find_map(|above| {
                db.query_row(find, [paths::to_text(above)], |row| row.get::<_, i64>(0)).optional().transpose()
            });
            if let Some(outer) = outer.transpose()? {
                db.execute("UPDATE clip SET folder_id = ? WHERE folder_id = ?", [outer, id])?;
                rename_places(db, outer)?;
            }
            db.execute("DELETE FROM folder WHERE id = ?", [id])?;
            super::tags::remove_unused(db)
        })
    }
}

/// Gives the clips in a new folder to it that belonged to one around it.
fn hand_over(db: &Transaction<'_>, folder: &str) -> Result<(), LibraryError> {
    let (from, to) = paths::below(folder);
    let id = db.last_insert_rowid();
    db.execute(
        "UPDATE clip SET folder_id = ?1 WHERE path >= ?2 AND path < ?3
         AND length((SELECT path FROM folder WHERE id = folder_id)) < length(?4)",
        params![id, from, to, folder],
    )?;
    rename_places(db, id)
}

/// Says anew where the clips of a folder lie.
fn rename_places(db: &Transaction<'_>, folder: i64) -> Result<(), LibraryError> {
    let root: String = db.query_row("SELECT path FROM folder WHERE id = ?", [folder], |row| row.get(0))?;
    let root = paths::to_path(&root);
    let mut clips = db.prepare("SELECT id, path FROM clip WHERE folder_id = ?")?;
    let clips: Vec<(i64, String)> =
        clips.query_map([folder], |row| Ok((row.get(0)?, row.get(1)?)))?.collect::<Result<_, _>>()?;
    let mut update = db.prepare("UPDATE clip SET folder = ? WHERE id = ?")?;
    for (id, path) in clips {
        update.execute(params![paths::place(&paths::to_path(&path), &root), id])?;
    }
    Ok(())
}
