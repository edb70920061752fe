//! What a file is, by its content: to choose a reader, and to say what was found where a reader cannot help.

use crate::error::ParseError;
use crate::text::{error_at, Lines};
use std::fmt;

/// A kind of file that is recognised by how it begins.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Kind {
    /// A kind that has a reader.
    Asf,
    /// A kind that has a reader.
    Amc,
    /// A kind that has a reader.
    Bvh,
    /// A kind that has a reader.
    C3d,
    /// A kind that has a reader.
    Csm,
    /// A kind that has a reader.
    Trc,
    /// Anything else that people take for motion capture, in words.
    Foreign(&'static str),
}

impl fmt::Display for Kind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Asf => "an Acclaim skeleton (.asf)",
            Self::Amc => "an Acclaim motion (.amc)",
            Self::Bvh => "a BVH motion (.bvh)",
            Self::C3d => "a C3D marker file (.c3d)",
            Self::Csm => "a CSM marker file (.csm)",
            Self::Trc => "a TRC marker file (.trc)",
            Self::Foreign(words) => words,
        })
    }
}

/// How files begin, but for ASF and AMC; letters match in either case.
const BEGINNINGS: &[(&[u8], Kind)] = &[
    (b"\xFF\xFE", Kind::Foreign("UTF-16 text; save it as UTF-8")),
    (b"\xFE\xFF", Kind::Foreign("UTF-16 text; save it as UTF-8")),
    (b"HIERARCHY", Kind::Bvh),
    (b"$", Kind::Csm),
    (b"PathFileType", Kind::Trc),
    (b"Kaydara FBX Binary", Kind::Foreign("an FBX file (.fbx)")),
    (b"; FBX", Kind::Foreign("an FBX file (.fbx)")),
    (b"BLENDER", Kind::Foreign("a Blender file (.blend)")),
    (b"<!DOCTYPE html", Kind::Foreign("a web page (HTML)")),
    (b"<html", Kind::Foreign("a web page (HTML)")),
    (b"<", Kind::Foreign("an XML file")),
    (b"{", Kind::Foreign("a JSON file")),
    (b"version https://git-lfs", Kind::Foreign("a Git LFS pointer instead of the file itself")),
    (b"PK\x03\x04", Kind::Foreign("a ZIP archive")),
    (b"\x1F\x8B", Kind::Foreign("a gzip archive")),
    (b"%PDF", Kind::Foreign("a PDF document")),
];

/// Words that begin a line of a skeleton and never one of a motion.
const ASF_SECTIONS: &[&str] = &[":version", ":name", ":units", ":documentation", ":root", ":bonedata", ":hierarchy"];

/// Words that begin a line of a motion's head.
const AMC_WORDS: &[&str] =
    &[":fully-specified", ":degrees", ":radians", ":samples-per-second", ":force-all-joints-be-3dof"];

/// How far into a file a kind is looked for.
const HEAD_BYTES: usize = 4096;

/// Returns what the bytes are; `None` for text that could be anything.
pub(crate) fn recognise(source: &[u8]) -> Option<Kind> {
    let head = source.get(..HEAD_BYTES).unwrap_or(source);
    let text = head.get(Lines::new(head).at()..).unwrap_or_default().trim_ascii_start();
    let is_like = |beginning: &[u8]| text.get(..beginning.len()).is_some_and(|t| t.eq_ignore_ascii_case(beginning));
    if let Some((_, kind)) = BEGINNINGS.iter().find(|(beginning, _)| is_like(beginning)) {
        return Some(*kind);
    }
    if memchr::memchr(0, source).is_some() {
        if matches!(head, [block, 0x50, ..] if *block < b' ') {
            return Some(Kind::C3d);
        }
        return Some(Kind::Foreign(if looks_like_utf16(head) {
            "UTF-16 text; save it as UTF-8"
        } else {
            "binary data"
        }));
    }
    recognise_acclaim(head)
}

/// Refuses what is recognised as something else than the reader of `wanted` can read.
pub(crate) fn check(source: &[u8], wanted: Kind) -> Result<(), ParseError> {
    match recognise(source) {
        _ if source.is_empty() => Err(error_at(source, 0, wanted, "an empty file")),
        Some(kind) if kind != wanted => Err(error_at(source, 0, wanted, kind)),
        _ => Ok(()),
    }
}

/// The first keyword decides; a motion without keywords begins with a frame number and a bone with its values.
fn recognise_acclaim(head: &[u8]) -> Option<Kind> {
    let mut lines = Lines::new(head);
    let mut after_number = false;
    while let Some(mut words) = lines.next_words() {
        let first = words.next()?;
        if ASF_SECTIONS.iter().any(|section| first.is(section)) {
            return Some(Kind::Asf);
        }
        if AMC_WORDS.iter().any(|keyword| first.is(keyword)) {
            return Some(Kind::Amc);
        }
        let second = words.next();
        if after_number && second.is_some_and(|word| word.number("").is_ok()) {
            return Some(Kind::Amc);
        }
        after_number = second.is_none() && first.number("").is_ok();
    }
    None
}

/// Latin text in UTF-16 has a zero in every other byte.
fn looks_like_utf16(head: &[u8]) -> bool {
    let zeros = |offset: usize| head.iter().skip(offset).step_by(2).filter(|byte| **byte == 0).count();
    let (even, odd) = (zeros(0), zeros(1));
    let pairs = head.len() / 2;
    even.min(odd) == 0 && even.max(odd) > pairs / 2
}
