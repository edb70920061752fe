//! What was recorded beside the markers: forces, muscles, switches.

use crate::formats::c3d::Frames;

/// Analog signals, as they were recorded.
#[derive(Debug, Clone, PartialEq)]
pub struct Analog {
    /// The channels in file order.
    pub channels: Vec<AnalogChannel>,
    /// The samples of each channel during one frame of the markers.
    pub samples_per_frame: usize,
    /// Samples per second, as the file says; `None` where it does not.
    pub rate_hz: Option<f64>,
    /// What the samples of every channel are multiplied by, besides its own scale.
    pub general_scale: f64,
    /// The numbers as recorded: sample after sample, and for each sample channel after channel.
    pub raw: RawSamples,
}

impl Default for Analog {
    /// Nothing was recorded.
    fn default() -> Self {
        Self {
            channels: Vec::new(),
            samples_per_frame: 1,
            rate_hz: None,
            general_scale: 1.0,
            raw: RawSamples::default(),
        }
    }
}

/// One signal.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct AnalogChannel {
    /// The file's own name, possibly empty.
    pub name: String,
    /// What it is, possibly empty.
    pub description: String,
    /// The unit of its values: "N", "V"; possibly empty.
    pub unit: String,
    /// The recorded number that stands for 0 ...
    pub offset: f64,
    /// ... and what the rest is multiplied by.
    pub scale: f64,
}

/// Recorded numbers.
#[derive(Debug, Clone, PartialEq)]
pub enum RawSamples {
    /// Numbers by themselves.
    Values(Vec<f32>),
    /// Those of a C3D, where they lie.
    Recorded {
        /// The file's frames.
        frames: Frames,
        /// Whether integers have no sign.
        is_unsigned: bool,
    },
}

impl Default for RawSamples {
    fn default() -> Self {
        Self::Values(Vec::new())
    }
}

impl RawSamples {
    /// Returns how many there are.
    pub fn len(&self) -> usize {
        match self {
            Self::Values(values) => values.len(),
            Self::Recorded { frames, .. } => frames.analog_count(),
        }
    }

    /// Returns true where there are none.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Returns a number; `None` beyond the last.
    #[inline]
    pub fn get(&self, at: usize) -> Option<f64> {
        match self {
            Self::Values(values) => values.get(at).map(|value| f64::from(*value)),
            Self::Recorded { frames, is_unsigned } => frames.analog(at, *is_unsigned),
        }
    }

    /// Returns every `step`th number from `first` on; `step` is what each sample has.
    fn every(&self, first: usize, step: usize) -> Vec<f64> {
        match self {
            Self::Values(values) => values.iter().skip(first).step_by(step.max(1)).map(|x| f64::from(*x)).collect(),
            Self::Recorded { frames, is_unsigned } => frames.channel(first, step, *is_unsigned),
        }
    }

    /// Returns all numbers in order.
    pub fn iter(&self) -> impl Iterator<Item = f64> + use<'_> {
        (0..self.len()).filter_map(|at| self.get(at))
    }
}

impl Analog {
    /// Returns how many samples each channel has.
    pub fn sample_count(&self) -> usize {
        self.raw.len().checked_div(self.channels.len()).unwrap_or(0)
    }

    /// Returns the samples of a channel in its unit; nothing where there is no such channel.
    pub fn samples(&self, channel: usize) -> Vec<f64> {
        let Some(known) = self.channels.get(channel) else { return Vec::new() };
        let mut samples = self.raw.every(channel, self.channels.len());
        for value in &mut samples {
            *value = (*value - known.offset) * known.scale * self.general_scale;
        }
        samples
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_channel_is_every_nth_number_less_the_offset_times_the_scale() {
        let channel = |offset, scale| AnalogChannel { offset, scale, ..AnalogChannel::default() };
        let channels = vec![channel(0.0, 1.0), channel(2048.0, -0.5)];
        let raw = RawSamples::Values(vec![1.0, 2048.0, 2.0, 2050.0]);
        let analog = Analog { channels, raw, ..Analog::default() };
        assert_eq!((analog.samples(0), analog.samples(1)), (vec![1.0, 2.0], vec![-0.0, -1.0]));
        assert_eq!((analog.samples(2), analog.sample_count()), (vec![], 2));
    }
}
