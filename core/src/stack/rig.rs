//! The armature a stack is evaluated for, and what its channels held before.

use glam::{DQuat, DVec3};

use super::output::Channel;
use crate::skeleton::EulerOrder;
use crate::value::EulerFrame;

/// Which of a bone's rotation channels count.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Mode {
    /// Four quaternion channels.
    #[default]
    Quaternion,
    /// Three angles in that order.
    Euler(EulerOrder),
}

/// One bone of the host's armature.
#[derive(Debug, Clone, PartialEq)]
pub struct RigBone {
    /// The host's name of the bone.
    pub name: String,
    /// Index of the parent.
    pub parent: Option<usize>,
    /// From the bone's rest axes to armature space.
    pub rest_rotation: DQuat,
    /// Where the bone starts at rest, in armature space.
    pub rest_head: DVec3,
    /// Which rotation channels count.
    pub mode: Mode,
    /// The angles in which "Linear (Euler)" blends; an Euler bone's own channels always blend in their own.
    pub angles: EulerFrame,
}

impl RigBone {
    /// Returns the Euler angles in which this bone is spoken of.
    pub fn euler_frame(&self) -> EulerFrame {
        match self.mode {
            Mode::Quaternion => self.angles,
            Mode::Euler(order) => EulerFrame { axes: DQuat::IDENTITY, order },
        }
    }

    /// Returns the channel that holds this bone's rotations.
    pub fn rotation_channel(&self) -> Channel {
        match self.mode {
            Mode::Quaternion => Channel::RotationQuaternion,
            Mode::Euler(_) => Channel::RotationEuler,
        }
    }
}

/// The armature a stack is evaluated for.
#[derive(Debug, Clone, PartialEq)]
pub struct Rig {
    /// In the host's order.
    pub bones: Vec<RigBone>,
    /// The unit vector that points up in armature space.
    pub up: DVec3,
    /// The scene's frames per second.
    pub rate_hz: f64,
}

/// What one channel of one bone held before the first entry.
#[derive(Debug, Clone, PartialEq)]
pub struct BaseChannel {
    /// Index of the bone.
    pub bone: usize,
    /// Which channel.
    pub channel: Channel,
    /// Scene frames, ascending.
    pub frames: Vec<f64>,
    /// Per frame the channel's components, one after another.
    pub values: Vec<f64>,
    /// Per frame whether a key of the host stands there; where not, the value was sampled between keys.
    /// Empty where all are keys.
    pub is_key: Vec<bool>,
}
