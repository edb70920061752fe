//! Rotations between frames.

use glam::{DQuat, DVec3};

use super::{split_index, Sampling};

/// Returns the rotation at a real-valued index; the identity if there are no samples.
///
/// Linear: slerp on the shorter arc. Smooth: `squad` (Shoemake 1987), which passes through every sample, turns without
/// a kink, and follows a joint that turns at constant speed exactly; about one axis it is the Catmull-Rom spline.
/// The signs of the samples do not matter.
pub fn sample_rotation(samples: &[DQuat], x: f64, sampling: Sampling) -> DQuat {
    let Some((index, fraction)) = split_index(samples.len(), x) else { return DQuat::IDENTITY };
    let from = samples[index];
    if fraction == 0.0 {
        return from;
    }
    let to = in_hemisphere_of(from, samples[index + 1]);
    match sampling {
        Sampling::Linear => slerp(from, to, fraction),
        Sampling::Smooth => {
            let before = index.checked_sub(1).map(|before| samples[before]);
            let after = samples.get(index + 2).copied();
            let from_control = before.map_or(from, |before| squad_control(before, from, to));
            let to_control = after.map_or(to, |after| squad_control(from, to, after));
            let along = slerp(from, to, fraction);
            let beside = slerp(from_control, to_control, fraction);
            slerp(along, beside, 2.0 * fraction * (1.0 - fraction))
        }
    }
}

/// Returns the rotation a fraction of the way from one to the other, on the shorter arc and at constant speed.
///
/// The same rotation twice gives it back bit for bit, as do the fractions 0 and, but for its sign, 1.
pub fn slerp(from: DQuat, to: DQuat, fraction: f64) -> DQuat {
    let to = in_hemisphere_of(from, to);
    let arc = quarter_turn_arc(from, to);
    if arc == 0.0 {
        return from;
    }
    let sine = arc.sin();
    from * (((1.0 - fraction) * arc).sin() / sine) + to * ((fraction * arc).sin() / sine)
}

/// Returns the angle in radians, 0 to pi, by which one rotation must turn to become the other.
///
/// From the chord rather than the cosine, which cannot tell angles below 1e-8 from none.
pub fn angle_between(a: DQuat, b: DQuat) -> f64 {
    2.0 * quarter_turn_arc(a, in_hemisphere_of(a, b))
}

/// Negates samples so that each lies in the hemisphere of the one before it. The rotations stay the same.
pub fn align_hemispheres(samples: &mut [DQuat]) {
    let mut last: Option<DQuat> = None;
    for sample in samples {
        if let Some(last) = last {
            *sample = in_hemisphere_of(last, *sample);
        }
        last = Some(*sample);
    }
}

fn in_hemisphere_of(reference: DQuat, rotation: DQuat) -> DQuat {
    if reference.dot(rotation) < 0.0 {
        -rotation
    } else {
        rotation
    }
}

/// The arc between two unit quaternions of one hemisphere: half the angle of the rotations, at most a quarter turn.
fn quarter_turn_arc(a: DQuat, b: DQuat) -> f64 {
    2.0 * ((b - a).length() / 2.0).min(1.0).asin()
}

/// The control point that gives a rotation the mean speed of its two neighbouring steps.
fn squad_control(before: DQuat, at: DQuat, after: DQuat) -> DQuat {
    let log_of_step = |to: DQuat| logarithm(at.conjugate() * in_hemisphere_of(at, to));
    at * exponential((log_of_step(before) + log_of_step(after)) * -0.25)
}

/// Half the rotation vector of a unit quaternion.
fn logarithm(rotation: DQuat) -> DVec3 {
    let vector = rotation.xyz();
    let length = vector.length();
    if length == 0.0 {
        DVec3::ZERO
    } else {
        vector * (length.atan2(rotation.w) / length)
    }
}

/// The inverse of [`logarithm`].
fn exponential(half_vector: DVec3) -> DQuat {
    DQuat::from_scaled_axis(2.0 * half_vector)
}
