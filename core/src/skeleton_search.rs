//! Which skeleton file belongs to a motion file, where the user did not say.
//!
//! An AMC rarely names its ASF, and where it does the name is often out of date. So candidates are put in order by how
//! much speaks for them, each with its reason in words; the caller takes the first that fits.

use std::path::{Path, PathBuf};

/// A skeleton file that may belong to a motion, and why.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Candidate {
    /// The skeleton file.
    pub path: PathBuf,
    /// The reason: "it has the same name".
    pub reason: String,
}

/// Returns the skeleton files for a motion among the files of its folder and of the folder above, best first.
/// `hint` is what the motion file itself says.
pub fn candidates(motion: &Path, hint: Option<&str>, folder: &[PathBuf], parent: &[PathBuf]) -> Vec<Candidate> {
    let mut found: Vec<Candidate> = Vec::new();
    for (files, place) in [(folder, "in the folder"), (parent, "of the folder above")] {
        for candidate in in_folder(motion, hint, files, place) {
            if !found.iter().any(|known| known.path == candidate.path) {
                found.push(candidate);
            }
        }
    }
    found
}

/// Returns the subject that the name of a take begins with: `02` of `02_03`, `09` of `09_06-run`.
fn subject(stem: &str) -> &str {
    stem.split(['_', '-', '.', ' ']).next().unwrap_or_default()
}

fn in_folder(motion: &Path, hint: Option<&str>, files: &[PathBuf], place: &str) -> Vec<Candidate> {
    let mut skeletons: Vec<&PathBuf> = files.iter().filter(|path| lower(path.extension()) == "asf").collect();
    skeletons.sort();
    let take = lower(motion.file_stem());
    let hint = hint.and_then(|hint| hint.rsplit(['/', '\\']).next()).map(str::to_lowercase);
    let number = subject(&take).to_owned();

    let of_name = |name: fn(&Path) -> Option<&std::ffi::OsStr>, wanted: &str| {
        skeletons.iter().filter(|path| lower(name(path)) == wanted).copied().collect::<Vec<_>>()
    };
    let hinted = hint.map_or_else(Vec::new, |hint| of_name(Path::file_name, &hint));
    let namesakes = of_name(Path::file_stem, &take);
    let mut related = skeletons.clone();
    related.retain(|path| subject(&lower(path.file_stem())) == number);
    related.sort_by_key(|path| path.file_stem().map_or(0, std::ffi::OsStr::len));
    let only = if skeletons.len() == 1 { skeletons } else { Vec::new() };
    let reasons = [
        (hinted, "named in the motion file".to_owned()),
        (namesakes, "it has the same name".to_owned()),
        (related, format!("it is of the same subject, {number}")),
        (only, format!("it is the only skeleton {place}")),
    ];
    let candidate = |path: &PathBuf, reason: &str| Candidate { path: path.clone(), reason: reason.to_owned() };
    let found = reasons.iter().flat_map(|(paths, reason)| paths.iter().map(move |path| candidate(path, reason)));
    found.collect()
}

fn lower(part: Option<&std::ffi::OsStr>) -> String {
    part.map(|part| part.to_string_lossy().to_lowercase()).unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn ranked(motion: &str, hint: Option<&str>, folder: &[&str], parent: &[&str]) -> Vec<(String, String)> {
        let paths = |names: &[&str]| names.iter().map(PathBuf::from).collect::<Vec<_>>();
        let found = candidates(Path::new(motion), hint, &paths(folder), &paths(parent));
        found.into_iter().map(|found| (found.path.display().to_string(), found.reason)).collect()
    }

    fn paths(ranked: &[(String, String)]) -> Vec<&str> {
        ranked.iter().map(|(path, _)| path.as_str()).collect()
    }

    #[test]
    fn a_hint_goes_before_the_name_and_the_name_before_the_subject() {
        let folder = ["d/02.asf", "d/02_03.ASF", "d/02-old.asf", "d/given.asf", "d/02_03.amc"];
        let found = ranked("d/02_03.amc", Some("C:\\takes\\Given.asf"), &folder, &[]);
        assert_eq!(paths(&found), ["d/given.asf", "d/02_03.ASF", "d/02.asf", "d/02-old.asf"]);
        assert_eq!(found[0].1, "named in the motion file");
        assert_eq!(found[1].1, "it has the same name");
        assert_eq!(found[2].1, "it is of the same subject, 02");
    }

    #[test]
    fn the_only_skeleton_is_taken_and_the_folder_comes_before_the_one_above() {
        let found = ranked("p/d/walk.amc", None, &["p/d/human.asf"], &["p/other.asf"]);
        assert_eq!(paths(&found), ["p/d/human.asf", "p/other.asf"]);
        assert_eq!(found[0].1, "it is the only skeleton in the folder");
        assert_eq!(found[1].1, "it is the only skeleton of the folder above");
    }

    #[test]
    fn several_skeletons_without_a_reason_are_none() {
        assert_eq!(ranked("walk.amc", None, &["a.asf", "b.asf"], &[]), []);
    }
}
