//! A file with what belongs to it: an AMC with its skeleton.

use std::path::{Path, PathBuf};

use motion_theater_core::read::{read_path, Clip, Format};
use motion_theater_core::skeleton_search::candidates;
use motion_theater_core::stack::ASSUMED_RATE_HZ;
use motion_theater_core::{Motion, ReadError, Skeleton};

use crate::folder::{files_in, words};
use crate::Refusal;

/// What a file holds, on its skeleton.
pub struct Loaded {
    pub path: PathBuf,
    pub clip: Clip,
    /// The file's own skeleton, or the one that was found for it.
    pub skeleton: Option<Skeleton>,
    pub motion: Option<Motion>,
    /// Where the skeleton was found, and why it was taken (no reason where it was named).
    pub found: Option<(PathBuf, String)>,
    /// What is odd, and what was inferred.
    pub notices: Vec<String>,
}

/// A skeleton, and the file it is from.
pub struct SkeletonFile {
    pub path: PathBuf,
    pub skeleton: Skeleton,
}

impl SkeletonFile {
    /// Reads a skeleton from a file that has one.
    pub fn read(path: &Path) -> Result<Self, String> {
        let skeleton = read(path)?.skeleton;
        let skeleton = skeleton.ok_or_else(|| format!("{}: there is no skeleton in it", path.display()))?;
        Ok(Self { path: path.to_owned(), skeleton })
    }

    /// Reads the skeleton that a whole command was given.
    pub fn read_if_any(path: Option<&Path>) -> Result<Option<Self>, Refusal> {
        path.map(Self::read).transpose().map_err(Refusal::Failed)
    }
}

/// Reads a file; the error is one line that begins with its path.
pub fn read(path: &Path) -> Result<Clip, String> {
    read_path(path, None).map_err(|error| match error {
        ReadError::Io { path, source } => format!("{}: {}", path.display(), words(&source)),
        other => one_line(&other.to_string()),
    })
}

/// Returns text without breaks: names of files may hold any character.
fn one_line(text: &str) -> String {
    text.replace(['\n', '\r'], " ")
}

impl Loaded {
    /// Reads a file and finds its skeleton. An AMC whose skeleton is not found is no error: see [`Loaded::moving`].
    pub fn read(path: &Path, given: Option<&SkeletonFile>) -> Result<Self, String> {
        let mut clip = read(path)?;
        let (skeleton, motion) = (clip.skeleton.take(), clip.motion.take());
        let notices = std::mem::take(&mut clip.notices);
        let mut loaded = Self { path: path.to_owned(), clip, skeleton, motion, found: None, notices };
        if loaded.clip.format == Format::Amc {
            match given {
                Some(given) => loaded.bind(given, String::new())?,
                None => loaded.find_skeleton(),
            }
        }
        if loaded.frame_count() > 0 && loaded.clip.rate_hz().is_none() {
            loaded.notices.push(format!("The file does not say its rate: {ASSUMED_RATE_HZ} Hz assumed"));
        }
        Ok(loaded)
    }

    fn bind(&mut self, file: &SkeletonFile, reason: String) -> Result<(), String> {
        let bound = self.clip.bind(&file.skeleton);
        let (motion, notices) = bound.map_err(|error| {
            one_line(&format!("{}: with the skeleton {}, {error}", self.path.display(), file.path.display()))
        })?;
        self.motion = Some(motion);
        self.skeleton = Some(file.skeleton.clone());
        self.notices = notices;
        self.found = Some((file.path.clone(), reason));
        Ok(())
    }

    /// Takes the first candidate that fits; where none does, a notice says so.
    fn find_skeleton(&mut self) {
        let hint = self.clip.amc.as_ref().and_then(|amc| amc.header.skeleton_hint.clone());
        let folder = self.path.parent().unwrap_or(Path::new("")).to_owned();
        let above = if folder.as_os_str().is_empty() { PathBuf::from("..") } else { folder.join("..") };
        let above = folder.parent().filter(|above| !above.as_os_str().is_empty()).map_or(above, Path::to_owned);
        let mut refused = None;
        for candidate in candidates(&self.path, hint.as_deref(), &files_in(&folder), &files_in(&above)) {
            let bound = SkeletonFile::read(&candidate.path).and_then(|file| self.bind(&file, candidate.reason));
            match bound {
                Ok(()) => return,
                Err(text) => refused = refused.or(Some(text)),
            }
        }
        self.notices.push(refused.map_or_else(
            || "The skeleton (.asf) was not found beside the file".to_owned(),
            |text| format!("No skeleton beside the file fits: {text}"),
        ));
    }

    /// Returns the names of joints or bones, in file order.
    pub fn names(&self) -> Vec<String> {
        match (&self.clip.amc, &self.skeleton) {
            (None, Some(skeleton)) => skeleton.bones.iter().map(|bone| bone.name.clone()).collect(),
            _ => self.clip.names(),
        }
    }

    /// Returns how many frames there are.
    pub fn frame_count(&self) -> usize {
        self.clip.frame_count()
    }

    /// Returns the frames per second, assumed where the file does not say; `None` without frames.
    pub fn rate_hz(&self) -> Option<f64> {
        (self.frame_count() > 0).then(|| self.clip.rate_hz().unwrap_or(ASSUMED_RATE_HZ))
    }

    /// Returns the skeleton with its motion.
    pub fn moving(&self) -> Result<(&Skeleton, &Motion), String> {
        let motion = self.motion.as_ref().ok_or_else(|| match self.clip.format {
            Format::Amc => self.missing_skeleton(),
            _ if self.clip.markers.is_some() => self.only_markers(),
            _ => format!("{}: there is no motion in it", self.path.display()),
        })?;
        Ok((self.skeleton()?, motion))
    }

    /// Returns the skeleton.
    pub fn skeleton(&self) -> Result<&Skeleton, String> {
        self.skeleton.as_ref().ok_or_else(|| match self.clip.format {
            Format::Amc => self.missing_skeleton(),
            _ => self.only_markers(),
        })
    }

    fn only_markers(&self) -> String {
        format!("{}: there are markers in it and no skeleton", self.path.display())
    }

    fn missing_skeleton(&self) -> String {
        let why = self.notices.last().map_or("", String::as_str);
        format!("{}: needs its skeleton, to be named with --skeleton. {why}", self.path.display())
    }
}
