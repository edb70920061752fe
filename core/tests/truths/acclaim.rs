//! Copies of Acclaim skeletons and their motions.

use super::turned;
use glam::DVec3;
use motion_theater_core::formats::amc::Amc;
use motion_theater_core::formats::asf::Asf;
use motion_theater_core::read::read_bytes;
use motion_theater_core::{Dof, EulerOrder, Motion, Skeleton};
use std::path::Path;

/// Writes a copy in another unit and with other axes, and reads it: the same values in degrees of freedom of other names.
pub fn read_copy(asf: &Asf, amc: &Amc, scale: f64, turns: usize) -> (Skeleton, Motion) {
    let turned_asf = changed(asf, scale, turns);
    let clip = read_bytes(&turned_asf.to_bytes(), Path::new("copy.asf"), None).unwrap();
    let skeleton = clip.skeleton.unwrap();
    let motion = scaled(asf, amc, scale).motion(&skeleton).unwrap().0;
    (skeleton, motion)
}

/// Writes a copy that states a rate, and reads what it says.
pub fn rate_of_copy(amc: &Amc, hz: f64) -> Option<f64> {
    let mut copy =
        Amc { values: amc.values.iter().take(amc.width()).copied().collect(), frame_count: 1, ..amc.clone() };
    copy.header.rate_hz = Some(hz);
    read_bytes(&copy.to_bytes(), Path::new("copy.amc"), None).unwrap().rate_hz()
}

fn changed(asf: &Asf, scale: f64, turns: usize) -> Asf {
    let vector = |v: [f64; 3]| turned(DVec3::from(v), turns).to_array();
    let order = |order: EulerOrder| {
        let axes = order.axes().map(|axis| (axis + turns) % 3);
        EulerOrder::ALL.into_iter().find(|other| other.axes() == axes).unwrap()
    };
    let dofs = |dofs: &mut Vec<Dof>| {
        for dof in dofs {
            *dof = match *dof {
                Dof::Translate(axis) => Dof::Translate((axis + turns) % 3),
                Dof::Rotate(axis) => Dof::Rotate((axis + turns) % 3),
                Dof::Length => Dof::Length,
            };
        }
    };
    let mut copy = asf.clone();
    let root = &mut copy.root;
    root.position = vector(root.position).map(|x| x * scale);
    (root.orientation, root.axis) = (vector(root.orientation), order(root.axis));
    dofs(&mut root.order);
    for bone in &mut copy.bones {
        bone.direction = vector(bone.direction);
        bone.length *= scale;
        (bone.axis, bone.axis_order) = (vector(bone.axis), order(bone.axis_order));
        dofs(&mut bone.dofs);
    }
    copy
}

/// Scales the places of the root, which come in the order of its degrees of freedom.
fn scaled(asf: &Asf, amc: &Amc, scale: f64) -> Amc {
    let root = amc.bones.iter().position(|bone| bone.name == "root").unwrap();
    let start: usize = amc.bones[..root].iter().map(|bone| bone.width).sum();
    let places: Vec<usize> =
        (0..asf.root.order.len()).filter(|at| matches!(asf.root.order[*at], Dof::Translate(_))).collect();
    let mut copy = amc.clone();
    for row in copy.values.chunks_exact_mut(amc.width()) {
        for place in &places {
            row[start + place] *= scale;
        }
    }
    copy
}
