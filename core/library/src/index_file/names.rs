//! Which clip a list means.

use std::collections::HashMap;

/// Returns a file's name without its extension, from a path of any system.
pub(super) fn stem(file: &str) -> &str {
    let name = file.rsplit(['/', '\\']).next().unwrap_or(file);
    name.rsplit_once('.').map_or(name, |(stem, _)| stem)
}

/// Returns the numbers of subject and trial in a name as CMU gives them: 2 and 1 of `02_01`, or of `02_01-walk`.
pub(super) fn numbers(stem: &str) -> Option<(u32, u32)> {
    let (subject, rest) = stem.split_once('_')?;
    let digits = rest.find(|c: char| !c.is_ascii_digit()).unwrap_or(rest.len());
    let (trial, tail) = rest.split_at(digits);
    let is_number = |text: &str| !text.is_empty() && text.bytes().all(|byte| byte.is_ascii_digit());
    let ends = !tail.starts_with(char::is_alphanumeric);
    (is_number(subject) && is_number(trial) && ends).then(|| Some((subject.parse().ok()?, trial.parse().ok()?)))?
}

/// Clips by their names, to find those that a row means.
pub(super) struct Names {
    /// By the stem in small letters: the whole path in small letters with `/`, and the clip's id.
    by_stem: HashMap<String, Vec<(String, i64)>>,
    by_numbers: HashMap<(u32, u32), Vec<i64>>,
}

impl Names {
    /// Takes paths of clips as the library keeps them.
    pub fn of(clips: impl Iterator<Item = (i64, String)>) -> Self {
        let mut names = Self { by_stem: HashMap::new(), by_numbers: HashMap::new() };
        for (id, path) in clips {
            let path = path.to_lowercase().replace('\\', "/");
            let stem = stem(&path);
            if let Some(numbers) = numbers(stem) {
                names.by_numbers.entry(numbers).or_default().push(id);
            }
            names.by_stem.entry(stem.to_owned()).or_default().push((path, id));
        }
        names
    }

    /// Returns the clips that a row means: by the name or the end of the path that it gives, with the extension if it gives
    /// one; where there is no such file, by the numbers of subject and trial.
    pub fn meant(&self, file: Option<&str>, numbers: Option<(u32, u32)>) -> Vec<i64> {
        let by_name = file.map_or_else(Vec::new, |file| {
            let file = file.to_lowercase().replace('\\', "/");
            let of = |stem: &str| self.by_stem.get(stem).map_or(&[][..], Vec::as_slice);
            let ends = |path: &str, end: &str| {
                path.strip_suffix(end).is_some_and(|before| before.is_empty() || before.ends_with('/'))
            };
            let tail = file.trim_start_matches(['.', '/']);
            let whole = of(stem(tail)).iter().filter(|(path, _)| ends(path, tail));
            // The name may have a point and no extension.
            let bare = of(tail.rsplit('/').next().unwrap_or(tail));
            let bare = bare.iter().filter(|(path, _)| path.rsplit_once('.').is_some_and(|(path, _)| ends(path, tail)));
            whole.chain(bare).map(|(_, id)| *id).collect()
        });
        match numbers {
            Some(numbers) if by_name.is_empty() => self.by_numbers.get(&numbers).cloned().unwrap_or_default(),
            _ => by_name,
        }
    }
}
