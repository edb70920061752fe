//! Where markers are: trajectory after trajectory, in the width of the file's numbers.

use crate::formats::c3d::Frames;
use glam::DVec3;
use std::borrow::Cow;

/// Positions of all markers on all frames. A gap is a position that is not a number.
///
/// As numbers they lie marker after marker, frame after frame, x y z; binary files have 32 bits for each, text files have
/// as many digits as they like. Those of a C3D stay where they lie in the file until they are changed: looking at some of
/// them, or at one trajectory, costs no more than that.
#[derive(Debug, Clone)]
pub struct Positions {
    frame_count: usize,
    values: Values,
}

#[derive(Debug, Clone)]
enum Values {
    Single(Vec<f32>),
    Double(Vec<f64>),
    Recorded(Frames),
}

impl Positions {
    /// Takes the positions of whole trajectories of `frame_count` frames each; what is left over is cut off.
    pub fn of_f32(mut values: Vec<f32>, frame_count: usize) -> Self {
        values.truncate(whole(values.len(), frame_count));
        Self { frame_count, values: Values::Single(values) }
    }

    /// Takes the positions of whole trajectories of `frame_count` frames each; what is left over is cut off.
    pub fn of_f64(mut values: Vec<f64>, frame_count: usize) -> Self {
        values.truncate(whole(values.len(), frame_count));
        Self { frame_count, values: Values::Double(values) }
    }

    /// Takes those of a C3D.
    pub(crate) fn recorded(frames: Frames) -> Self {
        Self { frame_count: frames.frame_count(), values: Values::Recorded(frames) }
    }

    /// Returns how many frames each trajectory has.
    pub fn frame_count(&self) -> usize {
        self.frame_count
    }

    /// Returns the numbers where they are of 32 bits; `None` where they are of 64.
    pub fn to_f32(&self) -> Option<Cow<'_, [f32]>> {
        match &self.values {
            Values::Single(values) => Some(Cow::Borrowed(values)),
            Values::Double(_) => None,
            Values::Recorded(frames) => Some(Cow::Owned(frames.positions())),
        }
    }

    /// Returns the numbers where they are of 64 bits; `None` where they are of 32.
    pub fn as_f64(&self) -> Option<&[f64]> {
        match &self.values {
            Values::Single(_) | Values::Recorded(_) => None,
            Values::Double(values) => Some(values),
        }
    }

    /// Returns where a marker is on a frame counted from 0; `None` in a gap, or where there is no such sample.
    #[inline]
    pub fn get(&self, marker: usize, frame: usize) -> Option<DVec3> {
        if frame >= self.frame_count {
            return None;
        }
        let at = marker.checked_mul(self.frame_count)?.checked_add(frame)?;
        let position = match &self.values {
            Values::Single(values) => DVec3::from_array(values.as_chunks::<3>().0.get(at)?.map(f64::from)),
            Values::Double(values) => DVec3::from_array(*values.as_chunks::<3>().0.get(at)?),
            Values::Recorded(frames) => DVec3::from_array(frames.position(marker, frame)?.map(f64::from)),
        };
        (!position.is_nan()).then_some(position)
    }

    /// Returns a trajectory; gaps are not numbers.
    pub fn trajectory(&self, marker: usize) -> Vec<DVec3> {
        let gap = DVec3::NAN;
        (0..self.frame_count).map(|frame| self.get(marker, frame).unwrap_or(gap)).collect()
    }

    /// Replaces a trajectory, rounded to the width of the others; what is too long is left out.
    pub fn set_trajectory(&mut self, marker: usize, trajectory: &[DVec3]) {
        if let Values::Recorded(frames) = &self.values {
            self.values = Values::Single(frames.positions());
        }
        let start = marker.saturating_mul(self.frame_count);
        let wanted = trajectory.iter().take(self.frame_count);
        match &mut self.values {
            Values::Single(values) => {
                let places = values.as_chunks_mut::<3>().0.iter_mut().skip(start);
                places.zip(wanted).for_each(|(place, value)| *place = value.to_array().map(|x| x as f32));
            }
            Values::Double(values) => {
                let places = values.as_chunks_mut::<3>().0.iter_mut().skip(start);
                places.zip(wanted).for_each(|(place, value)| *place = value.to_array());
            }
            Values::Recorded(_) => {}
        }
    }

    /// Returns for every sample whether the marker was seen, marker after marker.
    pub fn valid(&self) -> Vec<bool> {
        if let Values::Recorded(frames) = &self.values {
            return frames.seen();
        }
        (0..self.marker_count())
            .flat_map(|marker| (0..self.frame_count).map(move |frame| self.get(marker, frame).is_some()))
            .collect()
    }

    fn marker_count(&self) -> usize {
        let of_numbers = |count: usize| count.checked_div(3 * self.frame_count).unwrap_or(0);
        match &self.values {
            Values::Single(values) => of_numbers(values.len()),
            Values::Double(values) => of_numbers(values.len()),
            Values::Recorded(frames) => frames.point_count(),
        }
    }
}

/// Positions are equal where all samples are, whatever holds them; gaps are equal to each other.
impl PartialEq for Positions {
    fn eq(&self, other: &Self) -> bool {
        let shape = |positions: &Self| (positions.marker_count(), positions.frame_count);
        let is_same = |marker| (0..self.frame_count).all(|frame| self.get(marker, frame) == other.get(marker, frame));
        shape(self) == shape(other) && (0..self.marker_count()).all(is_same)
    }
}

/// Returns how many of `length` numbers make whole trajectories.
fn whole(length: usize, frame_count: usize) -> usize {
    let trajectory = frame_count.saturating_mul(3);
    length - length.checked_rem(trajectory).unwrap_or(length)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_trajectory_set_is_a_trajectory_got_and_others_stay() {
        let numbers: Vec<f64> = (0..18).map(f64::from).collect();
        let single = Positions::of_f32(numbers.iter().map(|x| *x as f32).collect(), 2);
        for mut positions in [Positions::of_f64(numbers, 2), single] {
            let (first, last) = (positions.trajectory(0), positions.trajectory(2));
            assert_eq!(positions.trajectory(1), [DVec3::new(6.0, 7.0, 8.0), DVec3::new(9.0, 10.0, 11.0)]);
            positions.set_trajectory(1, &[DVec3::NAN, DVec3::ONE]);
            assert_eq!((positions.get(1, 0), positions.get(1, 1)), (None, Some(DVec3::ONE)));
            assert_eq!((positions.trajectory(0), positions.trajectory(2)), (first, last));
            assert_eq!(positions.valid(), [true, true, false, true, true, true]);
            assert_eq!((positions.get(1, 2), positions.get(3, 0)), (None, None));
            assert_eq!(positions, positions.clone());
        }
    }

    #[test]
    fn what_makes_no_whole_trajectory_is_cut_off() {
        assert_eq!(Positions::of_f32(vec![0.0; 11], 1).valid().len(), 3);
        assert_eq!(Positions::of_f32(vec![0.0; 11], 2).valid().len(), 2);
        assert_eq!(Positions::of_f64(vec![0.0; 11], 0).valid().len(), 0);
    }
}
