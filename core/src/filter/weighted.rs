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
}

impl WindowKernel for Weighted {
    fn reach(&self) -> usize {
        self.reach
    }

    #[inline(always)]
    fn full_windows(&self, values: &[f64], out: &mut [f64]) {
        match self.reach {
            1 => map_windows(values, out, mean_of_3),
            2 => map_windows(values, out, mean_of_5),
            3 => map_windows(values, out, mean_of_7),
            reach => symmetric_means(values, out, reach, &self.weights),
        }
    }

    fn shrunk_window(&self, window: &[f64]) -> f64 {
        match *window {
            [a] => a,
            [a, b, c] => mean_of_3([a, b, c]),
            [a, b, c, d, e] => mean_of_5([a, b, c, d, e]),
            _ => symmetric_mean(window, pascal_weights(window.len() / 2)),
        }
    }
}

/// 1 2 1 over 4.
#[inline(always)]
fn mean_of_3(window: [f64; 3]) -> f64 {
    symmetric_mean(&window, [1.0 / 4.0])
}

/// 1 4 6 4 1 over 16.
#[inline(always)]
fn mean_of_5(window: [f64; 5]) -> f64 {
    symmetric_mean(&window, [4.0 / 16.0, 1.0 / 16.0])
}

/// 1 6 15 20 15 6 1 over 64.
#[inline(always)]
fn mean_of_7(window: [f64; 7]) -> f64 {
    symmetric_mean(&window, [15.0 / 64.0, 6.0 / 64.0, 1.0 / 64.0])
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
