//! The mean of a window.
//!
//! A running sum would drift, and would spread one value that is no number over all that follow. Here every result is
//! a sum of its own window's values only.

use std::iter::repeat;

use super::window::{map_windows, symmetric_mean, WindowKernel};

/// Mean over windows that reach so far to each side.
pub(super) struct Average {
    pub(super) reach: usize,
}

impl WindowKernel for Average {
    fn reach(&self) -> usize {
        self.reach
    }

    #[inline(always)]
    fn full_windows(&self, values: &[f64], out: &mut [f64]) {
        match self.reach {
            1 => map_windows(values, out, mean_of::<3>),
            2 => map_windows(values, out, mean_of::<5>),
            3 => map_windows(values, out, mean_of::<7>),
            reach => means_between_pivots(values, out, 2 * reach + 1),
        }
    }

    fn shrunk_window(&self, window: &[f64]) -> f64 {
        symmetric_mean(window, repeat(1.0 / window.len() as f64))
    }
}

/// Returns the weights of one side of a window, for [`symmetric_mean`].
pub(super) fn equal_weights(reach: usize) -> Vec<f64> {
    vec![1.0 / (2 * reach + 1) as f64; reach]
}

/// The centre plus the mean difference from it.
///
/// Exact where the window is constant: up to depth 7 the sum of its pairs rounds as the multiple of the centre does.
#[inline(always)]
fn mean_of<const D: usize>(window: [f64; D]) -> f64 {
    let centre = window[D / 2];
    let (before, after) = (&window[..D / 2], &window[D / 2 + 1..]);
    let pairs: f64 = before.iter().zip(after.iter().rev()).map(|(before, after)| before + after).sum();
    centre + (pairs - (D - 1) as f64 * centre) * (1.0 / D as f64)
}

/// Means of long windows in about three additions each.
///
/// Every `depth`-th value is a pivot; each window holds exactly one. Its sum is that of its values before the pivot,
/// which grows backwards from the pivot, plus that of the others, which grows forwards. Values are taken relative to
/// the pivot, so that constants are exact.
fn means_between_pivots(values: &[f64], out: &mut [f64], depth: usize) {
    let per_value = 1.0 / depth as f64;
    for (group, results) in out.chunks_mut(depth).enumerate() {
        // Windows that start in `start..start + depth` hold the value before `start + depth`, the pivot.
        let start = group * depth;
        let window_starts = &values[start..start + depth];
        let pivot = window_starts[depth - 1];

        let mut before = 0.0;
        for (index, value) in window_starts.iter().enumerate().rev() {
            before += value - pivot;
            if let Some(result) = results.get_mut(index) {
                *result = before;
            }
        }
        let mut after = 0.0;
        for (index, result) in results.iter_mut().enumerate() {
            if index > 0 {
                after += values[start + depth - 1 + index] - pivot;
            }
            *result = pivot + (*result + after) * per_value;
        }
    }
}
