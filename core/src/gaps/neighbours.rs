//! Which markers to draw lines between: those near each other whose distance stays nearly constant.

use super::rigid::{distance, step, Distance, RIGID};
use crate::markers::{scale, PointKind, Positions};
use rayon::prelude::*;
use std::collections::BTreeSet;

/// How many neighbours a marker is joined with by itself; others may join it.
const PER_MARKER: usize = 3;

/// How long a line is at most, in sizes of the whole.
const LONGEST: f64 = 0.35;

/// Returns pairs of markers that are near each other and keep their distance, each pair in ascending order.
///
/// Each marker is joined with the nearest three that keep their distance from it to a twentieth. Markers that are never
/// seen, and points that are no positions, are joined with none.
pub fn neighbours(positions: &Positions, kinds: &[PointKind]) -> Vec<(usize, usize)> {
    let markers: Vec<usize> = (0..kinds.len()).filter(|at| kinds.get(*at) == Some(&PointKind::Position)).collect();
    let size = scale::extents(positions, kinds).map_or(f64::INFINITY, |extents| extents.size.max_element());
    let step = step(positions.frame_count());
    let is_joined = |distance: &Distance| distance.deviation <= RIGID && distance.mean <= LONGEST * size;
    let lines = markers.par_iter().map(|&marker| {
        let others = markers.iter().filter(|other| **other != marker);
        let near = others.filter_map(|&other| Some((distance(positions, marker, other, step)?, other)));
        let mut near: Vec<(Distance, usize)> = near.filter(|(distance, _)| is_joined(distance)).collect();
        near.sort_by(|a, b| a.0.mean.total_cmp(&b.0.mean).then(a.1.cmp(&b.1)));
        near.into_iter().take(PER_MARKER).map(|(_, other)| (marker.min(other), marker.max(other))).collect::<Vec<_>>()
    });
    let pairs: BTreeSet<(usize, usize)> = lines.flatten_iter().collect();
    pairs.into_iter().collect()
}
