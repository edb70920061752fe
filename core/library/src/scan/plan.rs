//! What a scan has to do: which files are new or changed, which clips are gone or have come back.

use std::collections::{BTreeSet, HashSet};
use std::path::{Path, PathBuf};

use motion_theater_core::read::Format;
use rusqlite::{params, Connection, OptionalExtension};

use super::progress::{count, State};
use super::sidecars;
use super::skeletons::Skeletons;
use super::walk::{begins_as_motion, files, Found, Step};
use crate::catalogue::paths;
use crate::error::LibraryError;
use crate::facts::READER;
use crate::index_file::is_index;

/// What a walk over the folders says.
///
/// What is kept in memory: about 200 bytes for each file that is new or changed, about 16 for each clip.
#[derive(Default)]
pub(super) struct Plan {
    /// New or changed files, in the order of the walk.
    pub(super) to_read: Vec<Found>,
    /// Clips that were missing and are there again, unchanged.
    pub(super) back: Vec<i64>,
    /// Clips that are gone.
    pub(super) gone: HashSet<i64>,
    pub(super) skeletons: Skeletons,
    /// The sidecars in the folders, whether changed or not.
    pub(super) sidecars: Vec<Found>,
    /// Lists that describe clips.
    pub(super) lists: Vec<PathBuf>,
}

/// What the library knows of a file at some path.
struct Known {
    id: i64,
    is_unchanged: bool,
    is_missing: bool,
}

/// Walks over folders and compares them with the library.
pub(super) fn make(db: &Connection, folders: &[PathBuf], state: &State) -> Result<Plan, LibraryError> {
    let mut plan = Plan::default();
    let mut seen = HashSet::new();
    let mut closed = Vec::new();
    let mut other_skeletons = BTreeSet::new();
    for folder in folders {
        for step in files(folder) {
            if state.is_cancelled() {
                return Ok(plan);
            }
            match step {
                Step::File(found) if sidecars::is_sidecar(&found.path) => plan.sidecars.push(found),
                Step::File(found) => plan.look_at(db, found, &mut seen, &mut other_skeletons, state)?,
                Step::Closed(folder) => closed.push(folder),
            }
        }
    }
    for folder in folders {
        plan.miss(db, folder, &seen, &closed, &mut other_skeletons)?;
    }
    plan.know_distant_skeletons(db, folders)?;
    plan.pair_anew(db, &other_skeletons, state)?;
    plan.pair_by_sidecars(db, folders, state)?;
    Ok(plan)
}

impl Plan {
    fn look_at(
        &mut self,
        db: &Connection,
        found: Found,
        seen: &mut HashSet<i64>,
        other_skeletons: &mut BTreeSet<PathBuf>,
        state: &State,
    ) -> Result<(), LibraryError> {
        if is_index(&found.path) {
            self.lists.push(found.path.clone());
        }
        let may_be = found.may_be_motion();
        if may_be == Some(false) {
            return Ok(());
        }
        let is_skeleton = is_skeleton(&found.path);
        if is_skeleton {
            self.skeletons.add(&found.path);
        }
        let known = known(db, &found)?;
        if let Some(known) = &known {
            seen.insert(known.id);
        }
        match known {
            Some(Known { id, is_unchanged: true, is_missing }) => {
                count(&state.unchanged);
                if is_missing {
                    self.back.push(id);
                }
            }
            None if may_be.is_none() && !begins_as_motion(&found.path) => {}
            _ => {
                if is_skeleton {
                    other_skeletons.insert(found.path.clone());
                }
                count(&state.total);
                self.to_read.push(found);
            }
        }
        Ok(())
    }

    /// Notes which clips below a folder are gone.
    fn miss(
        &mut self,
        db: &Connection,
        folder: &Path,
        seen: &HashSet<i64>,
        closed: &[PathBuf],
        other_skeletons: &mut BTreeSet<PathBuf>,
    ) -> Result<(), LibraryError> {
        let (from, to) = paths::below(&paths::to_text(folder));
        let mut rows =
            db.prepare_cached("SELECT id, path FROM clip WHERE path >= ? AND path < ? AND is_missing = 0")?;
        let mut rows = rows.query([from, to])?;
        while let Some(row) = rows.next()? {
            let id: i64 = row.get(0)?;
            if seen.contains(&id) {
                continue;
            }
            let path = paths::to_path(&row.get::<_, String>(1)?);
            // Another scan may have found it meanwhile; in a folder that cannot be listed nobody knows.
            if closed.iter().any(|closed| path.starts_with(closed)) || !is_gone(&path) {
                continue;
            }
            if is_skeleton(&path) {
                other_skeletons.insert(path);
            }
            self.gone.insert(id);
        }
        Ok(())
    }

    /// Reads motions again that may have another skeleton now: those beside or below a skeleton that is new, changed or
    /// gone, those that had it, and those that had none.
    fn pair_anew(
        &mut self,
        db: &Connection,
        other_skeletons: &BTreeSet<PathBuf>,
        state: &State,
    ) -> Result<(), LibraryError> {
        if other_skeletons.is_empty() {
            return Ok(());
        }
        let mut listed: HashSet<PathBuf> = self.to_read.iter().map(|found| found.path.clone()).collect();
        let folders: HashSet<&Path> = other_skeletons.iter().filter_map(|path| path.parent()).collect();
        let mut rows = db.prepare_cached(
            "SELECT path, size, modified_ns, skeleton_path FROM clip
             WHERE format = 'amc' AND is_missing = 0 AND error IS NULL ORDER BY path",
        )?;
        let mut rows = rows.query(())?;
        while let Some(row) = rows.next()? {
            let path = paths::to_path(&row.get::<_, String>(0)?);
            let skeleton = row.get::<_, Option<String>>(3)?.map(|text| paths::to_path(&text));
            let is_near = || path.ancestors().skip(1).take(2).any(|above| folders.contains(above));
            let is_other = skeleton.is_none_or(|skeleton| other_skeletons.contains(&skeleton)) || is_near();
            if is_other && !is_gone(&path) && listed.insert(path.clone()) {
                count(&state.total);
                self.to_read.push(Found { path, size: row.get(1)?, modified_ns: row.get(2)? });
            }
        }
        Ok(())
    }

    /// Reads motions again whose sidecars may name another skeleton now.
    fn pair_by_sidecars(&mut self, db: &Connection, folders: &[PathBuf], state: &State) -> Result<(), LibraryError> {
        let mut listed: HashSet<PathBuf> = self.to_read.iter().map(|found| found.path.clone()).collect();
        for stale in sidecars::stale(db, folders, &self.sidecars)? {
            for clip in sidecars::beside(db, &stale)? {
                let is_motion = clip.format == Format::Amc.extension() && !is_gone(&clip.found.path);
                if is_motion && listed.insert(clip.found.path.clone()) {
                    count(&state.total);
                    self.to_read.push(clip.found);
                }
            }
        }
        Ok(())
    }

    /// Notes the skeletons of the library that lie outside the folders that are scanned.
    fn know_distant_skeletons(&mut self, db: &Connection, folders: &[PathBuf]) -> Result<(), LibraryError> {
        let mut rows = db.prepare_cached(
            "SELECT path FROM clip WHERE format = 'asf' AND is_missing = 0 AND error IS NULL ORDER BY path",
        )?;
        let mut rows = rows.query(())?;
        while let Some(row) = rows.next()? {
            let path = paths::to_path(&row.get::<_, String>(0)?);
            if !folders.iter().any(|folder| path.starts_with(folder)) {
                self.skeletons.add_distant(&path);
            }
        }
        Ok(())
    }
}

fn known(db: &Connection, found: &Found) -> Result<Option<Known>, LibraryError> {
    let mut find = db.prepare_cached(
        "SELECT id, size = ?2 AND modified_ns = ?3 AND facts_by = ?4, is_missing FROM clip WHERE path = ?1",
    )?;
    let values = params![paths::to_text(&found.path), found.size, found.modified_ns, READER];
    let known =
        |row: &rusqlite::Row<'_>| Ok(Known { id: row.get(0)?, is_unchanged: row.get(1)?, is_missing: row.get(2)? });
    Ok(find.query_row(values, known).optional()?)
}

fn is_skeleton(path: &Path) -> bool {
    path.extension().and_then(|extension| extension.to_str()).and_then(Format::from_extension) == Some(Format::Asf)
}

/// Returns whether there is nothing at a path. Where the disk cannot tell, there may be something.
pub(super) fn is_gone(path: &Path) -> bool {
    path.symlink_metadata()
        .is_err_and(|error| matches!(error.kind(), std::io::ErrorKind::NotFound | std::io::ErrorKind::NotADirectory))
}
