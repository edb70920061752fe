//! A motion as plain data: for each bone of a skeleton, its rotation and offset over frames.

use glam::{DQuat, DVec3};

/// The samples of one bone; every list is empty (no such channel) or has one item per frame.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct BoneMotion {
    /// Rotation relative to the rest pose, in the axes that the motion's frame of reference says (see [`Motion`]).
    /// Neighbours lie in one hemisphere.
    pub rotations: Vec<DQuat>,
    /// The same rotations as the file's own Euler angles in radians, indexed x, y, z whatever their order;
    /// empty where they do not come from Euler angles.
    pub angles: Vec<[f64; 3]>,
    /// Translation of the bone's start away from where the rest pose has it.
    pub translations: Vec<DVec3>,
    /// Change of the bone's length (Acclaim `l`), in file units.
    pub stretches: Vec<f64>,
}

impl BoneMotion {
    /// Returns true where the bone has no channel at all.
    pub fn is_empty(&self) -> bool {
        self.rotations.is_empty() && self.translations.is_empty() && self.stretches.is_empty()
    }
}

/// Channels over frames, evenly spaced in time.
///
/// A motion that was just read is in the *file's axes*: a bone's rotation `L` and translation `T` are relative to its
/// rest pose, expressed in the file's global axes, so that `G = G_parent * L` and
/// `start = parent_start + G_parent * (offset + T)` (Acclaim: `L = C * M * C^-1`). [`Motion::in_rest_axes`] moves it
/// into the rest axes of a host's bones.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Motion {
    /// One per bone of the skeleton, in its order.
    pub bones: Vec<BoneMotion>,
    /// The file's own number of the first frame.
    pub first_frame: i64,
    /// How many frames there are.
    pub frame_count: usize,
    /// Frames per second; `None` where the file does not say.
    pub rate_hz: Option<f64>,
}

impl Motion {
    /// Returns the file's own number of the last frame.
    pub fn last_frame(&self) -> i64 {
        self.first_frame + self.frame_count as i64 - 1
    }
}
