//! How long a file unit is, and which way is up: what the file says, and what the size of a person says.

mod axis;
mod unit;

pub(crate) use axis::{axis_name, axis_of, up};
pub(crate) use unit::{unit, unit_name};

use super::{PointKind, Positions};
use glam::DVec3;

/// At most so many frames are looked at.
const LOOKS: usize = 16;

/// Returns the frames, counted from 0, that say how large markers are. Markers on these alone are looked at as a whole.
pub(crate) fn frames_to_look_at(frame_count: usize) -> impl Iterator<Item = usize> {
    (0..frame_count).step_by(frame_count.div_ceil(LOOKS).max(1))
}

/// Returns how far the markers of a frame usually lie apart along x, y and z, the lowest and the highest coordinate;
/// `None` where too few are seen.
pub(crate) fn extents(positions: &Positions, kinds: &[PointKind]) -> Option<Extents> {
    const FEWEST: usize = 3;
    let markers: Vec<usize> =
        (0..kinds.len()).filter(|marker| kinds.get(*marker) == Some(&PointKind::Position)).collect();
    let mut frames: Vec<(DVec3, DVec3)> = Vec::with_capacity(LOOKS);
    for frame in frames_to_look_at(positions.frame_count()) {
        let seen = markers.iter().filter_map(|marker| positions.get(*marker, frame)).filter(|at| *at != DVec3::ZERO);
        let (mut count, mut low, mut high) = (0, DVec3::INFINITY, DVec3::NEG_INFINITY);
        for at in seen {
            (count, low, high) = (count + 1, low.min(at), high.max(at));
        }
        if count >= FEWEST && low.is_finite() && high.is_finite() {
            frames.push((low, high));
        }
    }
    if frames.is_empty() {
        return None;
    }
    let each = |of: fn(&(DVec3, DVec3)) -> DVec3| medians(&frames, of);
    let (low, high) = (each(|frame| frame.0), each(|frame| frame.1));
    let size = each(|(low, high)| *high - *low);
    for frame in &mut frames {
        frame.0 = (frame.0 - low).abs();
    }
    Some(Extents { size, low, high, unsteadiness: medians(&frames, |frame| frame.0) })
}

/// Returns the medians of x, y and z of something of every frame.
fn medians(frames: &[(DVec3, DVec3)], of: fn(&(DVec3, DVec3)) -> DVec3) -> DVec3 {
    let median = |axis: usize| {
        let mut values: Vec<f64> = frames.iter().map(|frame| of(frame).to_array()[axis]).collect();
        values.sort_by(f64::total_cmp);
        values.get(values.len() / 2).copied().unwrap_or(0.0)
    };
    DVec3::new(median(0), median(1), median(2))
}

/// How far the markers of a frame usually reach.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Extents {
    /// Along x, y and z, in file units.
    pub(crate) size: DVec3,
    low: DVec3,
    high: DVec3,
    /// By how much the lowest coordinates change from frame to frame.
    unsteadiness: DVec3,
}

/// By how much a person who stands is taller than wide, at least.
const TALL: f64 = 1.25;

/// How far from the floor the lowest marker of a person who stands usually is, and how much that changes, in heights.
const FLOOR: f64 = 0.15;

/// How markers stand in their axes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Stance {
    /// Much farther along one axis than along the others, with the lowest always near 0: on the floor.
    OnTheFloor,
    /// Much farther along one axis than along the others.
    Tall,
    /// Neither.
    Unclear,
}

impl Extents {
    /// Returns the axis along which the markers reach farthest, and how they stand along it.
    pub(super) fn tallest(&self) -> (DVec3, Stance) {
        let size = self.size;
        let (axis, tall) = [(DVec3::X, size.x), (DVec3::Y, size.y), (DVec3::Z, size.z)]
            .into_iter()
            .fold((DVec3::Z, f64::NEG_INFINITY), |best, next| if next.1 > best.1 { next } else { best });
        let wide = (size - axis * tall).max_element();
        // Feet stay near the floor, where most laboratories have their origin; heads do not.
        let (low, high) = (self.low.dot(axis), self.high.dot(axis));
        let (axis, lowest) = if low.abs() > 2.0 * high.abs() { (-axis, -high) } else { (axis, low) };
        let stance = if tall <= TALL * wide {
            Stance::Unclear
        } else if lowest.abs() <= FLOOR * tall && self.unsteadiness.dot(axis.abs()) <= FLOOR * tall {
            Stance::OnTheFloor
        } else {
            Stance::Tall
        };
        (axis, stance)
    }
}

#[cfg(test)]
impl Extents {
    /// Something of that size on the floor.
    fn of_size(size: DVec3) -> Self {
        Self { size, low: DVec3::ZERO, high: size, unsteadiness: DVec3::ZERO }
    }
}
