//! Which markers to draw lines between: those near each other whose distance stays nearly constant.

use super::rigid::{step, RIGID};
use crate::markers::{scale, PointKind, Positions};
use glam::DVec3;
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
    let looks = Looks::new(positions, &markers);
    let joined = (0..markers.len()).into_par_iter().flat_map_iter(|a| {
        let looks = &looks;
        (a + 1..markers.len()).filter_map(move |b| Some((looks.constant_distance(a, b, LONGEST * size)?, a, b)))
    });
    let mut joined: Vec<(f64, usize, usize)> = joined.collect();
    joined.sort_by(|a, b| a.0.total_cmp(&b.0).then((a.1, a.2).cmp(&(b.1, b.2))));
    let mut counts = vec![0; markers.len()];
    let mut pairs = BTreeSet::new();
    for (_, a, b) in joined {
        if counts[a] < PER_MARKER || counts[b] < PER_MARKER {
            pairs.insert((markers[a], markers[b]));
        }
        counts[a] += 1;
        counts[b] += 1;
    }
    pairs.into_iter().collect()
}

/// Where markers are on the frames that are looked at. All pairs of them are compared: they are taken out of the file's
/// numbers once.
struct Looks {
    places: Vec<DVec3>,
    per_marker: usize,
}

impl Looks {
    fn new(positions: &Positions, markers: &[usize]) -> Self {
        let frames = (0..positions.frame_count()).step_by(step(positions.frame_count()));
        let per_marker = frames.clone().count();
        let place = |marker, frame| positions.get(marker, frame).unwrap_or(DVec3::NAN);
        let of_marker = |marker: &usize| frames.clone().map(move |frame| place(*marker, frame)).collect::<Vec<_>>();
        Self { places: markers.iter().flat_map(of_marker).collect(), per_marker }
    }

    fn of(&self, marker: usize) -> &[DVec3] {
        let start = marker * self.per_marker;
        &self.places[start..start + self.per_marker]
    }

    /// Returns the mean distance of two markers where that is not above `longest` and deviates little.
    ///
    /// Most pairs are neither near nor constant, which a part of the looks shows: a deviation is at most
    /// [`RIGID`] of the mean, so neither the sum of its squares nor one distance can be above what `longest` allows.
    fn constant_distance(&self, a: usize, b: usize, longest: f64) -> Option<f64> {
        let looks = self.per_marker as f64;
        let most_squares = (RIGID * longest).powi(2) * looks;
        let farthest = longest * (1.0 + RIGID * looks.sqrt());
        let (mut count, mut mean, mut squares) = (0.0, 0.0, 0.0);
        for (a, b) in self.of(a).iter().zip(self.of(b)) {
            let distance = a.distance(*b);
            if distance.is_nan() {
                continue;
            }
            // Welford: no difference of large sums.
            count += 1.0;
            let delta = distance - mean;
            mean += delta / count;
            squares += delta * (distance - mean);
            if distance > farthest || squares > most_squares {
                return None;
            }
        }
        let is_constant = mean > 0.0 && (squares / count).sqrt() <= RIGID * mean;
        (is_constant && mean <= longest).then_some(mean)
    }
}
