//! Euler angles of any order <-> unit quaternions.
//!
//! Angles are always indexed x, y, z; the order only says which is applied first (about fixed axes). Extraction follows
//! K. Shoemake, "Euler Angle Conversion" (Graphics Gems IV, 1994), in f64.

mod many;
mod sines;

use std::f64::consts::{PI, TAU};
use std::fmt;
use std::str::FromStr;

use glam::{DMat3, DQuat, DVec3};

use crate::error::ParameterError;
use crate::skeleton::EulerOrder;

/// Two rotations closer than this angle (radians) are one and the same: the rounding of a dozen f64 operations.
const SAME_ROTATION_RAD: f64 = 1e-12;

/// Below this cosine of the middle angle only the sum or difference of the other two is known.
const GIMBAL_LOCK_COSINE: f64 = 1e-9;

impl EulerOrder {
    /// All six, for tables and tests.
    pub const ALL: [Self; 6] = [Self::Xyz, Self::Xzy, Self::Yxz, Self::Yzx, Self::Zxy, Self::Zyx];

    /// Returns the axes (0 = x) in the order in which they are applied.
    pub const fn axes(self) -> [usize; 3] {
        match self {
            Self::Xyz => [0, 1, 2],
            Self::Xzy => [0, 2, 1],
            Self::Yxz => [1, 0, 2],
            Self::Yzx => [1, 2, 0],
            Self::Zxy => [2, 0, 1],
            Self::Zyx => [2, 1, 0],
        }
    }

    /// Returns the order's name as Blender writes it, `"XYZ"` and so on.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Xyz => "XYZ",
            Self::Xzy => "XZY",
            Self::Yxz => "YXZ",
            Self::Yzx => "YZX",
            Self::Zxy => "ZXY",
            Self::Zyx => "ZYX",
        }
    }

    /// Returns the rotation by `angles` (radians, indexed x, y, z): the first axis of the order is applied first.
    pub fn quat(self, angles: [f64; 3]) -> DQuat {
        self.axes().into_iter().fold(DQuat::IDENTITY, |rotation, axis| turned(rotation, axis, angles[axis]))
    }

    /// Returns angles in radians that give `rotation`, the middle one within a quarter turn.
    pub fn angles(self, rotation: DQuat) -> [f64; 3] {
        let [i, j, k] = self.axes();
        let parity = if (i + 1) % 3 == j { 1.0 } else { -1.0 };
        let matrix = DMat3::from_quat(rotation);
        let at = |row: usize, column: usize| matrix.col(column)[row];
        let cosine = at(i, i).hypot(at(j, i));
        let mut angles = [0.0; 3];
        angles[j] = (-parity * at(k, i)).atan2(cosine);
        if cosine > GIMBAL_LOCK_COSINE {
            angles[i] = (parity * at(k, j)).atan2(at(k, k));
            angles[k] = (parity * at(j, i)).atan2(at(i, i));
        } else {
            angles[i] = (-parity * at(j, k)).atan2(at(j, j));
        }
        angles
    }

    /// Returns the angles that give `rotation` and lie nearest to `hint`: whole turns and the second solution
    /// included. Where `hint` itself gives the rotation, it comes back unchanged.
    pub fn angles_near(self, rotation: DQuat, hint: [f64; 3]) -> [f64; 3] {
        let difference = self.quat(hint).conjugate() * rotation;
        if difference.xyz().length() * 2.0 < SAME_ROTATION_RAD {
            return hint;
        }
        let [i, j, k] = self.axes();
        let mut angles = self.angles(rotation);
        if angles[j].cos() <= GIMBAL_LOCK_COSINE {
            let outer = DQuat::from_axis_angle(DVec3::AXES[k], hint[k]);
            angles = self.angles(outer.conjugate() * rotation);
            angles[k] += hint[k];
        }
        let mut other = [0.0; 3];
        other[i] = angles[i] + PI;
        other[j] = PI - angles[j];
        other[k] = angles[k] + PI;
        let [angles, other] = [angles, other].map(|found| nearest_turns(found, hint));
        if distance(other, hint) < distance(angles, hint) {
            other
        } else {
            angles
        }
    }
}

/// Returns the rotation, and then one about an axis (0 = x): half the work of a product of any two.
#[inline]
fn turned(rotation: DQuat, axis: usize, angle: f64) -> DQuat {
    let (sine, cosine) = (angle * 0.5).sin_cos();
    let DQuat { x, y, z, w } = rotation;
    // The unit of that axis times the rotation.
    let product = match axis {
        0 => DQuat::from_xyzw(w, -z, y, -x),
        1 => DQuat::from_xyzw(z, w, -x, -y),
        _ => DQuat::from_xyzw(-y, x, w, -z),
    };
    rotation * cosine + product * sine
}

impl fmt::Display for EulerOrder {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

impl FromStr for EulerOrder {
    type Err = ParameterError;

    fn from_str(name: &str) -> Result<Self, Self::Err> {
        Self::ALL
            .into_iter()
            .find(|order| order.name().eq_ignore_ascii_case(name))
            .ok_or_else(|| ParameterError(format!("expected an Euler order such as XYZ, found `{name}`")))
    }
}

/// Shifts each angle by whole turns to within half a turn of `hint`.
fn nearest_turns(angles: [f64; 3], hint: [f64; 3]) -> [f64; 3] {
    std::array::from_fn(|axis| angles[axis] + ((hint[axis] - angles[axis]) / TAU).round() * TAU)
}

fn distance(a: [f64; 3], b: [f64; 3]) -> f64 {
    (0..3).map(|axis| (a[axis] - b[axis]).abs()).sum()
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn angle_between(a: DQuat, b: DQuat) -> f64 {
        (a.conjugate() * b).xyz().length() * 2.0
    }

    #[test]
    fn the_first_letter_is_applied_first_about_fixed_axes() {
        let quarter = PI / 2.0;
        let turned = EulerOrder::Xyz.quat([quarter, quarter, 0.0]) * DVec3::Y;
        assert!((turned - DVec3::X).length() < 1e-12, "y -> (about x) z -> (about y) x, found {turned}");
    }

    #[test]
    fn a_rotation_is_the_product_of_those_about_each_axis() {
        for order in EulerOrder::ALL {
            for angles in [[0.3, -1.2, 2.9], [0.0, PI, -0.5], [7.0, 0.0, 0.0], [0.0; 3]] {
                let about = |axis: usize| DQuat::from_axis_angle(DVec3::AXES[axis], angles[axis]);
                let [first, second, third] = order.axes().map(about);
                let product = third * second * first;
                assert!(order.quat(angles).abs_diff_eq(product, 1e-15), "{order} {angles:?}");
            }
        }
    }

    #[test]
    fn names_and_orders_are_the_same_thing() {
        for order in EulerOrder::ALL {
            assert_eq!(order.name().parse::<EulerOrder>(), Ok(order));
        }
        assert!("XYX".parse::<EulerOrder>().is_err());
    }

    #[test]
    fn a_hint_decides_in_gimbal_lock() {
        for order in EulerOrder::ALL {
            let [i, j, k] = order.axes();
            let mut angles = [0.0; 3];
            (angles[i], angles[j], angles[k]) = (0.3, PI / 2.0, 1.1);
            let mut hint = angles;
            hint[k] += 0.01;
            let found = order.angles_near(order.quat(angles), hint);
            assert!(angle_between(order.quat(found), order.quat(angles)) < 1e-7, "{order}: {found:?}");
            assert!((found[k] - hint[k]).abs() < 1e-9, "{order}: {found:?}");
        }
    }

    proptest! {
        #[test]
        fn extraction_gives_the_rotation_back(x in -9.0..9.0, y in -9.0..9.0, z in -9.0..9.0, order in 0..6usize) {
            let order = EulerOrder::ALL[order];
            let rotation = order.quat([x, y, z]);
            prop_assert!(angle_between(order.quat(order.angles(rotation)), rotation) < 1e-7);
        }

        #[test]
        fn near_a_hint_the_hints_own_solution_comes_back(
            x in -9.0..9.0, y in -9.0..9.0, z in -9.0..9.0, order in 0..6usize, step in -0.05..0.05,
        ) {
            let order = EulerOrder::ALL[order];
            let angles = [x, y, z];
            prop_assert_eq!(order.angles_near(order.quat(angles), angles), angles);
            let middle = order.axes()[1];
            prop_assume!(angles[middle].cos().abs() > 0.2);
            let found = order.angles_near(order.quat(angles), [x + step, y - step, z + step]);
            prop_assert!(distance(found, angles) < 1e-9, "{:?}", found);
        }
    }
}
