//! Markers as plain data: named points over frames, with gaps, and what was recorded beside them.

mod analog;
mod filter;
mod positions;
mod quality;
mod resample;
pub(crate) mod scale;

pub use analog::{Analog, AnalogChannel, RawSamples};
pub use positions::Positions;
pub use quality::Quality;

use crate::infer::{markers, Answer};
use crate::skeleton::LengthUnit;
use glam::DVec3;

/// What a point of a file stands for. Laboratories store computed values beside markers, as three numbers each.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Hash)]
pub enum PointKind {
    /// A position: a marker, or a computed joint centre.
    #[default]
    Position,
    /// Three joint angles.
    Angle,
    /// A force.
    Force,
    /// A moment of force.
    Moment,
    /// A power.
    Power,
    /// Any other number.
    Scalar,
}

/// Something that happened at a moment.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Event {
    /// What: "Foot Strike".
    pub label: String,
    /// Which side or kind: "Left"; empty where the file does not say.
    pub context: String,
    /// To whom; empty where the file does not say.
    pub subject: String,
    /// When, in seconds; 0 is the file's frame 1.
    pub time_s: f64,
}

/// The axis that points up, in file axes, and why.
#[derive(Debug, Clone, PartialEq)]
pub struct UpAxis {
    /// One of the six axes.
    pub axis: DVec3,
    /// The reason in words: "+Z, as `POINT:Y_SCREEN` says".
    pub reason: String,
    /// False where the reasons are weak or contradict each other.
    pub is_certain: bool,
}

/// Named points over frames, evenly spaced in time, in the file's own axes and units.
#[derive(Debug, Clone, PartialEq)]
pub struct Markers {
    /// The file's own names in file order; they may be empty, or the same twice.
    pub names: Vec<String>,
    /// What each point stands for.
    pub kinds: Vec<PointKind>,
    /// Where each is on every frame.
    pub positions: Positions,
    /// How well each was seen; nothing where the format does not say.
    pub quality: Quality,
    /// The file's own number of the first frame.
    pub first_frame: i64,
    /// Frames per second; `None` where the file does not say.
    pub rate_hz: Option<f64>,
    /// How long a file unit is.
    pub unit: LengthUnit,
    /// Which way is up.
    pub up: UpAxis,
    /// What happened when, in file order.
    pub events: Vec<Event>,
    /// What was recorded beside the markers.
    pub analog: Analog,
}

impl Markers {
    /// Returns how many markers there are.
    pub fn count(&self) -> usize {
        self.names.len()
    }

    /// Returns how many frames there are.
    pub fn frame_count(&self) -> usize {
        self.positions.frame_count()
    }

    /// Returns the file's own number of the last frame.
    pub fn last_frame(&self) -> i64 {
        self.first_frame + self.frame_count() as i64 - 1
    }

    /// Works out the axis towards which the figure looks, in file axes: most of the time, or on the first frame where it
    /// turns. Names of markers say it, and the way of walking.
    pub fn facing(&self) -> Answer<DVec3> {
        markers::facing(self)
    }

    /// Returns the file's own number, not always whole, of the frame at which an event is.
    pub fn frame_of(&self, event: &Event) -> Option<f64> {
        Some(event.time_s * self.rate_hz? + 1.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Markers that move along X only, from frame 1 on; what is not a number is a gap.
    pub(super) fn walk(xs: &[&[f64]], rate_hz: Option<f64>) -> Markers {
        let frame_count = xs.first().map_or(0, |xs| xs.len());
        let place = |x: f64| if x.is_nan() { [f64::NAN; 3] } else { [x, 0.0, 0.0] };
        let values = xs.iter().flat_map(|xs| xs.iter().flat_map(|x| place(*x))).collect();
        let reason = String::new();
        Markers {
            names: (0..xs.len()).map(|marker| format!("M{marker}")).collect(),
            kinds: vec![PointKind::Position; xs.len()],
            positions: Positions::of_f64(values, frame_count),
            quality: Quality::default(),
            first_frame: 1,
            rate_hz,
            unit: LengthUnit { metres: 0.001, reason: reason.clone(), is_certain: true },
            up: UpAxis { axis: DVec3::Z, reason, is_certain: true },
            events: Vec::new(),
            analog: Analog::default(),
        }
    }
}
