//! [`Motion`] -> [`Amc`].

use super::{Amc, AmcBone, AmcHeader};
use crate::formats::asf::{file_names, rotation_order, ROOT};
use crate::formats::AngleUnit;
use crate::motion::{BoneMotion, Motion};
use crate::skeleton::{Bone, Dof, EulerOrder, Limit, Skeleton};
use glam::{DQuat, DVec3, EulerRot};

impl Amc {
    /// Returns a file of the motion's values for the degrees of freedom of `skeleton`, whose bones it belongs to; what
    /// moves beyond those is left out, so see [`with_dofs_for`]. Angles are the motion's own where it has any. Every
    /// bone with degrees of freedom has its line; one without motion has zeros.
    pub fn from_motion(skeleton: &Skeleton, motion: &Motion, angle: AngleUnit) -> Self {
        let names = file_names(skeleton);
        let at_rest = BoneMotion::default();
        let motions = motion.bones.iter().chain(std::iter::repeat(&at_rest));
        let named = skeleton.bones.iter().zip(motions).zip(&names).filter(|((bone, _), _)| !bone.dofs.is_empty());
        let moving: Vec<_> = named.map(|((bone, channels), name)| (bone, channels, name)).collect();
        let mut values =
            Vec::with_capacity(motion.frame_count * moving.iter().map(|(bone, ..)| bone.dofs.len()).sum::<usize>());
        for frame in 0..motion.frame_count {
            for (bone, channels, name) in &moving {
                let translation_axes = if *name == ROOT { DQuat::IDENTITY } else { bone.axes };
                push_values(bone, channels, frame, translation_axes, angle, &mut values);
            }
        }
        Self {
            header: AmcHeader {
                is_fully_specified: true,
                angle: Some(angle),
                rate_hz: motion.rate_hz,
                ..AmcHeader::default()
            },
            bones: moving
                .iter()
                .map(|(bone, _, name)| AmcBone { name: (*name).clone(), width: bone.dofs.len() })
                .collect(),
            first_frame: motion.first_frame,
            frame_count: motion.frame_count,
            frame_numbers: Vec::new(),
            values,
        }
    }
}

/// Returns the skeleton with the degrees of freedom that `motion` needs. Those of a bone stay as they are where they
/// are enough.
pub fn with_dofs_for(skeleton: &Skeleton, motion: &Motion) -> Skeleton {
    let mut skeleton = skeleton.clone();
    let at_rest = BoneMotion::default();
    for (bone, channels) in skeleton.bones.iter_mut().zip(motion.bones.iter().chain(std::iter::repeat(&at_rest))) {
        list_rotations_as_applied(bone);
        let needed = needed_dofs(bone, channels);
        if needed.iter().any(|dof| !bone.dofs.contains(dof)) {
            bone.order = rotation_order(&needed);
            bone.dofs = needed;
            bone.limits.clear();
        }
    }
    skeleton
}

/// Lists each degree of freedom once, and rotations in the order in which they are applied, as this format does; a BVH
/// lists them the other way round. Limits stay with theirs.
fn list_rotations_as_applied(bone: &mut Bone) {
    let axes = bone.order.axes();
    let place = |dof: &Dof| match dof {
        Dof::Translate(_) => 0,
        Dof::Rotate(axis) => 1 + axes.iter().position(|other| other == axis).unwrap_or_default(),
        Dof::Length => axes.len() + 1,
    };
    let rotations = bone.dofs.iter().filter(|dof| matches!(dof, Dof::Rotate(_))).map(place);
    if rotations.is_sorted_by(|a, b| a < b) {
        return;
    }
    let mut listed: Vec<(Dof, Option<Limit>)> = Vec::new();
    for (index, dof) in bone.dofs.iter().enumerate() {
        if listed.iter().all(|(known, _)| known != dof) {
            listed.push((*dof, bone.limits.get(index).copied()));
        }
    }
    listed.sort_by_key(|(dof, _)| place(dof));
    bone.limits = listed.iter().filter_map(|(_, limit)| *limit).collect();
    bone.dofs = listed.into_iter().map(|(dof, _)| dof).collect();
}

/// Returns translations, rotations in the bone's order and length, as far as any frame moves them. Without angles of the
/// file's own, a rotation takes all three.
fn needed_dofs(bone: &Bone, channels: &BoneMotion) -> Vec<Dof> {
    let mut dofs = Vec::new();
    if channels.translations.iter().any(|translation| *translation != DVec3::ZERO) {
        dofs.extend((0..3).map(Dof::Translate));
    }
    let turns = |axis: usize| {
        if channels.angles.is_empty() {
            channels.rotations.iter().any(|rotation| rotation.xyz() != DVec3::ZERO)
        } else {
            channels.angles.iter().any(|angles| angles[axis] != 0.0)
        }
    };
    dofs.extend(bone.order.axes().into_iter().filter(|axis| turns(*axis)).map(Dof::Rotate));
    if channels.stretches.iter().any(|stretch| *stretch != 0.0) {
        dofs.push(Dof::Length);
    }
    dofs
}

/// Appends the values of one bone in one frame; its translation is along `translation_axes`.
fn push_values(
    bone: &Bone,
    channels: &BoneMotion,
    frame: usize,
    translation_axes: DQuat,
    angle: AngleUnit,
    values: &mut Vec<f64>,
) {
    let angles = channels.angles.get(frame).copied();
    let angles = angles.or_else(|| Some(angles_of(bone, *channels.rotations.get(frame)?))).unwrap_or_default();
    let translation = channels.translations.get(frame).copied().unwrap_or_default();
    let translation = translation_axes.inverse() * translation;
    values.extend(bone.dofs.iter().map(|dof| match dof {
        Dof::Rotate(axis) => angle.of_radians(angles[*axis]),
        Dof::Translate(axis) => translation[*axis],
        Dof::Length => channels.stretches.get(frame).copied().unwrap_or_default(),
    }));
}

/// Returns the angles about the bone's own axes: `M = C^-1 * L * C` taken apart in the bone's order.
fn angles_of(bone: &Bone, rotation: DQuat) -> [f64; 3] {
    let turn = bone.axes.inverse() * rotation * bone.axes;
    let order = match bone.order {
        EulerOrder::Xyz => EulerRot::XYZEx,
        EulerOrder::Xzy => EulerRot::XZYEx,
        EulerOrder::Yxz => EulerRot::YXZEx,
        EulerOrder::Yzx => EulerRot::YZXEx,
        EulerOrder::Zxy => EulerRot::ZXYEx,
        EulerOrder::Zyx => EulerRot::ZYXEx,
    };
    let (first, second, third) = turn.to_euler(order);
    let mut angles = [0.0; 3];
    for (axis, value) in bone.order.axes().into_iter().zip([first, second, third]) {
        angles[axis] = value;
    }
    angles
}
