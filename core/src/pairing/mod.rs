//! Which skeleton file belongs to a motion file, where the user did not say.
//!
//! An AMC rarely names its ASF, and where it does the name is often out of date. So candidates are put in order by how
//! much speaks for them, each with its reason in words; the caller takes the first whose bones fit, or else the
//! [`default_skeleton`] where that fits.

mod default_skeleton;
mod rank;
mod reason;

use std::path::{Path, PathBuf};

pub use default_skeleton::{default_skeleton, DEFAULT_SKELETON_ASF, DEFAULT_SKELETON_NOTICE};
pub use reason::Reason;

use crate::sidecar::{self, Field};

/// A skeleton file that may belong to a motion, and why.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Candidate {
    /// The skeleton file.
    pub path: PathBuf,
    /// What speaks for it.
    pub reason: Reason,
}

/// Skeleton files that are known already, wherever they lie.
#[derive(Debug, Clone, Copy, Default)]
pub struct Known<'a> {
    /// Those that the user gave together with the motion: they go before all others.
    pub chosen: &'a [PathBuf],
    /// All others, such as those of a library: they come last.
    pub others: &'a [PathBuf],
}

/// What is said of a motion's skeleton.
#[derive(Debug, Clone, Copy, Default)]
pub struct Hints<'a> {
    /// What the sidecar names: a person's word, a path or a name.
    pub sidecar: Option<&'a str>,
    /// What the motion file names: only the file name counts, for the path is that of another computer, and files get
    /// renamed.
    pub motion: Option<&'a str>,
}

/// The skeleton files around a motion; other files among them do not matter.
#[derive(Debug, Clone, Copy, Default)]
pub struct Around<'a> {
    /// Those that the user gave together with the motion.
    pub chosen: &'a [PathBuf],
    /// Those of the motion's folder.
    pub folder: &'a [PathBuf],
    /// Those of the folder above.
    pub above: &'a [PathBuf],
    /// All others that are known.
    pub others: &'a [PathBuf],
}

/// Returns the skeleton files for a motion, best first, each once: those that came with it, the one that its sidecar names,
/// those of its folder and of the folder above, all others. None of them is opened: the caller takes the first that fits.
pub fn candidates(motion: &Path, hints: Hints<'_>, around: Around<'_>) -> Vec<Candidate> {
    rank::ranked(motion, hints, around)
}

/// Returns the same from what lies beside the motion on disk, its sidecar among it. `hint` is what the motion file itself
/// says.
pub fn skeletons_for(motion: &Path, hint: Option<&str>, known: Known<'_>) -> Vec<Candidate> {
    let folder = motion.parent().unwrap_or(Path::new(""));
    let sidecar = sidecar::read_beside(motion);
    let named = sidecar.as_ref().and_then(|sidecar| sidecar.get(Field::AsfFile)).filter(|name| !name.is_empty());
    let at_its_place = named.map(|name| folder.join(name.replace('\\', "/"))).filter(|path| path.is_file());
    let others: Vec<PathBuf> = at_its_place.into_iter().chain(known.others.iter().cloned()).collect();
    let around = Around {
        chosen: known.chosen,
        folder: &skeletons_in(folder),
        above: &skeletons_in(&above(folder)),
        others: &others,
    };
    candidates(motion, Hints { sidecar: named, motion: hint }, around)
}

/// Returns the folder that a folder lies in, also where its own name does not tell.
fn above(folder: &Path) -> PathBuf {
    match folder.parent() {
        Some(parent) if !parent.as_os_str().is_empty() && !folder.ends_with("..") => parent.to_owned(),
        _ if folder.as_os_str().is_empty() => PathBuf::from(".."),
        _ => folder.join(".."),
    }
}

/// Returns the skeleton files of a folder itself; none where it cannot be listed.
fn skeletons_in(folder: &Path) -> Vec<PathBuf> {
    let folder = if folder.as_os_str().is_empty() { Path::new(".") } else { folder };
    let entries = folder.read_dir().into_iter().flatten().filter_map(Result::ok);
    entries.map(|entry| entry.path()).filter(|path| rank::is_skeleton(path) && path.is_file()).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_folder_above_is_found_from_any_way_to_write_a_path() {
        let table = [("", ".."), ("a", "a/.."), ("a/b", "a"), ("..", "../.."), ("a/..", "a/../.."), ("/a", "/")];
        for (folder, wanted) in table {
            assert_eq!(above(Path::new(folder)), Path::new(wanted), "{folder}");
        }
    }
}
