//! The skeletons that a walk came by, and which of them a motion without one belongs to.

use std::collections::HashMap;
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, PoisonError};

use motion_theater_core::read::{read_path, Clip};
use motion_theater_core::skeleton_search::candidates;
use motion_theater_core::Skeleton;

/// So many skeletons are kept in memory (a few ten thousand bytes each); then reading begins anew.
const MOST_KEPT: usize = 1000;

/// The skeleton of a motion, or none, and why.
pub(super) struct Paired {
    pub(super) skeleton: Option<(PathBuf, Arc<Skeleton>)>,
    pub(super) reason: String,
}

/// The skeleton files of the folders that are scanned.
#[derive(Default)]
pub(super) struct Skeletons {
    by_folder: HashMap<PathBuf, Vec<PathBuf>>,
    kept: Mutex<HashMap<PathBuf, Option<Arc<Skeleton>>>>,
}

impl Skeletons {
    /// Notes a skeleton file.
    pub(super) fn add(&mut self, path: &Path) {
        let folder = path.parent().unwrap_or(Path::new("")).to_owned();
        self.by_folder.entry(folder).or_default().push(path.to_owned());
    }

    /// Finds the skeleton of a motion.
    pub(super) fn pair(&self, path: &Path, clip: &Clip) -> Paired {
        let hint = clip.amc.as_ref().and_then(|amc| amc.header.skeleton_hint.as_deref());
        let folder = path.parent().unwrap_or(Path::new(""));
        let in_folder = |folder: &Path| self.by_folder.get(folder).map_or(&[][..], Vec::as_slice);
        let above = folder.parent().map_or(&[][..], in_folder);
        let candidates = candidates(path, hint, in_folder(folder), above);
        let is_any = !candidates.is_empty();
        for candidate in candidates {
            let skeleton = self.read(&candidate.path).filter(|skeleton| clip.bind(skeleton).is_ok());
            if let Some(skeleton) = skeleton {
                return Paired { skeleton: Some((candidate.path, skeleton)), reason: candidate.reason };
            }
        }
        let reason = if is_any { "no skeleton beside the file fits" } else { "no skeleton (.asf) is beside the file" };
        Paired { skeleton: None, reason: reason.to_owned() }
    }

    /// Returns the skeleton of a file; `None` where it cannot be read.
    fn read(&self, path: &Path) -> Option<Arc<Skeleton>> {
        let kept = || self.kept.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(known) = kept().get(path) {
            return known.clone();
        }
        let skeleton = read_path(path, None).ok().and_then(|clip| clip.skeleton).map(Arc::new);
        let mut kept = kept();
        if kept.len() >= MOST_KEPT {
            kept.clear();
        }
        kept.insert(path.to_owned(), skeleton.clone());
        skeleton
    }
}
