//! The rotation and translation that lay one set of points best over another (Kabsch 1976, by quaternions: Horn 1987).

use glam::{DQuat, DVec3};

/// A rigid motion: a rotation about the origin, then a translation.
#[derive(Debug, Clone, Copy)]
pub(super) struct RigidMotion {
    rotation: DQuat,
    translation: DVec3,
}

impl RigidMotion {
    /// Returns the motion from points to others, of which there are as many, by least squares.
    pub(super) fn between(from: &[DVec3], to: &[DVec3]) -> Self {
        let centre = |points: &[DVec3]| points.iter().sum::<DVec3>() / points.len().max(1) as f64;
        let (from_centre, to_centre) = (centre(from), centre(to));
        let mut sums = [[0.0; 3]; 3];
        for (a, b) in from.iter().zip(to) {
            let (a, b) = ((*a - from_centre).to_array(), (*b - to_centre).to_array());
            for (row, a) in sums.iter_mut().zip(a) {
                row.iter_mut().zip(b).for_each(|(sum, b)| *sum += a * b);
            }
        }
        let [[xx, xy, xz], [yx, yy, yz], [zx, zy, zz]] = sums;
        let rotation = largest_eigenvector([
            [xx + yy + zz, yz - zy, zx - xz, xy - yx],
            [yz - zy, xx - yy - zz, xy + yx, zx + xz],
            [zx - xz, xy + yx, yy - xx - zz, yz + zy],
            [xy - yx, zx + xz, yz + zy, zz - xx - yy],
        ]);
        let [w, x, y, z] = rotation;
        let rotation = DQuat::from_xyzw(x, y, z, w).normalize();
        Self { rotation, translation: to_centre - rotation * from_centre }
    }

    /// Returns where a point comes to lie.
    pub(super) fn apply(&self, point: DVec3) -> DVec3 {
        self.rotation * point + self.translation
    }
}

/// Returns the eigenvector of the largest eigenvalue of a symmetric matrix, by Jacobi's rotations.
fn largest_eigenvector(mut matrix: [[f64; 4]; 4]) -> [f64; 4] {
    const SWEEPS: usize = 30;
    let mut vectors = [[0.0; 4]; 4];
    for (index, row) in vectors.iter_mut().enumerate() {
        row[index] = 1.0;
    }
    for _ in 0..SWEEPS {
        let mut off_diagonal = 0.0;
        for p in 0..4 {
            for q in p + 1..4 {
                off_diagonal += matrix[p][q].abs();
                rotate(&mut matrix, &mut vectors, p, q);
            }
        }
        if off_diagonal == 0.0 {
            break;
        }
    }
    let largest = (0..4).fold(0, |best, next| if matrix[next][next] > matrix[best][best] { next } else { best });
    vectors.map(|row| row[largest])
}

/// Turns rows and columns p and q so that their off-diagonal element becomes zero.
fn rotate(matrix: &mut [[f64; 4]; 4], vectors: &mut [[f64; 4]; 4], p: usize, q: usize) {
    if matrix[p][q] == 0.0 {
        return;
    }
    let theta = (matrix[q][q] - matrix[p][p]) / (2.0 * matrix[p][q]);
    let tangent = theta.signum() / (theta.abs() + theta.hypot(1.0));
    let cosine = 1.0 / tangent.hypot(1.0);
    let sine = tangent * cosine;
    let turn = |a: f64, b: f64| (cosine * a - sine * b, sine * a + cosine * b);
    for row in matrix.iter_mut().chain(vectors.iter_mut()) {
        (row[p], row[q]) = turn(row[p], row[q]);
    }
    let (row_p, row_q) = (matrix[p], matrix[q]);
    matrix[p] = std::array::from_fn(|column| turn(row_p[column], row_q[column]).0);
    matrix[q] = std::array::from_fn(|column| turn(row_p[column], row_q[column]).1);
    (matrix[p][q], matrix[q][p]) = (0.0, 0.0);
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn point() -> impl Strategy<Value = DVec3> {
        [-1000.0..1000.0, -1000.0..1000.0, -1000.0..1000.0_f64].prop_map(DVec3::from_array)
    }

    proptest! {
        #[test]
        fn a_rigid_motion_is_found_again(
            points in proptest::collection::vec(point(), 3..8),
            axis in point(),
            angle in -3.1..3.1_f64,
            translation in point(),
            other in point(),
        ) {
            let area = (points[1] - points[0]).cross(points[2] - points[0]).length();
            prop_assume!(axis.length() > 1.0 && area > 1000.0);
            let rotation = DQuat::from_axis_angle(axis.normalize(), angle);
            let moved: Vec<DVec3> = points.iter().map(|point| rotation * *point + translation).collect();
            let found = RigidMotion::between(&points, &moved);
            prop_assert!((found.apply(other) - (rotation * other + translation)).length() < 1e-6);
        }
    }
}
