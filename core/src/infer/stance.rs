//! Which axis is up and which way a figure faces, from how it stands.

use super::body::Body;
use super::Answer;
use crate::motion::Motion;
use crate::pose::pose_of;
use crate::skeleton::Skeleton;
use crate::upright::axis_name;
use glam::DVec3;

/// How many frames of a motion are looked at, spread over all of it ...
const MOST_FRAMES: usize = 16;

/// ... as long as that is not more than this many bones in all.
const MOST_BONES: usize = 1_000_000;

/// Nothing is less upright than this cosine: within 37 degrees.
pub(super) const UPRIGHT: f64 = 0.8;

/// The share of a motion that has to be upright for it to say which axis is up.
pub(super) const MOST_OF_THE_TIME: f64 = 0.75;

/// A rest pose stands where head and feet are at least this share of the bones between them apart.
const STRETCHED: f64 = 0.7;

/// Within this cosine of an axis a direction is meant to be along it: 26 degrees.
pub(super) const ALONG_AXIS: f64 = 0.9;

/// Toes point forward where the cosine of that is more than this: feet mostly point down as well.
const TOES_FORWARD: f64 = 0.3;

/// Thighs are apart by more than this share of a leg, or begin in one place.
const NARROWEST: f64 = 0.02;

/// The axis that points up in nearly all files.
const USUAL_UP: DVec3 = DVec3::Y;

/// The axis towards which figures look in nearly all files.
const USUAL_FACING: DVec3 = DVec3::Z;

/// Returns the frames, counted from 0, that say how a figure stands. A motion of these alone is looked at as a whole.
pub(crate) fn frames_to_look_at(frame_count: usize, bone_count: usize) -> impl Iterator<Item = usize> {
    let most = MOST_FRAMES.min(MOST_BONES / bone_count.max(1)).min(frame_count);
    (0..most).map(move |index| index * frame_count / most)
}

/// How a body stands at one moment.
#[derive(Debug, Clone, Copy)]
struct Stance {
    /// Where the legs come together.
    pelvis: DVec3,
    /// From the middle of the feet to the head, or to the pelvis of an animal.
    upward: DVec3,
    /// From the right thigh to the left one, or from foot to foot where the thighs begin in one place.
    leftward: DVec3,
    /// From the ankles to the toes, or along the feet where there are none.
    forward: DVec3,
}

/// How a body stands in the rest pose and over time.
pub(super) struct Stances<'a> {
    body: Option<&'a Body>,
    rest: Option<Stance>,
    frames: Vec<Stance>,
}

impl<'a> Stances<'a> {
    /// Looks at the rest pose and at frames spread over the motion, and there at those joints that matter to the body.
    pub(super) fn new(
        skeleton: &Skeleton,
        motion: Option<&Motion>,
        body: Option<&'a Body>,
        matters: impl Fn(usize) -> bool + Copy,
    ) -> Self {
        let Some(found) = body else { return Self { body, rest: None, frames: Vec::new() } };
        let heads = skeleton.rest_heads();
        let tails: Vec<_> = heads.iter().zip(&skeleton.bones).map(|(head, bone)| *head + bone.tail).collect();
        let rest = Stance::new(found, &heads, &tails);
        let frame_count = motion.map_or(0, |motion| motion.frame_count);
        let frames = motion.into_iter().flat_map(|motion| {
            frames_to_look_at(frame_count, skeleton.bones.len()).filter_map(move |frame| {
                let pose = pose_of(skeleton, motion, motion.first_frame as f64 + frame as f64, matters);
                Stance::new(found, &pose.heads, &pose.tails)
            })
        });
        Self { body, rest, frames: frames.collect() }
    }

    /// Returns the axis that points up.
    pub(super) fn up(&self) -> Answer<DVec3> {
        let Some(body) = self.body else {
            return Answer::unsure(USUAL_UP, "Y, as in most files: no legs were found by their names");
        };
        let rest = self.standing_at_rest().map(|(axis, _)| axis);
        let moving = self.upright_over_time();
        let name = axis_name;
        match (moving, rest) {
            (Some(axis), Some(rest)) if axis == rest => {
                Answer::certain(axis, format!("{}: the figure stands along it, at rest and in motion", name(axis)))
            }
            (Some(axis), Some(rest)) => Answer::unsure(
                axis,
                format!(
                    "{}: the figure moves upright along it, but its rest pose stands along {}",
                    name(axis),
                    name(rest)
                ),
            ),
            (Some(axis), None) if body.is_person() => {
                Answer::certain(axis, format!("{}: the figure moves upright along it", name(axis)))
            }
            (Some(axis), None) => Answer::unsure(axis, format!("{}: the legs are along it", name(axis))),
            (None, Some(rest)) if self.frames.is_empty() => {
                Answer::certain(rest, format!("{}: the rest pose stands along it", name(rest)))
            }
            (None, Some(rest)) => Answer::unsure(
                rest,
                format!("{}: the rest pose stands along it, but the motion is not upright", name(rest)),
            ),
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

    /// Returns the axis along which the rest pose stands, where it does.
    fn standing_at_rest(&self) -> Option<(DVec3, &Stance)> {
        let (body, rest) = (self.body?, self.rest.as_ref()?);
        let (axis, cosine) = nearest_axis(rest.upward)?;
        let is_stretched = rest.upward.length() >= STRETCHED * body.standing_length();
        (is_stretched && cosine >= ALONG_AXIS).then_some((axis, rest))
    }

    /// Returns how far the pelvis goes up and down, in file units.
    pub(super) fn rise(&self, up: DVec3) -> f64 {
        let heights = || self.frames.iter().map(|stance| stance.pelvis.dot(up));
        heights().fold(f64::NEG_INFINITY, f64::max) - heights().fold(f64::INFINITY, f64::min)
    }

    /// Returns the axis towards which the figure looks. Only a rest pose that stands makes it certain: a motion may begin
    /// in any direction.
    pub(super) fn facing(&self, up: DVec3) -> Answer<DVec3> {
        let standing = self.standing_at_rest().filter(|(axis, _)| *axis == up).map(|(_, rest)| rest);
        let is_upright = |stance: &&Stance| stance.upward.normalize_or_zero().dot(up) >= UPRIGHT;
        let (stance, when) = match (standing, self.frames.first().filter(is_upright)) {
            (Some(rest), _) => (rest, "in the rest pose"),
            (None, Some(first)) => (first, "at the first frame"),
            (None, None) => return as_usual(up, "the figure does not stand"),
        };
        let forward = stance.leftward.cross(up);
        let Some((axis, cosine)) = nearest_axis(forward) else { return as_usual(up, "the legs have no sides") };
        let reason = format!("{}: to the front of the legs {when}", axis_name(axis));
        let toes = stance.forward.normalize_or_zero().dot(forward.normalize_or_zero());
        if toes < -TOES_FORWARD {
            Answer::unsure(axis, format!("{reason}, but the toes point the other way"))
        } else if cosine < ALONG_AXIS {
            Answer::unsure(axis, format!("{reason}, though not quite"))
        } else if standing.is_some() && toes >= TOES_FORWARD {
            Answer::certain(axis, format!("{reason}, and so do the toes"))
        } else {
            Answer::unsure(axis, reason)
        }
    }
}

impl Stance {
    fn new(body: &Body, heads: &[DVec3], tails: &[DVec3]) -> Option<Self> {
        let between = |points: &[DVec3], pair: [usize; 2]| Some((*points.get(pair[0])?, *points.get(pair[1])?));
        let middle = |points: &[DVec3], pair| between(points, pair).map(|(left, right)| (left + right) / 2.0);
        let to_left = |pair| between(heads, pair).map(|(left, right)| left - right);
        let feet = middle(heads, body.feet)?;
        let pelvis = *heads.get(body.pelvis)?;
        let top = if body.is_person() { *heads.get(body.head?)? } else { pelvis };
        let thighs = to_left(body.thighs)?;
        Some(Self {
            pelvis,
            upward: top - feet,
            leftward: if thighs.length() > NARROWEST * body.leg { thighs } else { to_left(body.feet)? },
            forward: body.toes.map_or_else(|| middle(tails, body.feet), |toes| middle(heads, toes))? - feet,
        })
    }
}

/// Returns the axis towards which figures look in nearly all files where `up` is up.
pub(super) fn usual_facing(up: DVec3) -> DVec3 {
    if up.dot(USUAL_FACING) == 0.0 {
        USUAL_FACING
    } else {
        -DVec3::Y * up.dot(USUAL_FACING)
    }
}

/// The answer where nothing says it.
pub(crate) fn as_usual(up: DVec3, why: &str) -> Answer<DVec3> {
    let usual = usual_facing(up);
    Answer::unsure(usual, format!("{}, as in most files: {why}", axis_name(usual)))
}

/// Returns the signed axis nearest to a direction, and the cosine between them; `None` for no direction.
pub(super) fn nearest_axis(direction: DVec3) -> Option<(DVec3, f64)> {
    let direction = direction.try_normalize()?;
    let axes = DVec3::AXES.into_iter().flat_map(|axis| [axis, -axis]);
    let with_cosine = axes.map(|axis| (axis, axis.dot(direction)));
    with_cosine.max_by(|a, b| a.1.total_cmp(&b.1))
}
