//! The body in a skeleton: which joints are feet, thighs, head and hands, and how long legs and trunk are.

use super::names::{classify, Part, Side};
use crate::skeleton::Skeleton;
use std::collections::{HashMap, HashSet};

/// Hip joint to ankle, as a share of a person's height.
const LEG_SHARE: f64 = 0.49;

/// Hip joint to ankle and hip joint to head joint, as a share of a person's height: the rest is the foot under the ankle
/// and the skull above the joint.
const LEG_AND_TRUNK_SHARE: f64 = 0.87;

/// How many times longer the trunk is up to the head joint than up to the top of the neck's first bones.
const TRUNK_PER_NECK: f64 = 1.2;

/// How many times longer than the trunk the legs of a person are, in the skeletons of the public data sets: some leave
/// out a part of the spine. Animals on four legs have a longer trunk.
const LEGS_PER_TRUNK: std::ops::RangeInclusive<f64> = 1.0..=2.2;

/// What has more bones is no body.
const MOST_BONES: usize = 50_000;

/// Two legs, and what can be found above them. Numbers are indices of bones.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Body {
    /// Where the legs come together.
    pub(super) pelvis: usize,
    /// Left and right.
    pub(super) thighs: [usize; 2],
    /// Left and right.
    pub(super) feet: [usize; 2],
    /// Left and right, where there are both.
    pub(super) toes: Option<[usize; 2]>,
    /// Left and right, where there are both.
    pub(super) hands: Option<[usize; 2]>,
    /// The joint at the top of the neck, or where there is none the last one of the neck.
    pub(super) head: Option<usize>,
    /// From a hip joint to the ankle along the bones, in file units.
    pub(super) leg: f64,
    /// From where the legs come together to the head along the bones; 0 without a head.
    pub(super) trunk: f64,
    has_tail: bool,
}

impl Body {
    /// Finds a body by names; `None` where there is no pair of legs.
    pub(super) fn find(skeleton: &Skeleton) -> Option<Self> {
        // Elsewhere, a `LHipJoint` is not where the thigh begins.
        let of_joint = |name: &str| classify(name.strip_suffix("Joint")?);
        Self::find_by(skeleton, classify).or_else(|| Self::find_by(skeleton, of_joint))
    }

    fn find_by(skeleton: &Skeleton, classify: impl Fn(&str) -> Option<(Part, Side)>) -> Option<Self> {
        // The first of several is the one nearest to the root, but for a neck.
        let mut parts: HashMap<(Part, Side), usize> = HashMap::new();
        for (index, bone) in skeleton.bones.iter().enumerate().take(MOST_BONES) {
            if let Some(found) = classify(&bone.name) {
                let first = parts.entry(found).or_insert(index);
                if found.0 == Part::Neck {
                    *first = index;
                }
            }
        }
        let pair = |part| {
            let both = [Side::Left, Side::Right].map(|side| parts.get(&(part, side)).copied());
            Some([both[0]?, both[1]?])
        };
        let feet = pair(Part::Foot)?;
        let pelvis = common_ancestor(skeleton, feet[0], feet[1])?;
        let thighs = pair(Part::Thigh)?;
        let [head, neck, tail] =
            [Part::Head, Part::Neck, Part::Tail].map(|part| parts.get(&(part, Side::Middle)).copied());
        let leg =
            feet.iter().zip(thighs).map(|(foot, thigh)| path_length(skeleton, thigh, *foot)).sum::<Option<f64>>()?
                / 2.0;
        let trunk_to = |joint| trunk_length(skeleton, pelvis, joint);
        let trunk = head.and_then(trunk_to).or(neck.and_then(trunk_to).map(|length| length * TRUNK_PER_NECK));
        Some(Self {
            pelvis,
            thighs,
            feet,
            toes: pair(Part::Toe),
            hands: pair(Part::Hand),
            head: head.or(neck).filter(|_| trunk.is_some()),
            leg,
            trunk: trunk.unwrap_or(0.0),
            has_tail: tail.is_some(),
        })
    }

    /// Returns for each joint whether it is one of these parts, or leads to one.
    pub(super) fn with_ancestors(&self, skeleton: &Skeleton) -> Vec<bool> {
        let mut are_within = vec![false; skeleton.bones.len()];
        let pairs = [Some(self.thighs), Some(self.feet), self.toes];
        let parts = pairs.into_iter().flatten().flatten().chain([self.pelvis]).chain(self.head);
        for joint in parts.flat_map(|part| ancestors(skeleton, part)) {
            if let Some(is_within) = are_within.get_mut(joint) {
                *is_within = true;
            }
        }
        are_within
    }

    /// Returns whether this can be a person: two legs and a head in proportion, hands, and no tail.
    pub(super) fn is_person(&self) -> bool {
        let is_complete = self.head.is_some() && self.hands.is_some() && !self.has_tail;
        is_complete && self.leg > 0.0 && LEGS_PER_TRUNK.contains(&(self.leg / self.trunk))
    }

    /// Returns how far apart feet and top are when all bones are in one line, in file units.
    pub(super) fn standing_length(&self) -> f64 {
        self.leg + if self.is_person() { self.trunk } else { 0.0 }
    }

    /// Returns how tall a person with these bones is, whatever the pose, in file units: by the legs and by all of the body,
    /// in the mean.
    pub(super) fn stature(&self) -> f64 {
        f64::midpoint(self.leg / LEG_SHARE, (self.leg + self.trunk) / LEG_AND_TRUNK_SHARE)
    }
}

/// Returns the bone nearest to both from which both hang.
fn common_ancestor(skeleton: &Skeleton, a: usize, b: usize) -> Option<usize> {
    let above: HashSet<usize> = ancestors(skeleton, a).collect();
    ancestors(skeleton, b).find(|index| above.contains(index))
}

/// Returns a bone, its parent, and so on.
fn ancestors(skeleton: &Skeleton, bone: usize) -> impl Iterator<Item = usize> + '_ {
    std::iter::successors(Some(bone), |index| skeleton.bones.get(*index)?.parent)
}

/// Returns how long the bones are from `top` down to `bottom`; `None` where that does not hang from it.
fn path_length(skeleton: &Skeleton, top: usize, bottom: usize) -> Option<f64> {
    let mut length = 0.0;
    for index in ancestors(skeleton, bottom) {
        if index == top {
            return Some(length);
        }
        length += skeleton.bones.get(index)?.offset.length();
    }
    None
}

/// Returns how long the bones are from the pelvis to the head, over the bone from which both hang.
fn trunk_length(skeleton: &Skeleton, pelvis: usize, head: usize) -> Option<f64> {
    let top = common_ancestor(skeleton, pelvis, head)?;
    Some(path_length(skeleton, top, pelvis)? + path_length(skeleton, top, head)?)
}
