//! Moving a window along one channel: what every filter shares.
//!
//! A channel is worked on in pieces that fit the second-level cache, by all cores. Besides sharing the arithmetic that
//! shares the first touch of the output's fresh pages, which for long channels costs more than the arithmetic.

use rayon::prelude::*;

/// Frames per piece of work: 256 KiB of input and as much of output.
pub(crate) const PIECE: usize = 32 * 1024;

/// What stands for a centred window of values.
pub(crate) trait WindowKernel: Sync {
    /// How far a full window reaches to each side of its centre.
    fn reach(&self) -> usize;

    /// Fills `out` with the results of all full windows in `values`, which is longer by twice the reach.
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
        kernel.full_windows(
            &values[full_start - reach..full_end + reach],
            &mut out[full_start - start..full_end - start],
        );
    }
}

/// Fills `out` with a function of each window of `D` neighbours in `values`.
///
/// Written so that the compiler turns it into vector instructions: neighbouring results in neighbouring lanes.
#[inline]
pub(super) fn map_windows<const D: usize>(values: &[f64], out: &mut [f64], of_window: impl Fn([f64; D]) -> f64) {
    let count = out.len();
    let taps: [&[f64]; D] = std::array::from_fn(|tap| &values[tap..tap + count]);
    for (index, result) in out.iter_mut().enumerate() {
        *result = of_window(std::array::from_fn(|tap| taps[tap][index]));
    }
}

/// Returns the centre of an odd window plus the weighted sum of the differences from it.
///
/// `weights[k]` counts for the two values at distance `k + 1`; the centre has what is missing to 1.
/// Equal to the plain weighted sum, but exact where the window is constant or evenly rising.
#[inline]
pub(crate) fn symmetric_mean(window: &[f64], weights: &[f64]) -> f64 {
    let centre = window.len() / 2;
    let before = window[..centre].iter().rev();
    let after = &window[centre + 1..];
    let shift: f64 = before.zip(after).zip(weights).map(|((a, b), w)| w * ((a + b) - 2.0 * window[centre])).sum();
    window[centre] + shift
}

/// [`symmetric_mean`] of every full window in `values`, for any number of weights.
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
