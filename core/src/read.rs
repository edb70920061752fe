//! From a path or bytes to what the file holds.

use crate::error::{MisfitError, ParseError, ReadError};
use crate::formats::amc::Amc;
use crate::formats::asf::Asf;
use crate::formats::bvh::Bvh;
use crate::formats::c3d::C3d;
use crate::formats::csm::Csm;
use crate::formats::kind::{recognise, Kind};
use crate::formats::trc::Trc;
use crate::infer::Inference;
use crate::markers::Markers;
use crate::motion::Motion;
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

/// What one file holds. What a format does not have is `None`.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Clip {
    /// What kind of file it is.
    pub format: Format,
    /// What the file says, where it is an Acclaim skeleton.
    pub asf: Option<Asf>,
    /// What the file says, where it is an Acclaim motion.
    pub amc: Option<Amc>,
    /// What the file says, where it is a BVH.
    pub bvh: Option<Bvh>,
    /// What the file says, where it is a C3D.
    pub c3d: Option<C3d>,
    /// What the file says, where it is a CSM.
    pub csm: Option<Csm>,
    /// What the file says, where it is a TRC.
    pub trc: Option<Trc>,
    /// The file's markers.
    pub markers: Option<Arc<Markers>>,
    /// The file's own skeleton.
    pub skeleton: Option<Skeleton>,
    /// The file's motion, on its own skeleton or the one that was given; an AMC has none without.
    pub motion: Option<Motion>,
    /// What is odd in the file, and what was inferred, a sentence each.
    pub notices: Vec<String>,
}

impl Clip {
    fn new(format: Format) -> Self {
        Self {
            format,
            asf: None,
            amc: None,
            bvh: None,
            c3d: None,
            csm: None,
            trc: None,
            markers: None,
            skeleton: None,
            motion: None,
            notices: Vec::new(),
        }
    }

    /// Takes markers and what the user should know of them, and says what was inferred, but for
    /// [`Clip::facing_notice`].
    pub(crate) fn of_markers(format: Format, (markers, mut notices): (Markers, Vec<String>)) -> Self {
        notices.push(format!("Length unit: {}", markers.unit.reason));
        notices.push(format!("Up axis: {}", markers.up.reason));
        Self { markers: Some(Arc::new(markers)), notices, ..Self::new(format) }
    }

    /// Takes a motion that has no skeleton.
    pub(crate) fn of_amc(amc: Amc) -> Self {
        let notices = amc.notices();
        Self { amc: Some(amc), notices, ..Self::new(Format::Amc) }
    }

    /// Takes a skeleton, and says what was inferred.
    fn of_asf(asf: Asf) -> Self {
        let (skeleton, inference) = asf.skeleton_and_inference();
        let mut notices = asf.notices();
        notices.extend(inferred(&inference));
        Self { asf: Some(asf), skeleton: Some(skeleton), notices, ..Self::new(Format::Asf) }
    }

    /// Takes a motion with its skeleton, and says what was inferred.
    pub(crate) fn of_bvh(bvh: Bvh) -> Self {
        let (skeleton, motion, inference) = bvh.skeleton_motion_and_inference();
        let mut notices = bvh.notices();
        notices.extend(inferred(&inference));
        Self { bvh: Some(bvh), skeleton: Some(skeleton), motion, notices, ..Self::new(Format::Bvh) }
    }

    /// Returns the file anew: the same values, names and order.
    pub fn to_bytes(&self) -> Vec<u8> {
        let asf = self.asf.as_ref().map(Asf::to_bytes);
        let c3d = || self.c3d.as_ref().map(C3d::to_bytes);
        let csm = || self.csm.as_ref().map(Csm::to_bytes);
        let trc = || self.trc.as_ref().map(Trc::to_bytes);
        let amc = || self.amc.as_ref().map(Amc::to_bytes);
        let bvh = || self.bvh.as_ref().map(Bvh::to_bytes);
        asf.or_else(amc).or_else(bvh).or_else(c3d).or_else(csm).or_else(trc).unwrap_or_default()
    }

    /// Returns the file's skeleton alone as a file that gives the same one; nothing where it has none.
    pub fn skeleton_to_bytes(&self) -> Vec<u8> {
        let hierarchy = || self.bvh.as_ref().map(|bvh| Bvh::new(bvh.joints.clone(), None).to_bytes());
        self.asf.as_ref().map(Asf::to_bytes).or_else(hierarchy).unwrap_or_default()
    }

    /// Works out which way markers face, as a notice: for those who show it, and not for each file that is read.
    pub fn facing_notice(&self) -> Option<String> {
        Some(format!("Facing: {}", self.markers.as_ref()?.facing().reason))
    }

    /// Returns the names of the bones or markers, in file order.
    pub fn names(&self) -> Vec<String> {
        if let Some(markers) = &self.markers {
            return markers.names.clone();
        }
        match (&self.amc, &self.skeleton) {
            (Some(amc), _) => amc.bones.iter().map(|bone| bone.name.clone()).collect(),
            (None, Some(skeleton)) => skeleton.bones.iter().map(|bone| bone.name.clone()).collect(),
            (None, None) => Vec::new(),
        }
    }

    /// Returns how many frames of motion there are.
    pub fn frame_count(&self) -> usize {
        let of_bvh = || self.bvh.as_ref()?.motion.as_ref().map(|motion| motion.frame_count);
        let of_markers = || self.markers.as_ref().map(|markers| markers.frame_count());
        self.amc.as_ref().map(|amc| amc.frame_count).or_else(of_bvh).or_else(of_markers).unwrap_or(0)
    }

    /// Returns the file's own number of the first frame; 1 without motion.
    pub fn first_frame(&self) -> i64 {
        let of_markers = || self.markers.as_ref().map(|markers| markers.first_frame);
        self.amc.as_ref().map(|amc| amc.first_frame).or_else(of_markers).unwrap_or(1)
    }

    /// Returns the frames per second; `None` where the file does not say.
    pub fn rate_hz(&self) -> Option<f64> {
        let of_bvh = || self.bvh.as_ref()?.motion.as_ref()?.rate_hz();
        let of_markers = || self.markers.as_ref()?.rate_hz;
        self.amc.as_ref().and_then(|amc| amc.header.rate_hz).or_else(of_bvh).or_else(of_markers)
    }

    /// Returns the motion of an AMC on a skeleton, with what the user should know.
    ///
    /// # Errors
    /// Where the file has no motion, one of other bones, or one with a skeleton of its own.
    pub fn bind(&self, skeleton: &Skeleton) -> Result<(Motion, Vec<String>), MisfitError> {
        let why = if self.bvh.is_some() { "the file has a skeleton of its own" } else { "the file has no motion" };
        let no_motion = || MisfitError { bones: vec![why.to_owned()] };
        self.amc.as_ref().ok_or_else(no_motion)?.motion(skeleton)
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
        Some(Format::Csm) => Ok(csm_clip(Csm::parse(source).map_err(wrong)?)),
        Some(Format::Trc) => Ok(trc_clip(Trc::parse(source).map_err(wrong)?)),
        None => Err(wrong(unknown(source))),
    }
}

fn c3d_clip(source: Vec<u8>, name: &Path) -> Result<Clip, ReadError> {
    let c3d = C3d::parse(source).map_err(|error| ReadError::Parse { path: PathBuf::from(name), error })?;
    let markers = c3d.markers();
    Ok(Clip { c3d: Some(c3d), ..Clip::of_markers(Format::C3d, markers) })
}

fn csm_clip(csm: Csm) -> Clip {
    let markers = csm.markers();
    Clip { csm: Some(csm), ..Clip::of_markers(Format::Csm, markers) }
}

fn trc_clip(trc: Trc) -> Clip {
    let markers = trc.markers();
    Clip { trc: Some(trc), ..Clip::of_markers(Format::Trc, markers) }
}

/// Returns what was inferred, with the reasons.
fn inferred(inference: &Inference) -> [String; 3] {
    let Inference { unit_m, up, facing, .. } = inference;
    [("Length unit", &unit_m.reason), ("Up axis", &up.reason), ("Facing", &facing.reason)]
        .map(|(what, reason)| format!("{what}: {reason}"))
}

fn amc_clip(amc: Amc, skeleton: Option<&Skeleton>) -> Result<Clip, MisfitError> {
    let bound = skeleton.map(|skeleton| amc.motion(skeleton)).transpose()?;
    let mut clip = Clip::of_amc(amc);
    if let Some((motion, notices)) = bound {
        clip.motion = Some(motion);
        clip.notices = notices;
    }
    Ok(clip)
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
