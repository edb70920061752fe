//! From a path or bytes to what the file holds.

mod clip;

pub use clip::Clip;

use crate::error::{MisfitError, ParseError, ReadError};
use crate::formats::amc::Amc;
use crate::formats::asf::Asf;
use crate::formats::bvh::Bvh;
use crate::formats::c3d::C3d;
use crate::formats::csm::Csm;
use crate::formats::kind::{recognise, Kind};
use crate::formats::trc::Trc;
use crate::skeleton::Skeleton;
use std::io::Read;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// How much of a file is looked at to tell what it is.
const HEAD_BYTES: u64 = 4096;

/// A kind of file that can be read.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Format {
    /// Acclaim skeleton.
    Asf,
    /// Acclaim motion.
    Amc,
    /// Biovision hierarchy, with or without motion.
    Bvh,
    /// Markers and analog signals in binary.
    C3d,
    /// Markers of Character Studio.
    Csm,
    /// Markers as a table of text.
    Trc,
}

/// Every format with its extension, in lower case.
const FORMATS: [(Format, &str); 6] = [
    (Format::Asf, "asf"),
    (Format::Amc, "amc"),
    (Format::Bvh, "bvh"),
    (Format::C3d, "c3d"),
    (Format::Csm, "csm"),
    (Format::Trc, "trc"),
];

impl Format {
    /// Returns the format's extension in lower case, without a dot.
    pub fn extension(self) -> &'static str {
        FORMATS.iter().find(|(format, _)| *format == self).map_or("", |(_, extension)| extension)
    }

    /// Returns the format of an extension, in either case and without a dot.
    pub fn from_extension(extension: &str) -> Option<Self> {
        FORMATS.iter().find(|(_, known)| extension.eq_ignore_ascii_case(known)).map(|(format, _)| *format)
    }

    /// Returns the extensions of all formats in words: "asf, amc, bvh".
    pub fn list() -> String {
        FORMATS.map(|(_, extension)| extension).join(", ")
    }

    /// Returns what a file is by how it begins, or else by its extension; `None` for what has no reader.
    ///
    /// # Errors
    /// Where the disk fails.
    pub fn of_path(path: &Path) -> std::io::Result<Option<Self>> {
        let mut head = Vec::new();
        std::fs::File::open(path)?.take(HEAD_BYTES).read_to_end(&mut head)?;
        Ok(Self::of(&head, path))
    }

    /// Returns what the bytes are by their content, or else by the extension of `name`.
    pub fn of(source: &[u8], name: &Path) -> Option<Self> {
        let by_extension = || Self::from_extension(name.extension()?.to_str()?);
        match recognise(source) {
            Some(Kind::Asf) => Some(Self::Asf),
            Some(Kind::Amc) => Some(Self::Amc),
            Some(Kind::Bvh) => Some(Self::Bvh),
            Some(Kind::C3d) => Some(Self::C3d),
            Some(Kind::Csm) => Some(Self::Csm),
            Some(Kind::Trc) => Some(Self::Trc),
            Some(Kind::Foreign(_)) | None => by_extension(),
        }
    }
}

/// Reads a file of any known format. `skeleton` is what a motion without a skeleton of its own (AMC) belongs to.
///
/// The file is copied into memory of our own: another program that rewrites or cuts it meanwhile can at worst give a
/// damaged text, which is met with words, where a mapped file would end the process.
///
/// # Errors
/// Where the disk fails, the file is wrong, or the motion and `skeleton` do not belong together.
pub fn read_path(path: &Path, skeleton: Option<&Skeleton>) -> Result<Clip, ReadError> {
    let source = std::fs::read(path).map_err(|source| ReadError::Io { path: path.to_owned(), source })?;
    if Format::of(&source, path) == Some(Format::C3d) {
        // A C3D keeps its bytes: these need no copy.
        return c3d_clip(source, path);
    }
    read_bytes(&source, path, skeleton)
}

/// Reads a file that is in memory already. `name` stands for its path in messages and gives its extension.
///
/// # Errors
/// Where the file is wrong, or the motion and `skeleton` do not belong together.
pub fn read_bytes(source: &[u8], name: &Path, skeleton: Option<&Skeleton>) -> Result<Clip, ReadError> {
    let wrong = |error| ReadError::Parse { path: PathBuf::from(name), error };
    match Format::of(source, name) {
        Some(Format::Asf) => Ok(Clip::of_asf(Asf::parse(source).map_err(wrong)?)),
        Some(Format::Amc) => {
            let amc = Amc::parse(source).map_err(wrong)?;
            amc_clip(amc, skeleton).map_err(|error| ReadError::Misfit { path: PathBuf::from(name), error })
        }
        Some(Format::Bvh) => Ok(Clip::of_bvh(Bvh::parse(source).map_err(wrong)?)),
        Some(Format::C3d) => c3d_clip(source.to_vec(), name),
        Some(Format::Csm) => {
            let csm = Csm::parse(source).map_err(wrong)?;
            let markers = csm.markers();
            Ok(Clip::of_csm(csm, markers))
        }
        Some(Format::Trc) => {
            let trc = Trc::parse(source).map_err(wrong)?;
            let markers = trc.markers();
            Ok(Clip::of_trc(trc, markers))
        }
        None => Err(wrong(unknown(source))),
    }
}

/// Reads a file that is in memory already, as [`read_bytes`] does; but a C3D, which keeps its bytes, takes a share in these
/// and no copy.
///
/// # Errors
/// Where the file is wrong.
pub fn read_shared(source: &Arc<Vec<u8>>, name: &Path) -> Result<Clip, ReadError> {
    if Format::of(source, name) == Some(Format::C3d) {
        return c3d_clip(Arc::clone(source), name);
    }
    read_bytes(source, name, None)
}

fn c3d_clip(source: impl Into<Arc<Vec<u8>>>, name: &Path) -> Result<Clip, ReadError> {
    let c3d = C3d::parse(source).map_err(|error| ReadError::Parse { path: PathBuf::from(name), error })?;
    Ok(Clip::of_c3d(c3d))
}

fn amc_clip(amc: Amc, skeleton: Option<&Skeleton>) -> Result<Clip, MisfitError> {
    let bound = skeleton.map(|skeleton| amc.motion(skeleton)).transpose()?;
    Ok(Clip::of_amc(amc, bound))
}

fn unknown(source: &[u8]) -> ParseError {
    let expected = "an Acclaim skeleton (.asf), a motion (.amc, .bvh) or markers (.c3d, .csm, .trc)";
    let found = match recognise(source) {
        _ if source.is_empty() => "an empty file".to_owned(),
        Some(kind) => kind.to_string(),
        None => "text of an unknown kind".to_owned(),
    };
    crate::text::error_at(source, 0, expected, found)
}
