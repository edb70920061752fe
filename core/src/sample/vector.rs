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
