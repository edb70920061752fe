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

use rank::Place;

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

/// Returns the skeleton files for a motion, best first: those that came with it, those of its folder and of the folder
/// above, all others. `hint` is what the motion file itself says. None of them has been opened: the caller takes the first
/// that fits.
pub fn skeletons_for(motion: &Path, hint: Option<&str>, known: Known<'_>) -> Vec<Candidate> {
    let folder = motion.parent().unwrap_or(Path::new(""));
    skeletons_among(motion, hint, known, skeletons_in(folder), skeletons_in(&above(folder)))
}

/// Returns the same where the skeleton files of the motion's folder and of the folder above are known already.
pub fn skeletons_among(
    motion: &Path,
    hint: Option<&str>,
    known: Known<'_>,
    folder: Vec<PathBuf>,
    above: Vec<PathBuf>,
) -> Vec<Candidate> {
    let places = [
        (Place::Together, known.chosen.to_vec()),
        (Place::Folder, folder),
        (Place::Above, above),
        (Place::Elsewhere, known.others.to_vec()),
    ];
    rank::ranked(motion, hint, &places)
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
