//! The mean weighted by a row of Pascal's triangle.

use super::window::{map_windows, symmetric_mean, symmetric_means, WindowKernel};

/// Weights below this cannot change a sum of 53-bit numbers of like size; they are left out.
/// Thus a depth of 1001 costs 141 weights to a side instead of 500.
const NEGLIGIBLE_WEIGHT: f64 = 1e-20;

/// Weighted mean over windows that reach so far to each side.
pub(super) struct Weighted {
    reach: usize,
    weights: Vec<f64>,
}

impl Weighted {
    pub(super) fn new(reach: usize) -> Self {
        Self { reach, weights: pascal_weights(reach) }
    }

    #[inline]
    fn mean_of<const D: usize>(weights: [f64; 3], window: [f64; D]) -> f64 {
        let centre = window[D / 2];
        let mut shift = 0.0;
        for distance in 1..=D / 2 {
            shift += weights[distance - 1] * ((window[D / 2 - distance] + window[D / 2 + distance]) - 2.0 * centre);
        }
        centre + shift
    }
}

impl WindowKernel for Weighted {
    fn reach(&self) -> usize {
        self.reach
    }

    fn full_windows(&self, values: &[f64], out: &mut [f64]) {
        match *self.weights {
            [a] => map_windows(values, out, |window: [f64; 3]| Self::mean_of([a, 0.0, 0.0], window)),
            [a, b] => map_windows(values, out, |window: [f64; 5]| Self::mean_of([a, b, 0.0], window)),
            [a, b, c] => map_windows(values, out, |window: [f64; 7]| Self::mean_of([a, b, c], window)),
            _ => symmetric_means(values, out, self.reach, &self.weights),
        }
    }

    fn shrunk_window(&self, window: &[f64]) -> f64 {
        symmetric_mean(window, &pascal_weights(window.len() / 2))
    }
}

/// Returns the weights at distance 1, 2, ... from the middle of row `2 * reach` of Pascal's triangle, over its sum.
///
/// The row is walked from its middle outwards, each weight from the last; nothing overflows however long the row is.
/// Up to depth 51 every product and quotient is exact.
pub(super) fn pascal_weights(reach: usize) -> Vec<f64> {
    // binomial(2r, r) / 4^r = 1/2 * 3/4 * 5/6 * ...
    let middle = (1..=reach).fold(1.0, |weight, k| weight * (2 * k - 1) as f64 / (2 * k) as f64);
    let outwards = (1..=reach).scan(middle, |weight, k| {
        *weight = *weight * (reach - k + 1) as f64 / (reach + k) as f64;
        Some(*weight)
    });
    outwards.take_while(|&weight| weight > NEGLIGIBLE_WEIGHT).collect()
}

#[cfg(test)]
mod tests {
    use super::super::naive::pascal_row;
    use super::*;

    #[test]
    fn rows_are_pascals_exactly_while_they_fit_53_bits() {
        for reach in 1..=25 {
            assert_eq!(pascal_weights(reach), pascal_row(2 * reach + 1)[reach + 1..], "depth {}", 2 * reach + 1);
        }
    }

    #[test]
    fn long_rows_are_pascals_up_to_rounding_and_negligible_tails() {
        for reach in [26, 100, 500, 5000] {
            let row = &pascal_row(2 * reach + 1)[reach + 1..];
            let weights = pascal_weights(reach);
            let rounding = row[0] * 1e-12;
            assert!(weights.iter().zip(row).all(|(weight, expected)| (weight - expected).abs() < rounding));
            assert!(row[weights.len()..].iter().sum::<f64>() < 1e-17);
        }
    }
}
