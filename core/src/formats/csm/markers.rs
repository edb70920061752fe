//! [`Csm`] <-> [`Markers`].

use super::Csm;
use crate::formats::fields::{turned, writable_names, written};
use crate::markers::{scale, Analog, Markers, PointKind, Positions, Quality};
use glam::{DQuat, DVec3};

/// Millimetres in a metre.
const PER_METRE: f64 = 1000.0;

impl Csm {
    /// Returns the markers over frames and, a sentence each, what the user should know.
    pub fn markers(&self) -> (Markers, Vec<String>) {
        let frame_count = self.frame_numbers.len();
        let kinds = vec![PointKind::Position; self.order.len()];
        let positions = Positions::of_f64(turned(&self.values, self.order.len(), frame_count), frame_count);
        let extents = scale::extents(&positions, &kinds);
        let markers = Markers {
            names: self.order.clone(),
            kinds,
            positions,
            quality: Quality::default(),
            first_frame: self.frame_numbers.first().copied().or(self.first_frame).unwrap_or(1),
            rate_hz: self.rate_hz,
            unit: scale::unit("mm", "the format", extents),
            up: scale::up(Some((DVec3::Z, "the format")), extents),
            events: Vec::new(),
            analog: Analog::default(),
        };
        (markers, self.notices())
    }

    /// Returns a file with these markers, in millimetres and Z up as the format has it. Points that are no positions are
    /// left out; blanks and commas in names become `_`.
    pub fn of_markers(markers: &Markers) -> Self {
        let (chosen, order) = writable_names(markers);
        let turn = DQuat::from_rotation_arc(markers.up.axis, DVec3::Z);
        let is_turned = markers.up.axis != DVec3::Z;
        // Already in millimetres, numbers stay as they are.
        let factor = if markers.unit.metres == 1.0 / PER_METRE { 1.0 } else { markers.unit.metres * PER_METRE };
        let place = |marker: usize, frame: usize| {
            let at = markers.positions.get(marker, frame)?;
            Some(if is_turned { turn * at * factor } else { at * factor })
        };
        let place = |marker: usize, frame: usize| written(place(marker, frame));
        let frames = 0..markers.frame_count();
        Self {
            texts: Vec::new(),
            first_frame: Some(markers.first_frame),
            last_frame: Some(markers.last_frame()),
            rate_hz: markers.rate_hz,
            order,
            frame_numbers: (markers.first_frame..).take(frames.len()).collect(),
            values: frames.flat_map(|frame| chosen.iter().flat_map(move |marker| place(*marker, frame))).collect(),
        }
    }
}
