//! A file with what belongs to it: an AMC with its skeleton.

use std::path::{Path, PathBuf};

use crate::error::{MisfitError, ReadError};
use crate::motion::Motion;
use crate::pairing::{default_skeleton, skeletons_for, Candidate, Known, DEFAULT_SKELETON_NOTICE};
use crate::read::{read_path, Clip, Format};
use crate::skeleton::Skeleton;
use crate::stack::ASSUMED_RATE_HZ;

/// What a file holds, on its skeleton.
#[derive(Debug, Clone, PartialEq)]
pub struct Loaded {
    /// The file.
    pub path: PathBuf,
    /// What it holds; its skeleton, motion and notices have moved into the fields below.
    pub clip: Clip,
    /// The file's own skeleton, or the one that was found for it.
    pub skeleton: Option<Skeleton>,
    /// The motion on that skeleton.
    pub motion: Option<Motion>,
    /// Where the skeleton is from; `None` for the file's own, or none at all.
    pub pairing: Option<Pairing>,
    /// What is odd, what was inferred, and why the skeleton was taken: a sentence each.
    pub notices: Vec<String>,
}

/// Where the skeleton of a motion is from.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Pairing {
    /// From the file that was named.
    Named(PathBuf),
    /// From a file that was found.
    Found(Candidate),
    /// It is the built-in default skeleton.
    BuiltIn,
}

impl Pairing {
    /// Returns the file that the skeleton is from.
    pub fn path(&self) -> Option<&Path> {
        match self {
            Self::Named(path) => Some(path),
            Self::Found(candidate) => Some(&candidate.path),
            Self::BuiltIn => None,
        }
    }

    /// Returns what the user must know wherever sizes matter: that the skeleton is none of the motion's own.
    pub fn warning(&self) -> Option<&'static str> {
        (*self == Self::BuiltIn).then_some(DEFAULT_SKELETON_NOTICE)
    }

    /// Returns what the user should know: nothing of a skeleton that was named.
    pub fn notice(&self) -> Option<String> {
        match self {
            Self::Named(_) => None,
            Self::Found(found) => Some(format!("Took {}, because {}", found.path.display(), found.reason)),
            Self::BuiltIn => Some(DEFAULT_SKELETON_NOTICE.to_owned()),
        }
    }
}

/// Why a file gives no motion or no skeleton; each is one line.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum LoadError {
    /// The file cannot be read.
    #[error("{}", one_line(.0))]
    Read(#[from] ReadError),
    /// A file was named as a skeleton and is none.
    #[error("{}: there is no skeleton in it", one_line(.0.display()))]
    NoSkeleton(PathBuf),
    /// The motion and the skeleton that was tried do not belong together.
    #[error("{}: with the skeleton {}, {}", one_line(motion.display()), one_line(skeleton.display()), one_line(error))]
    Misfit {
        /// The motion's file.
        motion: PathBuf,
        /// The skeleton's file.
        skeleton: PathBuf,
        /// Which bones.
        error: MisfitError,
    },
    /// The motion has no skeleton of its own, and none was found that fits.
    #[error("{}: needs its skeleton. {why}", one_line(path.display()))]
    NeedsSkeleton {
        /// The motion's file.
        path: PathBuf,
        /// What was tried.
        why: String,
    },
    /// A skeleton was asked for where there are markers.
    #[error("{}: there are markers in it and no skeleton", one_line(.0.display()))]
    OnlyMarkers(PathBuf),
    /// A motion was asked for where there is none.
    #[error("{}: there is no motion in it", one_line(.0.display()))]
    NoMotion(PathBuf),
}

/// Returns text without breaks: names of files may hold any character.
fn one_line(text: impl std::fmt::Display) -> String {
    text.to_string().replace(['\n', '\r'], " ")
}

/// A skeleton, and the file it is from.
#[derive(Debug, Clone, PartialEq)]
pub struct SkeletonFile {
    /// The file.
    pub path: PathBuf,
    /// What it holds.
    pub skeleton: Skeleton,
}

impl SkeletonFile {
    /// Reads a skeleton from a file that has one.
    ///
    /// # Errors
    /// Where the file cannot be read or has none.
    pub fn read(path: &Path) -> Result<Self, LoadError> {
        let skeleton = read_path(path, None)?.skeleton;
        let skeleton = skeleton.ok_or_else(|| LoadError::NoSkeleton(path.to_owned()))?;
        Ok(Self { path: path.to_owned(), skeleton })
    }
}

impl Loaded {
    /// Reads a file with the skeleton that was named for it, or finds one. An AMC whose skeleton is not found is no
    /// error: see [`Loaded::moving`].
    ///
    /// # Errors
    /// Where the file cannot be read, or does not fit the skeleton that was named.
    pub fn read(path: &Path, named: Option<&SkeletonFile>) -> Result<Self, LoadError> {
        let clip = read_path(path, None)?;
        match named {
            Some(named) => Self::with(path, clip, named),
            None => Ok(Self::among(path, clip, Known::default())),
        }
    }

    /// Puts a file that was read on the skeleton that was named for it, where it has none of its own.
    ///
    /// # Errors
    /// Where the two do not belong together.
    pub fn with(path: &Path, clip: Clip, named: &SkeletonFile) -> Result<Self, LoadError> {
        let mut loaded = Self::of(path, clip);
        if loaded.clip.format == Format::Amc {
            let bound = loaded.bind(&named.skeleton, Pairing::Named(named.path.clone()));
            bound.map_err(|error| loaded.misfit(&named.path, error))?;
        }
        loaded.tell_of_rate();
        Ok(loaded)
    }

    /// Puts a file that was read on the first skeleton that fits: one beside it, one of those that are known, or else
    /// the built-in default; where none does, a notice says so.
    pub fn among(path: &Path, clip: Clip, known: Known<'_>) -> Self {
        let mut loaded = Self::of(path, clip);
        if loaded.clip.format == Format::Amc {
            loaded.find_skeleton(known);
        }
        loaded.tell_of_rate();
        loaded
    }

    fn of(path: &Path, mut clip: Clip) -> Self {
        let (skeleton, motion) = (clip.skeleton.take(), clip.motion.take());
        let notices = clip.notices().to_vec();
        Self { path: path.to_owned(), clip, skeleton, motion, pairing: None, notices }
    }

    fn tell_of_rate(&mut self) {
        if self.frame_count() > 0 && self.clip.rate_hz().is_none() {
            self.notices.push(format!("The file does not say its rate: {ASSUMED_RATE_HZ} Hz assumed"));
        }
    }

    fn bind(&mut self, skeleton: &Skeleton, pairing: Pairing) -> Result<(), MisfitError> {
        let (motion, notices) = self.clip.bind(skeleton)?;
        self.motion = Some(motion);
        self.skeleton = Some(skeleton.clone());
        self.notices = notices;
        self.notices.extend(pairing.notice());
        self.pairing = Some(pairing);
        Ok(())
    }

    fn misfit(&self, skeleton: &Path, error: MisfitError) -> LoadError {
        LoadError::Misfit { motion: self.path.clone(), skeleton: skeleton.to_owned(), error }
    }

    /// Takes the first candidate that fits, or the built-in default; where none does, a notice says so.
    fn find_skeleton(&mut self, known: Known<'_>) {
        let hint = self.clip.amc.as_ref().and_then(|amc| amc.header.skeleton_hint.clone());
        let mut refused = None;
        for candidate in skeletons_for(&self.path, hint.as_deref(), known) {
            let bound = SkeletonFile::read(&candidate.path).and_then(|file| {
                let bound = self.bind(&file.skeleton, Pairing::Found(candidate));
                bound.map_err(|error| self.misfit(&file.path, error))
            });
            match bound {
                Ok(()) => return,
                Err(error) => refused = refused.or(Some(error)),
            }
        }
        let refused = refused.map(|error| format!("No skeleton beside the file fits: {error}"));
        if self.bind(default_skeleton(), Pairing::BuiltIn).is_ok() {
            self.notices.extend(refused);
        } else {
            let why = || "The skeleton (.asf) was not found beside the file, and the default does not fit".to_owned();
            self.notices.push(refused.unwrap_or_else(why));
        }
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
    ///
    /// # Errors
    /// Where there is none.
    pub fn moving(&self) -> Result<(&Skeleton, &Motion), LoadError> {
        let motion = self.motion.as_ref().ok_or_else(|| match self.clip.format {
            Format::Amc => self.needs_skeleton(),
            _ if self.clip.has_markers() => LoadError::OnlyMarkers(self.path.clone()),
            _ => LoadError::NoMotion(self.path.clone()),
        })?;
        Ok((self.skeleton()?, motion))
    }

    /// Returns the skeleton.
    ///
    /// # Errors
    /// Where there is none.
    pub fn skeleton(&self) -> Result<&Skeleton, LoadError> {
        self.skeleton.as_ref().ok_or_else(|| match self.clip.format {
            Format::Amc => self.needs_skeleton(),
            _ => LoadError::OnlyMarkers(self.path.clone()),
        })
    }

    fn needs_skeleton(&self) -> LoadError {
        LoadError::NeedsSkeleton { path: self.path.clone(), why: self.notices.last().cloned().unwrap_or_default() }
    }
}
