//! A figure between frames, as a graphics card wants it.

use super::{Figure, Side};
use glam::Vec3;

impl Figure {
    /// Returns where all points are at a real-valued frame counted from 0, held between the first and the last.
    ///
    /// Between two frames points go in a straight line. That is meant for the eye: at half the way a limb that turns is
    /// a little short. A point that is seen on one of the two frames only is where it is on the nearer one.
    pub fn positions(&self, frame: f64) -> Vec<Vec3> {
        let last = self.frame_count.saturating_sub(1) as f64;
        let frame = frame.max(0.0).min(last);
        let (from, to) = (self.frame(frame as usize), self.frame(frame.ceil() as usize));
        let part = frame.fract() as f32;
        let between = |(from, to): (&Vec3, &Vec3)| match from.lerp(*to, part) {
            between if between.is_nan() && part < 0.5 => *from,
            between if between.is_nan() => *to,
            between => between,
        };
        from.iter().zip(to).map(between).collect()
    }

    /// Returns the ends of all lines at a real-valued frame counted from 0 (see [`Figure::positions`]), line after line.
    ///
    /// A line of which an end is not seen has no length, so that nothing is drawn: it lies in the other end, or where
    /// that is not seen either on the floor.
    pub fn segments(&self, frame: f64) -> Vec<[Vec3; 2]> {
        let points = self.positions(frame);
        let at = |point: usize| points.get(point).copied().filter(|point| !point.is_nan());
        let nowhere = Vec3::new(0.0, 0.0, self.floor);
        let segment = |line: &[usize; 2]| match line.map(at) {
            [Some(a), Some(b)] => [a, b],
            [Some(seen), None] | [None, Some(seen)] => [seen, seen],
            [None, None] => [nowhere, nowhere],
        };
        self.lines.iter().map(segment).collect()
    }

    /// Returns the points that are seen at a real-valued frame counted from 0 (see [`Figure::positions`]).
    pub fn dots(&self, frame: f64) -> Vec<Vec3> {
        let mut points = self.positions(frame);
        points.retain(|point| !point.is_nan());
        points
    }

    /// Returns one colour for each end of each line, in the order of [`Figure::segments`].
    pub fn colours<C: Copy>(&self, left: C, middle: C, right: C) -> Vec<[C; 2]> {
        let colour = |side: &Side| match side {
            Side::Left => [left; 2],
            Side::Middle => [middle; 2],
            Side::Right => [right; 2],
        };
        self.sides.iter().map(colour).collect()
    }
}
