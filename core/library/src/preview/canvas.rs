//! One small picture: what is drawn where, in which colours.

use crate::figure::Side;
use glam::Vec2;
use tiny_skia::{
    Color, FillRule, LineCap, Paint, Path, PathBuilder, Pixmap, PremultipliedColorU8, Rect, Stroke, Transform,
};

/// What a colour stands for. They are bright, and limbs have a dark rim: so they are seen on dark and light grounds.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Colour {
    /// Limbs on the figure's left: blue, as animators have them.
    Left,
    /// The trunk, and what has no side.
    Middle,
    /// Limbs on the figure's right: orange, which differs from blue for all eyes.
    Right,
    /// Markers.
    Marker,
    /// Marks on the floor.
    Floor,
    /// The way the figure goes.
    Way,
    /// What separates limbs that cross.
    Rim,
    /// The shadow on the floor.
    Shadow,
}

impl Colour {
    /// Returns red, green, blue and opacity.
    fn rgba(self) -> [u8; 4] {
        match self {
            Self::Left => [79, 160, 255, 255],
            Self::Middle => [205, 205, 205, 255],
            Self::Right => [255, 138, 56, 255],
            Self::Marker => [240, 240, 240, 255],
            Self::Floor => [128, 128, 128, 150],
            Self::Way => [128, 128, 128, 200],
            Self::Rim => [24, 24, 28, 220],
            Self::Shadow => [100, 100, 100, 90],
        }
    }
}

impl From<Side> for Colour {
    fn from(side: Side) -> Self {
        match side {
            Side::Left => Self::Left,
            Side::Middle => Self::Middle,
            Side::Right => Self::Right,
        }
    }
}

/// How far a rim reaches over what it surrounds, in pixels.
const RIM: f32 = 0.9;

/// How large marks on the floor are, and how wide the way is, in pixels.
const MARK: f32 = 0.7;
const WAY: f32 = 1.2;

/// A picture that is drawn into.
pub(super) struct Canvas {
    pixmap: Option<Pixmap>,
}

impl Canvas {
    /// Makes a picture of `size` pixels in width and height.
    pub(super) fn new(size: usize) -> Self {
        Self { pixmap: Pixmap::new(size as u32, size as u32) }
    }

    /// Makes everything transparent.
    pub(super) fn clear(&mut self) {
        if let Some(pixmap) = &mut self.pixmap {
            pixmap.fill(Color::TRANSPARENT);
        }
    }

    /// Returns the pixels, row after row from the top.
    pub(super) fn pixels(&self) -> &[PremultipliedColorU8] {
        self.pixmap.as_ref().map_or(&[], |pixmap| pixmap.pixels())
    }

    /// Draws lines and dots in one piece, with a rim around all.
    pub(super) fn limb(&mut self, lines: &[[Vec2; 2]], line: f32, dots: &[Vec2], dot: f32, colours: [Colour; 2]) {
        let (lines, circles) = (polyline(lines), |more: f32| circles(dots, dot + more));
        self.stroke(lines.as_ref(), line + 2.0 * RIM, Colour::Rim);
        self.fill(circles(RIM), Colour::Rim);
        self.stroke(lines.as_ref(), line, colours[0]);
        self.fill(circles(0.0), colours[1]);
    }

    /// Draws marks on the floor.
    pub(super) fn marks(&mut self, places: &[Vec2]) {
        self.fill(circles(places, MARK), Colour::Floor);
    }

    /// Draws the way on the floor.
    pub(super) fn way(&mut self, places: &[Vec2]) {
        let pieces: Vec<[Vec2; 2]> = places.windows(2).filter_map(|pair| pair.try_into().ok()).collect();
        self.stroke(polyline(&pieces).as_ref(), WAY, Colour::Way);
    }

    /// Draws a shadow: as wide as that to either side, and flat.
    pub(super) fn shadow(&mut self, at: Vec2, half: f32) {
        let flat = 0.25 * half;
        let bounds = Rect::from_ltrb(at.x - half, at.y - flat, at.x + half, at.y + flat);
        self.fill(bounds.and_then(PathBuilder::from_oval), Colour::Shadow);
    }

    fn stroke(&mut self, path: Option<&Path>, width: f32, colour: Colour) {
        let stroke = Stroke { width, line_cap: LineCap::Round, ..Stroke::default() };
        if let (Some(pixmap), Some(path)) = (&mut self.pixmap, path) {
            pixmap.stroke_path(path, &paint(colour), &stroke, Transform::identity(), None);
        }
    }

    fn fill(&mut self, path: Option<Path>, colour: Colour) {
        if let (Some(pixmap), Some(path)) = (&mut self.pixmap, path) {
            pixmap.fill_path(&path, &paint(colour), FillRule::Winding, Transform::identity(), None);
        }
    }
}

/// Returns lines as a path; those that go on where the one before them ends are one piece. `None` without any.
fn polyline(lines: &[[Vec2; 2]]) -> Option<Path> {
    let mut builder = PathBuilder::new();
    let mut last = None;
    for [from, to] in lines {
        if last != Some(*from) {
            builder.move_to(from.x, from.y);
        }
        builder.line_to(to.x, to.y);
        last = Some(*to);
    }
    builder.finish()
}

fn circles(places: &[Vec2], radius: f32) -> Option<Path> {
    let mut builder = PathBuilder::new();
    for at in places {
        builder.push_circle(at.x, at.y, radius);
    }
    builder.finish()
}

fn paint(colour: Colour) -> Paint<'static> {
    let [red, green, blue, opacity] = colour.rgba();
    let mut paint = Paint::default();
    paint.set_color_rgba8(red, green, blue, opacity);
    paint
}
