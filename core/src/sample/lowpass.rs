//! The low-pass before going down in rate: it removes what the lower rate cannot hold, which would otherwise come back
//! as a slow movement that was never made (aliasing).
//!
//! A windowed sinc: cut-off at [`CUTOFF`] of the new Nyquist frequency (half the new rate), Hamming window over
//! [`REACH`] samples of the new rate to each side. Below half of the new Nyquist frequency it changes amplitudes by
//! less than 0.3 %; above the new Nyquist frequency it leaves less than 0.3 % (-50 dB).
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

    fn full_windows(&self, values: &[f64], out: &mut [f64]) {
        symmetric_means(values, out, self.reach, &self.weights);
    }

    fn shrunk_window(&self, window: &[f64]) -> f64 {
        symmetric_mean(window, &sinc_weights(self.cutoff, window.len() / 2))
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
    weights.iter_mut().for_each(|weight| *weight /= sum);
    weights
}
