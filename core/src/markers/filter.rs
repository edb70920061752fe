//! Filters on trajectories.

use super::Markers;
use crate::filter::components::by_component;
use crate::filter::{filter_values, Depth, FilterKind};
use glam::DVec3;

impl Markers {
    /// Returns the markers with some of their trajectories filtered (`None`: all). A window never reaches over a gap: every
    /// stretch of seen samples is filtered by itself, and gaps stay.
    #[must_use]
    pub fn filtered(&self, chosen: Option<&[usize]>, kind: FilterKind, depth: Depth) -> Self {
        let mut filtered = self.clone();
        for marker in (0..self.count()).filter(|marker| chosen.is_none_or(|chosen| chosen.contains(marker))) {
            let mut trajectory = self.positions.trajectory(marker);
            for seen in trajectory.chunk_by_mut(|a, b| a.is_nan() == b.is_nan()) {
                if !seen.first().is_some_and(|at| at.is_nan()) {
                    let rows: Vec<_> = seen.iter().map(DVec3::to_array).collect();
                    let rows = by_component(&rows, |channel, out| filter_values(channel, out, kind, depth));
                    seen.iter_mut().zip(rows).for_each(|(at, row)| *at = row.into());
                }
            }
            filtered.positions.set_trajectory(marker, &trajectory);
        }
        filtered
    }
}

#[cfg(test)]
mod tests {
    use super::super::tests::walk;
    use super::*;

    #[test]
    fn a_spike_goes_a_gap_stays_and_no_window_reaches_over_it() {
        let x = [1.0, 1.0, 9.0, 1.0, f64::NAN, 5.0, 8.0, 5.0];
        let markers = walk(&[&x, &x], Some(100.0));
        let filtered = markers.filtered(Some(&[1]), FilterKind::Median, Depth::try_from(3).unwrap());
        assert_eq!(filtered.positions.trajectory(0)[2].x, 9.0);
        let after: Vec<f64> = filtered.positions.trajectory(1).iter().map(|at| at.x).collect();
        assert_eq!((&after[..4], &after[5..]), (&[1.0, 1.0, 1.0, 1.0][..], &[5.0, 5.0, 5.0][..]));
        assert!(after[4].is_nan());
    }
}
