use super::*;
use crate::markers::PointKind;
use glam::{DQuat, DVec3};
use proptest::prelude::*;

const GAP: DVec3 = DVec3::NAN;

fn positions(trajectories: &[Vec<DVec3>]) -> Positions {
    let frame_count = trajectories.first().map_or(0, Vec::len);
    Positions::of_f64(trajectories.iter().flatten().flat_map(DVec3::to_array).collect(), frame_count)
}

/// A body of markers that turns and travels, and after them one that does not belong to it.
fn moving_body(frame_count: usize) -> Vec<Vec<DVec3>> {
    let places = [
        DVec3::new(0.0, 0.0, 0.0),
        DVec3::new(100.0, 10.0, 0.0),
        DVec3::new(20.0, 120.0, 5.0),
        DVec3::new(10.0, 30.0, 90.0),
        DVec3::new(60.0, 50.0, 40.0),
    ];
    let pose = |frame: usize| {
        let t = frame as f64 / 20.0;
        (
            DQuat::from_euler(glam::EulerRot::XYZ, t.sin(), 0.7 * t, (1.3 * t).cos()),
            DVec3::new(300.0 * t, 50.0 * t.sin(), 900.0),
        )
    };
    let of_place = |place: &DVec3| {
        let frames = (0..frame_count).map(|frame| {
            let (rotation, translation) = pose(frame);
            rotation * *place + translation
        });
        frames.collect()
    };
    let mut trajectories: Vec<Vec<DVec3>> = places.iter().map(of_place).collect();
    trajectories.push((0..frame_count).map(|frame| DVec3::new(5.0 * frame as f64, 2000.0, 0.0)).collect());
    trajectories
}

#[test]
fn gaps_are_runs_between_samples_and_not_before_the_first_or_after_the_last() {
    let seen = DVec3::ONE;
    let trajectory = vec![GAP, GAP, seen, GAP, seen, seen, GAP, GAP, seen, GAP];
    let never = vec![GAP; 10];
    let found = find(&positions(&[trajectory, never]), 2);
    let gap = |frames| Gap { marker: 0, frames };
    assert_eq!(found, [gap(3..4), gap(6..8)]);
}

#[test]
fn only_gaps_up_to_the_longest_are_filled() {
    let line = |frame: usize| DVec3::new(frame as f64, 0.0, 1.0);
    let mut trajectory: Vec<DVec3> = (0..12).map(line).collect();
    for frame in [0, 2, 4, 5, 7, 8, 9, 11] {
        trajectory[frame] = GAP;
    }
    let mut positions = positions(&[trajectory]);
    let filled = fill(&mut positions, 1, &[0], Fill::Linear, 2);
    assert_eq!(filled.iter().map(|gap| gap.frames.clone()).collect::<Vec<_>>(), [2..3, 4..6]);
    assert_eq!(positions.get(0, 5), Some(line(5)));
    assert_eq!([0, 7, 8, 9, 11].map(|frame| positions.get(0, frame)), [None; 5]);
}

#[test]
fn a_marker_on_a_rigid_body_is_where_the_body_carries_it() {
    let recorded = moving_body(80);
    let mut broken = recorded.clone();
    broken[4][10..70].fill(GAP);
    let mut filled = positions(&broken);
    assert_eq!(fill(&mut filled, 6, &[4], Fill::Rigid, 100).len(), 1);
    for (found, expected) in filled.trajectory(4).iter().zip(&recorded[4]) {
        assert!((*found - *expected).length() < 1e-6, "{found} is not {expected}");
    }
    // A straight line is far away from there.
    let mut line = positions(&broken);
    fill(&mut line, 6, &[4], Fill::Linear, 100);
    assert!((line.trajectory(4)[40] - recorded[4][40]).length() > 10.0);
}

#[test]
fn a_marker_with_fewer_than_three_rigid_neighbours_in_sight_keeps_its_gap() {
    let mut broken = moving_body(80);
    broken[4][10..20].fill(GAP);
    broken[0][12..13].fill(GAP);
    broken[1][19..21].fill(GAP);
    let mut positions = positions(&broken);
    let before = positions.clone();
    assert_eq!(fill(&mut positions, 6, &[4, 5], Fill::Rigid, 100), []);
    assert_eq!(positions, before);
}

#[test]
fn neighbours_are_near_and_keep_their_distance() {
    let mut trajectories = moving_body(80);
    trajectories.push(vec![GAP; 80]);
    let mut kinds = vec![PointKind::Position; 7];
    let lines = neighbours(&positions(&trajectories), &kinds);
    assert!(lines.iter().all(|(a, b)| a < b && *b < 5), "{lines:?}");
    assert!((0..5).all(|marker| lines.iter().any(|(a, b)| *a == marker || *b == marker)), "{lines:?}");
    kinds[4] = PointKind::Angle;
    assert!(neighbours(&positions(&trajectories), &kinds).iter().all(|(_, b)| *b < 4));
}

fn seen_or_not() -> impl Strategy<Value = Vec<Option<[f64; 3]>>> {
    proptest::collection::vec(proptest::option::weighted(0.6, [-1e3..1e3_f64, -1e3..1e3, -1e3..1e3]), 1..40)
}

proptest! {
    #[test]
    fn samples_and_ends_stay_and_every_gap_in_reach_is_filled(
        samples in seen_or_not(),
        is_cubic in any::<bool>(),
        longest in 0_usize..8,
    ) {
        let trajectory: Vec<DVec3> = samples.iter().map(|at| at.map_or(GAP, DVec3::from_array)).collect();
        let how = if is_cubic { Fill::Cubic } else { Fill::Linear };
        let mut filled = positions(std::slice::from_ref(&trajectory));
        let gaps = fill(&mut filled, 1, &[0], how, longest);
        let expected: Vec<Gap> = find(&positions(std::slice::from_ref(&trajectory)), 1);
        let expected: Vec<Gap> = expected.into_iter().filter(|gap| gap.frames.len() <= longest).collect();
        prop_assert_eq!(&gaps, &expected);
        for (frame, at) in trajectory.iter().enumerate() {
            let is_in_gap = gaps.iter().any(|gap| gap.frames.contains(&frame));
            match filled.get(0, frame) {
                Some(found) if is_in_gap => prop_assert!(found.is_finite()),
                Some(found) => prop_assert_eq!(found, *at),
                None => prop_assert!(at.is_nan() && !is_in_gap),
            }
        }
    }

    #[test]
    fn a_line_is_filled_with_a_line_and_a_cubic_with_a_cubic(
        coefficients in [[-1.0..1.0_f64, -1.0..1.0, -1.0..1.0], [-1.0..1.0, -1.0..1.0, -1.0..1.0],
            [-0.1..0.1, -0.1..0.1, -0.1..0.1], [-0.01..0.01, -0.01..0.01, -0.01..0.01]],
        start in 2_usize..10,
        length in 1_usize..15,
    ) {
        let [a, b, c, d] = coefficients.map(DVec3::from_array);
        for (how, degree) in [(Fill::Linear, 1), (Fill::Cubic, 3)] {
            let curve = |frame: usize| {
                let t = frame as f64;
                if degree == 1 { a + b * t } else { a + t * (b + t * (c + t * d)) }
            };
            let whole: Vec<DVec3> = (0..start + length + 4).map(curve).collect();
            let mut broken = whole.clone();
            broken[start..start + length].fill(GAP);
            let mut filled = positions(&[broken]);
            prop_assert_eq!(fill(&mut filled, 1, &[0], how, length).len(), 1);
            for (found, expected) in filled.trajectory(0).iter().zip(&whole) {
                prop_assert!((*found - *expected).length() < 1e-7, "{how:?}: {found} is not {expected}");
            }
        }
    }
}
