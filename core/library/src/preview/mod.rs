//! How a clip looks: a still of a telling pose and a short moving strip, as small pictures.
//!
//! | file | what it does |
//! |---|---|
//! | `moments` | which frames are drawn: the liveliest seconds, and of these the most telling pose |
//! | `camera` | from where: the front, at the side that shows most, near enough to fill the picture |
//! | `scene`, `limbs`, `canvas` | floor, way, limbs and markers, from far to near |
//! | `pack` | pixels to PNG and back |
//! | `cache` | made once, kept until there is no room |
//! | `of_library` | those of a library's clips |

mod cache;
mod camera;
mod canvas;
mod head;
mod limbs;
mod moments;
mod of_library;
mod pack;
mod scene;

pub use cache::{ContentHash, PreviewCache, MOST_BYTES};
pub use of_library::Strip;
pub use pack::{unpack, Frames};

use crate::figure::Actor;
use camera::Camera;
use canvas::Canvas;
use moments::Moments;
use motion_theater_core::loaded::{LoadError, Loaded};
use pack::Packer;
use scene::Scene;

/// Which version of the drawing made a preview. It is raised whenever the drawing changes, so that older ones are made
/// anew.
pub const MADE_BY: u32 = 1;

/// How wide and high a picture is, in pixels.
pub const SIZE: usize = 128;

/// How a clip looks. The pictures are PNGs with transparency, for dark and light grounds.
#[derive(Debug, Clone, PartialEq)]
pub struct Preview {
    /// The file's own number of the frame that the still shows.
    pub frame: i64,
    /// How wide a picture is, in pixels.
    pub width: u32,
    /// How high it is.
    pub height: u32,
    /// The most telling pose.
    pub still: Vec<u8>,
    /// The liveliest seconds, frames side by side.
    pub strip: Vec<u8>,
    /// How many frames the strip has.
    pub strip_frames: u32,
    /// How many of them make a second, at the speed of the clip.
    pub strip_rate_hz: f64,
}

/// Draws what a file holds. A clip in which nothing is ever seen has empty pictures.
///
/// # Errors
/// Where there is nothing to draw: a motion whose skeleton was not found.
pub fn make(loaded: &Loaded) -> Result<Preview, LoadError> {
    Ok(draw(&Actor::of(loaded)?))
}

/// Draws an actor.
pub fn draw(actor: &Actor<'_>) -> Preview {
    let moments = Moments::of(actor);
    let camera = Camera::facing(actor, &moments);
    let scene = Scene::new(actor, &moments, &camera);
    let mut canvas = Canvas::new(SIZE);
    let mut strip = Packer::new(moments.poses.len().max(1), SIZE);
    let mut still = Packer::new(1, SIZE);
    for frame in 0..moments.poses.len() {
        scene.draw(frame, &mut canvas);
        strip.add(frame, canvas.pixels());
        if frame == moments.still {
            still.add(0, canvas.pixels());
        }
    }
    Preview {
        frame: actor.first_frame.saturating_add(moments.still_frame as i64),
        width: SIZE as u32,
        height: SIZE as u32,
        still: still.pack(),
        strip: strip.pack(),
        strip_frames: moments.poses.len().max(1) as u32,
        strip_rate_hz: moments.rate_hz,
    }
}

#[cfg(test)]
mod tests;
