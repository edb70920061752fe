//! From where a clip is seen, and how near.
//!
//! There is no perspective: a figure that comes nearer does not grow. The camera stands in front of the figure, somewhat
//! above it, and at that side from which its moves are broadest. It stays where it is, or follows a figure that goes so far
//! that it would be small in the picture; it never goes up and down, so that jumps are seen.

use super::moments::{seen, Moments};
use super::SIZE;
use crate::figure::{bounds, floor, leftward, middle, Actor};
use glam::{Quat, Vec2, Vec3};

/// How far from straight ahead the camera may stand, in degrees, to the figure's left and right. A little to the left is
/// the habit, so that it comes first among equals.
const AROUND_DEG: [f32; 6] = [35.0, -35.0, 55.0, -55.0, 70.0, -70.0];

/// The same where nobody knows where a figure's front is: around Blender's front view.
const ANYWHERE_DEG: [f32; 8] = [35.0, -35.0, 10.0, -10.0, 55.0, -55.0, 80.0, -80.0];

/// By how much another side must be broader than the one before it to be taken.
const BROADER: f32 = 1.03;

/// How far above the horizon the camera stands, in degrees.
const ABOVE_DEG: f32 = 12.0;

/// How much of the picture stays free around joints and markers, in pixels: a head reaches beyond its joint.
const MARGIN: f32 = 9.5;

/// The camera follows where the whole way would make the figure smaller than by this.
const FOLLOWED: f32 = 1.2;

/// Points this many times as far from the middle as most are strays, and no reason to stand back.
const STRAY: f32 = 3.0;

/// Over how many frames of the strip the followed path is smoothed, to either side.
const SMOOTH: usize = 4;

/// No figure is smaller, in metres: a single point is not blown up without end.
const SMALLEST_M: f32 = 0.01;

/// What is this many pictures away is not drawn, nor are lines to it.
const FAR_OUTSIDE: f32 = 4.0;

/// The floor is in the picture where the figure is no higher above it than this share of its height.
const ABOVE_FLOOR: f32 = 0.6;

/// A place of the picture: x to the right and y down in pixels, and how near it is in metres.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Spot {
    pub(super) at: Vec2,
    pub(super) near: f32,
}

/// Where the camera stands.
#[derive(Debug)]
pub(super) struct Camera {
    right: Vec3,
    up: Vec3,
    towards: Vec3,
    /// Pixels per metre.
    pub(super) scale: f32,
    /// What of the picture's plane is in its middle, from the frame's anchor, in metres.
    centre: Vec2,
    /// The place on the floor that the camera stands over, by frame of the strip.
    pub(super) anchors: Vec<Vec3>,
    /// How large the figure usually is on a frame, in metres.
    pub(super) figure: f32,
    /// The height of the floor, where it is in the picture.
    pub(super) floor: Option<f32>,
}

impl Camera {
    /// Finds a place for the camera.
    pub(super) fn facing(actor: &Actor<'_>, moments: &Moments) -> Self {
        // Somebody of whom half is out of sight is no measure.
        let fewest = moments.poses.iter().map(|pose| seen(pose)).max().unwrap_or(0) / 2;
        let whole = moments.poses.iter().map(|pose| if seen(pose) < fewest { &[][..] } else { pose });
        let poses: Vec<Vec<Vec3>> = whole.map(without_strays).collect();
        let front = moments.poses.get(moments.still).and_then(|pose| leftward(&actor.lines, &actor.sides, pose));
        let (front, angles) = match front {
            Some(left) => (left.cross(Vec3::Z), &AROUND_DEG[..]),
            None => (Vec3::NEG_Y, &ANYWHERE_DEG[..]),
        };
        let mut best = (Vec3::X, 0.0);
        for degrees in angles {
            let from = Quat::from_rotation_z(degrees.to_radians()) * front;
            let right = Vec3::Z.cross(from);
            let broad = breadth(&poses, right);
            if broad > best.1 * BROADER || best.1 == 0.0 {
                best = (right, broad);
            }
        }
        let right = best.0;
        let level = right.cross(Vec3::Z);
        let towards = Quat::from_axis_angle(right, -ABOVE_DEG.to_radians()) * level;
        let up = towards.cross(right);
        let floor = floor(moments.poses.iter().map(Vec::as_slice));
        Self::framing(&poses, [right, up, towards], floor)
    }

    fn framing(poses: &[Vec<Vec3>], [right, up, towards]: [Vec3; 3], floor: f32) -> Self {
        let middles = middles(poses);
        let staying = vec![middles.get(middles.len() / 2).copied().unwrap_or_default(); poses.len()];
        let following = smoothed(&middles);
        let low = poses.iter().flatten().map(|point| point.z).fold(f32::INFINITY, f32::min);
        let high = poses.iter().flatten().map(|point| point.z).fold(f32::NEG_INFINITY, f32::max);
        let floor = (low - floor < ABOVE_FLOOR * (high - low)).then_some(floor);
        let frame = |anchors: &[Vec3]| {
            box_around(poses.iter().zip(anchors).flat_map(|(pose, anchor)| {
                let on_floor = floor.map(|floor| anchor.with_z(floor));
                pose.iter().copied().chain(on_floor).map(|point| {
                    let from = point - anchor.with_z(0.0);
                    Vec2::new(right.dot(from), up.dot(from))
                })
            }))
        };
        let size = |(low, high): (Vec2, Vec2)| (high - low).max_element();
        let (of_all, of_figure) = (frame(&staying), frame(&following));
        let follows = size(of_all) > FOLLOWED * size(of_figure);
        let (bounds, anchors) = if follows { (of_figure, following) } else { (of_all, staying) };
        let scale = (SIZE as f32 - 2.0 * MARGIN) / size(bounds).max(SMALLEST_M);
        Self {
            right,
            up,
            towards,
            scale,
            centre: (bounds.0 + bounds.1) / 2.0,
            anchors,
            figure: figure_size(poses),
            floor,
        }
    }

    /// Returns where a point is in the picture of a frame of the strip; `None` where it is far outside, or nowhere.
    pub(super) fn spot(&self, frame: usize, point: Vec3) -> Option<Spot> {
        let from = point - self.anchors.get(frame).copied().unwrap_or_default().with_z(0.0);
        let plane = Vec2::new(self.right.dot(from), self.up.dot(from)) - self.centre;
        let half = SIZE as f32 / 2.0;
        let at = Vec2::new(half + plane.x * self.scale, half - plane.y * self.scale);
        let is_near = at.abs().max_element() < FAR_OUTSIDE * SIZE as f32;
        is_near.then_some(Spot { at, near: self.towards.dot(from) })
    }
}

/// Returns the lowest and the highest coordinates; zeros of nothing.
fn box_around(spots: impl Iterator<Item = Vec2>) -> (Vec2, Vec2) {
    let known = spots.filter(|at| !at.is_nan());
    let all = known.map(|at| (at, at)).reduce(|(low, high), (at, _)| (low.min(at), high.max(at)));
    all.unwrap_or_default()
}

/// Returns how large the figure is on half of the frames: the longest edge of the box around it.
fn figure_size(poses: &[Vec<Vec3>]) -> f32 {
    let boxes = poses.iter().filter_map(|pose| bounds(pose));
    let mut sizes: Vec<f32> = boxes.map(|[low, high]| (high - low).max_element()).collect();
    sizes.sort_by(f32::total_cmp);
    sizes.get(sizes.len() / 2).copied().unwrap_or(0.0).max(SMALLEST_M)
}

/// Returns how broad figures are along a direction: the mean square from the middle of each frame.
fn breadth(poses: &[Vec<Vec3>], right: Vec3) -> f32 {
    let squares = poses.iter().flat_map(|pose| {
        let centre = middle(pose).unwrap_or_default();
        pose.iter().map(move |point| right.dot(*point - centre).powi(2))
    });
    let known = squares.filter(|square| !square.is_nan());
    let (sum, count) = known.fold((0.0, 0.0), |(sum, count), square| (sum + square, count + 1.0));
    sum / f32::max(count, 1.0)
}

/// Returns the pose with strays as gaps.
fn without_strays(pose: &[Vec3]) -> Vec<Vec3> {
    let coordinate = |axis: usize| {
        let mut values: Vec<f32> = pose.iter().map(|point| point[axis]).filter(|value| !value.is_nan()).collect();
        values.sort_by(f32::total_cmp);
        values.get(values.len() / 2).copied().unwrap_or(0.0)
    };
    let centre = Vec3::new(coordinate(0), coordinate(1), coordinate(2));
    let mut away: Vec<f32> = pose.iter().map(|point| point.distance(centre)).filter(|away| !away.is_nan()).collect();
    away.sort_by(f32::total_cmp);
    let most = STRAY * away.get(away.len() * 3 / 4).copied().unwrap_or(0.0);
    pose.iter().map(|point| if point.distance(centre) > most { Vec3::NAN } else { *point }).collect()
}

/// Returns the middle of each pose on the floor plane; where nothing is seen, that of the frame before or after.
fn middles(poses: &[Vec<Vec3>]) -> Vec<Vec3> {
    let found: Vec<Option<Vec3>> = poses.iter().map(|pose| middle(pose)).collect();
    let mut last = found.iter().flatten().next().copied().unwrap_or_default();
    let held = found.into_iter().map(|middle| {
        last = middle.unwrap_or(last);
        last.with_z(0.0)
    });
    held.collect()
}

fn smoothed(path: &[Vec3]) -> Vec<Vec3> {
    let around = |index: usize| {
        let reach = SMOOTH.min(index).min(path.len() - 1 - index);
        let window = path.get(index - reach..=index + reach).unwrap_or_default();
        middle(window).unwrap_or_default()
    };
    (0..path.len()).map(around).collect()
}
