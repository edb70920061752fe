//! The polynomial through the samples around a gap.

use glam::DVec3;
use std::ops::Range;

/// A polynomial in Newton's form through up to four samples.
pub(super) struct Curve {
    frames: Vec<f64>,
    coefficients: Vec<DVec3>,
}

impl Curve {
    /// Returns the line between the samples at the ends of a gap.
    pub(super) fn between(trajectory: &[DVec3], gap: &Range<usize>) -> Option<Self> {
        Self::of_samples(trajectory, vec![gap.start.checked_sub(1)?, gap.end])
    }

    /// Returns the cubic through two samples on either side; a lower one where there are fewer.
    pub(super) fn through(trajectory: &[DVec3], gap: &Range<usize>) -> Option<Self> {
        const PER_SIDE: usize = 2;
        let is_seen = |frame: &usize| trajectory.get(*frame).is_some_and(|position| !position.is_nan());
        let before = (0..gap.start).rev().filter(is_seen).take(PER_SIDE);
        let after = (gap.end..trajectory.len()).filter(is_seen).take(PER_SIDE);
        Self::of_samples(trajectory, before.chain(after).collect())
    }

    fn of_samples(trajectory: &[DVec3], frames: Vec<usize>) -> Option<Self> {
        let samples = frames.iter().map(|frame| trajectory.get(*frame).copied().filter(|at| !at.is_nan()));
        let mut table = samples.collect::<Option<Vec<DVec3>>>()?;
        let frames: Vec<f64> = frames.into_iter().map(|frame| frame as f64).collect();
        // Divided differences, in place.
        for order in 1..table.len() {
            for index in (order..table.len()).rev() {
                table[index] = (table[index] - table[index - 1]) / (frames[index] - frames[index - order]);
            }
        }
        Some(Self { frames, coefficients: table })
    }

    /// Returns the curve at a frame.
    pub(super) fn at(&self, frame: f64) -> DVec3 {
        let terms = self.coefficients.iter().zip(&self.frames).rev();
        terms.fold(DVec3::ZERO, |sum, (coefficient, known)| sum * (frame - known) + *coefficient)
    }
}
