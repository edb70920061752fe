//! What tells skeletons apart.

use motion_theater_core::infer::tallness;
use motion_theater_core::Skeleton;

/// What is known of a skeleton.
#[derive(Debug, Clone, PartialEq)]
pub struct SkeletonFacts {
    /// Equal where the names and the hierarchy of two skeletons are.
    pub fingerprint: String,
    /// How tall the figure is: a person by the bones, anything else as the rest pose is.
    pub height_m: f64,
}

impl SkeletonFacts {
    /// Takes them from a skeleton.
    pub(super) fn of(skeleton: &Skeleton) -> Self {
        Self { fingerprint: fingerprint(skeleton), height_m: tallness(skeleton) * skeleton.unit.metres }
    }
}

/// Returns a short text that is equal for skeletons of the same bones: names and hierarchy, whatever their lengths.
pub fn fingerprint(skeleton: &Skeleton) -> String {
    const DIGITS: usize = 16;
    let mut hasher = blake3::Hasher::new();
    for bone in &skeleton.bones {
        // A name cannot hold what ends it here.
        hasher.update(bone.name.as_bytes()).update(b"\n");
        hasher.update(&bone.parent.map_or(u64::MAX, |parent| parent as u64).to_le_bytes());
    }
    hasher.finalize().to_hex().chars().take(DIGITS).collect()
}
