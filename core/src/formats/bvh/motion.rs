//! [`Bvh`] -> [`Motion`].

use super::name::{are_unique, unique_names};
use super::skeleton::order;
use super::{Bvh, BvhMotion, Channel, Joint};
use crate::formats::frame_values::FrameValues;
use crate::infer::{infer, Figure, Inference};
use crate::motion::{BoneMotion, Motion};
use crate::rate::rate_of_frame_time;
use crate::skeleton::Skeleton;
use glam::{DQuat, DVec3};
use rayon::prelude::*;

/// The number of the first frame: a BVH has no numbers, and people count from 1.
const FIRST_FRAME: i64 = 1;

/// Fewer values than these are converted on one thread.
const FEW_VALUES: usize = 1 << 14;

/// How many names a sentence lists.
const MOST_NAMES: usize = 5;

impl Bvh {
    /// Returns the motion of the joints; `None` for a hierarchy alone.
    ///
    /// Rotations compose in the order of the channels: `Zrotation Xrotation Yrotation` is `Rz * Rx * Ry`. Position channels
    /// stand in for the components of the offset that they name. Where one comes twice, the last counts. The joint's
    /// angles are kept where its rotations turn about different axes; those that it does not have are zero.
    pub fn motion(&self) -> Option<Motion> {
        self.motion_of(|_| true)
    }

    /// Returns the motion of some joints; the others have no samples.
    fn motion_of(&self, is_wanted: impl Fn(usize) -> bool + Sync) -> Option<Motion> {
        let motion = self.motion.as_ref()?;
        let starts = self.joints.iter().scan(0, |next, joint| {
            let start = *next;
            *next += joint.channels.len();
            Some(start)
        });
        let columns: Vec<(usize, (&Joint, usize))> = self.joints.iter().zip(starts).enumerate().collect();
        let values = FrameValues::new(&motion.values, self.width());
        let of_joint = |(index, (joint, start)): (usize, (&Joint, usize))| {
            if is_wanted(index) {
                joint.motion(values, start)
            } else {
                BoneMotion::default()
            }
        };
        // Few values are converted before another thread has woken up.
        let bones = if motion.values.len() < FEW_VALUES {
            columns.into_iter().map(of_joint).collect()
        } else {
            columns.into_par_iter().map(of_joint).collect()
        };
        Some(Motion { bones, first_frame: FIRST_FRAME, frame_count: motion.frame_count, rate_hz: motion.rate_hz() })
    }

    /// Returns the rest pose and the motion; what the format does not say is inferred from both.
    pub fn skeleton_and_motion(&self) -> (Skeleton, Option<Motion>) {
        let (skeleton, motion, _) = self.skeleton_motion_and_inference();
        (skeleton, motion)
    }

    /// Returns the same, and what was inferred.
    pub(crate) fn skeleton_motion_and_inference(&self) -> (Skeleton, Option<Motion>, Inference) {
        let (mut skeleton, motion) = (self.skeleton_as_written(), self.motion());
        let inference = infer(&skeleton, motion.as_ref());
        inference.apply_to(&mut skeleton);
        (skeleton, motion, inference)
    }

    /// Returns the rest pose, and what was inferred from it and from the motion, of which no more is converted than that
    /// takes.
    pub(crate) fn skeleton_and_inference(&self) -> (Skeleton, Inference) {
        let mut skeleton = self.skeleton_as_written();
        let figure = Figure::of(&skeleton);
        let inference = figure.infer(self.motion_of(|joint| figure.matters(joint)).as_ref());
        inference.apply_to(&mut skeleton);
        (skeleton, inference)
    }

    /// Returns what is odd in the file and what was done about it, a sentence each.
    pub fn notices(&self) -> Vec<String> {
        let mut notices = Vec::new();
        let names = self.joints.iter().map(|joint| joint.name.as_str());
        if !are_unique(names.clone()) {
            let (_, renamed) = unique_names(names);
            let more = renamed.len().saturating_sub(MOST_NAMES);
            let and_more = if more > 0 { format!(" and {more} more") } else { String::new() };
            let names = renamed.get(..MOST_NAMES).unwrap_or(&renamed).join(", ");
            notices.push(format!(
                "Joints whose name is missing or not the only one of its kind are called {names}{and_more}"
            ));
        }
        let Some(motion) = &self.motion else {
            notices.push("The file holds a hierarchy and no motion".to_owned());
            return notices;
        };
        notices.extend(self.faults.sentences(self.width()));
        notices.extend(motion.rate_notice());
        notices
    }
}

impl BvhMotion {
    /// Returns the frames per second that the frame time stands for; `None` where there is none above 0.
    pub fn rate_hz(&self) -> Option<f64> {
        Some(rate_of_frame_time(self.frame_time_s?)?.hz)
    }

    fn rate_notice(&self) -> Option<String> {
        match (self.frame_time_s, self.frame_time_s.and_then(rate_of_frame_time)) {
            (None, _) => Some("The file does not say its frame time: the rate is not known".to_owned()),
            (Some(time), None) => Some(format!("A frame time of {time} s is none: the rate is not known")),
            (_, Some(rate)) => rate.doubt,
        }
    }
}

impl Joint {
    /// Returns the joint's samples; its values start at column `start`.
    fn motion(&self, values: FrameValues<'_>, start: usize) -> BoneMotion {
        let columns = |axis_of: fn(Channel) -> Option<usize>| -> Vec<(usize, usize)> {
            let channels = self.channels.iter().zip(start..);
            channels.filter_map(|(channel, column)| Some((axis_of(*channel)?, column))).collect()
        };
        let (turns, places) = (columns(Channel::rotation_axis), columns(Channel::position_axis));
        let mut samples = BoneMotion::default();
        let is_euler = (0..3).all(|axis| turns.iter().filter(|(a, _)| *a == axis).count() <= 1);
        if is_euler && !turns.is_empty() {
            samples.angles = values.triples(&turns, 1_f64.to_radians(), [0.0; 3]);
            samples.rotations = order(&self.channels).quats(&samples.angles, DQuat::IDENTITY);
        } else if !turns.is_empty() {
            samples.rotations = products(values, &turns);
        }
        if !places.is_empty() {
            let offset = DVec3::from(self.offset);
            let places = values.triples(&places, 1.0, self.offset);
            samples.translations = places.into_iter().map(|place| DVec3::from(place) - offset).collect();
        }
        samples
    }
}

/// Returns the rotations of axes of which some come more than once, neighbours in one hemisphere.
fn products(values: FrameValues<'_>, turns: &[(usize, usize)]) -> Vec<DQuat> {
    let mut previous = DQuat::IDENTITY;
    let product = |row: &[f64]| {
        let angles = turns.iter().map(|(axis, column)| (*axis, row.get(*column).copied().unwrap_or_default()));
        let turned = angles.fold(DQuat::IDENTITY, |turned, (axis, degrees)| {
            turned * DQuat::from_axis_angle(DVec3::AXES[axis], degrees.to_radians())
        });
        let rotation = turned.normalize();
        previous = if rotation.dot(previous) < 0.0 { -rotation } else { rotation };
        previous
    };
    values.rows().map(product).collect()
}

impl Channel {
    fn rotation_axis(self) -> Option<usize> {
        match self {
            Self::Rotation(axis) => Some(axis),
            Self::Position(_) => None,
        }
    }

    fn position_axis(self) -> Option<usize> {
        match self {
            Self::Position(axis) => Some(axis),
            Self::Rotation(_) => None,
        }
    }
}
