//! What a channel can hold: a rotation, a rotation that is shown as Euler angles, or a location.

use glam::{DQuat, DVec3};
use serde::{Deserialize, Serialize};

use crate::error::ParameterError;
use crate::filter::components::by_component;
use crate::filter::{filter_angles, filter_rotations, filter_values, unwrap_angles, Depth, FilterKind};
use crate::motion::BoneMotion;
use crate::sample::{sample_angles, sample_rotation, sample_vector, slerp, Sampling};
use crate::skeleton::EulerOrder;

/// How a crossfade mixes two rotations.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
#[serde(rename_all = "UPPERCASE")]
pub enum Blend {
    /// As rotations, on the shorter arc.
    #[default]
    Slerp,
    /// "Linear (Euler)": angle by angle, as the 2004 program did.
    Euler,
}

/// Whether a filter sees rotations or single curves.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
#[serde(rename_all = "UPPERCASE")]
pub enum FilterChannels {
    /// Rotations are filtered as rotations.
    #[default]
    Rotation,
    /// The classic way: every curve by itself.
    #[serde(rename = "CHANNELS")]
    Each,
}

/// The Euler angles in which a bone is spoken of: `rotation = axes * order.quat(angles) * axes^-1`.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct EulerFrame {
    /// From the axes of the angles to the bone's rest axes.
    pub axes: DQuat,
    /// The order of the angles.
    pub order: EulerOrder,
}

impl EulerFrame {
    fn angles_near(&self, rotation: DQuat, hint: [f64; 3]) -> [f64; 3] {
        self.order.angles_near(self.axes.conjugate() * rotation * self.axes, hint)
    }

    fn quat(&self, angles: [f64; 3]) -> DQuat {
        self.axes * self.order.quat(angles) * self.axes.conjugate()
    }

    /// Reads rotations as angles without jumps, the first one near `hint`.
    fn continuous(&self, rotations: impl Iterator<Item = DQuat>, hint: [f64; 3]) -> Vec<[f64; 3]> {
        rotations
            .scan(hint, |near, rotation| {
                *near = self.angles_near(rotation, *near);
                Some(*near)
            })
            .collect()
    }
}

/// A rotation of a bone whose channels are Euler angles: the angles say which of the many solutions is meant.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Turn {
    /// The rotation itself.
    pub rotation: DQuat,
    /// Angles (radians, indexed x, y, z) that give it, or lie near those that do.
    pub angles: [f64; 3],
}

/// What the combiner and the filters need of a channel's value.
pub trait Value: Copy + PartialEq + Send + Sync + Default {
    /// Mixes towards `other`; `0` gives `self` and `1` gives `other`, rotations on the shorter arc.
    #[must_use]
    fn mix(self, other: Self, t: f64) -> Self;

    /// Takes a clip's samples at a real-valued index; `None` where the bone has no such channel.
    fn sample(bone: &BoneMotion, at: f64, sampling: Sampling) -> Option<Self>;

    /// Rewrites values so that they go on from `neighbour` without a change of sign or of whole turns.
    /// The rotations that they mean stay the same.
    fn go_on_from(values: &mut [Self], neighbour: Self, frame: &EulerFrame);

    /// Returns true where the straight line between two neighbours is not the way between what they mean.
    fn is_seam(self, next: Self) -> bool;

    /// Crossfades `old` into `new` frame by frame; `weights` are the share of `new`.
    fn crossfade(old: &[Self], new: &[Self], weights: &[f64], blend: Blend, frame: &EulerFrame) -> Vec<Self>;

    /// Filters evenly spaced values.
    fn filter(
        values: &[Self],
        kind: FilterKind,
        depth: Depth,
        channels: FilterChannels,
        frame: &EulerFrame,
    ) -> Vec<Self>;
}

fn mix_each<V: Value>(old: &[V], new: &[V], weights: &[f64]) -> Vec<V> {
    old.iter().zip(new).zip(weights).map(|((old, new), &weight)| old.mix(*new, weight)).collect()
}

fn lerp_angles(from: [f64; 3], to: [f64; 3], t: f64) -> [f64; 3] {
    std::array::from_fn(|axis| from[axis] * (1.0 - t) + to[axis] * t)
}

fn filtered_rotations(values: &[DQuat], kind: FilterKind, depth: Depth) -> Vec<DQuat> {
    let mut filtered = vec![DQuat::IDENTITY; values.len()];
    filter_rotations(values, &mut filtered, kind, depth);
    filtered
}

fn filtered_angles(values: &[[f64; 3]], kind: FilterKind, depth: Depth) -> Vec<[f64; 3]> {
    let mut filtered = vec![[0.0; 3]; values.len()];
    filter_angles(values, &mut filtered, kind, depth);
    filtered
}

impl Value for DVec3 {
    fn mix(self, other: Self, t: f64) -> Self {
        self * (1.0 - t) + other * t
    }

    fn sample(bone: &BoneMotion, at: f64, sampling: Sampling) -> Option<Self> {
        (!bone.translations.is_empty()).then(|| sample_vector(&bone.translations, at, sampling))
    }

    fn go_on_from(_: &mut [Self], _: Self, _: &EulerFrame) {}

    fn is_seam(self, _: Self) -> bool {
        false
    }

    fn crossfade(old: &[Self], new: &[Self], weights: &[f64], _: Blend, _: &EulerFrame) -> Vec<Self> {
        mix_each(old, new, weights)
    }

    fn filter(values: &[Self], kind: FilterKind, depth: Depth, _: FilterChannels, _: &EulerFrame) -> Vec<Self> {
        let rows: Vec<_> = values.iter().map(DVec3::to_array).collect();
        let rows = by_component(&rows, |channel, out| filter_values(channel, out, kind, depth));
        rows.into_iter().map(DVec3::from_array).collect()
    }
}

impl Value for DQuat {
    fn mix(self, other: Self, t: f64) -> Self {
        if t <= 0.0 {
            self
        } else if t >= 1.0 {
            other
        } else {
            slerp(self.normalize(), other.normalize(), t)
        }
    }

    fn sample(bone: &BoneMotion, at: f64, sampling: Sampling) -> Option<Self> {
        (!bone.rotations.is_empty()).then(|| sample_rotation(&bone.rotations, at, sampling))
    }

    fn go_on_from(values: &mut [Self], neighbour: Self, _: &EulerFrame) {
        let mut last = neighbour;
        for value in values {
            if value.dot(last) < 0.0 {
                *value = -*value;
            }
            last = *value;
        }
    }

    fn is_seam(self, next: Self) -> bool {
        self.dot(next) < 0.0
    }

    fn crossfade(old: &[Self], new: &[Self], weights: &[f64], blend: Blend, frame: &EulerFrame) -> Vec<Self> {
        if blend == Blend::Slerp {
            return mix_each(old, new, weights);
        }
        let old_angles = frame.continuous(old.iter().copied(), [0.0; 3]);
        let hint = old_angles.first().copied().unwrap_or_default();
        let new_angles = frame.continuous(new.iter().copied(), hint);
        (old_angles.iter().zip(&new_angles).zip(weights))
            .map(|((old, new), &weight)| frame.quat(lerp_angles(*old, *new, weight)))
            .collect()
    }

    fn filter(
        values: &[Self],
        kind: FilterKind,
        depth: Depth,
        channels: FilterChannels,
        frame: &EulerFrame,
    ) -> Vec<Self> {
        match channels {
            FilterChannels::Rotation => filtered_rotations(values, kind, depth),
            FilterChannels::Each => {
                let angles = frame.continuous(values.iter().copied(), [0.0; 3]);
                filtered_angles(&angles, kind, depth).into_iter().map(|angles| frame.quat(angles)).collect()
            }
        }
    }
}

impl Value for Turn {
    fn mix(self, other: Self, t: f64) -> Self {
        Self { rotation: self.rotation.mix(other.rotation, t), angles: lerp_angles(self.angles, other.angles, t) }
    }

    fn sample(bone: &BoneMotion, at: f64, sampling: Sampling) -> Option<Self> {
        Some(Self { rotation: DQuat::sample(bone, at, sampling)?, angles: sample_angles(&bone.angles, at, sampling) })
    }

    fn go_on_from(values: &mut [Self], neighbour: Self, frame: &EulerFrame) {
        let Some(first) = values.first().copied() else { return };
        let wanted = frame.order.angles_near(first.rotation, neighbour.angles);
        let [i, j, k] = frame.order.axes();
        // The second solution turns the outer angles by half a turn and mirrors the middle one.
        let mirrored = (wanted[j] - first.angles[j]).abs() > 1e-6
            && (((wanted[j] + first.angles[j]) / std::f64::consts::PI).rem_euclid(2.0) - 1.0).abs() < 1e-6;
        let solution = |angles: [f64; 3]| {
            let mut other = angles;
            if mirrored {
                other[i] += std::f64::consts::PI;
                other[j] = std::f64::consts::PI - angles[j];
                other[k] += std::f64::consts::PI;
            }
            other
        };
        let from = solution(first.angles);
        let turns: [f64; 3] = std::array::from_fn(|axis| {
            ((wanted[axis] - from[axis]) / std::f64::consts::TAU).round() * std::f64::consts::TAU
        });
        if !mirrored && turns == [0.0; 3] {
            return;
        }
        for value in values {
            let angles = solution(value.angles);
            value.angles = std::array::from_fn(|axis| angles[axis] + turns[axis]);
        }
    }

    fn is_seam(self, next: Self) -> bool {
        (0..3).any(|axis| (self.angles[axis] - next.angles[axis]).abs() > std::f64::consts::PI)
    }

    fn crossfade(old: &[Self], new: &[Self], weights: &[f64], blend: Blend, frame: &EulerFrame) -> Vec<Self> {
        let mut mixed = mix_each(old, new, weights);
        // Between two samples a rotation is not that of the angles between theirs: the pose is what is blended, as on
        // bones without angles.
        let angles = |value: &Self| frame.order.angles_near(value.rotation, value.angles);
        for (value, ((old, new), &weight)) in mixed.iter_mut().zip(old.iter().zip(new).zip(weights)) {
            if blend == Blend::Euler && weight > 0.0 && weight < 1.0 {
                value.angles = lerp_angles(angles(old), angles(new), weight);
                value.rotation = frame.order.quat(value.angles);
            }
        }
        mixed
    }

    fn filter(
        values: &[Self],
        kind: FilterKind,
        depth: Depth,
        channels: FilterChannels,
        frame: &EulerFrame,
    ) -> Vec<Self> {
        let mut angles: Vec<_> =
            values.iter().map(|value| frame.order.angles_near(value.rotation, value.angles)).collect();
        unwrap_angles(&mut angles);
        let angles = filtered_angles(&angles, kind, depth);
        match channels {
            FilterChannels::Each => {
                angles.into_iter().map(|angles| Self { rotation: frame.order.quat(angles), angles }).collect()
            }
            FilterChannels::Rotation => {
                let rotations: Vec<_> = values.iter().map(|value| value.rotation).collect();
                let rotations = filtered_rotations(&rotations, kind, depth);
                rotations.into_iter().zip(angles).map(|(rotation, angles)| Self { rotation, angles }).collect()
            }
        }
    }
}

/// Reads a filter's channels by name.
impl std::str::FromStr for FilterChannels {
    type Err = ParameterError;

    fn from_str(name: &str) -> Result<Self, Self::Err> {
        match name {
            "ROTATION" => Ok(Self::Rotation),
            "CHANNELS" => Ok(Self::Each),
            other => Err(ParameterError(format!("expected ROTATION or CHANNELS, found `{other}`"))),
        }
    }
}

/// Reads a blend by name.
impl std::str::FromStr for Blend {
    type Err = ParameterError;

    fn from_str(name: &str) -> Result<Self, Self::Err> {
        match name {
            "SLERP" => Ok(Self::Slerp),
            "EULER" => Ok(Self::Euler),
            other => Err(ParameterError(format!("expected SLERP or EULER, found `{other}`"))),
        }
    }
}
