//! Which axis is up and which way a figure faces, from how it stands.

use super::body::Body;
use super::Answer;
use crate::motion::Motion;
use crate::pose::pose;
use crate::skeleton::Skeleton;
use glam::DVec3;

/// How many frames of a motion are looked at, spread over all of it ...
const MOST_FRAMES: usize = 48;

/// ... as long as that is not more than this many bones in all.
const MOST_BONES: usize = 1_000_000;

/// Nothing is less upright than this cosine: within 37 degrees.
const UPRIGHT: f64 = 0.8;

/// The share of a motion that has to be upright for it to say which axis is up.
const MOST_OF_THE_TIME: f64 = 0.75;

/// A rest pose stands where head and feet are at least this share of the bones between them apart.
const STRETCHED: f64 = 0.7;

/// Within this cosine of an axis a direction is meant to be along it: 26 degrees.
const ALONG_AXIS: f64 = 0.9;

/// The axis that points up in nearly all files.
const USUAL_UP: DVec3 = DVec3::Y;

/// The axis towards which figures look in nearly all files.
const USUAL_FACING: DVec3 = DVec3::Z;

/// How a body stands at one moment.
#[derive(Debug, Clone, Copy)]
struct Stance {
    /// From the middle of the feet to the head, or to the pelvis of an animal.
    upward: DVec3,
    /// From the right thigh to the left one.
    leftward: DVec3,
    /// From the ankles to the toes; zero where these are not known.
    forward: DVec3,
}

/// How a body stands in the rest pose and over time.
pub(super) struct Stances<'a> {
    body: Option<&'a Body>,
    rest: Option<Stance>,
    frames: Vec<Stance>,
}

impl<'a> Stances<'a> {
    /// Looks at the rest pose and at frames spread over the motion.
    pub(super) fn new(skeleton: &Skeleton, motion: Option<&Motion>, body: Option<&'a Body>) -> Self {
        let Some(found) = body else { return Self { body, rest: None, frames: Vec::new() } };
        let rest = Stance::new(found, &skeleton.rest_heads());
        let frame_count = motion.map_or(0, |motion| motion.frame_count);
        let most = MOST_FRAMES.min(MOST_BONES / skeleton.bones.len().max(1)).min(frame_count);
        let frames = motion.into_iter().flat_map(|motion| {
            let frame = move |index: usize| motion.first_frame as f64 + (index * frame_count / most) as f64;
            (0..most).filter_map(move |index| Stance::new(found, &pose(skeleton, motion, frame(index)).heads))
        });
        Self { body, rest, frames: frames.collect() }
    }

    /// Returns the axis that points up.
    pub(super) fn up(&self) -> Answer<DVec3> {
        let Some(body) = self.body else {
            return Answer::unsure(USUAL_UP, "Y, as in most files: no legs were found by their names");
        };
        let rest = self.rest.filter(|rest| rest.upward.length() >= STRETCHED * body.standing_length()).map(|rest| rest.up());
        let rest = rest.filter(|(_, cosine)| *cosine >= ALONG_AXIS).map(|(axis, _)| axis);
        let moving = self.upright_over_time();
        let name = axis_name;
        match (moving, rest) {
            (Some(axis), Some(rest)) if axis == rest => {
                Answer::certain(axis, format!("{}: the figure stands along it, at rest and in motion", name(axis)))
            }
            (Some(axis), Some(rest)) => Answer::unsure(
                axis,
                format!("{}: the figure moves upright along it, but its rest pose stands along {}", name(axis), name(rest)),
            ),
            (Some(axis), None) if body.is_person() => {
                Answer::certain(axis, format!("{}: the figure moves upright along it", name(axis)))
            }
            (Some(axis), None) => Answer::unsure(axis, format!("{}: the legs are along it", name(axis))),
            (None, Some(rest)) if self.frames.is_empty() => {
                Answer::certain(rest, format!("{}: the rest pose stands along it", name(rest)))
            }
            (None, Some(rest)) => {
                Answer::unsure(rest, format!("{}: the rest pose stands along it, but the motion is not upright", name(rest)))
            }
            (None, None) => Answer::unsure(USUAL_UP, "Y, as in most files: the figure does not stand"),
        }
    }

    /// Returns the axis along which the figure is upright in most frames.
    fn upright_over_time(&self) -> Option<DVec3> {
        let mean = self.frames.iter().map(|stance| stance.upward.normalize_or_zero()).sum::<DVec3>();
        let (axis, _) = nearest_axis(mean)?;
        let upright = self.frames.iter().filter(|stance| stance.upward.normalize_or_zero().dot(axis) >= UPRIGHT);
        (upright.count() as f64 >= MOST_OF_THE_TIME * self.frames.len() as f64).then_some(axis)
    }

    /// Returns the axis towards which the figure looks.
    pub(super) fn facing(&self, up: DVec3) -> Answer<DVec3> {
        let usual = if up.dot(USUAL_FACING) == 0.0 { USUAL_FACING } else { -DVec3::Y * up.dot(USUAL_FACING) };
        let is_upright = |stance: &&Stance| stance.upward.normalize_or_zero().dot(up) >= UPRIGHT;
        let (stance, when) = match (self.rest.as_ref().filter(is_upright), self.frames.first().filter(is_upright)) {
            (Some(rest), _) => (rest, "in the rest pose"),
            (None, Some(first)) => (first, "at the first frame"),
            (None, None) => return Answer::unsure(usual, format!("{}, as in most files", axis_name(usual))),
        };
        let forward = stance.leftward.cross(up).normalize_or_zero();
        let along_ground = (stance.forward - up * stance.forward.dot(up)).normalize_or_zero();
        let Some((axis, cosine)) = nearest_axis(forward) else {
            return Answer::unsure(usual, format!("{}, as in most files: the thighs have no sides", axis_name(usual)));
        };
        let reason = format!("{}: to the front of the thighs {when}", axis_name(axis));
        if along_ground.dot(forward) < 0.0 {
            return Answer::unsure(axis, format!("{reason}, but the toes point the other way"));
        }
        if cosine < ALONG_AXIS {
            return Answer::unsure(axis, format!("{reason}, though not quite"));
        }
        Answer::certain(axis, reason)
    }
}

impl Stance {
    fn new(body: &Body, heads: &[DVec3]) -> Option<Self> {
        let at = |index: usize| heads.get(index).copied();
        let middle = |pair: [usize; 2]| Some((at(pair[0])? + at(pair[1])?) / 2.0);
        let feet = middle(body.feet)?;
        let top = if body.is_person() { body.head.and_then(at)? } else { at(body.pelvis)? };
        Some(Self {
            upward: top - feet,
            leftward: at(body.thighs[0])? - at(body.thighs[1])?,
            forward: body.toes.and_then(middle).map_or(DVec3::ZERO, |toes| toes - feet),
        })
    }

    fn up(&self) -> (DVec3, f64) {
        nearest_axis(self.upward).unwrap_or((USUAL_UP, 0.0))
    }
}

/// Returns the signed axis nearest to a direction, and the cosine between them; `None` for no direction.
fn nearest_axis(direction: DVec3) -> Option<(DVec3, f64)> {
    let direction = direction.try_normalize()?;
    let axes = DVec3::AXES.into_iter().flat_map(|axis| [axis, -axis]);
    let with_cosine = axes.map(|axis| (axis, axis.dot(direction)));
    with_cosine.max_by(|a, b| a.1.total_cmp(&b.1))
}

/// Returns an axis as people write it: `Y`, `-Z`.
pub(super) fn axis_name(axis: DVec3) -> &'static str {
    let names = [(DVec3::X, "X"), (DVec3::Y, "Y"), (DVec3::Z, "Z"), (-DVec3::X, "-X"), (-DVec3::Y, "-Y")];
    names.into_iter().find(|(known, _)| *known == axis).map_or("-Z", |(_, name)| name)
}
