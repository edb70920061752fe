//! [`Asf`] -> [`Skeleton`].

use super::hierarchy::tree;
use super::unit::{assumed_unit, infer_unit};
use super::{Asf, AsfBone, ROOT};
use crate::formats::AngleUnit;
use crate::infer::{as_usual, infer, Answer, Inference};
use crate::skeleton::{Bone, Dof, EulerOrder, Limit, Skeleton};
use glam::{DQuat, DVec3};

/// How many times longer than along Y a rest pose is along Z before Z counts as up: a person with Y up is far from
/// it, and so is an animal on four legs.
const Z_UP_RATIO: f64 = 2.0;

impl Asf {
    /// Returns the rest pose in the file's axes and units, the root first and parents before children; file order
    /// wherever that is so already.
    ///
    /// `axis` is in global axes (measured in the public data sets), not relative to the parent. The rest pose is the
    /// setup pose: a bone ends at its start plus `direction * length`, and its children start there.
    pub fn skeleton(&self) -> Skeleton {
        self.skeleton_and_inference().0
    }

    /// Returns the same, and what was inferred of the rest pose.
    pub(crate) fn skeleton_and_inference(&self) -> (Skeleton, Inference) {
        let tree = tree(self);
        let mut places = vec![0; tree.order.len()];
        let mut bones: Vec<Bone> = Vec::with_capacity(tree.order.len());
        for (place, node) in tree.order.into_iter().enumerate() {
            places[node] = place;
            let parent = tree.parents[node].map(|parent| places[parent]);
            let bone = match (node.checked_sub(1).and_then(|index| self.bones.get(index)), parent) {
                (Some(bone), Some(parent)) => self.bone(bone, parent, bones[parent].tail),
                _ => self.root_bone(),
            };
            bones.push(bone);
        }
        let unit = assumed_unit(&self.units, 0.0);
        let mut skeleton = Skeleton { name: self.name.clone().unwrap_or_default(), bones, up: DVec3::Y, unit };
        let mut inference = infer(&skeleton, None);
        if !inference.up.is_certain && is_longer_along_z(&mut skeleton) {
            let reason = "Z: the rest pose is far longer along it than along Y".to_owned();
            inference.up = Answer { value: DVec3::Z, reason, is_certain: false };
            inference.facing = as_usual(DVec3::Z, "the figure does not stand");
        }
        skeleton.up = inference.up.value;
        let unit = infer_unit(&self.units, skeleton.height(), &inference.unit_m);
        inference.unit_m = Answer { value: unit.metres, reason: unit.reason, is_certain: unit.is_certain };
        inference.apply_to(&mut skeleton);
        (skeleton, inference)
    }

    /// Returns what is odd in the file and what was done about it, a sentence each.
    pub fn notices(&self) -> Vec<String> {
        let mut notices = Vec::new();
        let odd_limits: Vec<_> =
            self.bones.iter().filter(|bone| has_odd_limits(bone)).map(|b| b.name.as_str()).collect();
        if !odd_limits.is_empty() {
            let names = odd_limits.join(", ");
            notices.push(format!("Limits left out where they are not one pair per degree of freedom: {names}"));
        }
        notices
    }

    fn root_bone(&self) -> Bone {
        Bone {
            name: ROOT.to_owned(),
            parent: None,
            offset: DVec3::from(self.root.position),
            tail: DVec3::ZERO,
            axes: axes(self.angle_unit(), self.root.axis, self.root.orientation),
            order: rotation_order(&self.root.order),
            dofs: self.root.order.clone(),
            limits: Vec::new(),
        }
    }

    fn bone(&self, bone: &AsfBone, parent: usize, offset: DVec3) -> Bone {
        let unit = self.angle_unit();
        let in_radians = |(dof, limit): (&Dof, &Limit)| {
            let bound = |value| if matches!(dof, Dof::Rotate(_)) { unit.radians(value) } else { value };
            (bound(limit.0.min(limit.1)), bound(limit.0.max(limit.1)))
        };
        let is_odd = has_odd_limits(bone);
        Bone {
            name: bone.name.clone(),
            parent: Some(parent),
            offset,
            tail: DVec3::from(bone.direction) * bone.length,
            axes: axes(unit, bone.axis_order, bone.axis),
            order: rotation_order(&bone.dofs),
            dofs: bone.dofs.clone(),
            limits: if is_odd { Vec::new() } else { bone.dofs.iter().zip(&bone.limits).map(in_radians).collect() },
        }
    }
}

fn has_odd_limits(bone: &AsfBone) -> bool {
    !bone.limits.is_empty() && bone.limits.len() != bone.dofs.len()
}

fn axes(unit: AngleUnit, order: EulerOrder, angles: [f64; 3]) -> DQuat {
    order.quat(angles.map(|angle| unit.radians(angle)))
}

/// Returns the order in which the rotations among `dofs` are listed; where some are missing, the first order that keeps
/// the rest.
pub(crate) fn rotation_order(dofs: &[Dof]) -> EulerOrder {
    let listed = || dofs.iter().filter_map(|dof| if let Dof::Rotate(axis) = dof { Some(*axis) } else { None });
    let keeps = |order: &EulerOrder| listed().is_sorted_by_key(|axis| order.axes().iter().position(|a| *a == axis));
    EulerOrder::ALL.into_iter().find(keeps).unwrap_or_default()
}

/// Returns whether Z may be up where no body says it, for the rest pose is far longer along it.
fn is_longer_along_z(skeleton: &mut Skeleton) -> bool {
    let [along_y, along_z] = [DVec3::Y, DVec3::Z].map(|axis| {
        skeleton.up = axis;
        skeleton.height()
    });
    along_z > along_y * Z_UP_RATIO
}
