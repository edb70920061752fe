//! Filters on rotations.
//!
//! A quaternion and its negative are one rotation, so before anything is added up each sample of a window is brought
//! into the hemisphere of the window's centre. A joint that turns through 180 degrees is nothing special then.

use glam::DQuat;
use rayon::prelude::*;

use super::average::equal_weights;
use super::weighted::pascal_weights;
use super::{Depth, FilterKind};
use crate::sample::{align_hemispheres, angle_between};

/// Frames per piece of work; shorter motions are not worth waking other threads for.
const PIECE: usize = 2048;

/// Filters rotations over frames; the rule at the ends is the [module's](super).
///
/// - Averages: the weighted sum of the window's quaternions, each in the hemisphere of the window's centre, normalised.
/// - Median: the sample of the window with the smallest sum of angles to the others, among equals the one nearest to
///   the centre. It makes no new values.
///
/// Results of neighbouring frames lie in one hemisphere, whatever the signs of the input.
///
/// # Panics
///
/// If `out` is not as long as `values`.
pub fn filter_rotations(values: &[DQuat], out: &mut [DQuat], kind: FilterKind, depth: Depth) {
    assert_eq!(values.len(), out.len(), "one result per frame");
    let reach = depth.reach_within(values.len());
    match kind {
        FilterKind::Median => in_pieces(out, |start, out| medians(values, start, out, reach)),
        FilterKind::Average => means(values, out, reach, equal_weights),
        FilterKind::Weighted => means(values, out, reach, pascal_weights),
    }
    align_hemispheres(out);
}

/// Calls `work` with the start and the results of each piece, in parallel where there are several.
fn in_pieces(out: &mut [DQuat], work: impl Fn(usize, &mut [DQuat]) + Sync) {
    if out.len() <= PIECE {
        work(0, out);
    } else {
        out.par_chunks_mut(PIECE).enumerate().for_each(|(index, out)| work(index * PIECE, out));
    }
}

/// How far a centred window of at most `reach` to each side can reach around `frame`.
fn reach_at(frame: usize, frames: usize, reach: usize) -> usize {
    reach.min(frame).min(frames - 1 - frame)
}

fn means(values: &[DQuat], out: &mut [DQuat], reach: usize, weights_of: fn(usize) -> Vec<f64>) {
    let full_weights = weights_of(reach);
    let frames = values.len();
    in_pieces(out, |start, out| {
        for (frame, result) in (start..).zip(out) {
            let reach_here = reach_at(frame, frames, reach);
            let window = &values[frame - reach_here..=frame + reach_here];
            *result = if reach_here == reach {
                mean_of(window, &full_weights)
            } else {
                mean_of(window, &weights_of(reach_here))
            };
        }
    });
}

/// As the mean of plain numbers: the centre plus weighted differences from it, so that a still joint stays still.
fn mean_of(window: &[DQuat], weights: &[f64]) -> DQuat {
    let centre = window[window.len() / 2];
    let aligned = |rotation: &DQuat| if rotation.dot(centre) < 0.0 { -*rotation } else { *rotation };
    let before = window[..window.len() / 2].iter().rev();
    let after = &window[window.len() / 2 + 1..];
    let mut shift = DQuat::from_xyzw(0.0, 0.0, 0.0, 0.0);
    for ((before, after), &weight) in before.zip(after).zip(weights) {
        shift = shift + ((aligned(before) + aligned(after)) - centre * 2.0) * weight;
    }
    let sum = centre + shift;
    let length = sum.length();
    if sum != centre && length.is_finite() && length > 0.0 {
        sum / length
    } else {
        centre
    }
}

/// The best sample so far for one window.
#[derive(Clone, Copy)]
struct Candidate {
    frame: usize,
    angle_sum: f64,
}

/// Every sample stands as a candidate in each window it lies in.
///
/// Seen from one candidate, the sum of its angles to all samples of a window is the running sum up to the window's
/// first frame plus that up to its last: two look-ups, whatever the depth.
fn medians(values: &[DQuat], start: usize, out: &mut [DQuat], reach: usize) {
    let frames = values.len();
    let end = start + out.len();
    let mut best: Vec<_> = (start..end).map(|frame| Candidate { frame, angle_sum: f64::INFINITY }).collect();
    let mut back_sums = Vec::with_capacity(2 * reach + 1);
    let mut forth_sums = Vec::with_capacity(2 * reach + 1);

    for candidate in start.saturating_sub(reach)..(end + reach).min(frames) {
        let rotation = values[candidate];
        let first_neighbour = candidate.saturating_sub(2 * reach);
        let last_neighbour = (candidate + 2 * reach).min(frames - 1);
        running_angle_sums(&mut back_sums, rotation, values[first_neighbour..candidate].iter().rev());
        running_angle_sums(&mut forth_sums, rotation, values[candidate + 1..=last_neighbour].iter());

        for centre in start.max(candidate.saturating_sub(reach))..end.min(candidate + reach + 1) {
            let reach_here = reach_at(centre, frames, reach);
            if centre.abs_diff(candidate) > reach_here {
                continue;
            }
            let back = candidate - (centre - reach_here);
            let forth = centre + reach_here - candidate;
            let angle_sum = back_sums[back] + forth_sums[forth];
            let best = &mut best[centre - start];
            let is_nearer = centre.abs_diff(candidate) < centre.abs_diff(best.frame);
            if angle_sum < best.angle_sum || (angle_sum == best.angle_sum && is_nearer) {
                *best = Candidate { frame: candidate, angle_sum };
            }
        }
    }
    for (result, best) in out.iter_mut().zip(best) {
        *result = values[best.frame];
    }
}

/// Makes `sums[n]` the sum of the angles from a rotation to its first `n` neighbours.
fn running_angle_sums<'a>(sums: &mut Vec<f64>, rotation: DQuat, neighbours: impl Iterator<Item = &'a DQuat>) {
    let mut sum = 0.0;
    sums.clear();
    sums.push(sum);
    sums.extend(neighbours.map(|&neighbour| {
        sum += angle_between(rotation, neighbour);
        sum
    }));
}
