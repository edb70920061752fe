//! A clip as points and lines in metres, Z up, ready to draw.

mod actor;
mod bridges;
mod floor;
mod groups;
mod heading;
mod joints;
mod segments;
mod sides;

pub use actor::Actor;
pub use sides::Side;

pub(crate) use actor::evenly;
pub(crate) use floor::{bounds, floor};
pub(crate) use groups::Groups;
pub(crate) use heading::{leftward, middle};

use glam::Vec3;

/// A clip as points and lines over frames, in metres, Z up, at the place where the file has it.
///
/// Of a skeleton the points are its joints and the ends of its last bones, and the lines are its bones; of markers the
/// points are the markers, and the lines join neighbours that keep their distance, and groups of these.
#[derive(Debug, Clone, PartialEq)]
pub struct Figure {
    /// One per point; that of an end is its bone's with `_End` behind it.
    pub names: Vec<String>,
    /// Frame after frame, point after point; what is not seen is not a number.
    pub points: Vec<Vec3>,
    /// Which points each line joins.
    pub lines: Vec<[usize; 2]>,
    /// One per line.
    pub sides: Vec<Side>,
    /// How many frames there are here.
    pub frame_count: usize,
    /// Every so many frames of the file one is here.
    pub frame_step: usize,
    /// The file's own number of the first frame.
    pub first_frame: i64,
    /// Frames per second of the frames that are here; assumed where the file does not say.
    pub rate_hz: f64,
    /// The lowest and the highest coordinates of all points on all frames; `None` where nothing is ever seen.
    pub bounds: Option<[Vec3; 2]>,
    /// The height of the floor that the figure stands on, on the Z axis.
    pub floor: f32,
}

impl Figure {
    /// Places an actor on every frame, or, where that would be more than `longest`, on every second, third, ... one: on
    /// evenly spaced ones, so that the figure still moves at its speed.
    pub fn new(actor: &Actor<'_>, longest: Option<usize>) -> Self {
        let frame_step = longest.map_or(1, |longest| actor.frame_count.div_ceil(longest.max(1)).max(1));
        let mut points = Vec::new();
        let mut frame_count = 0;
        for frame in (0..actor.frame_count).step_by(frame_step) {
            actor.place(frame, &mut points);
            frame_count += 1;
        }
        let bounds = bounds(&points);
        Self {
            names: actor.names.clone(),
            lines: actor.lines.clone(),
            sides: actor.sides.clone(),
            frame_count,
            frame_step,
            first_frame: actor.first_frame,
            rate_hz: actor.rate_hz / frame_step as f64,
            bounds,
            floor: floor(points.chunks(actor.names.len().max(1))),
            points,
        }
    }

    /// Returns where all points are on a frame counted from 0; nothing where there is no such frame.
    pub fn frame(&self, frame: usize) -> &[Vec3] {
        let start = frame.saturating_mul(self.names.len());
        self.points.get(start..).and_then(|rest| rest.get(..self.names.len())).unwrap_or_default()
    }
}

#[cfg(test)]
pub(crate) mod tests;
