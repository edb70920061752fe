//! [`Skeleton`] + [`Motion`] -> [`Bvh`].

use super::name::name_for_file;
use super::skeleton::tails;
use super::{Bvh, BvhMotion, Channel, EndSite, Joint};
use crate::motion::{BoneMotion, Motion};
use crate::pose::stretch_direction;
use crate::skeleton::{Bone, Dof, EulerOrder, Skeleton};
use glam::{DQuat, DVec3};

/// The order of rotations that have none of their own: `Zrotation Xrotation Yrotation`, the usual one.
const USUAL_ORDER: EulerOrder = EulerOrder::Yxz;

/// Angles are written in steps of this part of a degree: far below what any capture resolves, far above the noise that
/// radians leave, so that 18 degrees are 18 again.
const ANGLE_STEPS_PER_DEGREE: f64 = 1e10;

/// So many digits of a position are written, for the same reason.
const POSITION_DIGITS: i32 = 13;

/// Two ends of a bone closer than this part of its length are one.
const SAME_TAIL: f64 = 1e-9;

impl Bvh {
    /// Returns a skeleton and a motion of it, in the file's axes, as a BVH: the same joints, places and rotations at every
    /// frame.
    ///
    /// Rotations become the channels that the bone has, in its own order, where its axes are the file's and these channels
    /// are enough, and else three.
    /// A root always has positions; another joint where it moves, or where its parent grows. A motion without a rate has
    /// no frame time. Left out is what the format has no words for: the number of the first frame, limits, and the growth
    /// of a bone on which none hangs.
    pub fn from_motion(skeleton: &Skeleton, motion: &Motion) -> Self {
        let sources = nested(skeleton);
        let mut places = vec![None; skeleton.bones.len()];
        let mut joints: Vec<Joint> = Vec::with_capacity(sources.len());
        let mut columns = Vec::with_capacity(sources.len());
        for index in &sources {
            let Some(bone) = skeleton.bones.get(*index) else { continue };
            let column = Column::new(skeleton, motion, bone, *index);
            places[*index] = Some(joints.len());
            joints.push(Joint {
                name: name_for_file(&bone.name),
                parent: bone.parent.and_then(|parent| places.get(parent).copied().flatten()),
                offset: bone.offset.into(),
                channels: column.channels(),
                end_sites: Vec::new(),
            });
            columns.push(column);
        }
        add_end_sites(&mut joints, sources.iter().filter_map(|index| skeleton.bones.get(*index)));
        let width: usize = joints.iter().map(|joint| joint.channels.len()).sum();
        let mut values = vec![0.0; width * motion.frame_count];
        let mut start = 0;
        for (joint, column) in joints.iter().zip(&columns) {
            column.write(&joint.channels, values.chunks_exact_mut(width.max(1)).map(|row| &mut row[start..]));
            start += joint.channels.len();
        }
        let frame_time_s = motion.rate_hz.map(|rate| 1.0 / rate);
        let motion = BvhMotion { frame_time_s, frame_count: motion.frame_count, values };
        Self::new(joints, Some(motion))
    }
}

/// Returns the bones in the order in which a file nests them: all descendants before the next sibling.
fn nested(skeleton: &Skeleton) -> Vec<usize> {
    let mut children = vec![Vec::new(); skeleton.bones.len()];
    let mut open = Vec::new();
    for (index, bone) in skeleton.bones.iter().enumerate().rev() {
        match bone.parent.and_then(|parent| children.get_mut(parent)) {
            Some(siblings) => siblings.push(index),
            None => open.push(index),
        }
    }
    let mut order = Vec::with_capacity(skeleton.bones.len());
    while let Some(index) = open.pop() {
        order.push(index);
        open.append(&mut children[index]);
    }
    order
}

/// Says where bones end: where no joint hangs from one, and where it ends elsewhere than a reader would think.
fn add_end_sites<'a>(joints: &mut [Joint], bones: impl Iterator<Item = &'a Bone>) {
    let mut has_children = vec![false; joints.len()];
    for parent in joints.iter().filter_map(|joint| joint.parent) {
        has_children[parent] = true;
    }
    let tails = tails(joints);
    for (((joint, bone), tail), has_children) in joints.iter_mut().zip(bones).zip(tails).zip(has_children) {
        let is_elsewhere = bone.tail.distance(tail) > SAME_TAIL * bone.tail.length();
        if !has_children || is_elsewhere {
            joint.end_sites.push(EndSite { name: String::new(), offset: bone.tail.into() });
        }
    }
}

/// The samples of one joint on their way into the columns of a file.
struct Column<'a> {
    bone: &'a Bone,
    samples: Option<&'a BoneMotion>,
    /// By how much the parent grows, and where to.
    growth: (&'a [f64], DVec3),
    order: EulerOrder,
    /// Which angles are written, in the order of the channels.
    rotation_axes: Vec<usize>,
    has_position: bool,
}

impl<'a> Column<'a> {
    fn new(skeleton: &'a Skeleton, motion: &'a Motion, bone: &'a Bone, index: usize) -> Self {
        let samples = motion.bones.get(index);
        let parent = bone.parent.and_then(|parent| Some((skeleton.bones.get(parent)?, motion.bones.get(parent)?)));
        let growth = parent
            .map_or((Default::default(), DVec3::ZERO), |(bone, m)| (m.stretches.as_slice(), stretch_direction(bone)));
        let translates = |dof: &Dof| matches!(dof, Dof::Translate(_));
        let moves = samples.is_some_and(|samples| !samples.translations.is_empty()) || bone.dofs.iter().any(translates);
        let rotates = |axis: usize| bone.dofs.contains(&Dof::Rotate(axis));
        let turns = (0..3).any(rotates) || samples.is_some_and(|samples| !samples.rotations.is_empty());
        let has_own_angles = bone.axes == DQuat::IDENTITY && samples.is_none_or(has_angles);
        let order = if has_own_angles && (0..3).any(rotates) { bone.order } else { USUAL_ORDER };
        // What was blended may turn about an axis about which the bone does not by itself.
        let is_needed = |axis: usize| samples.is_some_and(|samples| turns_about(samples, axis));
        let is_written =
            |axis: &usize| turns && (rotates(*axis) || !has_own_angles || !(0..3).any(rotates) || is_needed(*axis));
        Self {
            bone,
            samples,
            growth,
            order,
            rotation_axes: order.axes().into_iter().rev().filter(is_written).collect(),
            has_position: bone.parent.is_none() || moves || !growth.0.is_empty(),
        }
    }

    fn channels(&self) -> Vec<Channel> {
        let positions = (0..3).filter(|_| self.has_position).map(Channel::Position);
        positions.chain(self.rotation_axes.iter().copied().map(Channel::Rotation)).collect()
    }

    /// Writes the joint's values into rows that begin with them.
    fn write<'r>(&self, channels: &[Channel], rows: impl Iterator<Item = &'r mut [f64]>) {
        let angles = self.samples.map_or(&[][..], |samples| &samples.angles);
        let uses_own = !angles.is_empty() && self.bone.axes == DQuat::IDENTITY;
        let mut turned = [0.0; 3];
        for (frame, row) in rows.enumerate() {
            let rotation = self.samples.and_then(|samples| samples.rotations.get(frame));
            match angles.get(frame).filter(|_| uses_own) {
                Some(angles) => turned = *angles,
                None => turned = rotation.map_or(turned, |rotation| self.order.angles_near(*rotation, turned)),
            }
            let position = self.position(frame);
            for (value, channel) in row.iter_mut().zip(channels) {
                *value = match channel {
                    Channel::Position(axis) => rounded_position(position[*axis]),
                    Channel::Rotation(axis) => rounded_angle(turned[*axis].to_degrees()),
                };
            }
        }
    }

    /// Returns where the joint starts at a frame, from its parent's start.
    fn position(&self, frame: usize) -> DVec3 {
        let (lengths, direction) = self.growth;
        let moved = self.samples.and_then(|samples| samples.translations.get(frame)).copied().unwrap_or_default();
        self.bone.offset + moved + direction * lengths.get(frame).copied().unwrap_or_default()
    }
}

fn has_angles(samples: &BoneMotion) -> bool {
    samples.angles.len() == samples.rotations.len()
}

fn turns_about(samples: &BoneMotion, axis: usize) -> bool {
    samples.angles.iter().any(|angles| rounded_angle(angles[axis].to_degrees()) != 0.0)
}

fn rounded_angle(degrees: f64) -> f64 {
    (degrees * ANGLE_STEPS_PER_DEGREE).round() / ANGLE_STEPS_PER_DEGREE
}

fn rounded_position(position: f64) -> f64 {
    if position == 0.0 {
        return 0.0;
    }
    let digits_before = position.abs().log10().floor() as i32 + 1;
    let steps = 10_f64.powi(POSITION_DIGITS - digits_before);
    let rounded = (position * steps).round() / steps;
    // Far below 1 the number of steps itself is too large.
    if rounded.is_finite() {
        rounded
    } else {
        position
    }
}
