//! The entries of a stack, and what of them can be worked out once for all bones.

use std::sync::Arc;

use super::rig::Rig;
use super::source::Source;
use crate::combine::{Alignment, KeySpacing, Placement, Span};
use crate::error::ParameterError;
use crate::filter::{Depth, FilterKind};
use crate::motion::Motion;
use crate::rate::usual_rate;
use crate::sample::Sampling;
use crate::value::{Blend, FilterChannels};

/// What is assumed of a clip that does not say its rate: nearly all public Acclaim takes run at it.
pub const ASSUMED_RATE_HZ: f64 = 120.0;

/// Blender merges keys that stand nearer than 0.01 frame; samples must be further apart than that.
const CLOSEST_KEYS: f64 = 0.0125;

/// A clip on some bones, with its cut, scale and blend.
#[derive(Debug, Clone)]
pub struct Track {
    /// The clip, for the bones of the rig.
    pub source: Arc<Source>,
    /// What the user calls it; begins error messages.
    pub label: String,
    /// Indices of bones; `None` for all.
    pub bones: Option<Vec<usize>>,
    /// The part of the file, in file frames.
    pub cut: Span,
    /// Where that part goes, in scene frames.
    pub scale: Span,
    /// Half width of the crossfade in scene frames; `None` is "not set".
    pub blend_depth: Option<u32>,
    /// "Preserve old position/rotation", and how.
    pub preserve: Option<Alignment>,
    /// Remove the old motion of the bones first.
    pub discard: bool,
    /// How rotations are mixed in the crossfade.
    pub blend: Blend,
    /// How values between samples are found.
    pub sampling: Sampling,
    /// Where keys stand.
    pub spacing: KeySpacing,
    /// Frames per second where the file's own rate is missing or wrong.
    pub rate_hz: Option<f64>,
}

/// A filter on some bones.
#[derive(Debug, Clone)]
pub struct FilterEntry {
    /// What the user calls it.
    pub label: String,
    /// Indices of bones; `None` for all.
    pub bones: Option<Vec<usize>>,
    /// Which filter.
    pub kind: FilterKind,
    /// How many values one result is made of.
    pub depth: Depth,
    /// Whether it sees rotations or single curves.
    pub channels: FilterChannels,
}

/// One line of the stack.
#[derive(Debug, Clone)]
pub enum Entry {
    /// A clip.
    Track(Track),
    /// A filter.
    Filter(FilterEntry),
}

/// An entry with what all bones share worked out.
pub(super) enum Prepared<'a> {
    Track(PreparedTrack<'a>),
    Filter(&'a FilterEntry),
}

pub(super) struct PreparedTrack<'a> {
    pub track: &'a Track,
    pub motion: Arc<Motion>,
    pub placement: Placement,
    pub blend_depth: Option<u32>,
    pub rate_is_assumed: bool,
    pub samples_too_close: bool,
}

impl Entry {
    pub(super) fn prepare(&self, rig: &Rig) -> Result<Prepared<'_>, ParameterError> {
        match self {
            Self::Track(track) => track
                .prepare(rig)
                .map(Prepared::Track)
                .map_err(|error| ParameterError(format!("{}: {error}", track.label))),
            Self::Filter(filter) => Ok(Prepared::Filter(filter)),
        }
    }
}

impl Prepared<'_> {
    pub fn includes(&self, bone: usize) -> bool {
        let bones = match self {
            Self::Track(track) => &track.track.bones,
            Self::Filter(filter) => &filter.bones,
        };
        bones.as_ref().is_none_or(|bones| bones.contains(&bone))
    }
}

impl Track {
    fn prepare(&self, rig: &Rig) -> Result<PreparedTrack<'_>, ParameterError> {
        let motion = self.source.motion();
        if motion.frame_count == 0 {
            return Err(ParameterError("the clip has no frames".into()));
        }
        let known_rate = self.rate_hz.or(motion.rate_hz);
        let ratio = usual_rate(known_rate.unwrap_or(ASSUMED_RATE_HZ)) / usual_rate(rig.rate_hz);
        if !(ratio.is_finite() && (1e-4..=1e4).contains(&ratio)) {
            return Err(ParameterError(format!(
                "cannot fit a rate into the scene's: {ratio} file frames per scene frame"
            )));
        }
        let file = (motion.first_frame, motion.last_frame());
        let place = |spacing| Placement::new(file, self.cut, self.scale, ratio, spacing);
        let mut placement = place(self.spacing)?;
        let samples_too_close = self.spacing == KeySpacing::Samples && placement.speed() * CLOSEST_KEYS > 1.0;
        if samples_too_close {
            placement = place(KeySpacing::Frames)?;
        }
        let is_resampled = self.scale == Span::default() && (self.spacing == KeySpacing::Frames || samples_too_close);
        Ok(PreparedTrack {
            track: self,
            motion: self.source.for_ratio(if is_resampled { ratio } else { 1.0 }),
            placement,
            blend_depth: self.blend_depth.filter(|_| self.preserve.is_none()),
            rate_is_assumed: known_rate.is_none(),
            samples_too_close,
        })
    }
}
