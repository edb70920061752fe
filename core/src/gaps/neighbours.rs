//! Which markers to draw lines between: those near each other whose distance stays nearly constant.

use super::rigid::{step, RIGID};
use crate::markers::{scale, PointKind, Positions};
use glam::DVec3;
use rayon::prelude::*;
use std::collections::BTreeSet;

/// How many neighbours a marker is joined with by itself; others may join it.
const PER_MARKER: usize = 3;

/// So many markers at a time are compared with all others.
const ROWS: usize = 16;

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
    let rows = (0..markers.len()).into_par_iter().with_min_len(ROWS);
    let nearest = rows.fold(
        || vec![Nearest::default(); markers.len()],
        |mut nearest, a| {
            for b in a + 1..markers.len() {
                if let Some(distance) = looks.constant_distance(a, b, LONGEST * size) {
                    nearest[a].add(distance, b);
                    nearest[b].add(distance, a);
                }
            }
            nearest
        },
    );
    let nearest = nearest.reduce(Vec::new, |some, others| {
        if some.is_empty() {
            return others;
        }
        some.into_iter().zip(others).map(|(some, others)| some.with(&others)).collect()
    });
    let joined =
        nearest.iter().enumerate().flat_map(|(a, near)| near.0.iter().map(move |(_, b)| (a.min(*b), a.max(*b))));
    let pairs: BTreeSet<(usize, usize)> = joined.map(|(a, b)| (markers[a], markers[b])).collect();
    pairs.into_iter().collect()
}

/// The nearest of those that a marker may be joined with, with their distances, in order.
#[derive(Debug, Clone, Default)]
struct Nearest(Vec<(f64, usize)>);

impl Nearest {
    fn add(&mut self, distance: f64, other: usize) {
        let before = |known: &(f64, usize)| known.0.total_cmp(&distance).then(known.1.cmp(&other)).is_lt();
        let place = self.0.partition_point(before);
        if place < PER_MARKER {
            self.0.insert(place, (distance, other));
            self.0.truncate(PER_MARKER);
        }
    }

    fn with(mut self, others: &Self) -> Self {
        for (distance, other) in &others.0 {
            self.add(*distance, *other);
        }
        self
    }
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
