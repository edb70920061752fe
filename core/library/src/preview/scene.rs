//! What is in a picture: the floor, the way the figure goes, and the figure, from far to near.
//!
//! The figure is drawn limb by limb (an arm, a leg, the trunk), each with a dark rim around all of it: so a limb is in one
//! piece, and where two cross one sees which is in front.

use super::camera::{Camera, Spot};
use super::canvas::{Canvas, Colour};
use super::head;
use super::limbs::{limbs, Limb};
use super::moments::Moments;
use crate::figure::{middle, Actor, Side};
use glam::{Vec2, Vec3};

/// How wide a limb is, in sizes of the figure, and in pixels at least and at most.
const WIDTH: f32 = 0.035;
const WIDTH_PIXELS: std::ops::RangeInclusive<f32> = 1.6..=4.2;

/// Lines between markers are thinner: they are many, and no limbs.
const STRING: f32 = 0.65;

/// By how much the nearest limb is wider than the middle ones, and the farthest is narrower.
const NEARER: f32 = 0.25;

/// How far apart the marks on the floor are, in sizes of the figure, ...
const MARKS: f32 = 0.35;

/// ... and how many are drawn to each side of it.
const MARKS_AROUND: i32 = 2;

/// The way is drawn through so many places.
const WAY_PLACES: usize = 12;

/// Everything that is drawn, frame by frame.
pub(super) struct Scene<'a> {
    actor: &'a Actor<'a>,
    moments: &'a Moments,
    camera: &'a Camera,
    limbs: Vec<Limb>,
    head: Vec<usize>,
    /// The places that the figure goes over.
    way: Vec<Vec3>,
}

impl<'a> Scene<'a> {
    /// Sets the stage.
    pub(super) fn new(actor: &'a Actor<'a>, moments: &'a Moments, camera: &'a Camera) -> Self {
        let head = if actor.is_markers() { Vec::new() } else { head::points(&actor.names) };
        let path: Vec<Vec3> = moments.poses.iter().filter_map(|pose| middle(pose)).collect();
        let way = crate::figure::evenly(path.len(), WAY_PLACES).filter_map(|at| path.get(at).copied()).collect();
        Self { actor, moments, camera, limbs: limbs(actor), head, way }
    }

    /// Draws a frame of the strip.
    pub(super) fn draw(&self, frame: usize, canvas: &mut Canvas) {
        canvas.clear();
        let Some(pose) = self.moments.poses.get(frame) else { return };
        if let Some(floor) = self.camera.floor {
            self.draw_floor(frame, pose, floor, canvas);
        }
        let of_head: Vec<Vec3> = self.head.iter().filter_map(|point| pose.get(*point).copied()).collect();
        let head = middle(&of_head).and_then(|at| self.camera.spot(frame, at));
        let mut shapes: Vec<Shape> = self.limbs.iter().map(|limb| self.shape(frame, pose, limb, head)).collect();
        shapes.extend(head.map(|at| Shape {
            near: at.near,
            lines: Vec::new(),
            dots: vec![at.at],
            dot: self.head_radius(),
            line: 0.0,
            colours: [Colour::Middle; 2],
        }));
        shapes.sort_by(|a, b| a.near.total_cmp(&b.near));
        for shape in &shapes {
            canvas.limb(&shape.lines, shape.line, &shape.dots, shape.dot, shape.colours);
        }
    }

    fn head_radius(&self) -> f32 {
        head::WIDTH / 2.0 * self.camera.figure * self.camera.scale
    }

    fn shape(&self, frame: usize, pose: &[Vec3], limb: &Limb, head: Option<Spot>) -> Shape {
        let spot = |point: usize| self.camera.spot(frame, *pose.get(point)?);
        let lines: Vec<[Spot; 2]> =
            limb.lines.iter().filter_map(|[from, to]| Some([spot(*from)?, spot(*to)?])).collect();
        // What is inside of the head: a face of many joints.
        let is_inside = |end: &Spot| head.is_some_and(|head| head.at.distance(end.at) < 1.3 * self.head_radius());
        let shown = lines.iter().filter(|ends| !ends.iter().all(is_inside));
        let is_markers = self.actor.is_markers();
        let dots: Vec<Spot> = limb.points.iter().filter(|_| is_markers).filter_map(|point| spot(*point)).collect();
        let depths = lines.iter().flatten().chain(&dots).map(|spot| spot.near);
        let (sum, count) = depths.fold((0.0, 0.0), |(sum, count), near| (sum + near, count + 1.0));
        let near = sum / f32::max(count, 1.0);
        let width = (WIDTH * self.camera.figure * self.camera.scale).clamp(*WIDTH_PIXELS.start(), *WIDTH_PIXELS.end());
        let width = width * (1.0 + NEARER * (near / self.camera.figure * 4.0).clamp(-1.0, 1.0));
        Shape {
            near,
            line: if is_markers { width * STRING } else { width },
            lines: shown.map(|ends| ends.map(|end| end.at)).collect(),
            dot: width * 0.5,
            dots: dots.into_iter().map(|spot| spot.at).collect(),
            colours: [limb.side.into(), if limb.side == Side::Middle { Colour::Marker } else { limb.side.into() }],
        }
    }

    /// Marks on the floor, which pass by where the camera follows; the way the figure goes; its shadow.
    fn draw_floor(&self, frame: usize, pose: &[Vec3], floor: f32, canvas: &mut Canvas) {
        let on_floor = |at: Vec3| Some(self.camera.spot(frame, at.with_z(floor))?.at);
        let apart = MARKS * self.camera.figure;
        let anchor = self.camera.anchors.get(frame).copied().unwrap_or_default().with_z(0.0);
        let around = (anchor / apart).round();
        let reach = -MARKS_AROUND..=MARKS_AROUND;
        let marks = reach.clone().flat_map(|x| reach.clone().map(move |y| Vec3::new(x as f32, y as f32, 0.0)));
        let marks = marks.map(|mark| (around + mark) * apart);
        let marks: Vec<Vec2> =
            marks.filter(|mark| mark.distance(anchor) < MARKS_AROUND as f32 * apart).filter_map(on_floor).collect();
        canvas.marks(&marks);
        let way: Vec<Vec2> = self.way.iter().filter_map(|at| on_floor(*at)).collect();
        canvas.way(&way);
        if let Some(under) = middle(pose).and_then(on_floor) {
            canvas.shadow(under, 0.16 * self.camera.figure * self.camera.scale);
        }
    }
}

/// A limb in the picture.
struct Shape {
    near: f32,
    lines: Vec<[Vec2; 2]>,
    line: f32,
    dots: Vec<Vec2>,
    dot: f32,
    /// Of lines and of dots.
    colours: [Colour; 2],
}
