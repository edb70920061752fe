//! What is in a clip as points and lines, placed on the frames that are asked for and on no others.

use super::bridges::bridges;
use super::heading;
use super::joints::{End, Joints};
use super::sides::{sides, Side};
use glam::{DMat3, DVec3, Vec3};
use motion_theater_core::gaps::neighbours;
use motion_theater_core::loaded::{LoadError, Loaded};
use motion_theater_core::markers::PointKind;
use motion_theater_core::pose::pose;
use motion_theater_core::stack::ASSUMED_RATE_HZ;
use motion_theater_core::upright::to_z_up;
use motion_theater_core::{Markers, Motion, Skeleton};

/// How many frames are looked at to tell which lines are bones and which side they are on.
const LOOKS: usize = 24;

/// A line that is ever this many times as long as at its shortest is no bone: it leads from a root on the floor to a
/// figure that walks away from it.
const ELASTIC: f32 = 1.5;

/// Lines that never are longer than this are points, in metres.
const SHORTEST_M: f32 = 1e-5;

/// A skeleton with its motion, or markers, as points and lines that can be placed on any frame.
#[derive(Debug)]
pub struct Actor<'a> {
    /// One per point.
    pub names: Vec<String>,
    /// Which points each line joins.
    pub lines: Vec<[usize; 2]>,
    /// One per line.
    pub sides: Vec<Side>,
    /// How many frames there are; at least one of a skeleton, which rests where it has no motion.
    pub frame_count: usize,
    /// The file's own number of the first frame.
    pub first_frame: i64,
    /// Frames per second; assumed where the file does not say.
    pub rate_hz: f64,
    to_metres: DMat3,
    body: Body<'a>,
}

#[derive(Debug)]
enum Body<'a> {
    Joints {
        skeleton: &'a Skeleton,
        motion: Option<&'a Motion>,
        ends: Vec<End>,
    },
    /// Which of the markers are positions.
    Markers {
        markers: &'a Markers,
        chosen: Vec<usize>,
    },
}

impl<'a> Actor<'a> {
    /// Takes what a file holds: its markers, or else its skeleton.
    ///
    /// # Errors
    /// Where there is neither: a motion whose skeleton was not found.
    pub fn of(loaded: &'a Loaded) -> Result<Self, LoadError> {
        match loaded.clip.markers() {
            Some(markers) => Ok(Self::of_markers(markers)),
            None => Ok(Self::of_skeleton(loaded.skeleton()?, loaded.motion.as_ref())),
        }
    }

    /// Takes a skeleton and its motion, in the file's axes, or its rest pose where it has none.
    pub fn of_skeleton(skeleton: &'a Skeleton, motion: Option<&'a Motion>) -> Self {
        let motion = motion.filter(|motion| motion.frame_count > 0);
        let Joints { names, ends, lines, sides } = Joints::new(skeleton, motion);
        Self {
            names,
            lines,
            sides,
            frame_count: motion.map_or(1, |motion| motion.frame_count),
            first_frame: motion.map_or(1, |motion| motion.first_frame),
            rate_hz: known_rate(motion.and_then(|motion| motion.rate_hz)),
            to_metres: to_z_up(skeleton.up) * skeleton.unit.metres,
            body: Body::Joints { skeleton, motion, ends },
        }
        .with_bones_and_sides_seen()
    }

    /// Takes the markers that are positions; forces and angles have no place.
    pub fn of_markers(markers: &'a Markers) -> Self {
        let is_position = |marker: &usize| markers.kinds.get(*marker) == Some(&PointKind::Position);
        let chosen: Vec<usize> = (0..markers.count()).filter(is_position).collect();
        let name = |marker: &usize| markers.names.get(*marker).cloned().unwrap_or_default();
        let names: Vec<String> = chosen.iter().map(name).collect();
        let point_of = |marker: usize| chosen.binary_search(&marker).ok();
        let pairs = neighbours(&markers.positions, &markers.kinds);
        let lines: Vec<[usize; 2]> =
            pairs.into_iter().filter_map(|(a, b)| Some([point_of(a)?, point_of(b)?])).collect();
        let of_points: Vec<Side> = sides(names.iter().map(String::as_str));
        let actor = Self {
            sides: Vec::new(),
            names,
            lines,
            frame_count: markers.frame_count(),
            first_frame: markers.first_frame,
            rate_hz: known_rate(markers.rate_hz),
            to_metres: to_z_up(markers.up.axis) * markers.unit.metres,
            body: Body::Markers { markers, chosen },
        };
        actor.with_bridges(&of_points).with_bones_and_sides_seen()
    }

    /// Returns whether the points are markers, and no joints.
    pub(crate) fn is_markers(&self) -> bool {
        matches!(self.body, Body::Markers { .. })
    }

    /// Adds where all points are on a frame counted from 0, in metres, Z up. What is not seen is not a number; a marker
    /// exactly in the origin is not seen either, for that is how many programs write it.
    pub fn place(&self, frame: usize, points: &mut Vec<Vec3>) {
        let in_metres = |at: DVec3| {
            let point = (self.to_metres * at).as_vec3();
            if point.is_finite() {
                point
            } else {
                Vec3::NAN
            }
        };
        match &self.body {
            Body::Joints { skeleton, motion, ends } => {
                let at_rest = Motion::default();
                let motion = motion.unwrap_or(&at_rest);
                let pose = pose(skeleton, motion, motion.first_frame as f64 + frame as f64);
                let of = |list: &[DVec3], bone: usize| list.get(bone).copied().unwrap_or(DVec3::NAN);
                points.extend(ends.iter().map(|end| match *end {
                    End::Head(bone) => in_metres(of(&pose.heads, bone)),
                    End::Tail(bone) => in_metres(of(&pose.tails, bone)),
                }));
            }
            Body::Markers { markers, chosen } => {
                let seen = |marker| markers.positions.get(marker, frame).filter(|at| *at != DVec3::ZERO);
                points.extend(chosen.iter().map(|marker| in_metres(seen(*marker).unwrap_or(DVec3::NAN))));
            }
        }
    }

    /// Joins groups of markers, and gives each line the side of its ends.
    fn with_bridges(mut self, of_points: &[Side]) -> Self {
        let looks: Vec<Vec<Vec3>> = evenly(self.frame_count, LOOKS).map(|frame| self.placed(frame)).collect();
        self.lines.extend(bridges(&self.lines, of_points, &looks));
        let side_of = |point: usize| of_points.get(point).copied().unwrap_or_default();
        self.sides = self.lines.iter().map(|[a, b]| side_of(*a).with(side_of(*b))).collect();
        self
    }

    /// Leaves out lines that are no bones, and finds sides by the way the figure goes where names say none.
    fn with_bones_and_sides_seen(mut self) -> Self {
        let looks: Vec<Vec<Vec3>> = evenly(self.frame_count, LOOKS).map(|frame| self.placed(frame)).collect();
        let is_bone: Vec<bool> = self.lines.iter().map(|line| is_bone(*line, &looks)).collect();
        let mut keep = is_bone.iter();
        self.lines.retain(|_| keep.next() == Some(&true));
        let mut keep = is_bone.iter();
        self.sides.retain(|_| keep.next() == Some(&true));
        if self.sides.iter().all(|side| *side == Side::Middle) {
            self.sides = heading::sides(&self.lines, &looks);
        }
        self
    }

    /// Returns where all points are on a frame counted from 0.
    pub(crate) fn placed(&self, frame: usize) -> Vec<Vec3> {
        let mut points = Vec::with_capacity(self.names.len());
        self.place(frame, &mut points);
        points
    }
}

/// Returns up to `most` frames of `count`, evenly spread from the first to the last.
pub(crate) fn evenly(count: usize, most: usize) -> impl Iterator<Item = usize> + Clone {
    let taken = count.min(most);
    (0..taken).map(move |index| index * count.saturating_sub(1) / taken.saturating_sub(1).max(1))
}

fn known_rate(rate_hz: Option<f64>) -> f64 {
    rate_hz.filter(|rate| rate.is_finite() && *rate > 0.0).unwrap_or(ASSUMED_RATE_HZ)
}

/// Returns whether a line keeps its length; one that is never seen as a whole may be one.
pub(super) fn is_bone([a, b]: [usize; 2], looks: &[Vec<Vec3>]) -> bool {
    let lengths = looks.iter().filter_map(|points| Some(points.get(a)?.distance(*points.get(b)?)));
    let (mut shortest, mut longest) = (f32::INFINITY, 0_f32);
    for length in lengths.filter(|length| !length.is_nan()) {
        (shortest, longest) = (shortest.min(length), longest.max(length));
    }
    shortest == f32::INFINITY || (longest > SHORTEST_M && longest <= ELASTIC * shortest)
}
