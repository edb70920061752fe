//! A stack without a host: on a skeleton of a file, in the bones' own axes, back to a motion of that skeleton.
//!
//! Nothing is rounded to single precision on the way, and where an entry leaves a sample alone it keeps the file's own
//! Euler angles: what is written then says the same numbers as what was read.

use glam::{DQuat, DVec3};
use rayon::prelude::*;

use super::bone::{evaluate, Outcome};
use super::entry::Entry;
use super::notice::{self, Notice};
use super::rig::{Mode, Rig, RigBone};
use crate::error::ParameterError;
use crate::motion::{BoneMotion, Motion};
use crate::rest_axes::RestAxes;
use crate::skeleton::{Bone, Skeleton};
use crate::value::{EulerFrame, Turn};

/// Returns the clip of a track on `skeleton`: `motion` belongs to `own`, whose bones are found by their names. Where the
/// two skeletons have another unit or another axis up, the motion is brought to those of `skeleton`.
pub fn on_skeleton(skeleton: &Skeleton, own: &Skeleton, motion: &Motion) -> Motion {
    let upright = DQuat::from_rotation_arc(own.up, skeleton.up);
    let host = |bone: &Bone| RestAxes {
        bone: own.index_of(&bone.name),
        axes: bone.axes.conjugate() * upright,
        order: Some(bone.order),
    };
    let host: Vec<RestAxes> = skeleton.bones.iter().map(host).collect();
    motion.in_rest_axes(own, &host, own.unit.metres / skeleton.unit.metres)
}

/// Evaluates a stack on the skeleton itself, over a base without motion. The motions of tracks come from
/// [`on_skeleton`]; `rate_hz` is the rate of the result, whose frames are whole numbers.
///
/// The result has the frames from the first to the last one that an entry touches. Bones that no entry touches have no
/// motion.
///
/// # Errors
/// Where an entry's frames make no sense; the message begins with the entry's label.
pub fn evaluate_on(
    skeleton: &Skeleton,
    rate_hz: f64,
    entries: &[Entry],
) -> Result<(Motion, Vec<Notice>), ParameterError> {
    let rig = rig(skeleton, rate_hz);
    let prepared = entries.iter().map(|entry| entry.prepare(&rig)).collect::<Result<Vec<_>, _>>()?;
    let outcomes: Vec<Outcome<Turn>> =
        (0..rig.bones.len()).into_par_iter().map(|index| evaluate(&rig, index, &[], &prepared)).collect();
    let events: Vec<_> = outcomes.iter().map(|outcome| outcome.events.clone()).collect();
    let notices = notice::collect(&rig, &prepared, &events);
    let ranges = outcomes.iter().flat_map(|outcome| [outcome.rotation.keys.range(), outcome.location.keys.range()]);
    let range = ranges.flatten().reduce(|a, b| (a.0.min(b.0), a.1.max(b.1)));
    let Some((start, end)) = range else {
        return Ok((Motion { rate_hz: Some(rate_hz), ..Motion::default() }, notices));
    };
    let (first, last) = (start.ceil(), end.floor().max(start.ceil()));
    let frames: Vec<f64> = (0..=(last - first) as usize).map(|frame| first + frame as f64).collect();
    let bones = outcomes.par_iter().zip(&skeleton.bones).map(|(outcome, bone)| to_file(outcome, bone, &frames));
    let motion =
        Motion { bones: bones.collect(), first_frame: first as i64, frame_count: frames.len(), rate_hz: Some(rate_hz) };
    Ok((motion, notices))
}

/// The skeleton as an armature whose bones have the file's own axes and Euler angles.
fn rig(skeleton: &Skeleton, rate_hz: f64) -> Rig {
    let bones = skeleton.bones.iter().zip(skeleton.rest_heads()).map(|(bone, rest_head)| RigBone {
        name: bone.name.clone(),
        parent: bone.parent,
        rest_rotation: bone.axes,
        rest_head,
        mode: Mode::Euler(bone.order),
        angles: EulerFrame::default(),
    });
    Rig { bones: bones.collect(), up: skeleton.up, rate_hz }
}

/// Samples the channels of a bone at whole frames and brings them back into the file's axes.
fn to_file(outcome: &Outcome<Turn>, bone: &Bone, frames: &[f64]) -> BoneMotion {
    let mut motion = BoneMotion::default();
    let mut last = DQuat::IDENTITY;
    for turn in frames.iter().filter_map(|&frame| outcome.rotation.keys.at(frame)) {
        motion.angles.push(bone.order.angles_near(turn.rotation, turn.angles));
        let rotation = bone.axes * turn.rotation * bone.axes.conjugate();
        last = if rotation.dot(last) < 0.0 { -rotation } else { rotation };
        motion.rotations.push(last);
    }
    let locations = frames.iter().filter_map(|&frame| outcome.location.keys.at(frame));
    motion.translations = locations.map(|location: DVec3| bone.axes * location).collect();
    motion
}
