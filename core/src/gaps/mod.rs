//! Gaps of markers: where they are, and filling them.
//!
//! | way | what stands in a gap | good for |
//! |---|---|---|
//! | [`Fill::Linear`] | the straight line between its ends | a few frames |
//! | [`Fill::Cubic`] | the cubic through two samples on either side | up to a quarter of a second |
//! | [`Fill::Rigid`] | where the marker would be if it were fixed to its most rigid neighbours | long gaps of one marker of several on a bone |
//!
//! Nothing is ever filled before the first or after the last sample of a trajectory, nor a gap longer than the user
//! says: what would stand there is invented.

mod cubic;
mod kabsch;
mod neighbours;
mod rigid;

pub use neighbours::neighbours;

use crate::markers::Positions;
use glam::DVec3;
use std::ops::Range;

/// How a gap is filled.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Fill {
    /// By the straight line between its ends.
    Linear,
    /// By the cubic through two samples on either side.
    Cubic,
    /// By the motion of the most rigid neighbours.
    Rigid,
}

/// Frames on which a marker was not seen though it was before and after.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub struct Gap {
    /// Which marker.
    pub marker: usize,
    /// Its frames, counted from 0.
    pub frames: Range<usize>,
}

/// Returns the gaps of all markers, marker after marker.
pub fn find(positions: &Positions, marker_count: usize) -> Vec<Gap> {
    let of_marker = |marker| {
        let gaps = gaps_of(&positions.trajectory(marker));
        gaps.into_iter().map(move |frames| Gap { marker, frames })
    };
    (0..marker_count).flat_map(of_marker).collect()
}

/// Fills the gaps of some markers that are at most `longest` frames long, and returns those that it filled.
///
/// A gap that [`Fill::Rigid`] cannot fill, for fewer than three rigid neighbours were seen all the time, stays.
pub fn fill(positions: &mut Positions, marker_count: usize, chosen: &[usize], how: Fill, longest: usize) -> Vec<Gap> {
    let mut filled = Vec::new();
    // Neighbours are looked at as they were recorded, whatever was filled before.
    let recorded = if how == Fill::Rigid { Some(positions.clone()) } else { None };
    for &marker in chosen {
        let mut trajectory = positions.trajectory(marker);
        let gaps = gaps_of(&trajectory).into_iter().filter(|gap| gap.len() <= longest);
        let mut stiffest = None;
        let before = filled.len();
        for gap in gaps {
            let is_filled = match &recorded {
                None => fill_alone(&mut trajectory, &gap, how),
                Some(recorded) => {
                    let stiffest = stiffest.get_or_insert_with(|| rigid::stiffest(recorded, marker_count, marker));
                    rigid::fill(&mut trajectory, &gap, recorded, stiffest)
                }
            };
            if is_filled {
                filled.push(Gap { marker, frames: gap });
            }
        }
        if filled.len() > before {
            positions.set_trajectory(marker, &trajectory);
        }
    }
    filled
}

/// Returns the runs of missing samples that have a sample on both sides.
fn gaps_of(trajectory: &[DVec3]) -> Vec<Range<usize>> {
    let mut gaps = Vec::new();
    let mut last_seen: Option<usize> = None;
    for (frame, _) in trajectory.iter().enumerate().filter(|(_, position)| !position.is_nan()) {
        if let Some(last) = last_seen.filter(|last| frame - last > 1) {
            gaps.push(last + 1..frame);
        }
        last_seen = Some(frame);
    }
    gaps
}

/// Fills a gap from its own trajectory.
fn fill_alone(trajectory: &mut [DVec3], gap: &Range<usize>, how: Fill) -> bool {
    let curve = match how {
        Fill::Cubic => cubic::Curve::through(trajectory, gap),
        Fill::Linear | Fill::Rigid => cubic::Curve::between(trajectory, gap),
    };
    let Some(curve) = curve else { return false };
    for frame in gap.clone() {
        if let Some(place) = trajectory.get_mut(frame) {
            *place = curve.at(frame as f64);
        }
    }
    true
}

#[cfg(test)]
mod tests;
