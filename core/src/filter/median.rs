//! The middle of a window.
//!
//! Depths 3, 5 and 7 are selection networks: a fixed list of compare-and-swaps without branches, several windows at a
//! time in vector registers. Larger depths keep the window sorted while it moves.

use super::window::{map_windows, WindowKernel};

/// Median over windows that reach so far to each side.
pub(super) struct Median {
    pub(super) reach: usize,
}

impl WindowKernel for Median {
    fn reach(&self) -> usize {
        self.reach
    }

    #[inline(always)]
    fn full_windows(&self, values: &[f64], out: &mut [f64]) {
        match self.reach {
            1 => map_windows(values, out, median_of_3),
            2 => map_windows(values, out, median_of_5),
            3 => map_windows(values, out, median_of_7),
            reach => medians_of_sorted_window(values, out, reach),
        }
    }

    fn shrunk_window(&self, window: &[f64]) -> f64 {
        match *window {
            [a] => a,
            [a, b, c] => median_of_3([a, b, c]),
            [a, b, c, d, e] => median_of_5([a, b, c, d, e]),
            _ => *window.to_vec().select_nth_unstable_by(window.len() / 2, f64::total_cmp).1,
        }
    }
}

/// Returns the smaller and the larger of two values: one vector instruction each.
///
/// Where either is not a number the two trade places, so that no value of a window is ever lost or doubled.
#[inline(always)]
fn sorted(a: f64, b: f64) -> (f64, f64) {
    (if a < b { a } else { b }, if b > a { b } else { a })
}

#[inline(always)]
fn median_of_3([a, b, c]: [f64; 3]) -> f64 {
    let (low, high) = sorted(a, b);
    let (smaller, _) = sorted(high, c);
    sorted(low, smaller).1
}

/// Sorts two pairs, drops the smallest and the largest of the four, and takes the median of the three that remain.
#[inline(always)]
fn median_of_5([a, b, c, d, e]: [f64; 5]) -> f64 {
    let (a, b) = sorted(a, b);
    let (c, d) = sorted(c, d);
    let (_, low) = sorted(a, c);
    let (high, _) = sorted(b, d);
    median_of_3([low, high, e])
}

/// Drops the smallest and the largest of six, and takes the median of the five that remain.
#[inline(always)]
fn median_of_7([a, b, c, d, e, f, g]: [f64; 7]) -> f64 {
    let (a, b) = sorted(a, b);
    let (c, d) = sorted(c, d);
    let (e, f) = sorted(e, f);
    let (least, a) = sorted(a, c);
    let (_, e) = sorted(least, e);
    let (b, greatest) = sorted(b, d);
    let (f, _) = sorted(f, greatest);
    median_of_5([a, b, e, f, g])
}

fn medians_of_sorted_window(values: &[f64], out: &mut [f64], reach: usize) {
    let depth = 2 * reach + 1;
    let Some(first_window) = values.get(..depth) else { return };
    let mut sorted = first_window.to_vec();
    sorted.sort_unstable_by(f64::total_cmp);
    let leaving = values.iter();
    let entering = values[depth..].iter().map(Some).chain([None]);
    for ((result, &leaving), entering) in out.iter_mut().zip(leaving).zip(entering) {
        *result = sorted[reach];
        if let Some(&entering) = entering {
            replace_in_sorted(&mut sorted, leaving, entering);
        }
    }
}

/// Replaces a value that is in the sorted list by another, moving only what lies between the two.
fn replace_in_sorted(sorted: &mut [f64], leaving: f64, entering: f64) {
    let rank = |value: f64| sorted.partition_point(|other| other.total_cmp(&value).is_lt());
    let (hole, place) = (rank(leaving), rank(entering));
    if place > hole {
        sorted.copy_within(hole + 1..place, hole);
        sorted[place - 1] = entering;
    } else {
        sorted.copy_within(place..hole, place + 1);
        sorted[place] = entering;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Zeros and ones in every arrangement prove a network for all values (the 0-1 principle).
    fn assert_selects_the_middle<const D: usize>(network: impl Fn([f64; D]) -> f64) {
        for bits in 0..1_usize << D {
            let window: [f64; D] = std::array::from_fn(|place| f64::from(bits >> place & 1 == 1));
            let expected = f64::from(bits.count_ones() as usize > D / 2);
            assert_eq!(network(window), expected, "{window:?}");
        }
    }

    #[test]
    fn networks_select_the_middle() {
        assert_selects_the_middle(median_of_3);
        assert_selects_the_middle(median_of_5);
        assert_selects_the_middle(median_of_7);
    }

    #[test]
    fn networks_give_a_value_of_the_window_even_if_some_are_no_numbers() {
        let window = [1.0, f64::NAN, 3.0, f64::NAN, 5.0, 6.0, f64::NAN];
        let median = median_of_7(window);
        assert!(window.iter().any(|value| value.to_bits() == median.to_bits()));
    }

    #[test]
    fn a_sorted_window_stays_sorted_when_a_value_is_replaced() {
        for leaving in [1.0, 2.0, 3.0] {
            for entering in [0.0, 1.0, 1.5, 2.0, 2.5, 3.0, 4.0, f64::NAN] {
                let mut sorted = [1.0, 2.0, 3.0];
                let mut expected = sorted.map(|value| if value == leaving { entering } else { value });
                expected.sort_by(f64::total_cmp);
                replace_in_sorted(&mut sorted, leaving, entering);
                assert_eq!(sorted.map(f64::to_bits), expected.map(f64::to_bits), "{leaving} by {entering}");
            }
        }
    }
}
