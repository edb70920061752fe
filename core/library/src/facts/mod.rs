//! What is in a file, without its samples: what `motion-theater info` tells.

pub(crate) mod said;
mod skeleton;

pub use skeleton::{fingerprint, SkeletonFacts};

use std::path::Path;
use std::sync::Arc;

use motion_theater_core::read::{read_bytes, Clip, Format};
use motion_theater_core::skim::skim as skim_file;
use motion_theater_core::stack::ASSUMED_RATE_HZ;
use motion_theater_core::upright::axis_name;
use motion_theater_core::{ReadError, Skeleton};

use crate::catalogue::Field;

/// What this reader tells of a file has changed so many times: clips of an earlier count are read again.
pub(crate) const READER: i64 = 1;

/// What is in a file. What it does not have is `None`.
#[derive(Debug, Clone, PartialEq)]
pub struct Facts {
    /// The file's format, by its content.
    pub format: Format,
    /// How many frames there are.
    pub frames: usize,
    /// The file's own number of the first frame.
    pub first_frame: Option<i64>,
    /// Frames per second; assumed where the file does not say, as a notice tells. `None` without frames.
    pub rate_hz: Option<f64>,
    /// How many joints or bones move.
    pub joints: Option<usize>,
    /// How many markers there are.
    pub markers: Option<usize>,
    /// What is known of its skeleton.
    pub skeleton: Option<SkeletonFacts>,
    /// Metres per file unit.
    pub unit_m: Option<f64>,
    /// The axis that points up in the file: `Y`, `-Z`.
    pub up: Option<&'static str>,
    /// What the file and its name say of the clip.
    pub says: Vec<(Field, String)>,
    /// What is odd in the file, and what was inferred, a sentence each.
    pub notices: Vec<String>,
}

/// Looks over a file that is in memory, and reads only what its facts need; the clip has some of the frames then. `None`
/// where the file is no usual one: then [`read`] says the same, or what is wrong.
pub fn skim(source: &[u8], path: &Path) -> Option<(Facts, Clip)> {
    let skimmed = skim_file(source, path)?;
    Some((Facts::of(&skimmed.clip, skimmed.frame_count, path), skimmed.clip))
}

/// Reads a file that is in memory, every number of it. `path` stands in no message.
///
/// # Errors
/// Where the file is wrong: the place and the reason in words.
pub fn read(source: &[u8], path: &Path) -> Result<(Facts, Clip), String> {
    of_whole(read_bytes(source, path, None), path)
}

/// Reads a file that is in memory; the clip may take a share in it.
///
/// # Errors
/// Where the file is wrong: the place and the reason in words.
pub(crate) fn read_shared(source: &Arc<Vec<u8>>, path: &Path) -> Result<(Facts, Clip), String> {
    of_whole(motion_theater_core::read::read_shared(source, path), path)
}

fn of_whole(read: Result<Clip, ReadError>, path: &Path) -> Result<(Facts, Clip), String> {
    let clip = read.map_err(|error| match error {
        ReadError::Io { source, .. } => crate::error::words(&source),
        ReadError::Parse { error, .. } => error.to_string(),
        ReadError::Misfit { error, .. } => error.to_string(),
        other => other.to_string(),
    })?;
    Ok((Facts::of(&clip, clip.frame_count(), path), clip))
}

impl Facts {
    /// Takes them from a clip that holds `frames` frames, or stands for so many.
    pub(crate) fn of(clip: &Clip, frames: usize, path: &Path) -> Self {
        let markers = clip.markers();
        let mut notices = clip.notices().to_vec();
        let said_rate = clip.rate_hz();
        if frames > 0 && said_rate.is_none() {
            notices.push(format!("The file does not say its rate: {ASSUMED_RATE_HZ} Hz assumed"));
        }
        let mut facts = Self {
            format: clip.format,
            frames,
            first_frame: (frames > 0).then(|| clip.first_frame()),
            rate_hz: (frames > 0).then(|| said_rate.unwrap_or(ASSUMED_RATE_HZ)),
            joints: markers.is_none().then(|| clip.names().len()),
            markers: markers.map(|markers| markers.count()),
            skeleton: None,
            unit_m: markers.map(|markers| markers.unit.metres),
            up: markers.map(|markers| axis_name(markers.up.axis)),
            says: said::by(clip, path),
            notices,
        };
        if let Some(skeleton) = &clip.skeleton {
            facts.set_skeleton(skeleton);
        }
        facts
    }

    /// Takes what a skeleton says: the file's own, or the one that was found for it.
    pub(crate) fn set_skeleton(&mut self, skeleton: &Skeleton) {
        self.unit_m = Some(skeleton.unit.metres);
        self.up = Some(axis_name(skeleton.up));
        self.skeleton = Some(SkeletonFacts::of(skeleton));
    }

    /// Returns how long all frames last, in seconds.
    pub fn duration_s(&self) -> Option<f64> {
        self.rate_hz.map(|rate| self.frames as f64 / rate)
    }
}
