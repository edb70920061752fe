//! Forward kinematics: where every bone is at a frame, in the file's own axes and units.
//!
//! ```text
//! G_i     = G_parent * L_i
//! start_i = start_parent + G_parent * (offset_i + T_i + s_parent)      s: the parent's own stretch, along its tail
//! end_i   = start_i + G_i * (tail_i + s_i)
//! ```

use glam::{DQuat, DVec3};

use crate::motion::{BoneMotion, Motion};
use crate::sample::{sample_rotation, sample_value, sample_vector, Sampling};
use crate::skeleton::{Bone, Skeleton};

/// Where every bone is at one moment; one item per bone.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Pose {
    /// Where bones start.
    pub heads: Vec<DVec3>,
    /// Where bones end.
    pub tails: Vec<DVec3>,
    /// Global rotation relative to the rest pose: identity at rest.
    pub rotations: Vec<DQuat>,
}

/// Returns the pose at a real-valued `frame` in the file's own numbering, clamped to the motion's range.
/// Bones without samples stay at rest.
pub fn pose(skeleton: &Skeleton, motion: &Motion, frame: f64) -> Pose {
    pose_of(skeleton, motion, frame, |_| true)
}

/// Returns the pose of some bones, whose parents must be among them; the others are at the origin.
pub(crate) fn pose_of(skeleton: &Skeleton, motion: &Motion, frame: f64, is_wanted: impl Fn(usize) -> bool) -> Pose {
    let at = frame - motion.first_frame as f64;
    let count = skeleton.bones.len();
    let mut pose = Pose {
        heads: Vec::with_capacity(count),
        tails: Vec::with_capacity(count),
        rotations: Vec::with_capacity(count),
    };
    let mut stretches = Vec::with_capacity(count);
    let still = BoneMotion::default();
    for (index, bone) in skeleton.bones.iter().enumerate() {
        if !is_wanted(index) {
            pose.heads.push(DVec3::ZERO);
            pose.tails.push(DVec3::ZERO);
            pose.rotations.push(DQuat::IDENTITY);
            stretches.push(DVec3::ZERO);
            continue;
        }
        let samples = motion.bones.get(index).unwrap_or(&still);
        let (start, turned, stretched) = bone.parent.map_or((DVec3::ZERO, DQuat::IDENTITY, DVec3::ZERO), |parent| {
            (pose.heads[parent], pose.rotations[parent], stretches[parent])
        });
        let head =
            start + turned * (bone.offset + sample_vector(&samples.translations, at, Sampling::Linear) + stretched);
        let rotation = turned * sample_rotation(&samples.rotations, at, Sampling::Linear);
        let stretch = stretch_direction(bone) * sample_value(&samples.stretches, at, Sampling::Linear);
        pose.heads.push(head);
        pose.tails.push(head + rotation * (bone.tail + stretch));
        pose.rotations.push(rotation);
        stretches.push(stretch);
    }
    pose
}

/// The direction in which a bone grows when its length changes: along itself, nowhere for a point.
pub(crate) fn stretch_direction(bone: &Bone) -> DVec3 {
    bone.tail.normalize_or_zero()
}
