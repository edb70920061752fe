//! From a file's axes into the rest axes of a host's bones.

use glam::{DQuat, DVec3};
use rayon::prelude::*;

use crate::filter::unwrap_angles;
use crate::motion::{BoneMotion, Motion};
use crate::pose::stretch_direction;
use crate::skeleton::{EulerOrder, Skeleton};

/// The host's rest axes are stored in f32: up to this angle (radians) they are meant to be the file's.
const SAME_AXES_RAD: f64 = 1e-3;

/// A host's bone, as seen from a motion.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RestAxes {
    /// The bone of the motion that it shows; `None` where the motion has none.
    pub bone: Option<usize>,
    /// The rotation from the motion's axes into the host bone's rest axes.
    pub axes: DQuat,
    /// The order in which the host's bone wants Euler angles; `None` for quaternions.
    pub order: Option<EulerOrder>,
}

impl Motion {
    /// Returns the motion as channels of a host's bones: rotations `A * L * A^-1` and locations `A * T * scale`, with
    /// `A` the bone's [`RestAxes::axes`]. Stretches become locations of the children.
    ///
    /// Where a bone wants Euler angles and its axes and order are the file's own, the angles are the file's own
    /// numbers, without jumps of whole turns.
    #[must_use]
    pub fn in_rest_axes(&self, skeleton: &Skeleton, host: &[RestAxes], scale: f64) -> Self {
        let bones = host
            .par_iter()
            .map(|host| {
                let Some(index) = host.bone.filter(|&index| index < self.bones.len()) else {
                    return BoneMotion::default();
                };
                let bone = &self.bones[index];
                let (rotations, angles) = rotations(bone, host);
                let turned = host.axes.normalize();
                let translations = self.translations_with_stretch(skeleton, index);
                let translations = translations.into_iter().map(|offset| turned * offset * scale).collect();
                BoneMotion { rotations, angles, translations, stretches: Vec::new() }
            })
            .collect();
        Self { bones, first_frame: self.first_frame, frame_count: self.frame_count, rate_hz: self.rate_hz }
    }

    fn translations_with_stretch(&self, skeleton: &Skeleton, index: usize) -> Vec<DVec3> {
        let own = &self.bones[index].translations;
        let parent = skeleton.bones.get(index).and_then(|bone| bone.parent);
        let Some((parent, stretches)) = parent
            .and_then(|parent| Some((skeleton.bones.get(parent)?, &self.bones.get(parent)?.stretches)))
            .filter(|(_, stretches)| !stretches.is_empty())
        else {
            return own.clone();
        };
        let direction = stretch_direction(parent);
        let own = own.iter().copied().chain(std::iter::repeat(DVec3::ZERO));
        stretches.iter().zip(own).map(|(stretch, own)| own + direction * *stretch).collect()
    }
}

fn rotations(bone: &BoneMotion, host: &RestAxes) -> (Vec<DQuat>, Vec<[f64; 3]>) {
    let axes = host.axes.normalize();
    let turned: Vec<DQuat> = bone.rotations.iter().map(|local| axes * *local * axes.conjugate()).collect();
    let Some(order) = host.order else { return (turned, Vec::new()) };
    let speaks_of = |(rotation, angles): (&DQuat, &[f64; 3])| {
        (order.quat(*angles).conjugate() * *rotation).xyz().length() * 2.0 < SAME_AXES_RAD
    };
    let is_files_own = bone.angles.len() == turned.len() && turned.iter().zip(&bone.angles).all(speaks_of);
    if !is_files_own {
        let mut near = [0.0; 3];
        let angles = turned.iter().map(|rotation| {
            near = order.angles_near(*rotation, near);
            near
        });
        let angles = angles.collect();
        return (turned, angles);
    }
    let mut angles = bone.angles.clone();
    unwrap_angles(&mut angles);
    let mut last = DQuat::IDENTITY;
    let own = angles.iter().map(|angles| {
        let rotation = order.quat(*angles);
        last = if rotation.dot(last) < 0.0 { -rotation } else { rotation };
        last
    });
    (own.collect(), angles)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::skeleton::{Bone, Dof, LengthUnit};

    fn skeleton(bones: Vec<Bone>) -> Skeleton {
        let unit = LengthUnit { metres: 1.0, reason: String::new(), is_certain: true };
        Skeleton { name: String::new(), bones, up: DVec3::Y, unit }
    }

    fn bone(parent: Option<usize>, dofs: Vec<Dof>) -> Bone {
        Bone {
            name: "bone".into(),
            parent,
            offset: DVec3::ZERO,
            tail: DVec3::X * 2.0,
            axes: DQuat::IDENTITY,
            order: EulerOrder::Xyz,
            dofs,
            limits: Vec::new(),
        }
    }

    #[test]
    fn in_the_files_own_axes_the_angles_are_the_files_numbers_without_jumps() {
        let axes = EulerOrder::Zxy.quat([0.3, -0.8, 1.2]);
        let angles: Vec<[f64; 3]> = (0..40).map(|frame| [f64::from(frame) * 0.2 - 3.0, 0.4, -0.2]).collect();
        let mut wrapped = angles.clone();
        for angles in &mut wrapped {
            angles[0] = (angles[0] + 3.1).rem_euclid(std::f64::consts::TAU) - 3.1;
        }
        let local = |angles: &[f64; 3]| axes * EulerOrder::Xyz.quat(*angles) * axes.conjugate();
        let samples =
            BoneMotion { rotations: angles.iter().map(local).collect(), angles: wrapped, ..BoneMotion::default() };
        let motion = Motion { bones: vec![samples], frame_count: 40, ..Motion::default() };
        // Rest axes as a host gives them back: off by the rounding of f32.
        let host_axes = axes.conjugate() * DQuat::from_rotation_y(2e-5);
        let host = RestAxes { bone: Some(0), axes: host_axes, order: Some(EulerOrder::Xyz) };
        let moved = motion.in_rest_axes(&skeleton(vec![bone(None, vec![])]), &[host], 1.0);
        for (found, meant) in moved.bones[0].angles.iter().zip(&angles) {
            assert!((0..3).all(|axis| (found[axis] - meant[axis]).abs() < 1e-12), "{found:?} {meant:?}");
        }
        assert!(moved.bones[0].rotations.windows(2).all(|pair| pair[0].dot(pair[1]) > 0.0));
    }

    #[test]
    fn a_stretch_moves_the_children() {
        let stretched = BoneMotion { stretches: vec![0.5, 1.0], ..BoneMotion::default() };
        let motion = Motion { bones: vec![stretched, BoneMotion::default()], frame_count: 2, ..Motion::default() };
        let skeleton = skeleton(vec![bone(None, vec![Dof::Length]), bone(Some(0), vec![])]);
        let host = [0, 1].map(|index| RestAxes { bone: Some(index), axes: DQuat::IDENTITY, order: None });
        let moved = motion.in_rest_axes(&skeleton, &host, 10.0);
        assert_eq!(moved.bones[1].translations, [DVec3::X * 5.0, DVec3::X * 10.0]);
        assert!(moved.bones[0].translations.is_empty());
    }

    #[test]
    fn a_bone_that_the_motion_lacks_stays_empty() {
        let host = RestAxes { bone: None, axes: DQuat::IDENTITY, order: None };
        let moved = Motion::default().in_rest_axes(&skeleton(Vec::new()), &[host], 1.0);
        assert!(moved.bones[0].is_empty());
    }
}
