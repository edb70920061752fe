//! Filters on trajectories.

use super::Markers;
use crate::filter::{filter_values, Depth, FilterKind};
use glam::DVec3;

impl Markers {
    /// Filters the trajectories of some markers. Between two gaps is a trajectory of its own: no window reaches over a
    /// gap, and gaps stay.
    pub fn filter(&mut self, chosen: &[usize], kind: FilterKind, depth: Depth) {
        for &marker in chosen {
            let mut trajectory = self.positions.trajectory(marker);
            for run in trajectory.chunk_by_mut(|a, b| a.is_nan() == b.is_nan()) {
                if run.first().is_some_and(|position| !position.is_nan()) {
                    filter_run(run, kind, depth);
                }
            }
            self.positions.set_trajectory(marker, &trajectory);
        }
    }
}

fn filter_run(run: &mut [DVec3], kind: FilterKind, depth: Depth) {
    let mut filtered = vec![0.0; run.len()];
    for axis in 0..3 {
        let values: Vec<f64> = run.iter().map(|position| position.to_array()[axis]).collect();
        filter_values(&values, &mut filtered, kind, depth);
        for (position, value) in run.iter_mut().zip(&filtered) {
            position.as_mut()[axis] = *value;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::formats::csm::Csm;

    #[test]
    fn a_filter_does_not_reach_over_a_gap() {
        let rows = ["0 0 0", "9 0 0", "0 0 0", "DROPOUT", "6 0 0", "6 1 0", "6 0 0"];
        let rows: String = rows.iter().enumerate().map(|(frame, row)| format!("{frame} {row}\n")).collect();
        let (mut markers, _) = Csm::parse(format!("$Order A\n$Points\n{rows}").as_bytes()).unwrap().markers();
        let Ok(depth) = Depth::try_from(3) else { panic!("3 is odd") };
        markers.filter(&[0], FilterKind::Average, depth);
        let x = |frame| markers.positions.get(0, frame).map(|at| at.x);
        assert_eq!([0, 1, 2, 3, 4].map(x), [Some(0.0), Some(3.0), Some(0.0), None, Some(6.0)]);
        let middle = markers.positions.get(0, 5).unwrap_or_default();
        assert!(middle.abs_diff_eq(DVec3::new(6.0, 1.0 / 3.0, 0.0), 1e-15), "{middle}");
    }
}
