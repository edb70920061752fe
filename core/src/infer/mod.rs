//! What a skeleton does not say of itself, worked out with a reason: how long its unit is, which axis is up and which way
//! it faces, and at which rate it moves.
//!
//! Every answer says whether it is certain. It is only where nothing speaks against it: a wrong size or a lying figure
//! costs an animator more than one look at an honest "perhaps".

mod body;
mod marker_names;
pub(crate) mod markers;
mod names;
mod stance;
mod unit;

use crate::motion::Motion;
use crate::skeleton::{LengthUnit, Skeleton};
use body::Body;
use glam::DVec3;

pub(crate) use stance::{as_usual, frames_to_look_at};
pub(crate) use unit::{Reading, TYPICAL_PERSON_M};

/// A value that was worked out.
#[derive(Debug, Clone, PartialEq)]
pub struct Answer<T> {
    /// The value; the likeliest one where it is not certain.
    pub value: T,
    /// Why, in words.
    pub reason: String,
    /// False where several values were plausible, or none.
    pub is_certain: bool,
}

impl<T> Answer<T> {
    fn certain(value: T, reason: impl Into<String>) -> Self {
        Self { value, reason: reason.into(), is_certain: true }
    }

    fn unsure(value: T, reason: impl Into<String>) -> Self {
        Self { value, reason: reason.into(), is_certain: false }
    }
}

/// Everything that can be worked out of a skeleton and its motion.
#[derive(Debug, Clone, PartialEq)]
pub struct Inference {
    /// Metres per file unit.
    pub unit_m: Answer<f64>,
    /// The axis that points up, in file axes.
    pub up: Answer<DVec3>,
    /// The axis towards which the figure looks in its rest pose, or at the first frame where the rest pose does not stand.
    pub facing: Answer<DVec3>,
    /// Frames per second; `None` where the motion does not say, or there is none.
    pub rate_hz: Answer<Option<f64>>,
}

impl Inference {
    /// Writes what belongs to it into a skeleton.
    pub fn apply_to(&self, skeleton: &mut Skeleton) {
        skeleton.up = self.up.value;
        skeleton.unit = LengthUnit {
            metres: self.unit_m.value,
            reason: self.unit_m.reason.clone(),
            is_certain: self.unit_m.is_certain,
        };
    }
}

/// Works out what a skeleton, and a motion of it in the file's axes, do not say of themselves.
///
/// Joints are recognised by their names. The size of a person is taken from the lengths of the bones, which no pose
/// changes; directions are taken from where head, pelvis and feet are in the motion and in the rest pose. A figure
/// that is no person (or whose names say nothing) has only guesses.
pub fn infer(skeleton: &Skeleton, motion: Option<&Motion>) -> Inference {
    let body = Body::find(skeleton);
    let stances = stance::Stances::new(skeleton, motion, body.as_ref());
    let up = stances.up();
    Inference {
        unit_m: unit::unit(body.as_ref(), stances.rise(up.value)),
        facing: stances.facing(up.value),
        rate_hz: rate(motion),
        up,
    }
}

/// Slower or faster than this, a file's word is doubted.
const USUAL_RATES_HZ: std::ops::RangeInclusive<f64> = 5.0..=1000.0;

fn rate(motion: Option<&Motion>) -> Answer<Option<f64>> {
    match motion.and_then(|motion| motion.rate_hz) {
        Some(rate) if USUAL_RATES_HZ.contains(&rate) => Answer::certain(Some(rate), "as the file says"),
        Some(rate) => Answer::unsure(Some(rate), "as the file says, but nothing is captured at such a rate"),
        None => Answer::unsure(None, "the file does not say"),
    }
}
