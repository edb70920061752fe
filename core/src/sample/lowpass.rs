//! The low-pass before going down in rate: it removes what the lower rate cannot hold, which would otherwise come back
//! as a slow movement that was never made (aliasing).
//!
//! A windowed sinc: cut-off at [`CUTOFF`] of the new Nyquist frequency (half the new rate), Hamming window over
//! [`REACH`] samples of the new rate to each side. Below half of the new Nyquist frequency it changes amplitudes by
//! less than 0.5 %; above the new Nyquist frequency it leaves less than 0.3 % (-50 dB).
//!
//! Near the ends the window shrinks so that it stays centred, as in [`crate::filter`]: the first and the last sample
//! stay, and the filter grows gentler towards them. A constant stays constant to the last bit.

use std::f64::consts::{PI, TAU};

use glam::{DQuat, DVec3};

use super::align_hemispheres;
use crate::filter::components::by_component;
use crate::filter::unwrap_angles;
use crate::filter::window::{slide_along, symmetric_mean, symmetric_means, WindowKernel};

/// Where the filter has fallen to one half, as a part of the new Nyquist frequency.
const CUTOFF: f64 = 0.75;

/// How far the filter reaches to each side, in samples of the new rate.
const REACH: f64 = 8.0;

/// Returns the samples without what a rate lower by `ratio` (old rate / new rate) cannot hold.
///
/// A ratio up to 1, or one that is not finite, gives the samples back as they are.
pub fn lowpass_values(samples: &[f64], ratio: f64) -> Vec<f64> {
    let Some(kernel) = LowPass::new(samples.len(), ratio) else { return samples.to_vec() };
    let mut filtered = vec![0.0; samples.len()];
    slide_along(&kernel, samples, &mut filtered);
    filtered
}

/// As [`lowpass_values`], for each coordinate.
pub fn lowpass_vectors(samples: &[DVec3], ratio: f64) -> Vec<DVec3> {
    let Some(kernel) = LowPass::new(samples.len(), ratio) else { return samples.to_vec() };
    let coordinates: Vec<_> = samples.iter().map(DVec3::to_array).collect();
    let filtered = by_component(&coordinates, |channel, out| slide_along(&kernel, channel, out));
    filtered.into_iter().map(DVec3::from_array).collect()
}

/// As [`lowpass_values`], for each channel of angles in radians, [unwrapped](unwrap_angles).
pub fn lowpass_angles(samples: &[[f64; 3]], ratio: f64) -> Vec<[f64; 3]> {
    let Some(kernel) = LowPass::new(samples.len(), ratio) else { return samples.to_vec() };
    let mut unwrapped = samples.to_vec();
    unwrap_angles(&mut unwrapped);
    by_component(&unwrapped, |channel, out| slide_along(&kernel, channel, out))
}

/// As [`lowpass_values`], for rotations.
///
/// The four components are filtered after neighbours were brought into one hemisphere, then normalised: a joint that
/// turns at constant speed, however far, comes out as it went in.
pub fn lowpass_rotations(samples: &[DQuat], ratio: f64) -> Vec<DQuat> {
    let Some(kernel) = LowPass::new(samples.len(), ratio) else { return samples.to_vec() };
    let mut aligned = samples.to_vec();
    align_hemispheres(&mut aligned);
    let components: Vec<_> = aligned.iter().map(DQuat::to_array).collect();
    let filtered = by_component(&components, |channel, out| slide_along(&kernel, channel, out));
    for (rotation, sum) in aligned.iter_mut().zip(filtered) {
        let sum = DQuat::from_array(sum);
        let length = sum.length();
        // A still joint keeps its bits; a sum without direction says nothing, so the sample stays.
        if sum != *rotation && length.is_finite() && length > 0.0 {
            *rotation = sum / length;
        }
    }
    aligned
}

/// The filter for one ratio and number of samples.
struct LowPass {
    /// Radians per sample of the old rate.
    cutoff: f64,
    reach: usize,
    weights: Vec<f64>,
}

impl LowPass {
    /// `None` where nothing is to be removed.
    fn new(samples: usize, ratio: f64) -> Option<Self> {
        if samples < 3 || !ratio.is_finite() || ratio <= 1.0 {
            return None;
        }
        let cutoff = CUTOFF * PI / ratio;
        let reach = ((REACH * ratio).ceil() as usize).min((samples - 1) / 2);
        Some(Self { cutoff, reach, weights: sinc_weights(cutoff, reach) })
    }
}

impl WindowKernel for LowPass {
    fn reach(&self) -> usize {
        self.reach
    }

    #[inline(always)]
    fn full_windows(&self, values: &[f64], out: &mut [f64]) {
        symmetric_means(values, out, self.reach, &self.weights);
    }

    fn shrunk_window(&self, window: &[f64]) -> f64 {
        symmetric_mean(window, sinc_weights(self.cutoff, window.len() / 2))
    }
}

/// Returns the weights at distance 1, 2, ... of a sinc under a Hamming window; with that of the centre they sum to 1.
fn sinc_weights(cutoff: f64, reach: usize) -> Vec<f64> {
    let weight = |distance: usize| {
        let phase = cutoff * distance as f64;
        let taper = 0.54 + 0.46 * (TAU * distance as f64 / (2 * reach + 2) as f64).cos();
        taper * phase.sin() / phase
    };
    let mut weights: Vec<f64> = (1..=reach).map(weight).collect();
    let sum = 1.0 + 2.0 * weights.iter().sum::<f64>();
    for weight in &mut weights {
        *weight /= sum;
    }
    weights
}

#[cfg(test)]
mod tests {
    use super::super::angle_between;
    use super::*;

    const RATIOS: [f64; 4] = [1.25, 2.0, 4.0, 5.004];
    const SAMPLES: usize = 1000;

    /// A sine at a part of the Nyquist frequency of the new rate.
    fn sine(ratio: f64, part_of_new_nyquist: f64) -> Vec<f64> {
        let step = PI * part_of_new_nyquist / ratio;
        (0..SAMPLES).map(|sample| (0.3 + step * sample as f64).sin()).collect()
    }

    /// Where the window is whole.
    fn interior(ratio: f64) -> std::ops::Range<usize> {
        let reach = (REACH * ratio).ceil() as usize;
        reach..SAMPLES - reach
    }

    fn largest(values: impl Iterator<Item = f64>) -> f64 {
        values.map(f64::abs).fold(0.0, f64::max)
    }

    #[test]
    fn above_the_new_nyquist_frequency_less_than_a_hundredth_remains() {
        for ratio in RATIOS {
            for part in [1.0, 1.1, 1.2, ratio * 0.9, ratio].into_iter().filter(|&part| (1.0..=ratio).contains(&part)) {
                let remaining = lowpass_values(&sine(ratio, part), ratio);
                let amplitude = largest(remaining[interior(ratio)].iter().copied());
                assert!(amplitude < 0.003, "{part} of Nyquist at ratio {ratio}: {amplitude}");
            }
        }
    }

    #[test]
    fn below_half_of_the_new_nyquist_frequency_nothing_changes_by_a_hundredth() {
        for ratio in RATIOS {
            for part in [0.01, 0.1, 0.25, 0.4, 0.5] {
                let samples = sine(ratio, part);
                let filtered = lowpass_values(&samples, ratio);
                let differences = interior(ratio).map(|index| filtered[index] - samples[index]);
                assert!(largest(differences) < 0.005, "{part} of Nyquist at ratio {ratio}");
            }
        }
    }

    #[test]
    fn rotations_are_filtered_alike() {
        let ratio = 4.0;
        let swing =
            |angles: Vec<f64>| angles.into_iter().map(|angle| DQuat::from_rotation_x(0.1 * angle)).collect::<Vec<_>>();
        let trembling = lowpass_rotations(&swing(sine(ratio, 1.1)), ratio);
        let tremble = trembling[interior(ratio)].iter().map(|&rotation| angle_between(rotation, DQuat::IDENTITY));
        assert!(largest(tremble) < 0.1 * 0.01);
        let swinging = swing(sine(ratio, 0.4));
        let filtered = lowpass_rotations(&swinging, ratio);
        let differences = interior(ratio).map(|index| angle_between(filtered[index], swinging[index]));
        assert!(largest(differences) < 0.1 * 0.01);
    }

    #[test]
    fn a_joint_that_spins_at_constant_speed_comes_out_as_it_went_in() {
        let spinning: Vec<_> = (0..400).map(|frame| DQuat::from_rotation_y(f64::from(frame) * TAU / 30.0)).collect();
        for ratio in RATIOS {
            let filtered = lowpass_rotations(&spinning, ratio);
            let differences = filtered.iter().zip(&spinning).map(|(&a, &b)| angle_between(a, b));
            assert!(largest(differences) < 1e-13, "ratio {ratio}");
        }
    }

    #[test]
    fn angles_that_wrap_are_unwrapped_first() {
        let wrapped: Vec<_> = (0..100).map(|frame| [(f64::from(frame) * 0.2 + PI).rem_euclid(TAU) - PI; 3]).collect();
        for (frame, triple) in lowpass_angles(&wrapped, 3.0).into_iter().enumerate() {
            assert!(largest(triple.iter().map(|angle| angle - frame as f64 * 0.2)) < 1e-12);
        }
    }

    #[test]
    fn what_is_still_stays_to_the_last_bit() {
        let pose = DQuat::from_xyzw(0.1, 0.7, -0.3, 0.2).normalize();
        let place = DVec3::new(0.1, -17.3, 1e6 / 3.0);
        for ratio in RATIOS {
            assert_eq!(lowpass_rotations(&[pose; 60], ratio), [pose; 60]);
            assert_eq!(lowpass_vectors(&[place; 60], ratio), [place; 60]);
            assert_eq!(lowpass_values(&[0.1; 60], ratio), [0.1; 60]);
        }
    }

    #[test]
    fn the_first_and_the_last_sample_stay() {
        let samples = sine(4.0, 3.0);
        let filtered = lowpass_values(&samples, 4.0);
        assert_eq!((filtered[0], filtered[SAMPLES - 1]), (samples[0], samples[SAMPLES - 1]));
    }

    #[test]
    fn going_up_or_nowhere_changes_no_bit() {
        let samples = sine(1.0, 0.9);
        let rotations: Vec<_> = samples.iter().map(|&angle| -DQuat::from_rotation_z(angle)).collect();
        for ratio in [1.0, 0.5, 0.0, -3.0, f64::NAN, f64::INFINITY] {
            assert_eq!(lowpass_values(&samples, ratio), samples);
            assert_eq!(lowpass_rotations(&rotations, ratio), rotations);
        }
    }

    #[test]
    fn hardly_any_samples_absurd_ratios_and_values_that_are_no_numbers_do_not_panic() {
        for ratio in [1.0 + f64::EPSILON, 1e9, f64::MAX] {
            for samples in 0..6 {
                assert_eq!(lowpass_values(&vec![2.5; samples], ratio), vec![2.5; samples]);
                assert_eq!(lowpass_rotations(&vec![DQuat::IDENTITY; samples], ratio).len(), samples);
                assert!(lowpass_values(&vec![f64::NAN; samples], ratio).iter().all(|value| value.is_nan()));
            }
        }
    }
}
