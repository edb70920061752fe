//! How much speaks for each skeleton file, by names and places alone.

use std::collections::HashSet;
use std::ffi::OsStr;
use std::path::{Path, PathBuf};

use super::{Around, Candidate, Hints, Reason};

/// Where skeleton files lie, seen from a motion.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Place {
    /// Given by the user together with the motion.
    Together,
    /// In the motion's folder.
    Folder,
    /// In the folder above.
    Above,
    /// Anywhere.
    Elsewhere,
}

impl Place {
    /// What speaks for the only file of a place.
    fn of_the_only_one(self) -> Option<Reason> {
        match self {
            Self::Folder => Some(Reason::OnlyOne),
            Self::Above => Some(Reason::OnlyOneAbove),
            Self::Together | Self::Elsewhere => None,
        }
    }

    /// What speaks for any file of a place.
    fn of_any(self) -> Reason {
        match self {
            Self::Together => Reason::Chosen,
            Self::Folder => Reason::Folder,
            Self::Above => Reason::Above,
            Self::Elsewhere => Reason::Bones,
        }
    }
}

/// Returns the skeletons among the files of all places, best first, each once.
///
/// What a person chose or wrote goes before all else, then a name that tells something before none, and a near file before a
/// far one.
pub(super) fn ranked(motion: &Path, hints: Hints<'_>, around: Around<'_>) -> Vec<Candidate> {
    let names = Names {
        take: lower(motion.file_stem()),
        hint: hints.motion.map(|hint| file_name(hint).to_lowercase()).filter(|hint| !hint.is_empty()),
    };
    let places = [
        (Place::Together, sorted(around.chosen)),
        (Place::Folder, sorted(around.folder)),
        (Place::Above, sorted(around.above)),
        (Place::Elsewhere, sorted(around.others)),
    ];
    let mut chosen: Vec<Candidate> = Vec::new();
    let mut telling: Vec<Candidate> = Vec::new();
    let mut silent: Vec<Candidate> = Vec::new();
    for (place, skeletons) in &places {
        let only_one = place.of_the_only_one().filter(|_| skeletons.len() == 1);
        let mut told: Vec<(Reason, &PathBuf)> =
            skeletons.iter().filter_map(|path| Some((names.reason(path).or(only_one.clone())?, *path))).collect();
        told.sort_by(|a, b| a.0.cmp(&b.0));
        let told = told.into_iter().map(|(reason, path)| Candidate { path: path.clone(), reason });
        let rest = skeletons.iter().map(|path| Candidate { path: (*path).clone(), reason: place.of_any() });
        match place {
            Place::Together => chosen.extend(told.chain(rest).map(|it| Candidate { reason: Reason::Chosen, ..it })),
            Place::Folder | Place::Above => {
                telling.extend(told);
                silent.extend(rest);
            }
            Place::Elsewhere => silent.extend(told.chain(rest)),
        }
    }
    let named = hints.sidecar.map(|named| named_in(named, places.iter().flat_map(|(_, paths)| paths.iter().copied())));
    let named = named.unwrap_or_default().into_iter().map(|path| Candidate { path, reason: Reason::Sidecar });
    let mut seen = HashSet::new();
    let all = chosen.into_iter().chain(named).chain(telling).chain(silent);
    all.filter(|candidate| seen.insert(candidate.path.clone())).collect()
}

/// Returns the skeletons in a fixed order: of two with the same evidence the shorter name is the closer one, `02` before
/// `02-old`.
fn sorted(files: &[PathBuf]) -> Vec<&PathBuf> {
    let mut skeletons: Vec<&PathBuf> = files.iter().filter(|path| is_skeleton(path)).collect();
    skeletons.sort_by_key(|path| (path.file_stem().map_or(0, OsStr::len), *path));
    skeletons
}

/// Returns the files that a path or name means; those first whose folders are named too.
fn named_in<'a>(named: &str, files: impl Iterator<Item = &'a PathBuf>) -> Vec<PathBuf> {
    let name = file_name(named).to_lowercase();
    let slashed = named.replace('\\', "/");
    let below = slashed.trim_start_matches("../").trim_start_matches("./");
    let mut found: Vec<&PathBuf> = files.filter(|path| lower(path.file_name()) == name).collect();
    found.sort_by_key(|path| !path.ends_with(below));
    found.into_iter().cloned().collect()
}

/// Whether the name of a file says that it is a skeleton.
pub(super) fn is_skeleton(path: &Path) -> bool {
    path.extension().is_some_and(|extension| extension.eq_ignore_ascii_case("asf"))
}

/// What is looked for in the names of skeletons, in lower case.
struct Names {
    /// The motion's name without extension.
    take: String,
    /// The file that the motion names.
    hint: Option<String>,
}

impl Names {
    /// Returns the best that the name of a skeleton tells.
    fn reason(&self, skeleton: &Path) -> Option<Reason> {
        let (name, stem) = (lower(skeleton.file_name()), lower(skeleton.file_stem()));
        let number = subject(&self.take);
        if self.hint.as_ref() == Some(&name) {
            Some(Reason::Motion)
        } else if stem == self.take {
            Some(Reason::Name)
        } else {
            (!number.is_empty() && subject(&stem) == number).then(|| Reason::Subject(number.to_owned()))
        }
    }
}

/// Returns the subject that the name of a take begins with: `02` of `02_03`, `09` of `09_06-run`.
fn subject(stem: &str) -> &str {
    stem.split(['_', '-', '.', ' ']).next().unwrap_or_default()
}

/// Returns the last part of a path as any system writes it.
fn file_name(path: &str) -> &str {
    path.rsplit(['/', '\\']).next().unwrap_or_default()
}

fn lower(part: Option<&OsStr>) -> String {
    part.map(|part| part.to_string_lossy().to_lowercase()).unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Ranks files by name in the places together, folder, above and elsewhere.
    fn candidates(motion: &str, hint: Option<&str>, places: [&[&str]; 4]) -> Vec<(String, String)> {
        with_sidecar(motion, None, hint, places)
    }

    fn with_sidecar(
        motion: &str,
        sidecar: Option<&str>,
        hint: Option<&str>,
        places: [&[&str]; 4],
    ) -> Vec<(String, String)> {
        let paths = |names: &[&str]| names.iter().map(PathBuf::from).collect::<Vec<_>>();
        let [chosen, folder, above, others] = &places.map(paths);
        let found =
            ranked(Path::new(motion), Hints { sidecar, motion: hint }, Around { chosen, folder, above, others });
        found.into_iter().map(|found| (found.path.display().to_string(), found.reason.to_string())).collect()
    }

    fn paths(ranked: &[(String, String)]) -> Vec<&str> {
        ranked.iter().map(|(path, _)| path.as_str()).collect()
    }

    #[test]
    fn a_hint_goes_before_the_name_and_the_name_before_the_subject() {
        let folder = ["d/02.asf", "d/02_03.ASF", "d/02-old.asf", "d/given.asf", "d/02_03.amc"];
        let found = candidates("d/02_03.amc", Some("C:\\takes\\Given.asf"), [&[], &folder, &[], &[]]);
        assert_eq!(paths(&found), ["d/given.asf", "d/02_03.ASF", "d/02.asf", "d/02-old.asf"]);
        assert_eq!(found[0].1, "named in the motion file");
        assert_eq!(found[1].1, "it has the same name");
        assert_eq!(found[2].1, "it is of the same subject, 02");
    }

    #[test]
    fn what_the_sidecar_names_goes_before_all_that_names_tell_wherever_it_lies() {
        let places: [&[&str]; 4] = [&[], &["d/a.asf", "d/02_03.asf"], &["old/b.asf"], &["x/Mine.asf", "y/mine.asf"]];
        let found = with_sidecar("d/02_03.amc", Some("..\\y\\mine.asf"), Some("a.asf"), places);
        assert_eq!(paths(&found), ["y/mine.asf", "x/Mine.asf", "d/a.asf", "d/02_03.asf", "old/b.asf"]);
        assert_eq!(found[0].1, "named in the sidecar");
        assert_eq!(found[2].1, "named in the motion file");
        assert_eq!(
            with_sidecar("d/02_03.amc", Some(""), Some("a.asf"), places),
            candidates("d/02_03.amc", Some("a.asf"), places)
        );
    }

    #[test]
    fn the_only_skeleton_is_taken_and_the_folder_comes_before_the_one_above() {
        let found = candidates("p/d/walk.amc", None, [&[], &["p/d/human.asf"], &["p/other.asf"], &[]]);
        assert_eq!(paths(&found), ["p/d/human.asf", "p/other.asf"]);
        assert_eq!(found[0].1, "it is the only skeleton in the folder");
        assert_eq!(found[1].1, "it is the only skeleton of the folder above");
    }

    #[test]
    fn what_only_lies_near_comes_after_every_name_that_tells_something() {
        let found = candidates("p/d/07_walk.amc", None, [&[], &["p/d/a.asf", "p/d/b.asf"], &["p/07.asf"], &[]]);
        assert_eq!(paths(&found), ["p/07.asf", "p/d/a.asf", "p/d/b.asf"]);
        assert_eq!(found[1].1, "its bones fit and it lies in the same folder");
    }

    #[test]
    fn other_known_skeletons_come_last_those_of_the_same_subject_first() {
        let others = ["x/08.asf", "y/07.asf", "p/d/a.asf"];
        let found = candidates("p/d/07_walk.amc", None, [&[], &["p/d/a.asf"], &[], &others]);
        assert_eq!(paths(&found), ["p/d/a.asf", "y/07.asf", "x/08.asf"]);
        assert_eq!(found[1].1, "it is of the same subject, 07");
        assert_eq!(found[2].1, "its bones fit");
    }

    #[test]
    fn what_came_with_the_motion_goes_before_everything_the_likeliest_first() {
        let found = candidates("d/07_walk.amc", None, [&["x/08.asf", "x/07.asf"], &["d/07_walk.asf"], &[], &[]]);
        assert_eq!(paths(&found), ["x/07.asf", "x/08.asf", "d/07_walk.asf"]);
        assert_eq!((found[0].1.as_str(), found[1].1.as_str()), ("it came with the motion", "it came with the motion"));
    }

    #[test]
    fn the_subject_begins_the_name() {
        for (stem, number) in [("02_03", "02"), ("09-run", "09"), ("walk", "walk"), ("a.b", "a"), ("_x", "")] {
            assert_eq!(subject(stem), number);
        }
        let found = candidates("d/_x.amc", None, [&[], &["d/_y.asf", "d/z.asf"], &[], &[]]);
        assert!(found.iter().all(|(_, reason)| reason.starts_with("its bones fit")), "no subject is none");
    }
}
