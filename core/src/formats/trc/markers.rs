//! [`Trc`] <-> [`Markers`].

use super::Trc;
use crate::formats::fields::{turned, writable_names, written};
use crate::markers::{scale, Analog, Markers, PointKind, Positions, Quality};

impl Trc {
    /// Returns the markers over frames and, a sentence each, what the user should know.
    pub fn markers(&self) -> (Markers, Vec<String>) {
        let frame_count = self.frame_numbers.len();
        let kinds = vec![PointKind::Position; self.names.len()];
        let positions = Positions::of_f64(turned(&self.values, self.names.len(), frame_count), frame_count);
        let extents = scale::extents(&positions, &kinds);
        let markers = Markers {
            names: self.names.clone(),
            kinds,
            positions,
            quality: Quality::default(),
            first_frame: self.frame_numbers.first().copied().unwrap_or(1),
            rate_hz: self.rate_hz(),
            unit: scale::unit(self.value("Units").unwrap_or_default(), "the file", extents),
            up: scale::up(None, extents),
            events: Vec::new(),
            analog: Analog::default(),
        };
        (markers, self.notices())
    }

    /// Returns a file with these markers, in their own axes, and their own unit where the format has a name for it, in
    /// metres else. Points that are no positions are left out; blanks and commas in names become `_`.
    pub fn of_markers(markers: &Markers, name: &str) -> Self {
        let (chosen, names) = writable_names(markers);
        let (unit, factor) = match scale::unit_name(markers.unit.metres) {
            Some(name) => (name, 1.0),
            None => ("m", markers.unit.metres),
        };
        // The format has no place for a missing rate; times then count frames.
        let rate = markers.rate_hz.unwrap_or(1.0);
        let frame_count = markers.frame_count();
        let header = [
            ("DataRate", rate.to_string()),
            ("CameraRate", rate.to_string()),
            ("NumFrames", frame_count.to_string()),
            ("NumMarkers", names.len().to_string()),
            ("Units", unit.to_owned()),
            ("OrigDataRate", rate.to_string()),
            ("OrigDataStartFrame", markers.first_frame.to_string()),
            ("OrigNumFrames", frame_count.to_string()),
        ];
        let place = |marker: usize, frame: usize| written(markers.positions.get(marker, frame).map(|at| at * factor));
        let values = (0..frame_count).flat_map(|frame| chosen.iter().flat_map(move |marker| place(*marker, frame)));
        Self {
            path_file_type: ["PathFileType", "4", "(X/Y/Z)", name].map(str::to_owned).to_vec(),
            header: header.map(|(key, value)| (key.to_owned(), value)).to_vec(),
            names,
            frame_numbers: (markers.first_frame..).take(frame_count).collect(),
            times: (0..frame_count).map(|frame| frame as f64 / rate).collect(),
            values: values.collect(),
            broken_places: 0,
        }
    }
}
