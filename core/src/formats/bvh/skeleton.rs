//! [`Bvh`] -> [`Skeleton`].

use super::name::unique_names;
use super::{Bvh, Channel, Joint};
use crate::formats::asf::rotation_order;
use crate::infer::infer;
use crate::skeleton::{Bone, Dof, EulerOrder, LengthUnit, Skeleton};
use glam::{DQuat, DVec3};

/// Children that lead apart leave no direction for their parent: that is when the mean of their offsets is shorter than
/// this share of what they measure.
const CANCELLED: f64 = 0.25;

impl Bvh {
    /// Returns the rest pose in the file's axes and units, joint by joint; what the format does not say (the unit, which
    /// axis is up) is inferred from the rest pose.
    ///
    /// A joint's own axes are the file's. Names that several joints share get a suffix. A bone ends at its `End Site`;
    /// without one, where its children start, in the mean if they are several; where these lead apart (as the thighs and
    /// the spine do from the hips), where the child starts that carries most joints. Else it is a point.
    pub fn skeleton(&self) -> Skeleton {
        let mut skeleton = self.skeleton_as_written();
        infer(&skeleton, None).apply_to(&mut skeleton);
        skeleton
    }

    /// Returns the rest pose with nothing inferred.
    pub(super) fn skeleton_as_written(&self) -> Skeleton {
        let (names, _) = unique_names(self.joints.iter().map(|joint| joint.name.as_str()));
        let tails = tails(&self.joints);
        let bones = self.joints.iter().zip(names).zip(tails).map(|((joint, name), tail)| Bone {
            name,
            parent: joint.parent,
            offset: DVec3::from(joint.offset),
            tail,
            axes: DQuat::IDENTITY,
            order: order(&joint.channels),
            dofs: joint.channels.iter().map(|channel| channel.dof()).collect(),
            limits: Vec::new(),
        });
        let unit = LengthUnit { metres: 1.0, reason: String::new(), is_certain: false };
        Skeleton { name: String::new(), bones: bones.collect(), up: DVec3::Y, unit }
    }
}

/// Returns the order of a joint's rotations: the last channel is applied first. `Xyz` where they do not turn about
/// different axes.
pub(super) fn order(channels: &[Channel]) -> EulerOrder {
    let applied: Vec<Dof> = channels.iter().rev().map(|channel| channel.dof()).collect();
    rotation_order(&applied)
}

/// Returns for each joint where its bone ends, from its start.
pub(super) fn tails(joints: &[Joint]) -> Vec<DVec3> {
    let mut fans: Vec<Fan> = vec![Fan::default(); joints.len()];
    // Children come after their parents, so each is complete when it is added to its parent's.
    for (index, joint) in joints.iter().enumerate().rev() {
        let joint_count = fans.get(index).map_or(0, |fan| fan.joint_count) + 1;
        if let Some(fan) = joint.parent.and_then(|parent| fans.get_mut(parent)) {
            fan.add(DVec3::from(joint.offset), joint_count);
        }
    }
    let end_site =
        |joint: &Joint| joint.end_sites.iter().map(|end| DVec3::from(end.offset)).find(|at| *at != DVec3::ZERO);
    joints.iter().zip(fans).map(|(joint, fan)| end_site(joint).unwrap_or_else(|| fan.tail())).collect()
}

/// Where the children of a joint start, as far as that is not where the joint does.
#[derive(Debug, Clone, Default)]
struct Fan {
    /// How many joints there are below, children of children too.
    joint_count: usize,
    /// How many children start elsewhere, ...
    child_count: usize,
    /// ... the sum of their offsets, ...
    sum: DVec3,
    /// ... the sum of the lengths of these, ...
    length: f64,
    /// ... and how many joints the one carries that carries most, and where it starts.
    heaviest: (usize, DVec3),
}

impl Fan {
    fn add(&mut self, offset: DVec3, joint_count: usize) {
        self.joint_count += joint_count;
        if offset != DVec3::ZERO {
            self.child_count += 1;
            self.sum += offset;
            self.length += offset.length();
            // Children are added from the last to the first: of equals, the first counts.
            if joint_count >= self.heaviest.0 {
                self.heaviest = (joint_count, offset);
            }
        }
    }

    fn tail(&self) -> DVec3 {
        if self.sum.length() < CANCELLED * self.length {
            self.heaviest.1
        } else {
            self.sum / self.child_count.max(1) as f64
        }
    }
}
