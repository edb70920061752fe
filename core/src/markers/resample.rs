//! Markers at another rate.

use super::{Analog, Markers, Positions, Quality};
use crate::error::ParameterError;
use crate::sample::{lowpass_vectors, nearest_frame, sample_vector, Sampling};
use glam::DVec3;

/// The most samples (markers times frames) that resampling may make of markers that have fewer: about 6 GB.
const MOST_SAMPLES: usize = 1 << 28;

/// A frame that misses the last moment by less than this part of a frame is rounding.
const SLACK_FRAMES: f64 = 1e-6;

impl Markers {
    /// Returns the same movement at another rate, low-passed first when going down; every stretch of seen samples by
    /// itself, so that gaps stay. At the markers' own rate nothing changes.
    ///
    /// Frame 1 stays the moment 0 of the recording, which events count from; so the number of the first frame changes.
    /// The first and the last frame are those nearest to the moments of the old ones, so the duration stays to half a frame
    /// at either end; what lies outside shows the old ones.
    /// Residuals and analog signals, which belong to the old frames, are left out.
    ///
    /// # Errors
    /// If the markers do not know their own rate, if either rate is not a number above 0, or if the result would be larger
    /// than memory can be expected to hold.
    pub fn resampled(&self, rate_hz_to: f64) -> Result<Self, ParameterError> {
        let unknown =
            || ParameterError("the markers do not say their rate, so they cannot be brought to another".into());
        let rate_hz = self.rate_hz.ok_or_else(unknown)?;
        let is_rate = |rate: f64| rate.is_finite() && rate > 0.0;
        if let Some(wrong) = [rate_hz, rate_hz_to].into_iter().find(|rate| !is_rate(*rate)) {
            return Err(ParameterError(format!("a rate is a number of frames per second above 0, not {wrong}")));
        }
        if rate_hz == rate_hz_to {
            return Ok(self.clone());
        }
        let ratio = rate_hz / rate_hz_to;
        let (first, last) = ((self.first_frame - 1) as f64, (self.last_frame() - 1) as f64);
        let new_first = nearest_frame(first / ratio);
        let new_count = if self.frame_count() > 0 { nearest_frame(last / ratio) - new_first + 1.0 } else { 0.0 };
        let most = MOST_SAMPLES.max(self.count().saturating_mul(self.frame_count()));
        if new_count * self.count().max(1) as f64 > most as f64 {
            return Err(ParameterError(format!(
                "at {rate_hz_to} frames per second there would be {new_count} frames, more than memory can be expected to hold"
            )));
        }
        let moments = (0..new_count as usize).map(|frame| (new_first + frame as f64) * ratio - first);
        let at: Vec<f64> = moments.map(|moment| moment.clamp(0.0, last - first)).collect();
        let trajectories = (0..self.count()).flat_map(|marker| sampled(&self.positions.trajectory(marker), &at, ratio));
        let positions = if self.positions.as_f64().is_none() {
            Positions::of_f32(trajectories.flat_map(|at| at.as_vec3().to_array()).collect(), at.len())
        } else {
            Positions::of_f64(trajectories.flat_map(|at| at.to_array()).collect(), at.len())
        };
        Ok(Self {
            positions,
            quality: Quality::default(),
            first_frame: new_first as i64 + 1,
            rate_hz: Some(rate_hz_to),
            analog: Analog::default(),
            names: self.names.clone(),
            kinds: self.kinds.clone(),
            unit: self.unit.clone(),
            up: self.up.clone(),
            events: self.events.clone(),
        })
    }
}

/// Samples a trajectory at real-valued frames; between a seen and a missing sample there is nothing.
fn sampled(trajectory: &[DVec3], frames: &[f64], ratio: f64) -> Vec<DVec3> {
    let mut result = vec![DVec3::NAN; frames.len()];
    let mut start = 0;
    for seen in trajectory.chunk_by(|a, b| a.is_nan() == b.is_nan()) {
        let (from, to) = (start as f64, (start + seen.len() - 1) as f64);
        start += seen.len();
        if seen.first().is_some_and(|at| at.is_nan()) {
            continue;
        }
        let smooth = lowpass_vectors(seen, ratio);
        for (place, frame) in result.iter_mut().zip(frames) {
            if (from - SLACK_FRAMES..=to + SLACK_FRAMES).contains(frame) {
                *place = sample_vector(&smooth, frame - from, Sampling::Smooth);
            }
        }
    }
    result
}

#[cfg(test)]
mod tests {
    use super::super::tests::walk;
    use super::*;
    use crate::markers::Event;

    fn xs(markers: &Markers) -> Vec<f64> {
        markers.positions.trajectory(0).iter().map(|at| at.x).collect()
    }

    #[test]
    fn twice_the_rate_keeps_every_sample_and_its_moment() {
        let mut markers = walk(&[&[0.0, 1.0, 2.0, 3.0]], Some(50.0));
        markers.first_frame = 11;
        markers.events = vec![Event { time_s: 0.22, ..Event::default() }];
        let finer = markers.resampled(100.0).unwrap();
        assert_eq!(xs(&finer), [0.0, 0.5, 1.0, 1.5, 2.0, 2.5, 3.0]);
        assert_eq!((finer.first_frame, finer.rate_hz), (21, Some(100.0)));
        // The event lies on the second sample before and after.
        assert_eq!(markers.frame_of(&markers.events[0]), Some(12.0));
        assert_eq!(finer.frame_of(&finer.events[0]), Some(23.0));
    }

    #[test]
    fn first_and_last_frame_are_nearest_to_the_old_ones_and_show_them() {
        let mut markers = walk(&[&[0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0]], Some(50.0));
        // From 0.06 s to 0.22 s: at 30 Hz frames 1.8 to 6.6.
        markers.first_frame = 4;
        let slower = markers.resampled(30.0).unwrap();
        assert_eq!((slower.first_frame, slower.last_frame()), (3, 8));
        let found = xs(&slower);
        assert!((found[1] - 2.0).abs() < 0.01, "{found:?}");
        assert_eq!(found.last(), Some(&8.0));
        // From 0.04 s to 0.2 s: at 30 Hz frames 1.2 to 6.
        markers.first_frame = 3;
        let slower = markers.resampled(30.0).unwrap();
        assert_eq!((slower.first_frame, slower.last_frame(), xs(&slower)[0]), (2, 7, 0.0));
    }

    #[test]
    fn gaps_stay_and_nothing_is_made_up_at_their_borders() {
        let gap = f64::NAN;
        let finer = walk(&[&[0.0, 1.0, gap, 3.0, 3.0]], Some(50.0)).resampled(100.0).unwrap();
        let seen: Vec<bool> = xs(&finer).iter().map(|x| !x.is_nan()).collect();
        assert_eq!(seen, [true, true, true, false, false, false, true, true, true]);
    }

    #[test]
    fn rates_without_sense_are_refused_in_words() {
        let refusal = |from, to| walk(&[&[0.0, 1.0]], from).resampled(to).unwrap_err().to_string();
        assert!(refusal(None, 30.0).starts_with("the markers do not say their rate"));
        assert_eq!(refusal(Some(50.0), -1.0), "a rate is a number of frames per second above 0, not -1");
        assert!(refusal(Some(50.0), 1e12).contains("more than memory can be expected to hold"));
    }
}
