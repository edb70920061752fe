//! Filters on channels of plain numbers.

use rayon::prelude::*;

use super::average::Average;
use super::median::Median;
use super::weighted::Weighted;
use super::window::{slide_along, WindowKernel, PIECE};
use super::{Depth, FilterKind};

/// Filters one channel, given frame after frame; the rule at the ends is the [module's](super).
///
/// ```
/// use motion_theater_core::filter::{filter_values, Depth, FilterKind};
///
/// let mut filtered = [0.0; 7];
/// let spike = [0.0, 0.0, 0.0, 16.0, 0.0, 0.0, 0.0];
/// filter_values(&spike, &mut filtered, FilterKind::Weighted, Depth::try_from(5)?);
/// assert_eq!(filtered, [0.0, 0.0, 4.0, 6.0, 4.0, 0.0, 0.0]);
/// # Ok::<(), motion_theater_core::ParameterError>(())
/// ```
///
/// (The second and the last but one are 0, not 1: their windows have shrunk to 3 values.)
///
/// # Panics
///
/// If `out` is not as long as `values`.
pub fn filter_values(values: &[f64], out: &mut [f64], kind: FilterKind, depth: Depth) {
    filter_channels(values, values.len(), out, kind, depth);
}

/// Filters channels of `frames` values each, one channel after the other.
///
/// All cores share the work, whether it is many channels or a long one.
///
/// # Panics
///
/// If `out` is not as long as `values`.
pub fn filter_channels(values: &[f64], frames: usize, out: &mut [f64], kind: FilterKind, depth: Depth) {
    let reach = depth.reach_within(frames);
    match kind {
        FilterKind::Median => slide_along_channels(&Median { reach }, values, frames, out),
        FilterKind::Average => slide_along_channels(&Average { reach }, values, frames, out),
        FilterKind::Weighted => slide_along_channels(&Weighted::new(reach), values, frames, out),
    }
}

fn slide_along_channels(kernel: &impl WindowKernel, values: &[f64], frames: usize, out: &mut [f64]) {
    assert_eq!(values.len(), out.len(), "one result per value");
    if frames == 0 {
        return;
    }
    if values.len() <= PIECE {
        // Waking other threads would take longer than the work.
        let channels = values.chunks(frames).zip(out.chunks_mut(frames));
        channels.for_each(|(channel, out)| slide_along(kernel, channel, out));
    } else {
        let channels = values.par_chunks(frames).zip(out.par_chunks_mut(frames));
        let per_thread = (PIECE / frames).max(1);
        channels.with_min_len(per_thread).for_each(|(channel, out)| slide_along(kernel, channel, out));
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::super::naive;
    use super::*;

    const KINDS: [FilterKind; 3] = [FilterKind::Median, FilterKind::Average, FilterKind::Weighted];

    /// Sums of `depth` terms of size 1000 round by less than `depth * 1000 * 2^-52`; for depths up to 61, below this.
    const ROUNDING: f64 = 2e-11;

    fn depth(depth: usize) -> Depth {
        Depth::try_from(depth).unwrap()
    }

    fn filtered(values: &[f64], kind: FilterKind, of_depth: usize) -> Vec<f64> {
        let mut out = vec![f64::NAN; values.len()];
        filter_values(values, &mut out, kind, depth(of_depth));
        out
    }

    /// Noise that needs no seed: the fractional parts of multiples of the golden ratio, shuffled by squaring.
    fn noise(count: usize) -> Vec<f64> {
        (0..count).map(|i| ((i * i) as f64 * 0.618_033_988_749_894_9).fract() * 2.0 - 1.0).collect()
    }

    fn largest_difference(a: &[f64], b: &[f64]) -> f64 {
        assert_eq!(a.len(), b.len());
        a.iter().zip(b).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
    }

    #[test]
    fn weighted_average_of_depth_5_is_1_4_6_4_1_over_16() {
        let mut spike = [0.0; 9];
        spike[4] = 16.0;
        assert_eq!(filtered(&spike, FilterKind::Weighted, 5), [0.0, 0.0, 1.0, 4.0, 6.0, 4.0, 1.0, 0.0, 0.0]);
    }

    #[test]
    fn average_spreads_a_spike_evenly() {
        let mut spike = [0.0; 9];
        spike[4] = 7.0;
        // Towards the ends the windows that still hold the spike have shrunk to 5 values, the next ones miss it.
        let expected = [0.0, 0.0, 1.4, 1.0, 1.0, 1.0, 1.4, 0.0, 0.0];
        assert!(largest_difference(&filtered(&spike, FilterKind::Average, 7), &expected) < 1e-15);
    }

    #[test]
    fn median_removes_a_spike_and_keeps_an_edge() {
        let values = [1.0, 1.0, 9.0, 1.0, 1.0, 5.0, 5.0, 5.0];
        assert_eq!(filtered(&values, FilterKind::Median, 3), [1.0, 1.0, 1.0, 1.0, 1.0, 5.0, 5.0, 5.0]);
    }

    #[test]
    fn windows_shrink_towards_the_ends() {
        let values = [8.0, 0.0, 4.0, 0.0, 2.0];
        assert_eq!(filtered(&values, FilterKind::Median, 7), [8.0, 4.0, 2.0, 2.0, 2.0]);
        assert_eq!(filtered(&values, FilterKind::Average, 7), [8.0, 4.0, 2.8, 2.0, 2.0]);
        assert_eq!(filtered(&values, FilterKind::Weighted, 7), [8.0, 3.0, 2.125, 1.5, 2.0]);
    }

    #[test]
    fn nothing_and_one_value_stay() {
        for kind in KINDS {
            for depth in [3, 5, 7, 1001, usize::MAX] {
                assert_eq!(filtered(&[], kind, depth), [0.0; 0]);
                assert_eq!(filtered(&[0.5], kind, depth), [0.5]);
            }
        }
    }

    #[test]
    fn a_depth_of_1001_neither_overflows_nor_drifts() {
        let values = noise(1101);
        for kind in KINDS {
            let difference =
                largest_difference(&filtered(&values, kind, 1001), &naive::filter_values(&values, kind, depth(1001)));
            assert!(difference < 1e-12, "{kind:?}: {difference:e}");
        }
    }

    #[test]
    fn a_depth_beyond_all_memory_is_the_largest_window_that_fits() {
        let values = noise(51);
        for kind in KINDS {
            assert_eq!(filtered(&values, kind, usize::MAX), filtered(&values, kind, 51));
        }
    }

    #[test]
    fn the_seams_between_pieces_of_a_long_channel_do_not_show() {
        let values = noise(2 * PIECE + 1000);
        for kind in KINDS {
            for of_depth in [3, 7, 9, 101] {
                let whole = filtered(&values, kind, of_depth);
                let start = PIECE - 500;
                let around_seam = filtered(&values[start..start + 1000], kind, of_depth);
                let inside = of_depth..1000 - of_depth;
                let difference = largest_difference(&whole[start..][inside.clone()], &around_seam[inside]);
                assert!(difference < 1e-14, "{kind:?} {of_depth}: {difference:e}");
            }
        }
    }

    #[test]
    fn channels_do_not_touch_each_other() {
        for (channels, frames) in [(7, 11), (300, 267), (3, PIECE + 5)] {
            let values = noise(channels * frames);
            for kind in KINDS {
                let mut out = vec![f64::NAN; values.len()];
                filter_channels(&values, frames, &mut out, kind, depth(5));
                for (channel, result) in values.chunks(frames).zip(out.chunks(frames)) {
                    assert_eq!(result, filtered(channel, kind, 5));
                }
            }
        }
    }

    #[test]
    fn values_that_are_no_numbers_stay_within_their_windows() {
        for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            for kind in KINDS {
                for of_depth in [3, 5, 7, 9, 21] {
                    let mut values = noise(100);
                    let clean = filtered(&values, kind, of_depth);
                    values[50] = bad;
                    let result = filtered(&values, kind, of_depth);
                    let reach = of_depth / 2;
                    let outside = |frame: &usize| frame.abs_diff(50) > reach;
                    for frame in (0..100).filter(outside) {
                        assert!((result[frame] - clean[frame]).abs() < 1e-14, "{kind:?} {of_depth} {frame}");
                    }
                }
            }
        }
    }

    fn any_depth() -> impl Strategy<Value = usize> {
        prop_oneof![Just(3), Just(5), Just(7), (1..30_usize).prop_map(|reach| 2 * reach + 1)]
    }

    fn any_values() -> impl Strategy<Value = Vec<f64>> {
        prop::collection::vec(-1000.0..1000.0, 0..200)
    }

    proptest! {
        #[test]
        fn fast_equals_clear(values in any_values(), depth_asked in any_depth()) {
            for kind in KINDS {
                let fast = filtered(&values, kind, depth_asked);
                let clear = naive::filter_values(&values, kind, depth(depth_asked));
                let difference = largest_difference(&fast, &clear);
                prop_assert!(difference < ROUNDING, "{:?}: {:e}", kind, difference);
            }
        }

        #[test]
        fn a_median_is_a_value_of_its_window(values in any_values(), depth_asked in any_depth()) {
            let medians = filtered(&values, FilterKind::Median, depth_asked);
            prop_assert_eq!(medians, naive::filter_values(&values, FilterKind::Median, depth(depth_asked)));
        }

        #[test]
        fn constants_stay_to_the_last_bit(value in prop::num::f64::NORMAL, count in 0..200_usize, depth in any_depth()) {
            prop_assume!(value.abs() < 1e307);
            for kind in KINDS {
                let values = vec![value; count];
                prop_assert_eq!(filtered(&values, kind, depth), values);
            }
        }

        #[test]
        fn even_ramps_stay(start in -1000.0..1000.0, step in -10.0..10.0, depth in any_depth()) {
            let ramp: Vec<f64> = (0..100).map(|frame| start + step * f64::from(frame)).collect();
            for kind in KINDS {
                prop_assert!(largest_difference(&filtered(&ramp, kind, depth), &ramp) < ROUNDING);
            }
        }

        #[test]
        fn results_lie_between_the_smallest_and_the_largest_value(values in any_values(), depth in any_depth()) {
            let smallest = values.iter().copied().fold(f64::INFINITY, f64::min) - ROUNDING;
            let largest = values.iter().copied().fold(f64::NEG_INFINITY, f64::max) + ROUNDING;
            for kind in KINDS {
                prop_assert!(filtered(&values, kind, depth).iter().all(|value| (smallest..=largest).contains(value)));
            }
        }
    }
}
