//! Paths as text: what a database can hold, and back, whatever bytes a path is made of.
//!
//! Unix paths are bytes. One that is UTF-8 is kept as it is. Of another, every byte that is not UTF-8 becomes a character
//! of its own from a private range (0x80 is U+F780, 0xFF is U+F7FF), and so do the bytes of such a character where a
//! path really holds one: every path has exactly one text, and every text leads back to its path.

use std::path::{Component, Path, PathBuf, MAIN_SEPARATOR};

/// A byte plus this is its private character.
#[cfg(unix)]
const PRIVATE: u32 = 0xF700;

/// Returns a path as the database keeps it.
#[cfg(unix)]
pub(crate) fn to_text(path: &Path) -> String {
    use std::os::unix::ffi::OsStrExt;
    let private = |byte: &u8| char::from_u32(PRIVATE + u32::from(*byte)).unwrap_or(char::REPLACEMENT_CHARACTER);
    let mut text = String::with_capacity(path.as_os_str().len());
    for chunk in path.as_os_str().as_bytes().utf8_chunks() {
        for character in chunk.valid().chars() {
            if byte_of(character).is_some() {
                text.extend(character.encode_utf8(&mut [0; 4]).as_bytes().iter().map(private));
            } else {
                text.push(character);
            }
        }
        text.extend(chunk.invalid().iter().map(private));
    }
    text
}

/// Returns the path that the database keeps as `text`.
#[cfg(unix)]
pub(crate) fn to_path(text: &str) -> PathBuf {
    use std::os::unix::ffi::OsStringExt;
    let mut bytes = Vec::with_capacity(text.len());
    for character in text.chars() {
        match byte_of(character) {
            Some(byte) => bytes.push(byte),
            None => bytes.extend_from_slice(character.encode_utf8(&mut [0; 4]).as_bytes()),
        }
    }
    PathBuf::from(std::ffi::OsString::from_vec(bytes))
}

/// Returns the byte that a private character stands for.
#[cfg(unix)]
fn byte_of(character: char) -> Option<u8> {
    let byte = u8::try_from(u32::from(character).checked_sub(PRIVATE)?).ok()?;
    (byte >= 0x80).then_some(byte)
}

/// Returns a path as the database keeps it; half characters (lone surrogates) are lost.
#[cfg(not(unix))]
pub(crate) fn to_text(path: &Path) -> String {
    path.to_string_lossy().into_owned()
}

/// Returns the path that the database keeps as `text`.
#[cfg(not(unix))]
pub(crate) fn to_path(text: &str) -> PathBuf {
    PathBuf::from(text)
}

/// Returns where a file lies as people think of it: the name of the folder that they pointed at, and the folders below it
/// down to the file's own, with `/` between them.
pub(crate) fn place(path: &Path, root: &Path) -> String {
    let below = path.parent().and_then(|folder| folder.strip_prefix(root).ok()).unwrap_or(Path::new(""));
    let names = root.file_name().into_iter().chain(below.iter());
    names.map(|name| name.to_string_lossy()).collect::<Vec<_>>().join("/")
}

/// Returns a folder as it is kept: absolute, and without a way up in it.
pub(crate) fn plain(folder: &Path) -> std::io::Result<PathBuf> {
    let absolute = std::path::absolute(folder)?;
    let goes_up = absolute.components().any(|part| part == Component::ParentDir);
    let plain = if goes_up { absolute.canonicalize()? } else { absolute };
    // Without a separator at its end.
    Ok(plain.components().collect())
}

/// Returns the bounds of the paths below a folder, as text: from the first on, and before the second.
pub(crate) fn below(folder: &str) -> (String, String) {
    let after = char::from_u32(u32::from(MAIN_SEPARATOR) + 1).unwrap_or(MAIN_SEPARATOR);
    let folder = folder.trim_end_matches(MAIN_SEPARATOR);
    (format!("{folder}{MAIN_SEPARATOR}"), format!("{folder}{after}"))
}

#[cfg(all(test, unix))]
mod tests {
    use super::*;
    use proptest::prelude::*;
    use std::ffi::OsString;
    use std::os::unix::ffi::OsStringExt;

    proptest! {
        #[test]
        fn every_path_has_a_text_of_its_own(bytes in prop::collection::vec(any::<u8>(), 0..40), tail in "[\u{F77F}-\u{F801}]{0,3}") {
            let path = PathBuf::from(OsString::from_vec([bytes, tail.into_bytes()].concat()));
            prop_assert_eq!(to_path(&to_text(&path)), path);
        }

        #[test]
        fn a_path_of_usual_text_is_kept_as_it_is(text in "[a-zA-Z0-9/äöü日本 ._-]{0,40}") {
            prop_assert_eq!(to_text(Path::new(&text)), text);
        }
    }

    #[test]
    fn a_file_lies_in_the_folder_that_was_pointed_at_and_those_below() {
        let table = [("/data/cmu/02/02_01.amc", "cmu/02"), ("/data/cmu/a.bvh", "cmu"), ("/other/a.bvh", "cmu")];
        for (path, expected) in table {
            assert_eq!(place(Path::new(path), Path::new("/data/cmu")), expected);
        }
        assert_eq!(place(Path::new("/data/a.bvh"), Path::new("/")), "data");
    }

    #[test]
    fn paths_below_a_folder_are_within_its_bounds() {
        let (from, to) = below("/data/a");
        let is_below = |path: &str| (from.as_str()..to.as_str()).contains(&path);
        assert!(is_below("/data/a/b") && is_below("/data/a/\u{10FFFF}"));
        assert!(!is_below("/data/a") && !is_below("/data/a.bvh") && !is_below("/data/a0") && !is_below("/data/b"));
        assert_eq!(below("/"), ("/".to_owned(), "0".to_owned()));
    }
}
