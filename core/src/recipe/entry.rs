//! One entry of a stack file, and what the core makes of it.

use std::sync::Arc;

use serde::{Deserialize, Serialize};

use super::is_default;
use crate::combine::{Alignment, KeySpacing, Span};
use crate::error::ParameterError;
use crate::filter::{Depth, FilterKind};
use crate::sample::Sampling;
use crate::stack::{Entry, FilterEntry, Source, Track};
use crate::value::{Blend, FilterChannels};

/// Blender's own limit of frame numbers.
const FRAME_LIMIT: i64 = 1_048_574;

/// What an entry is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
#[serde(rename_all = "UPPERCASE")]
pub enum EntryKind {
    /// A clip on some bones.
    #[default]
    Track,
    /// A filter on what lies below.
    Filter,
}

/// How far new motion is turned to continue the old one.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
#[serde(rename_all = "UPPERCASE")]
pub enum RotationAlignment {
    /// About the up axis alone.
    #[default]
    Heading,
    /// About all axes.
    Full,
}

/// One entry; each field has the name and the values of the add-on's property. What is not in the file has its default.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
#[allow(clippy::struct_excessive_bools)] // the add-on's own properties, each a box to tick
pub struct RecipeEntry {
    /// What the user calls it; begins error messages.
    #[serde(skip_serializing_if = "String::is_empty")]
    pub name: String,
    /// A track or a filter; what follows is of either.
    pub kind: EntryKind,
    /// Whether it takes part.
    #[serde(skip_serializing_if = "is_true")]
    pub enabled: bool,
    /// The path of a track's motion file.
    #[serde(skip_serializing_if = "String::is_empty")]
    pub source: String,
    /// The path of a track's own skeleton, where it is not that of the stack.
    #[serde(skip_serializing_if = "String::is_empty")]
    pub skeleton: String,
    /// Names of the bones on which it acts; without this, on all.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub bones: Option<Vec<String>>,
    /// Frames per second of the source, where its own are missing or wrong; 0 is its own.
    #[serde(skip_serializing_if = "is_default")]
    pub rate_hz: f64,
    /// First frame of the file to take.
    #[serde(skip_serializing_if = "is_default")]
    pub cut_start: i64,
    /// Last frame of the file to take.
    #[serde(skip_serializing_if = "is_default")]
    pub cut_end: i64,
    /// Frame of the result at which the track starts.
    #[serde(skip_serializing_if = "is_default")]
    pub scale_start: i64,
    /// Frame of the result at which the track ends.
    #[serde(skip_serializing_if = "is_default")]
    pub scale_end: i64,
    /// Half width of the crossfade, in frames of the result.
    #[serde(skip_serializing_if = "is_default")]
    pub blend_depth: u32,
    /// Continue from where the old motion left the root.
    #[serde(skip_serializing_if = "is_default")]
    pub preserve: bool,
    /// How far the new motion is turned for that.
    #[serde(skip_serializing_if = "is_default")]
    pub preserve_rotation: RotationAlignment,
    /// Continue at the old height too.
    #[serde(skip_serializing_if = "is_default")]
    pub preserve_height: bool,
    /// Remove the old motion of the bones first.
    #[serde(skip_serializing_if = "is_default")]
    pub discard: bool,
    /// How rotations are mixed in the crossfade.
    #[serde(skip_serializing_if = "is_default")]
    pub blend: Blend,
    /// How values between samples are found.
    #[serde(skip_serializing_if = "is_default")]
    pub sampling: Sampling,
    /// Where an armature gets keys; a file has whole frames.
    #[serde(skip_serializing_if = "is_default")]
    pub keys: KeySpacing,
    /// Which filter.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub filter_kind: Option<FilterKind>,
    /// How many values one result of the filter is made of.
    #[serde(skip_serializing_if = "is_three")]
    pub depth: usize,
    /// What the filter takes as one value.
    #[serde(skip_serializing_if = "is_default")]
    pub filter_channels: FilterChannels,
}

#[allow(clippy::trivially_copy_pass_by_ref)] // serde passes references
fn is_true(value: &bool) -> bool {
    *value
}

#[allow(clippy::trivially_copy_pass_by_ref)] // serde passes references
fn is_three(depth: &usize) -> bool {
    *depth == 3
}

impl Default for RecipeEntry {
    fn default() -> Self {
        Self {
            name: String::new(),
            kind: EntryKind::default(),
            enabled: true,
            source: String::new(),
            skeleton: String::new(),
            bones: None,
            rate_hz: 0.0,
            cut_start: 0,
            cut_end: 0,
            scale_start: 0,
            scale_end: 0,
            blend_depth: 0,
            preserve: false,
            preserve_rotation: RotationAlignment::default(),
            preserve_height: false,
            discard: false,
            blend: Blend::default(),
            sampling: Sampling::default(),
            keys: KeySpacing::default(),
            filter_kind: None,
            depth: 3,
            filter_channels: FilterChannels::default(),
        }
    }
}

impl RecipeEntry {
    /// Returns what the entry is called: its name, or else its source or what it does.
    pub fn label(&self) -> String {
        match self.kind {
            _ if !self.name.is_empty() => self.name.clone(),
            EntryKind::Track if self.source.is_empty() => "a track".to_owned(),
            EntryKind::Track => self.source.clone(),
            EntryKind::Filter => "a filter".to_owned(),
        }
    }

    /// Returns the entry for bones of these names. `source` is the clip of a track, for the same bones.
    ///
    /// # Errors
    /// Where a bone is unknown, a track has no clip or a filter no kind, or a number makes no sense.
    pub fn to_entry(&self, names: &[&str], source: Option<Arc<Source>>) -> Result<Entry, ParameterError> {
        let label = self.label();
        let wrong = |text: String| ParameterError(format!("{label}: {text}"));
        let bones = self.bone_indices(names).map_err(wrong)?;
        match self.kind {
            EntryKind::Track => {
                let cut = span("cut", self.cut_start, self.cut_end).map_err(wrong)?;
                let scale = span("scale", self.scale_start, self.scale_end).map_err(wrong)?;
                let full_rotation = self.preserve_rotation == RotationAlignment::Full;
                Ok(Entry::Track(Track {
                    source: source.ok_or_else(|| wrong("there is no source".to_owned()))?,
                    label,
                    bones,
                    cut,
                    scale,
                    blend_depth: Some(self.blend_depth).filter(|depth| *depth != 0),
                    preserve: self.preserve.then_some(Alignment { full_rotation, height: self.preserve_height }),
                    discard: self.discard,
                    blend: self.blend,
                    sampling: self.sampling,
                    spacing: self.keys,
                    rate_hz: Some(self.rate_hz).filter(|rate| *rate != 0.0),
                }))
            }
            EntryKind::Filter => {
                let kind = self.filter_kind.ok_or_else(|| {
                    wrong("`filter_kind` is missing: \"MEDIAN\", \"AVERAGE\" or \"WEIGHTED\"".to_owned())
                })?;
                let depth = Depth::try_from(self.depth).map_err(|error| wrong(error.to_string()))?;
                Ok(Entry::Filter(FilterEntry { label, bones, kind, depth, channels: self.filter_channels }))
            }
        }
    }

    fn bone_indices(&self, names: &[&str]) -> Result<Option<Vec<usize>>, String> {
        let Some(wanted) = &self.bones else { return Ok(None) };
        let index = |name: &String| {
            let found = names.iter().position(|known| known == name);
            found.ok_or_else(|| format!("there is no bone `{name}`: the bones are {}", names.join(", ")))
        };
        wanted.iter().map(index).collect::<Result<_, _>>().map(Some)
    }
}

/// Returns two frames as a span; 0 is "not set", as in the add-on.
fn span(what: &str, start: i64, end: i64) -> Result<Span, String> {
    let frame = |frame: i64| {
        if (-FRAME_LIMIT..=FRAME_LIMIT).contains(&frame) {
            Ok(Some(frame).filter(|frame| *frame != 0))
        } else {
            Err(format!("a {what} frame lies between {} and {FRAME_LIMIT}, not at {frame}", -FRAME_LIMIT))
        }
    };
    Ok(Span { start: frame(start)?, end: frame(end)? })
}
