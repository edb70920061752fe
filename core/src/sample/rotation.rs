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
    at * exponential((half_step(at, before) + half_step(at, after)) * -0.25)
}

/// Half the rotation vector that leads from one rotation to another, in the axes of the first: zero if they are equal.
fn half_step(from: DQuat, to: DQuat) -> DVec3 {
    let change = from.conjugate() * (in_hemisphere_of(from, to) - from);
    let vector = change.xyz();
    let length = vector.length();
    if length == 0.0 {
        DVec3::ZERO
    } else {
        vector * (length.atan2(1.0 + change.w) / length)
    }
}

/// The rotation by twice a vector.
fn exponential(half_vector: DVec3) -> DQuat {
    DQuat::from_scaled_axis(2.0 * half_vector)
}

#[cfg(test)]
mod tests {
    use std::f64::consts::{FRAC_PI_2, PI, TAU};

    use proptest::prelude::*;

    use super::super::sample_value;
    use super::*;

    const SAMPLINGS: [Sampling; 2] = [Sampling::Linear, Sampling::Smooth];

    /// A handful of roundings by 2^-53 on components of unit size.
    const ROUNDING_RAD: f64 = 1e-14;

    #[test]
    fn a_quarter_of_the_way_is_a_quarter_of_the_angle_on_the_shorter_arc() {
        let from = DQuat::from_rotation_x(0.5);
        let to = DQuat::from_rotation_x(0.5 - FRAC_PI_2);
        for to in [to, -to] {
            let expected = DQuat::from_rotation_x(0.5 - FRAC_PI_2 / 4.0);
            assert!(angle_between(sample_rotation(&[from, to], 0.25, Sampling::Linear), expected) < ROUNDING_RAD);
        }
    }

    #[test]
    fn tiny_angles_are_told_apart() {
        let tiny_rad = 1e-12;
        let angle = angle_between(DQuat::IDENTITY, DQuat::from_rotation_y(tiny_rad));
        assert!((angle - tiny_rad).abs() < 1e-24);
    }

    #[test]
    fn a_half_turn_is_the_largest_angle() {
        let angle = angle_between(DQuat::IDENTITY, DQuat::from_rotation_z(PI));
        assert!((angle - PI).abs() < ROUNDING_RAD);
    }

    #[test]
    fn smooth_about_one_axis_is_the_catmull_rom_spline() {
        let angles = [0.0, 0.3, 0.2, 0.9, 1.0];
        let rotations = angles.map(DQuat::from_rotation_y);
        for step in 0..=40 {
            let x = f64::from(step) / 10.0;
            let expected = DQuat::from_rotation_y(sample_value(&angles, x, Sampling::Smooth));
            assert!(angle_between(sample_rotation(&rotations, x, Sampling::Smooth), expected) < ROUNDING_RAD, "{x}");
        }
    }

    #[test]
    fn smooth_has_no_kink_at_the_samples() {
        let samples: Vec<_> = (0..6)
            .map(|frame| {
                let time = f64::from(frame);
                DQuat::from_scaled_axis(DVec3::new(time.sin(), 0.7 * (2.0 * time).cos(), 0.2 * time))
            })
            .collect();
        let nearby = 1e-6;
        for frame in 1..5 {
            let x = f64::from(frame);
            let at = samples[frame as usize];
            let velocity = |x: f64| half_step(at, sample_rotation(&samples, x, Sampling::Smooth)) / nearby;
            // One-sided differences err by their step times the second derivative, which is of size 1 here.
            assert!((velocity(x + nearby) + velocity(x - nearby)).length() < 1e-5);
        }
    }

    #[test]
    fn a_joint_that_turns_at_constant_speed_does_so_between_the_frames_too() {
        let turn = |x: f64| DQuat::from_rotation_z(x * TAU / 10.0);
        let samples: Vec<_> = (0..=20).map(|frame| turn(f64::from(frame))).collect();
        for sampling in SAMPLINGS {
            for step in 0..=200 {
                let x = f64::from(step) / 10.0;
                assert!(angle_between(sample_rotation(&samples, x, sampling), turn(x)) < ROUNDING_RAD);
            }
        }
    }

    #[test]
    fn no_samples_and_values_that_are_no_numbers_do_not_panic() {
        let broken = [DQuat::from_xyzw(f64::NAN, 0.0, 0.0, f64::INFINITY); 3];
        for sampling in SAMPLINGS {
            assert_eq!(sample_rotation(&[], 1.5, sampling), DQuat::IDENTITY);
            assert!(sample_rotation(&broken, 1.5, sampling).is_nan());
            assert_eq!(sample_rotation(&[DQuat::IDENTITY], f64::NAN, sampling), DQuat::IDENTITY);
        }
    }

    fn any_rotation() -> impl Strategy<Value = DQuat> {
        [-TAU..TAU, -TAU..TAU, -TAU..TAU].prop_map(|vector| DQuat::from_scaled_axis(DVec3::from_array(vector)))
    }

    proptest! {
        #[test]
        fn at_samples_the_value_is_the_sample_bit_for_bit(samples in prop::collection::vec(any_rotation(), 1..9)) {
            for sampling in SAMPLINGS {
                for (index, sample) in samples.iter().enumerate() {
                    prop_assert_eq!(sample_rotation(&samples, index as f64, sampling), *sample);
                }
            }
        }

        #[test]
        fn between_samples_lie_unit_quaternions(samples in prop::collection::vec(any_rotation(), 1..9), x in -1.0..9.0) {
            for sampling in SAMPLINGS {
                prop_assert!((sample_rotation(&samples, x, sampling).length() - 1.0).abs() < ROUNDING_RAD);
            }
        }

        #[test]
        fn a_still_joint_stays_to_the_last_bit(rotation in any_rotation(), x in 0.0..4.0) {
            for sampling in SAMPLINGS {
                prop_assert_eq!(sample_rotation(&[rotation; 5], x, sampling), rotation);
            }
        }
    }
}
