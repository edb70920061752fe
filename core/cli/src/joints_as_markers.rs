//! The joints of a skeleton in motion as markers.

use motion_theater_core::markers::{Analog, Markers, PointKind, Positions, Quality, UpAxis};
use motion_theater_core::read::Clip;
use motion_theater_core::{Motion, Skeleton};

use crate::points::{points, positions};

/// Returns the points of a file (see [`points`]) as markers, in its axes and units.
pub fn joints_as_markers(clip: &Clip, skeleton: &Skeleton, motion: &Motion) -> Markers {
    let points = points(clip, skeleton);
    let frame_count = motion.frame_count;
    let mut values = vec![0.0; points.len() * frame_count * 3];
    for frame in 0..frame_count {
        let at = (motion.first_frame + frame as i64) as f64;
        for (point, position) in positions(&points, skeleton, Some(motion), at).into_iter().enumerate() {
            let start = (point * frame_count + frame) * 3;
            if let Some(place) = values.get_mut(start..start + 3) {
                place.copy_from_slice(&position.to_array());
            }
        }
    }
    Markers {
        kinds: vec![PointKind::Position; points.len()],
        names: points.into_iter().map(|point| point.name).collect(),
        positions: Positions::of_f64(values, frame_count),
        quality: Quality::default(),
        first_frame: motion.first_frame,
        rate_hz: motion.rate_hz,
        unit: skeleton.unit.clone(),
        up: UpAxis { axis: skeleton.up, reason: "that of the skeleton".to_owned(), is_certain: true },
        events: Vec::new(),
        analog: Analog::default(),
    }
}
