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

/// Returns how tall a figure is, in file units: a person by the bones, whatever the pose; anything else as the rest pose is.
///
/// Rest poses of real files lie, crouch, or have all joints in one place.
pub fn tallness(skeleton: &Skeleton) -> f64 {
    let person = Body::find(skeleton).filter(Body::is_person);
    person.map_or_else(|| skeleton.height(), |body| body.stature())
}

/// Works out what a skeleton, and a motion of it in the file's axes, do not say of themselves.
///
/// Joints are recognised by their names. The size of a person is taken from the lengths of the bones, which no pose
/// changes; directions are taken from where head, pelvis and feet are in the motion and in the rest pose. A figure
/// that is no person (or whose names say nothing) has only guesses.
pub fn infer(skeleton: &Skeleton, motion: Option<&Motion>) -> Inference {
    Figure::of(skeleton).infer(motion)
}

/// A skeleton of which is known what its joints are.
pub(crate) struct Figure<'a> {
    skeleton: &'a Skeleton,
    body: Option<Body>,
    /// For each joint, whether its motion says anything.
    matters: Vec<bool>,
}

impl<'a> Figure<'a> {
    /// Recognises the joints.
    pub(crate) fn of(skeleton: &'a Skeleton) -> Self {
        let body = Body::find(skeleton);
        let matters = body.as_ref().map_or_else(Vec::new, |body| body.with_ancestors(skeleton));
        Self { skeleton, body, matters }
    }

    /// Whether the motion of a joint is looked at: the others may be left out of it.
    pub(crate) fn matters(&self, joint: usize) -> bool {
        self.matters.get(joint).is_some_and(|matters| *matters)
    }

    /// Works out what [`infer`] does.
    pub(crate) fn infer(&self, motion: Option<&Motion>) -> Inference {
        let body = self.body.as_ref();
        let stances = stance::Stances::new(self.skeleton, motion, body, |joint| self.matters(joint));
        let up = stances.up();
        Inference {
            unit_m: unit::unit(body, stances.rise(up.value)),
            facing: stances.facing(up.value),
            rate_hz: rate(motion),
            up,
        }
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_person_is_as_tall_in_any_rest_pose_and_anything_else_as_its_rest_pose_is() {
        let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../testdata/human.asf");
        let mut skeleton = crate::read::read_path(std::path::Path::new(path), None).unwrap().skeleton.unwrap();
        let upright = tallness(&skeleton);
        assert!((upright / skeleton.height() - 1.0).abs() < 0.1, "{upright}, in its pose {}", skeleton.height());
        for bone in &mut skeleton.bones {
            (bone.offset, bone.tail) = (bone.offset.length() * DVec3::X, bone.tail.length() * DVec3::X);
        }
        assert_eq!(skeleton.height(), 0.0);
        assert!((tallness(&skeleton) / upright - 1.0).abs() < 1e-12);

        for (index, bone) in skeleton.bones.iter_mut().enumerate() {
            bone.name = format!("part{index}");
            bone.offset += DVec3::Y;
        }
        assert_eq!(tallness(&skeleton), skeleton.height());
    }
}
