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
        shift += ((aligned(before) + aligned(after)) - centre * 2.0) * weight;
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

#[cfg(test)]
mod tests {
    use std::f64::consts::{PI, TAU};

    use glam::DVec3;
    use proptest::prelude::*;

    use super::*;

    const KINDS: [FilterKind; 3] = [FilterKind::Median, FilterKind::Average, FilterKind::Weighted];

    /// Components of unit quaternions round by 2^-53 per operation; angles from them by little more.
    const ROUNDING_RAD: f64 = 1e-13;

    fn filtered(values: &[DQuat], kind: FilterKind, depth: usize) -> Vec<DQuat> {
        let mut out = vec![DQuat::IDENTITY; values.len()];
        filter_rotations(values, &mut out, kind, Depth::try_from(depth).unwrap());
        out
    }

    fn steps_rad(rotations: &[DQuat]) -> impl Iterator<Item = f64> + '_ {
        rotations.windows(2).map(|pair| angle_between(pair[0], pair[1]))
    }

    fn largest_angle_rad(a: &[DQuat], b: &[DQuat]) -> f64 {
        assert_eq!(a.len(), b.len());
        a.iter().zip(b).map(|(&a, &b)| angle_between(a, b)).fold(0.0, f64::max)
    }

    /// The definition of the rotation median, window by window.
    fn naive_medians(values: &[DQuat], depth: usize) -> Vec<DQuat> {
        let median_at = |frame: usize| {
            let reach = frame.min(values.len() - 1 - frame).min(depth / 2);
            let window = &values[frame - reach..=frame + reach];
            let angle_sum = |&a: &DQuat| window.iter().map(|&b| angle_between(a, b)).sum::<f64>();
            *window.iter().min_by(|a, b| angle_sum(a).total_cmp(&angle_sum(b))).unwrap()
        };
        (0..values.len()).map(median_at).collect()
    }

    #[test]
    fn a_joint_that_turns_at_constant_speed_through_half_and_whole_turns_shows_no_spike() {
        let axis = DVec3::new(1.0, 2.0, -0.5).normalize();
        for turn_deg in [180.0_f64, 360.0, 720.0, -720.0] {
            for stored_in_one_hemisphere in [true, false] {
                let turn = |frame: u32| DQuat::from_axis_angle(axis, turn_deg.to_radians() * f64::from(frame) / 60.0);
                let mut turning: Vec<_> = (0..=60).map(turn).collect();
                if stored_in_one_hemisphere {
                    turning.iter_mut().filter(|q| q.w < 0.0).for_each(|q| *q = -*q);
                }
                let before = steps_rad(&turning).fold(0.0, f64::max);
                for kind in KINDS {
                    for depth in [3, 5, 7, 15] {
                        let result = filtered(&turning, kind, depth);
                        let after = steps_rad(&result).fold(0.0, f64::max);
                        assert!(after <= before + ROUNDING_RAD, "{kind:?} {depth}: {after} after {before}");
                        assert!(largest_angle_rad(&result, &turning) < ROUNDING_RAD, "{kind:?} {depth}");
                    }
                }
            }
        }
    }

    #[test]
    fn a_half_turn_about_changing_axes_is_no_special_place() {
        let near_half_turns: Vec<_> = (0..40)
            .map(|frame| {
                let time = f64::from(frame) * 0.1;
                DQuat::from_scaled_axis(DVec3::new(PI + 0.2 * time.sin(), 0.3 * time.cos(), 0.1 * time))
            })
            .collect();
        let before = steps_rad(&near_half_turns).fold(0.0, f64::max);
        for kind in [FilterKind::Average, FilterKind::Weighted] {
            let after = steps_rad(&filtered(&near_half_turns, kind, 7)).fold(0.0, f64::max);
            assert!(after <= before, "{kind:?}: {after} after {before}");
        }
    }

    #[test]
    fn median_removes_a_spike() {
        let mut still = vec![DQuat::from_rotation_x(0.4); 9];
        let clean = still.clone();
        still[4] = DQuat::from_rotation_y(2.0);
        assert_eq!(filtered(&still, FilterKind::Median, 3), clean);
    }

    #[test]
    fn weighted_average_about_one_axis_is_that_of_the_angles_while_they_are_small() {
        let mut spike = vec![DQuat::IDENTITY; 9];
        spike[4] = DQuat::from_rotation_z(16e-4);
        let result = filtered(&spike, FilterKind::Weighted, 5);
        for (frame, weight) in [(2, 1.0), (3, 4.0), (4, 6.0), (5, 4.0), (6, 1.0)] {
            // The sine of half a milliradian differs from it by its cube / 6.
            assert!((angle_between(DQuat::IDENTITY, result[frame]) - weight * 1e-4).abs() < 1e-10);
        }
    }

    #[test]
    fn pieces_of_a_long_motion_show_no_seams() {
        let waving = |frame: usize| DQuat::from_rotation_y((frame as f64 * 0.37).sin());
        let long: Vec<_> = (0..PIECE + 100).map(waving).collect();
        for kind in KINDS {
            let whole = filtered(&long, kind, 9);
            let around_seam = filtered(&long[PIECE - 100..], kind, 9);
            assert!(largest_angle_rad(&whole[PIECE - 90..PIECE + 90], &around_seam[10..190]) < ROUNDING_RAD);
        }
    }

    #[test]
    fn nothing_one_value_and_values_that_are_no_numbers_do_not_panic() {
        let broken = DQuat::from_xyzw(f64::NAN, 0.0, f64::INFINITY, 1.0);
        let zero = DQuat::from_xyzw(0.0, 0.0, 0.0, 0.0);
        for kind in KINDS {
            assert_eq!(filtered(&[], kind, 5), []);
            assert_eq!(filtered(&[DQuat::IDENTITY], kind, usize::MAX), [DQuat::IDENTITY]);
            let mut values = [DQuat::IDENTITY; 9];
            values[4] = broken;
            values[8] = zero;
            let result = filtered(&values, kind, 5);
            assert!(result[..4].iter().all(|&rotation| rotation == DQuat::IDENTITY), "{kind:?}");
        }
    }

    prop_compose! {
        /// A joint that wanders by less than 0.4 rad per frame: windows of 7 stay within a half turn.
        fn any_motion()(
            steps in prop::collection::vec([-0.2..0.2, -0.2..0.2, -0.2..0.2], 0..50)
        ) -> Vec<DQuat> {
            let wander = |at: &mut DQuat, step: [f64; 3]| {
                *at *= DQuat::from_scaled_axis(DVec3::from_array(step));
                Some(at.normalize())
            };
            steps.into_iter().scan(DQuat::IDENTITY, wander).collect()
        }
    }

    fn any_depth() -> impl Strategy<Value = usize> {
        prop_oneof![Just(3), Just(5), Just(7)]
    }

    proptest! {
        #[test]
        fn signs_of_the_input_do_not_matter(motion in any_motion(), signs in any::<u64>(), depth in any_depth()) {
            let sign = |frame: usize| if signs >> (frame % 64) & 1 == 1 { -1.0 } else { 1.0 };
            let flipped: Vec<_> = motion.iter().enumerate().map(|(frame, &rotation)| rotation * sign(frame)).collect();
            for kind in KINDS {
                let angle = largest_angle_rad(&filtered(&motion, kind, depth), &filtered(&flipped, kind, depth));
                prop_assert!(angle < ROUNDING_RAD);
            }
        }

        #[test]
        fn turning_the_whole_motion_turns_the_result(
            motion in any_motion(),
            turn in [-3.0..3.0, -3.0..3.0, -3.0..3.0],
            depth in any_depth(),
        ) {
            let turn = DQuat::from_scaled_axis(DVec3::from_array(turn));
            let turned: Vec<_> = motion.iter().map(|&rotation| turn * rotation).collect();
            for kind in [FilterKind::Average, FilterKind::Weighted] {
                let expected: Vec<_> = filtered(&motion, kind, depth).iter().map(|&rotation| turn * rotation).collect();
                let angle = largest_angle_rad(&filtered(&turned, kind, depth), &expected);
                prop_assert!(angle < ROUNDING_RAD);
            }
        }

        #[test]
        fn medians_have_the_smallest_sum_of_angles(motion in any_motion(), depth in any_depth()) {
            let medians = filtered(&motion, FilterKind::Median, depth);
            let expected = naive_medians(&motion, depth);
            for frame in 0..motion.len() {
                let reach = frame.min(motion.len() - 1 - frame).min(depth / 2);
                let window = &motion[frame - reach..=frame + reach];
                let angle_sum = |a: DQuat| window.iter().map(|&b| angle_between(a, b)).sum::<f64>();
                prop_assert!((angle_sum(medians[frame]) - angle_sum(expected[frame])).abs() < ROUNDING_RAD);
                prop_assert!(window.contains(&medians[frame]) || window.contains(&-medians[frame]));
            }
        }

        #[test]
        fn results_are_unit_quaternions_in_one_hemisphere(motion in any_motion(), depth in any_depth()) {
            for kind in KINDS {
                let result = filtered(&motion, kind, depth);
                prop_assert!(result.iter().all(|rotation| (rotation.length() - 1.0).abs() < 1e-15 * 4.0));
                prop_assert!(result.windows(2).all(|pair| pair[0].dot(pair[1]) >= 0.0));
            }
        }

        #[test]
        fn a_still_joint_stays_to_the_last_bit(pose in [-TAU..TAU, -TAU..TAU, -TAU..TAU], depth in any_depth()) {
            let still = vec![DQuat::from_scaled_axis(DVec3::from_array(pose)); 20];
            for kind in KINDS {
                prop_assert_eq!(filtered(&still, kind, depth), still.clone());
            }
        }
    }
}
