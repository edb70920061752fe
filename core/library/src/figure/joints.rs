//! The joints of a skeleton as points, its bones as lines.

use super::sides::{sides, Side};
use glam::DVec3;
use motion_theater_core::{Motion, Skeleton};
use std::collections::HashMap;

/// Words that name a root that carries a figure and is no part of it.
const CARRIERS: [&str; 7] = ["root", "reference", "armature", "master", "world", "origin", "scene"];

/// Where on a bone a point is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum End {
    /// Where the bone of that number starts.
    Head(usize),
    /// Where the bone of that number ends.
    Tail(usize),
}

/// Points of a skeleton and the lines between them.
#[derive(Debug, Default)]
pub(super) struct Joints {
    pub(super) names: Vec<String>,
    pub(super) ends: Vec<End>,
    pub(super) lines: Vec<[usize; 2]>,
    pub(super) sides: Vec<Side>,
}

impl Joints {
    /// Joints that are always in one place are one point, so that no line is drawn twice and none has no length. A bone
    /// without children has a line to its end.
    pub(super) fn new(skeleton: &Skeleton, motion: Option<&Motion>) -> Self {
        let mut joints = Self::default();
        let child_counts = child_counts(skeleton);
        let sides = inherited_sides(skeleton);
        let mut point_of: Vec<usize> = Vec::with_capacity(skeleton.bones.len());
        // By parent and offset, the line to joints that do not move against their parent.
        let mut fixed: HashMap<(usize, [u64; 3]), usize> = HashMap::new();
        for (index, bone) in skeleton.bones.iter().enumerate() {
            let side = sides.get(index).copied().unwrap_or_default();
            let samples = motion.and_then(|motion| motion.bones.get(index));
            let moves = samples.is_some_and(|samples| !samples.translations.is_empty());
            let parent = bone.parent.and_then(|parent| Some((parent, *point_of.get(parent)?)));
            let place = parent.map(|(parent, _)| (parent, bone.offset.to_array().map(f64::to_bits)));
            let line = place.and_then(|place| fixed.get(&place)).filter(|_| !moves).copied();
            let point = match (parent, line) {
                (Some((_, from)), _) if !moves && bone.offset == DVec3::ZERO => from,
                (_, Some(line)) => joints.go_on_from(line, side),
                (Some((parent, from)), None) => {
                    let point = joints.add(bone.name.clone(), End::Head(index));
                    let is_carried = child_counts.get(parent) == Some(&1) && carries(skeleton, parent);
                    if !is_carried {
                        fixed.extend(place.map(|place| (place, joints.lines.len())));
                        joints.join(from, point, side);
                    }
                    point
                }
                (None, None) => joints.add(bone.name.clone(), End::Head(index)),
            };
            if child_counts.get(index) == Some(&0) && bone.tail != DVec3::ZERO {
                let end = joints.add(format!("{}_End", bone.name), End::Tail(index));
                joints.join(point, end, side);
            }
            point_of.push(point);
        }
        joints
    }

    fn add(&mut self, name: String, end: End) -> usize {
        self.names.push(name);
        self.ends.push(end);
        self.names.len() - 1
    }

    fn join(&mut self, from: usize, to: usize, side: Side) {
        self.lines.push([from, to]);
        self.sides.push(side);
    }

    /// Several bones start where a line ends: it has their side where they agree. Returns that point.
    fn go_on_from(&mut self, line: usize, side: Side) -> usize {
        if let Some(known) = self.sides.get_mut(line).filter(|known| **known != side) {
            *known = Side::Middle;
        }
        self.lines.get(line).map_or(0, |line| line[1])
    }
}

fn child_counts(skeleton: &Skeleton) -> Vec<usize> {
    let mut counts = vec![0; skeleton.bones.len()];
    for parent in skeleton.bones.iter().filter_map(|bone| bone.parent) {
        if let Some(count) = counts.get_mut(parent) {
            *count += 1;
        }
    }
    counts
}

/// Returns whether a bone is a root that only carries a figure: many programs put one on the floor.
fn carries(skeleton: &Skeleton, bone: usize) -> bool {
    skeleton.bones.get(bone).is_some_and(|bone| {
        let name = bone.name.to_lowercase();
        bone.parent.is_none() && CARRIERS.iter().any(|word| name.contains(word))
    })
}

/// Returns the side of every bone; one whose name says nothing is on its parent's side, as fingers are.
fn inherited_sides(skeleton: &Skeleton) -> Vec<Side> {
    let mut sides = sides(skeleton.bones.iter().map(|bone| bone.name.as_str()));
    for (index, bone) in skeleton.bones.iter().enumerate() {
        let of_parent = bone.parent.and_then(|parent| sides.get(parent).copied()).unwrap_or_default();
        if let Some(side) = sides.get_mut(index).filter(|side| **side == Side::Middle) {
            *side = of_parent;
        }
    }
    sides
}
