//! Values between frames, and other rates.
//!
//! Samples lie on whole numbers: the value at `x` = 2.25 is a quarter of the way from sample 2 to sample 3. At a whole
//! `x` every function returns the stored value itself, bit for bit. Before the first and after the last sample the end
//! value holds. Nothing panics: of no samples the result is zero or the identity, and an `x` that is no number counts
//! as 0.

mod lowpass;
mod resample;
mod rotation;
mod vector;

pub use lowpass::{lowpass_angles, lowpass_rotations, lowpass_values, lowpass_vectors};
pub(crate) use resample::nearest_frame;
pub use rotation::{align_hemispheres, angle_between, sample_rotation, slerp};
pub use vector::{sample_angles, sample_value, sample_vector};

use serde::{Deserialize, Serialize};

/// How to go from one sample to the next.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Hash, Serialize, Deserialize)]
#[serde(rename_all = "UPPERCASE")]
pub enum Sampling {
    /// In a straight line; rotations by slerp on the shorter arc.
    #[default]
    Linear,
    /// Without a kink: a cubic through the samples, rotations likewise.
    Smooth,
}

/// Splits `x` into the sample before it and the fraction of the way to the next; `None` if there are no samples.
/// The fraction is below 1, and 0 on the last sample.
fn split_index(samples: usize, x: f64) -> Option<(usize, f64)> {
    let last = samples.checked_sub(1)?;
    // `max` before `min`: it is the one that turns NaN into a number.
    let x = x.max(0.0).min(last as f64);
    Some((x as usize, x.fract()))
}

#[cfg(test)]
mod tests {
    use super::split_index;

    #[test]
    fn an_index_is_held_between_the_ends() {
        assert_eq!(split_index(3, -4.5), Some((0, 0.0)));
        assert_eq!(split_index(3, 1.25), Some((1, 0.25)));
        assert_eq!(split_index(3, 2.0), Some((2, 0.0)));
        assert_eq!(split_index(3, 2.5), Some((2, 0.0)));
        assert_eq!(split_index(3, f64::INFINITY), Some((2, 0.0)));
    }

    #[test]
    fn an_index_that_is_no_number_counts_as_0() {
        assert_eq!(split_index(3, f64::NAN), Some((0, 0.0)));
    }

    #[test]
    fn no_samples_have_no_index() {
        assert_eq!(split_index(0, 0.0), None);
    }
}
