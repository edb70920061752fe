//! The skeletons that a walk came by, and which of them a motion without one belongs to.

use std::collections::HashMap;
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, PoisonError};

use motion_theater_core::pairing::{candidates, default_skeleton, Around, Candidate, Hints, DEFAULT_SKELETON_NOTICE};
use motion_theater_core::read::{read_path, Clip};
use motion_theater_core::sidecar::{self, Field};
use motion_theater_core::Skeleton;

/// So many skeletons are kept in memory (a few ten thousand bytes each); then reading begins anew.
const MOST_KEPT: usize = 1000;

/// The skeleton of a motion, or none, and why.
pub(super) struct Paired {
    pub(super) skeleton: Option<Arc<Skeleton>>,
    /// Its file; `None` for the built-in one.
    pub(super) path: Option<PathBuf>,
    pub(super) reason: String,
    /// Whether the user should be told that sizes are a guess.
    pub(super) is_default: bool,
}

/// The skeleton files of the folders that are scanned.
#[derive(Default)]
pub(super) struct Skeletons {
    by_folder: HashMap<PathBuf, Vec<PathBuf>>,
    /// All that there are, and those of the library that lie elsewhere.
    all: Vec<PathBuf>,
    kept: Mutex<HashMap<PathBuf, Option<Arc<Skeleton>>>>,
}

impl Skeletons {
    /// Notes a skeleton file.
    pub(super) fn add(&mut self, path: &Path) {
        let folder = path.parent().unwrap_or(Path::new("")).to_owned();
        self.by_folder.entry(folder).or_default().push(path.to_owned());
        self.add_distant(path);
    }

    /// Notes a skeleton file outside the folders that are scanned.
    pub(super) fn add_distant(&mut self, path: &Path) {
        self.all.push(path.to_owned());
    }

    /// Finds the skeleton of a motion: the one that its sidecar names, one beside it, any of the library, or else the
    /// built-in default where it fits.
    pub(super) fn pair(&self, path: &Path, clip: &Clip) -> Paired {
        let sidecar = sidecar::read_beside(path);
        let named = sidecar.as_ref().and_then(|sidecar| sidecar.get(Field::AsfFile)).filter(|name| !name.is_empty());
        let motion = clip.amc.as_ref().and_then(|amc| amc.header.skeleton_hint.as_deref());
        let hints = Hints { sidecar: named, motion };
        let parent = path.parent().unwrap_or(Path::new(""));
        let in_folder = |folder: &Path| self.by_folder.get(folder).map_or(&[][..], Vec::as_slice);
        let near = Around {
            folder: in_folder(parent),
            above: parent.parent().map(in_folder).unwrap_or_default(),
            ..Around::default()
        };
        let anywhere = Around { others: &self.all, ..near };
        let is_any = !near.folder.is_empty() || !near.above.is_empty();
        // Most motions find theirs beside them; all others are only ranked for the rest.
        let first = if named.is_some() { None } else { self.first_that_fits(candidates(path, hints, near), clip) };
        if let Some(paired) = first.or_else(|| self.first_that_fits(candidates(path, hints, anywhere), clip)) {
            return paired;
        }
        let is_default = clip.fits(default_skeleton());
        let reason = match is_default {
            true => DEFAULT_SKELETON_NOTICE,
            false if is_any => "No skeleton beside the file fits, and the default does not either",
            false => "The skeleton (.asf) was not found beside the file, and the default does not fit",
        };
        let skeleton = is_default.then(|| Arc::new(default_skeleton().clone()));
        Paired { skeleton, path: None, reason: reason.to_owned(), is_default }
    }

    fn first_that_fits(&self, candidates: Vec<Candidate>, clip: &Clip) -> Option<Paired> {
        candidates.into_iter().find_map(|candidate| {
            let skeleton = self.read(&candidate.path).filter(|skeleton| clip.fits(skeleton))?;
            let reason = candidate.reason.to_string();
            Some(Paired { skeleton: Some(skeleton), path: Some(candidate.path), reason, is_default: false })
        })
    }

    /// Returns the skeleton of a file; `None` where it cannot be read.
    fn read(&self, path: &Path) -> Option<Arc<Skeleton>> {
        let kept = || self.kept.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(known) = kept().get(path) {
            return known.clone();
        }
        let skeleton = read_path(path, None).ok().and_then(|clip| clip.skeleton).map(Arc::new);
        self.keep(path, skeleton.clone());
        skeleton
    }

    /// Keeps the skeleton of a file that was read anyway.
    pub(super) fn keep(&self, path: &Path, skeleton: Option<Arc<Skeleton>>) {
        let mut kept = self.kept.lock().unwrap_or_else(PoisonError::into_inner);
        if kept.len() >= MOST_KEPT {
            kept.clear();
        }
        kept.insert(path.to_owned(), skeleton);
    }
}
