//! Euler angles of any order <-> unit quaternions.

use crate::skeleton::EulerOrder;
use glam::{DQuat, DVec3};

impl EulerOrder {
    /// Every order, `XYZ` first.
    pub const ALL: [Self; 6] = [Self::Xyz, Self::Xzy, Self::Yxz, Self::Yzx, Self::Zxy, Self::Zyx];

    /// Returns the axes (0, 1, 2 for X, Y, Z) in the order in which they are applied.
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

    /// Returns the rotation by `angles` (radians, indexed x, y, z whatever the order): the first letter of the order is
    /// applied first, about fixed axes, so that `XYZ` is `Rz * Ry * Rx`.
    pub fn quat(self, angles: [f64; 3]) -> DQuat {
        let [first, second, third] = self.axes().map(|axis| about(axis, angles[axis]));
        third * second * first
    }
}

fn about(axis: usize, angle: f64) -> DQuat {
    DQuat::from_axis_angle(DVec3::AXES[axis], angle)
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::EulerRot;

    #[test]
    fn quaternions_agree_with_glam_for_every_order() {
        let glam_orders =
            [EulerRot::XYZEx, EulerRot::XZYEx, EulerRot::YXZEx, EulerRot::YZXEx, EulerRot::ZXYEx, EulerRot::ZYXEx];
        let angles = [0.3, -1.1, 2.4];
        for (order, glam_order) in EulerOrder::ALL.into_iter().zip(glam_orders) {
            let [a, b, c] = order.axes().map(|axis| angles[axis]);
            let expected = DQuat::from_euler(glam_order, a, b, c);
            // Four products of numbers below 1: a few units in the last place.
            assert!(order.quat(angles).dot(expected).abs() > 1.0 - 1e-15, "{order:?}");
        }
    }
}
