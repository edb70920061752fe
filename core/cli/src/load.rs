//! Files with what belongs to them, and what goes wrong in the words of this program.

use std::path::Path;

use motion_theater_core::loaded::{LoadError, Loaded, Pairing, SkeletonFile};
use motion_theater_core::{Motion, Skeleton};

use crate::Refusal;

/// Reads a file with the skeleton that was named for it, or finds one; the error is one line that begins with its path.
pub fn load(path: &Path, named: Option<&SkeletonFile>) -> Result<Loaded, String> {
    Loaded::read(path, named).map_err(|error| error.to_string())
}

/// Reads the skeleton of a file.
pub fn load_skeleton(path: &Path) -> Result<SkeletonFile, String> {
    SkeletonFile::read(path).map_err(|error| error.to_string())
}

/// Reads the skeleton that a whole command was given.
pub fn named_skeleton(path: Option<&Path>) -> Result<Option<SkeletonFile>, Refusal> {
    path.map(load_skeleton).transpose().map_err(Refusal::Failed)
}

/// Returns the skeleton with its motion.
pub fn moving(loaded: &Loaded) -> Result<(&Skeleton, &Motion), String> {
    loaded.moving().map_err(said)
}

/// Returns the skeleton.
pub fn skeleton(loaded: &Loaded) -> Result<&Skeleton, String> {
    loaded.skeleton().map_err(said)
}

/// Returns what must be told of the skeleton wherever sizes matter.
pub fn warning(loaded: &Loaded) -> Option<&'static str> {
    loaded.pairing.as_ref().and_then(Pairing::warning)
}

/// Says also what helps.
fn said(error: LoadError) -> String {
    match error {
        LoadError::NeedsSkeleton { path, why } => {
            format!("{}: needs its skeleton, to be named with --skeleton. {why}", path.display())
        }
        other => other.to_string(),
    }
}
