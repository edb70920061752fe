//! The points of a skeleton that have a name: joints, and the ends of bones where no joint is.

use std::collections::HashSet;

use glam::DVec3;
use motion_theater_core::pose::pose;
use motion_theater_core::read::{Clip, Format};
use motion_theater_core::{Motion, Skeleton};

/// One point.
#[derive(Debug, Clone, PartialEq)]
pub struct Point {
    pub name: String,
    bone: usize,
    place: Place,
}

#[derive(Debug, Clone, Copy, PartialEq)]
enum Place {
    Start,
    End,
    /// From the start, in the rest pose.
    At(DVec3),
}

/// Returns the points of a file, in its order.
///
/// Acclaim names bones: a bone's point is its end, which is where those after it start, and the root's is the root.
/// Other formats name joints: a joint's point is where it is, and each end site is a point too, called after its joint.
pub fn points(clip: &Clip, skeleton: &Skeleton) -> Vec<Point> {
    if matches!(clip.format, Format::Asf | Format::Amc) {
        let bones = skeleton.bones.iter().enumerate();
        return bones.map(|(bone, known)| Point { name: known.name.clone(), bone, place: Place::End }).collect();
    }
    let mut taken: HashSet<&str> = skeleton.bones.iter().map(|bone| bone.name.as_str()).collect();
    let joints = clip.bvh.as_ref().map_or(&[][..], |bvh| &bvh.joints);
    let mut points = Vec::new();
    let ends: Vec<String> = skeleton.bones.iter().map(|bone| format!("{}_End", bone.name)).collect();
    for (bone, known) in skeleton.bones.iter().enumerate() {
        points.push(Point { name: known.name.clone(), bone, place: Place::Start });
        let end_sites = joints.get(bone).map_or(&[][..], |joint| &joint.end_sites);
        for (number, end_site) in (1..).zip(end_sites) {
            let plain = ends.get(bone).filter(|name| number == 1 && taken.insert(name.as_str()));
            let name = plain.cloned().unwrap_or_else(|| format!("{}_End{number}", known.name));
            points.push(Point { name, bone, place: Place::At(DVec3::from(end_site.offset)) });
        }
    }
    points
}

/// Returns where points are at a frame, in the file's axes and units; at rest without motion.
pub fn positions(points: &[Point], skeleton: &Skeleton, motion: Option<&Motion>, frame: f64) -> Vec<DVec3> {
    let at_rest = Motion::default();
    let pose = pose(skeleton, motion.unwrap_or(&at_rest), frame);
    let of = |list: &[DVec3], bone: usize| list.get(bone).copied().unwrap_or_default();
    let place = |point: &Point| match point.place {
        Place::Start => of(&pose.heads, point.bone),
        Place::End => of(&pose.tails, point.bone),
        Place::At(offset) => {
            let turned = pose.rotations.get(point.bone).copied().unwrap_or_default();
            of(&pose.heads, point.bone) + turned * offset
        }
    };
    points.iter().map(place).collect()
}
