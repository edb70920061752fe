//! A whole motion at another rate.

use rayon::prelude::*;

use super::{
    lowpass_angles, lowpass_rotations, lowpass_values, lowpass_vectors, sample_angles, sample_rotation, sample_value,
    sample_vector, Sampling,
};
use crate::filter::unwrap_angles;
use crate::{BoneMotion, Motion, ParameterError};

/// The most poses (bones times frames) that resampling may make of a motion that has fewer: about 5 GB.
const MOST_POSES: usize = 1 << 26;

impl Motion {
    /// Returns the same movement at another rate, low-passed first when going down.
    ///
    /// Frame `k` of the result shows the moment `k / rate_hz_to` seconds after the first frame, so there are as many
    /// frames as fit between the moments of the first and the last one. Between samples values follow
    /// [`Sampling::Smooth`]. Euler angles are [unwrapped](unwrap_angles) first. [`Motion::first_frame`] stays. At the
    /// motion's own rate the result equals it bit for bit.
    ///
    /// # Errors
    ///
    /// If the motion does not know its own rate, if either rate is not a number above 0, or if the result would be
    /// larger than memory can be expected to hold.
    pub fn resampled(&self, rate_hz_to: f64) -> Result<Self, ParameterError> {
        let rate_hz_from = self.rate_hz.ok_or_else(|| {
            ParameterError("the motion does not say its rate, so it cannot be brought to another".into())
        })?;
        for rate_hz in [rate_hz_from, rate_hz_to] {
            if !rate_hz.is_finite() || rate_hz <= 0.0 {
                return Err(ParameterError(format!("a rate is a number of frames per second above 0, not {rate_hz}")));
            }
        }
        if rate_hz_from == rate_hz_to {
            return Ok(self.clone());
        }
        let frame_count = self.frames_at(rate_hz_from, rate_hz_to)?;
        let positions: Vec<f64> = (0..frame_count).map(|frame| frame as f64 * rate_hz_from / rate_hz_to).collect();
        let ratio = rate_hz_from / rate_hz_to;
        let bones = self.bones.par_iter().map(|bone| bone.sampled_at(&positions, ratio)).collect();
        Ok(Self { bones, first_frame: self.first_frame, frame_count, rate_hz: Some(rate_hz_to) })
    }

    /// How many frames of the new rate fit between the moments of the first and the last frame.
    fn frames_at(&self, rate_hz_from: f64, rate_hz_to: f64) -> Result<usize, ParameterError> {
        /// A frame that misses the last moment by less than this part of a frame is rounding, not motion.
        const SLACK_FRAMES: f64 = 1e-6;
        let Some(steps) = self.frame_count.checked_sub(1) else { return Ok(0) };
        let new_frames = (steps as f64 * rate_hz_to / rate_hz_from + SLACK_FRAMES).floor() + 1.0;
        let bones = self.bones.len().max(1);
        let most = MOST_POSES.max(bones.saturating_mul(self.frame_count));
        if new_frames * bones as f64 <= most as f64 {
            Ok(new_frames as usize)
        } else {
            Err(ParameterError(format!(
                "at {rate_hz_to} frames per second the motion would have {new_frames} frames of {bones} bones, \
                 more than memory can be expected to hold"
            )))
        }
    }
}

impl BoneMotion {
    fn sampled_at(&self, positions: &[f64], ratio: f64) -> Self {
        let mut angles = lowpass_angles(&self.angles, ratio);
        unwrap_angles(&mut angles);
        Self {
            rotations: sampled_at(&lowpass_rotations(&self.rotations, ratio), positions, sample_rotation),
            angles: sampled_at(&angles, positions, sample_angles),
            translations: sampled_at(&lowpass_vectors(&self.translations, ratio), positions, sample_vector),
            stretches: sampled_at(&lowpass_values(&self.stretches, ratio), positions, sample_value),
        }
    }
}

/// Samples a channel at many positions; an empty channel stays empty.
fn sampled_at<T>(samples: &[T], positions: &[f64], sample: fn(&[T], f64, Sampling) -> T) -> Vec<T> {
    if samples.is_empty() {
        return Vec::new();
    }
    positions.iter().map(|&x| sample(samples, x, Sampling::Smooth)).collect()
}
