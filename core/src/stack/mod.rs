//! Base motion + ordered tracks and filters -> the resulting channels, and what the user should know.
//!
//! Evaluation is a pure function: the same rig, base and entries give the same result bit for bit, and an entry that is
//! left out leaves no trace. Every bone is evaluated by itself, bones side by side.

mod bone;
mod entry;
mod notice;
mod on_skeleton;
mod output;
mod rig;
mod source;

use rayon::prelude::*;

pub use entry::{Entry, FilterEntry, Track, ASSUMED_RATE_HZ};
pub use notice::Notice;
pub use on_skeleton::{evaluate_on, on_skeleton};
pub use output::{Channel, ResultChannel};
pub use rig::{BaseChannel, Mode, Rig, RigBone};
pub use source::Source;

use crate::error::ParameterError;
use crate::value::Turn;

/// What a stack comes to.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Evaluation {
    /// Only channels that an entry touches, in the rig's order of bones.
    pub channels: Vec<ResultChannel>,
    /// What the user should know, in order of entries.
    pub notices: Vec<Notice>,
    /// First and last frame of the touched channels; `None` where nothing was touched.
    pub range: Option<(f64, f64)>,
}

/// Evaluates a stack on a rig.
///
/// `base` is what the armature's channels held before the first entry. Channels of bones that no entry touches are not
/// in the result.
///
/// # Errors
/// Where an entry's frames make no sense; the message begins with the entry's label.
pub fn evaluate(rig: &Rig, base: &[BaseChannel], entries: &[Entry]) -> Result<Evaluation, ParameterError> {
    let prepared = entries.iter().map(|entry| entry.prepare(rig)).collect::<Result<Vec<_>, _>>()?;
    let (channels, events): (Vec<_>, Vec<_>) = (0..rig.bones.len())
        .into_par_iter()
        .map(|index| match rig.bones[index].mode {
            Mode::Quaternion => bone::evaluate::<glam::DQuat>(rig, index, base, &prepared).into_channels(rig, index),
            Mode::Euler(_) => bone::evaluate::<Turn>(rig, index, base, &prepared).into_channels(rig, index),
        })
        .unzip();
    let notices = notice::collect(rig, &prepared, &events);
    let channels: Vec<ResultChannel> = channels.into_iter().flatten().collect();
    let range = channels.iter().filter_map(ResultChannel::key_range).reduce(|a, b| (a.0.min(b.0), a.1.max(b.1)));
    Ok(Evaluation { channels, notices, range })
}

#[cfg(test)]
mod tests;
