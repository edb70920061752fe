//! A channel of the result as arrays that a host can take whole.

use crate::keys::{Interpolation, Keys, SAME_FRAME};

/// A channel of a bone, named as the host names it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Channel {
    /// Four components w, x, y, z.
    RotationQuaternion,
    /// Three angles in radians, indexed x, y, z.
    RotationEuler,
    /// Three components, host length units, in the bone's rest axes.
    Location,
}

impl Channel {
    /// Returns how many F-curves the channel has.
    pub const fn components(self) -> usize {
        match self {
            Self::RotationQuaternion => 4,
            Self::RotationEuler | Self::Location => 3,
        }
    }

    /// Returns the host's name of the channel.
    pub const fn name(self) -> &'static str {
        match self {
            Self::RotationQuaternion => "rotation_quaternion",
            Self::RotationEuler => "rotation_euler",
            Self::Location => "location",
        }
    }

    /// Returns the channel of that name.
    pub fn from_name(name: &str) -> Option<Self> {
        [Self::RotationQuaternion, Self::RotationEuler, Self::Location]
            .into_iter()
            .find(|channel| channel.name() == name)
    }
}

/// What one channel of one bone became.
#[derive(Debug, Clone, PartialEq)]
pub struct ResultChannel {
    /// Index of the bone.
    pub bone: usize,
    /// Which channel.
    pub channel: Channel,
    /// From here to `end` the base's keys are replaced; outside they stay as they are.
    pub start: f64,
    /// See `start`.
    pub end: f64,
    /// How many keys there are per curve; 0 where the curves are removed.
    pub key_count: usize,
    /// Per component a row of frame and value by turns: `components * 2 * key_count` numbers.
    pub coordinates: Vec<f32>,
    /// Per key; `None` where all are linear.
    pub interpolation: Option<Vec<i32>>,
}

impl ResultChannel {
    /// Returns the first and the last frame with a key.
    pub fn key_range(&self) -> Option<(f64, f64)> {
        let row = self.coordinates.get(..self.key_count * 2)?;
        Some((f64::from(*row.first()?), f64::from(*row.get(row.len().checked_sub(2)?)?)))
    }

    /// Writes the keys from `start` to `end` as rows.
    pub(super) fn new<V: Copy>(
        bone: usize,
        channel: Channel,
        (start, end): (f64, f64),
        keys: &Keys<V>,
        mut component: impl FnMut(V, &mut [f64]),
    ) -> Self {
        let from = keys.0.partition_point(|key| key.frame < start - SAME_FRAME);
        let to = keys.0.partition_point(|key| key.frame <= end + SAME_FRAME).max(from);
        let inside = &keys.0[from..to];
        let mut coordinates = vec![0.0_f32; channel.components() * 2 * inside.len()];
        let mut values = [0.0; 4];
        for (index, key) in inside.iter().enumerate() {
            component(key.value, &mut values);
            for (row, value) in values[..channel.components()].iter().enumerate() {
                let at = row * 2 * inside.len() + 2 * index;
                coordinates[at] = key.frame as f32;
                coordinates[at + 1] = *value as f32;
            }
        }
        let interpolation = inside
            .iter()
            .any(|key| key.interpolation != Interpolation::Linear)
            .then(|| inside.iter().map(|key| key.interpolation as i32).collect());
        Self { bone, channel, start, end, key_count: inside.len(), coordinates, interpolation }
    }
}
