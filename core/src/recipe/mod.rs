//! A stack as a small file, TOML or JSON: the same recipe that the add-on keeps on an armature.
//!
//! ```toml
//! version = 1
//! skeleton = "human.asf"      # the skeleton of the result
//! rate_hz = 30.0              # the rate of the result; without it, that of the first track
//!
//! [[entries]]                 # from bottom to top
//! kind = "TRACK"
//! source = "wave.amc"
//! bones = ["lhumerus", "rhumerus"]
//! cut_start = 1
//! cut_end = 55
//! blend_depth = 10
//!
//! [[entries]]
//! kind = "FILTER"
//! filter_kind = "WEIGHTED"
//! depth = 7
//! ```
//!
//! An entry has the names and the values of the add-on's own properties ([`RecipeEntry`]). Paths are relative to the
//! file's folder. A frame that is 0 or absent is not set.

mod entry;
mod text;

pub use entry::{EntryKind, RecipeEntry, RotationAlignment};

use serde::{Deserialize, Serialize};

/// The version of the file that is written.
pub const VERSION: u32 = 1;

/// A stack as a file says it.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Recipe {
    /// The version of this layout: [`VERSION`].
    #[serde(default = "version")]
    pub version: u32,
    /// The path of the skeleton on which the result moves; without it, that of the first track.
    #[serde(default, skip_serializing_if = "String::is_empty")]
    pub skeleton: String,
    /// Frames per second of the result; 0 is that of the first track.
    #[serde(default, skip_serializing_if = "is_default")]
    pub rate_hz: f64,
    /// Tracks and filters, from bottom to top.
    #[serde(default)]
    pub entries: Vec<RecipeEntry>,
}

fn version() -> u32 {
    VERSION
}

/// Whether a value need not be written.
fn is_default<T: Default + PartialEq>(value: &T) -> bool {
    *value == T::default()
}

#[cfg(test)]
mod tests;
