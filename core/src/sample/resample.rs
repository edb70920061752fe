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
    /// Frame `k` of the result shows the moment `k / rate_hz_to` seconds after the first frame. The last one is nearest to
    /// the moment of the old last frame, so the duration stays to half a frame; what lies behind that moment shows it, as
    /// on the stack. Between samples values follow
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

    /// How many frames of the new rate there are up to the one nearest to the moment of the last frame.
    fn frames_at(&self, rate_hz_from: f64, rate_hz_to: f64) -> Result<usize, ParameterError> {
        let Some(steps) = self.frame_count.checked_sub(1) else { return Ok(0) };
        let new_frames = nearest_frame(steps as f64 * rate_hz_to / rate_hz_from) + 1.0;
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

/// Returns the whole frame nearest to a moment in frames, the earlier one of two.
pub(crate) fn nearest_frame(moment: f64) -> f64 {
    /// What differs by less than this part of a frame is the same moment, rounded.
    const SLACK_FRAMES: f64 = 1e-6;
    (moment - SLACK_FRAMES).round()
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

#[cfg(test)]
mod tests {
    use glam::{DQuat, DVec3};

    use super::*;
    use crate::sample::angle_between;

    /// A joint that swings once in two seconds while its start moves along.
    fn swing(frame_count: usize, rate_hz: f64) -> Motion {
        let angle = |frame: usize| 0.8 * (frame as f64 / rate_hz * std::f64::consts::PI).sin();
        let swinging = BoneMotion {
            rotations: (0..frame_count).map(|frame| DQuat::from_rotation_x(angle(frame))).collect(),
            angles: (0..frame_count).map(|frame| [angle(frame), 0.0, 0.0]).collect(),
            translations: (0..frame_count).map(|frame| DVec3::new(frame as f64 / rate_hz, 0.0, 0.0)).collect(),
            stretches: vec![0.25; frame_count],
        };
        let bones = vec![swinging, BoneMotion::default()];
        Motion { bones, first_frame: 17, frame_count, rate_hz: Some(rate_hz) }
    }

    fn refusal(motion: &Motion, rate_hz: f64) -> String {
        motion.resampled(rate_hz).unwrap_err().to_string()
    }

    #[test]
    fn its_own_rate_changes_no_bit() {
        let motion = swing(50, 120.0);
        assert_eq!(motion.resampled(120.0), Ok(motion));
    }

    #[test]
    fn frames_show_the_same_moments() {
        for rate_hz in [24.0, 25.0, 29.97, 60.0, 119.0, 240.0, 1000.0] {
            let motion = swing(601, 120.0).resampled(rate_hz).unwrap();
            let direct = swing(motion.frame_count, rate_hz);
            assert_eq!((motion.first_frame, motion.rate_hz), (17, Some(rate_hz)));
            assert_eq!(motion.frame_count, (5.0 * rate_hz).round() as usize + 1);
            assert_eq!(motion.bones[1], BoneMotion::default());
            let (bone, expected) = (&motion.bones[0], &direct.bones[0]);
            assert_eq!(bone.stretches, expected.stretches);
            for frame in (0..motion.frame_count).take_while(|frame| *frame as f64 <= 5.0 * rate_hz) {
                assert!(angle_between(bone.rotations[frame], expected.rotations[frame]) < 1e-3, "{rate_hz} {frame}");
                assert!((bone.angles[frame][0] - expected.angles[frame][0]).abs() < 1e-3);
                assert!(bone.translations[frame].distance(expected.translations[frame]) < 1e-9);
            }
        }
    }

    #[test]
    fn the_last_frame_is_nearest_to_the_last_moment_and_shows_it() {
        // 99 frames of 120 Hz are 0.825 s: at 24 Hz 19.8 frames, at 23 Hz 18.975, at 10 Hz 8.25, at 20 Hz 16.5.
        for (rate_hz, last) in [(24.0, 20), (23.0, 19), (10.0, 8), (20.0, 16), (240.0, 198)] {
            assert_eq!(swing(100, 120.0).resampled(rate_hz).unwrap().frame_count, last + 1, "{rate_hz}");
        }
        let slower = swing(100, 120.0).resampled(24.0).unwrap();
        assert_eq!(slower.bones[0].translations.last(), swing(100, 120.0).bones[0].translations.last());
    }

    #[test]
    fn going_up_by_a_whole_factor_keeps_every_sample() {
        let motion = swing(40, 60.0);
        let finer = motion.resampled(180.0).unwrap();
        assert_eq!(finer.frame_count, 39 * 3 + 1);
        for frame in 0..40 {
            assert_eq!(finer.bones[0].rotations[3 * frame], motion.bones[0].rotations[frame]);
            assert_eq!(finer.bones[0].translations[3 * frame], motion.bones[0].translations[frame]);
        }
    }

    #[test]
    fn no_frames_and_one_frame_stay() {
        for frames in [0, 1] {
            let mut expected = swing(frames, 30.0);
            expected.rate_hz = Some(24.0);
            assert_eq!(swing(frames, 30.0).resampled(24.0), Ok(expected));
        }
    }

    #[test]
    fn rates_without_sense_are_refused_in_words() {
        let motion = swing(50, 120.0);
        assert_eq!(refusal(&motion, 0.0), "a rate is a number of frames per second above 0, not 0");
        assert_eq!(refusal(&motion, f64::NAN), "a rate is a number of frames per second above 0, not NaN");
        assert_eq!(refusal(&motion, f64::INFINITY), "a rate is a number of frames per second above 0, not inf");
        let unknown = Motion { rate_hz: None, ..motion };
        assert_eq!(refusal(&unknown, 24.0), "the motion does not say its rate, so it cannot be brought to another");
    }

    #[test]
    fn a_rate_that_would_fill_the_memory_is_refused_in_words() {
        let words = "at 1000000000 frames per second the motion would have 1000000001 frames of 2 bones, \
                     more than memory can be expected to hold";
        assert_eq!(refusal(&swing(121, 120.0), 1e9), words);
        assert!(swing(121, 1e-300).resampled(1e300).is_err());
    }

    #[test]
    fn a_rate_far_below_leaves_the_first_frame() {
        let motion = swing(121, 120.0).resampled(1e-6).unwrap();
        assert_eq!(motion.frame_count, 1);
        assert_eq!(motion.bones[0].rotations, swing(1, 120.0).bones[0].rotations);
    }
}
