//! Median, moving average and weighted average over frames.
//!
//! | filter | result | good for |
//! |---|---|---|
//! | [`FilterKind::Median`] | the middle of the sorted window | spikes; keeps edges, makes no new values |
//! | [`FilterKind::Average`] | the window's mean | noise; softens |
//! | [`FilterKind::Weighted`] | the mean weighted by a row of Pascal's triangle | noise; softens less |
//!
//! **At the ends** the window shrinks so that it stays centred: the first frame has a window of 1 (it is left as it
//! is), the second one of 3, and so on up to the depth; the same backwards from the last frame. The weighted average
//! uses the row of Pascal's triangle that fits the shrunk window. Thus no value from outside the motion is invented,
//! a ramp stays a ramp up to its ends, and a depth larger than the motion is fine.
//!
//! **Constants stay constant** to the last bit: averages are computed as the centre plus weighted differences from it.
//!
//! **Values that are no numbers** never panic. An average whose window holds one gives one. A median orders them
//! above all numbers where it sorts; the fixed networks of depth 3 to 7 give one of the window's values.
//! For rotations a window that holds one leaves its frame as it is.

mod angles;
mod average;
mod channels;
pub(crate) mod components;
mod median;
mod rotation;
mod weighted;
pub(crate) mod window;

#[cfg(test)]
mod naive;

pub use angles::{filter_angles, unwrap_angles};
pub use channels::{filter_channels, filter_values};
pub use rotation::filter_rotations;

use serde::{Deserialize, Serialize};

use crate::ParameterError;

/// Which value stands for a window.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "UPPERCASE")]
pub enum FilterKind {
    /// The middle of the sorted window.
    Median,
    /// The mean.
    Average,
    /// The mean with the weights of a row of Pascal's triangle: for depth 5, 1 4 6 4 1 over 16.
    Weighted,
}

/// How many values are considered per result: odd, at least 3.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Depth(usize);

impl Depth {
    /// Returns the number of values in a full window.
    pub fn get(self) -> usize {
        self.0
    }

    /// Returns how far a window reaches to each side in a motion of that many frames.
    ///
    /// No centred window is longer than the motion, so a larger depth changes nothing; bounding it here keeps the
    /// work and memory of an absurd depth small.
    fn reach_within(self, frames: usize) -> usize {
        (self.0 / 2).min(frames.saturating_sub(1) / 2)
    }
}

impl TryFrom<usize> for Depth {
    type Error = ParameterError;

    fn try_from(depth: usize) -> Result<Self, ParameterError> {
        if depth >= 3 && depth % 2 == 1 {
            Ok(Self(depth))
        } else {
            Err(ParameterError(format!("the depth of a filter is an odd number of at least 3, not {depth}")))
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn odd_depths_from_3_are_accepted() {
        for depth in [3, 5, 7, 9, 1001, usize::MAX] {
            assert_eq!(Depth::try_from(depth).map(Depth::get), Ok(depth));
        }
    }

    #[test]
    fn other_depths_are_refused_in_words() {
        for depth in [0, 1, 2, 4, 1000] {
            let error = Depth::try_from(depth).unwrap_err();
            let words = format!("the depth of a filter is an odd number of at least 3, not {depth}");
            assert_eq!(error.to_string(), words);
        }
    }
}
