//! Numbers, positions and angles between frames.

use std::ops::{Add, Mul, Sub};

use glam::DVec3;

use super::{split_index, Sampling};

/// Returns the value at a real-valued index; 0 if there are no samples. Smooth: the Catmull-Rom spline.
pub fn sample_value(samples: &[f64], x: f64, sampling: Sampling) -> f64 {
    sample(samples.len(), x, sampling, |index| samples[index]).unwrap_or_default()
}

/// Returns the vector at a real-valued index; zero if there are no samples. Smooth: the Catmull-Rom spline.
pub fn sample_vector(samples: &[DVec3], x: f64, sampling: Sampling) -> DVec3 {
    sample(samples.len(), x, sampling, |index| samples[index]).unwrap_or_default()
}

/// Returns three angles at a real-valued index, each channel by itself; zeros if there are no samples.
/// Smooth: the Catmull-Rom spline.
///
/// The channels are taken as they are: [unwrap](crate::filter::unwrap_angles) them first where they may jump by turns.
pub fn sample_angles(samples: &[[f64; 3]], x: f64, sampling: Sampling) -> [f64; 3] {
    sample(samples.len(), x, sampling, |index| DVec3::from_array(samples[index])).unwrap_or_default().to_array()
}

fn sample<T>(samples: usize, x: f64, sampling: Sampling, at: impl Fn(usize) -> T) -> Option<T>
where
    T: Copy + Default + Add<Output = T> + Sub<Output = T> + Mul<f64, Output = T>,
{
    let (index, fraction) = split_index(samples, x)?;
    let from = at(index);
    if fraction == 0.0 {
        return Some(from);
    }
    let to = at(index + 1);
    let step = to - from;
    let straight = from + step * fraction;
    Some(match sampling {
        Sampling::Linear => straight,
        Sampling::Smooth => {
            // How much the step grows at either end; none at the motion's own ends, which are left in a straight line.
            let growth_from = index.checked_sub(1).map_or_else(T::default, |before| step - (from - at(before)));
            let growth_to = if index + 2 < samples { (at(index + 2) - to) - step } else { T::default() };
            // Hermite's cubic with the mean of the neighbouring steps as its slopes, as a bend off the straight line.
            let rest = 1.0 - fraction;
            straight - (growth_from * rest + growth_to * fraction) * (0.5 * fraction * rest)
        }
    })
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    const SAMPLINGS: [Sampling; 2] = [Sampling::Linear, Sampling::Smooth];

    #[test]
    fn linear_goes_straight() {
        assert_eq!(sample_value(&[1.0, 5.0], 0.25, Sampling::Linear), 2.0);
        assert_eq!(sample_vector(&[DVec3::ZERO, DVec3::X], 0.5, Sampling::Linear), DVec3::new(0.5, 0.0, 0.0));
        assert_eq!(sample_angles(&[[0.0, 2.0, -4.0], [1.0, 4.0, 0.0]], 0.5, Sampling::Linear), [0.5, 3.0, -2.0]);
    }

    #[test]
    fn smooth_follows_a_parabola_inside() {
        let parabola: Vec<f64> = (0..6).map(|frame| f64::from(frame * frame)).collect();
        assert_eq!(sample_value(&parabola, 2.5, Sampling::Smooth), 6.25);
        assert_eq!(sample_value(&parabola, 3.25, Sampling::Smooth), 10.5625);
    }

    #[test]
    fn of_no_samples_the_value_is_zero() {
        for sampling in SAMPLINGS {
            assert_eq!(sample_value(&[], 1.0, sampling), 0.0);
            assert_eq!(sample_vector(&[], 1.0, sampling), DVec3::ZERO);
            assert_eq!(sample_angles(&[], f64::NAN, sampling), [0.0; 3]);
        }
    }

    proptest! {
        #[test]
        fn at_samples_the_value_is_the_sample(samples in prop::collection::vec(any::<f64>(), 1..9)) {
            for sampling in SAMPLINGS {
                for (index, sample) in samples.iter().enumerate() {
                    prop_assert_eq!(sample_value(&samples, index as f64, sampling).to_bits(), sample.to_bits());
                }
            }
        }

        #[test]
        fn before_and_after_the_samples_the_ends_hold(samples in prop::collection::vec(-9.0..9.0, 1..9), far in 0.0..1e9_f64) {
            for sampling in SAMPLINGS {
                prop_assert_eq!(sample_value(&samples, -far, sampling), samples[0]);
                let beyond = (samples.len() - 1) as f64 + far;
                prop_assert_eq!(Some(&sample_value(&samples, beyond, sampling)), samples.last());
            }
        }

        #[test]
        fn constants_stay_to_the_last_bit(value in -1e9..1e9, x in 0.0..4.0) {
            for sampling in SAMPLINGS {
                prop_assert_eq!(sample_value(&[value; 5], x, sampling), value);
            }
        }
    }
}
