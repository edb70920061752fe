//! Moving a window along one channel: what every filter shares.
//!
//! A channel is worked on in pieces that fit the second-level cache, by all cores. Besides sharing the arithmetic that
//! shares the first touch of the output's fresh pages, which for long channels costs more than the arithmetic.
//!
//! The kernels are plain loops that the compiler turns into vector instructions: two values at a time everywhere, four
//! where the processor has AVX2 (a weighted average of depth 7 over 27 million values: 49 ms and 29 ms on two cores).
//! Both are the same operations in the same order, so the results are the same to the last bit.

use rayon::prelude::*;

/// Frames per piece of work: 256 KiB of input and as much of output.
pub(crate) const PIECE: usize = 32 * 1024;

/// What stands for a centred window of values.
pub(crate) trait WindowKernel: Sync {
    /// How far a full window reaches to each side of its centre.
    fn reach(&self) -> usize;

    /// Fills `out` with the results of all full windows in `values`, which is longer by twice the reach.
    ///
    /// To be inlined always, with what it calls: only then is it compiled once for each width of vectors.
    fn full_windows(&self, values: &[f64], out: &mut [f64]);

    /// Returns the result of one window of odd length, not longer than a full one.
    fn shrunk_window(&self, window: &[f64]) -> f64;
}

/// Fills `out` with one result per value; near the ends windows shrink so that they stay centred.
pub(crate) fn slide_along(kernel: &impl WindowKernel, values: &[f64], out: &mut [f64]) {
    if values.len() <= PIECE {
        slide_over_piece(kernel, values, 0, out);
    } else {
        let pieces = out.par_chunks_mut(PIECE).enumerate();
        pieces.for_each(|(index, piece)| slide_over_piece(kernel, values, index * PIECE, piece));
    }
}

/// Fills `out` with the results of the frames from `start` on.
fn slide_over_piece(kernel: &impl WindowKernel, values: &[f64], start: usize, out: &mut [f64]) {
    let reach = kernel.reach();
    let end = start + out.len();
    let full_start = reach.clamp(start, end);
    let full_end = values.len().saturating_sub(reach).clamp(full_start, end);

    for frame in (start..full_start).chain(full_end..end) {
        let shrunk_reach = frame.min(values.len() - 1 - frame);
        out[frame - start] = kernel.shrunk_window(&values[frame - shrunk_reach..=frame + shrunk_reach]);
    }
    if full_start < full_end {
        let values = &values[full_start - reach..full_end + reach];
        full_windows_in_widest_vectors(kernel, values, &mut out[full_start - start..full_end - start]);
    }
}

/// Calls [`WindowKernel::full_windows`] as compiled for the widest vectors that this processor has.
fn full_windows_in_widest_vectors(kernel: &impl WindowKernel, values: &[f64], out: &mut [f64]) {
    #[cfg(target_arch = "x86_64")]
    if std::arch::is_x86_feature_detected!("avx2") {
        // SAFETY: the function is safe but for needing AVX2, which this processor was just found to have.
        unsafe { full_windows_in_avx2(kernel, values, out) };
        return;
    }
    kernel.full_windows(values, out);
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx2")]
fn full_windows_in_avx2(kernel: &impl WindowKernel, values: &[f64], out: &mut [f64]) {
    kernel.full_windows(values, out);
}

/// Fills `out` with a function of each window of `D` neighbours in `values`.
///
/// Slices of one length and an index below it: in this form the compiler sees that nothing can go out of bounds, and
/// puts neighbouring results into neighbouring lanes.
#[inline(always)]
pub(super) fn map_windows<const D: usize>(values: &[f64], out: &mut [f64], of_window: impl Fn([f64; D]) -> f64) {
    let count = out.len();
    let taps: [&[f64]; D] = std::array::from_fn(|tap| &values[tap..tap + count]);
    for index in 0..count {
        out[index] = of_window(std::array::from_fn(|tap| taps[tap][index]));
    }
}

/// Returns the centre of an odd window plus the weighted sum of the differences from it.
///
/// The weights are those at distance 1, 2, ... to both sides; the centre has what is missing to 1.
/// Equal to the plain weighted sum, but exact where the window is constant or evenly rising.
#[inline(always)]
pub(crate) fn symmetric_mean(window: &[f64], weights: impl IntoIterator<Item = f64>) -> f64 {
    let centre = window[window.len() / 2];
    let before = window[..window.len() / 2].iter().rev();
    let after = &window[window.len() / 2 + 1..];
    let mut shift = 0.0;
    for ((before, after), weight) in before.zip(after).zip(weights) {
        shift += weight * ((before + after) - 2.0 * centre);
    }
    centre + shift
}

/// [`symmetric_mean`] of every full window in `values`, for any number of weights.
#[inline(always)]
pub(crate) fn symmetric_means(values: &[f64], out: &mut [f64], reach: usize, weights: &[f64]) {
    /// Results kept in the first-level cache while one weight after the other is added.
    const BLOCK: usize = 1024;
    for (index, block) in out.chunks_mut(BLOCK).enumerate() {
        let start = index * BLOCK + reach;
        let around = |from: usize| &values[from..from + block.len()];
        let centres = around(start);
        let mut shifts = [0.0; BLOCK];
        for (distance, &weight) in (1..=reach).zip(weights) {
            let pairs = around(start - distance).iter().zip(around(start + distance));
            for ((shift, (before, after)), centre) in shifts.iter_mut().zip(pairs).zip(centres) {
                *shift += weight * ((before + after) - 2.0 * centre);
            }
        }
        for ((result, centre), shift) in block.iter_mut().zip(centres).zip(shifts) {
            *result = centre + shift;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::average::Average;
    use super::super::median::Median;
    use super::super::weighted::Weighted;
    use super::*;

    fn assert_same_bits_in_all_widths(kernel: &impl WindowKernel) {
        let values: Vec<f64> = (0..200).map(|i| (f64::from(i * i) * 0.618_034).fract() / 3.0).collect();
        let count = values.len() - 2 * kernel.reach();
        let (mut plain, mut widest) = (vec![0.0; count], vec![1.0; count]);
        kernel.full_windows(&values, &mut plain);
        full_windows_in_widest_vectors(kernel, &values, &mut widest);
        assert_eq!(plain, widest, "reach {}", kernel.reach());
    }

    #[test]
    fn vectors_of_every_width_give_the_same_bits() {
        for reach in [1, 2, 3, 4, 20] {
            assert_same_bits_in_all_widths(&Median { reach });
            assert_same_bits_in_all_widths(&Average { reach });
            assert_same_bits_in_all_widths(&Weighted::new(reach));
        }
    }
}
