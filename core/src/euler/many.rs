//! Angles of many frames to rotations: [`EulerOrder::quat`] for all of them at once.

use super::sines::sines_and_cosines;
use crate::skeleton::EulerOrder;
use glam::{DMat3, DQuat};

/// So many frames are worked on side by side: their numbers stay in the nearest cache.
const LANES: usize = 32;

/// The rotations of a block of frames, component by component, behind the one of the frame before.
type Block = [[f64; LANES + 1]; 4];

impl EulerOrder {
    /// Returns for every frame `axes * quat(angles) * axes^-1`, by angles in radians, indexed x, y, z. Of the two
    /// quaternions of a rotation it is the one nearer to that of the frame before; the first frame's is nearer to none.
    pub(crate) fn quats(self, angles: &[[f64; 3]], axes: DQuat) -> Vec<DQuat> {
        #[cfg(target_arch = "x86_64")]
        if std::arch::is_x86_feature_detected!("avx2") {
            // SAFETY: the function is safe but for needing AVX2, which this processor was just found to have.
            return unsafe { in_avx2(self, angles, axes) };
        }
        in_any(self, angles, axes)
    }
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx2")]
fn in_avx2(order: EulerOrder, angles: &[[f64; 3]], axes: DQuat) -> Vec<DQuat> {
    in_any(order, angles, axes)
}

#[inline(always)]
fn in_any(order: EulerOrder, angles: &[[f64; 3]], axes: DQuat) -> Vec<DQuat> {
    let axes = DMat3::from_quat(axes);
    let mut rotations = Vec::with_capacity(angles.len());
    // No rotation comes before the first.
    let mut block: Block = [[0.0; LANES + 1], [0.0; LANES + 1], [0.0; LANES + 1], [1.0; LANES + 1]];
    let mut sign = 0;
    for angles in angles.chunks(LANES) {
        for component in &mut block {
            component[0] = component[LANES];
        }
        turn(order, angles, &mut block);
        change_axes(&axes, &mut block);
        let signs = signs(&block, &mut sign);
        let [x, y, z, w] = &block;
        rotations.extend((0..angles.len()).map(|frame| {
            let signed = |component: &[f64; LANES + 1]| f64::from_bits(component[frame + 1].to_bits() ^ signs[frame]);
            DQuat::from_xyzw(signed(x), signed(y), signed(z), signed(w))
        }));
    }
    rotations
}

/// Puts the rotations of up to [`LANES`] frames into a block.
#[inline(always)]
fn turn(order: EulerOrder, angles: &[[f64; 3]], block: &mut Block) {
    let [i, j, k] = order.axes();
    // Not `map`: only what the compiler inlines is made for the processor's widest vectors.
    let (sine_i, cosine_i) = sines_and_cosines(&halves(angles, i));
    let (sine_j, cosine_j) = sines_and_cosines(&halves(angles, j));
    let (sine_k, cosine_k) = sines_and_cosines(&halves(angles, k));
    // Whether the order goes round as x, y, z does, or against it.
    let parity = if (i + 1) % 3 == j { 1.0 } else { -1.0 };
    let mut parts = [[0.0; LANES]; 4];
    let [part_i, part_j, part_k, part_w] = &mut parts;
    for lane in 0..LANES {
        let (si, sj, sk) = (sine_i[lane], sine_j[lane], sine_k[lane]);
        let (ci, cj, ck) = (cosine_i[lane], cosine_j[lane], cosine_k[lane]);
        let (ss, sc, cs, cc) = (si * sk, si * ck, ci * sk, ci * ck);
        part_i[lane] = sc * cj - parity * cs * sj;
        part_j[lane] = cc * sj + parity * ss * cj;
        part_k[lane] = cs * cj - parity * sc * sj;
        part_w[lane] = cc * cj + parity * ss * sj;
    }
    for (component, part) in [i, j, k, 3].into_iter().zip(parts) {
        block[component][1..].copy_from_slice(&part);
    }
}

/// Returns half of each frame's angle about an axis, and zeros to the end of the block.
#[inline(always)]
fn halves(angles: &[[f64; 3]], axis: usize) -> [f64; LANES] {
    let mut halves = [0.0; LANES];
    for (half, angles) in halves.iter_mut().zip(angles) {
        *half = angles[axis] * 0.5;
    }
    halves
}

/// Turns the axes of the rotations; how far they turn stays.
#[inline(always)]
fn change_axes(axes: &DMat3, block: &mut Block) {
    if *axes == DMat3::IDENTITY {
        return;
    }
    let [x, y, z, _] = block;
    for lane in 1..=LANES {
        let (a, b, c) = (x[lane], y[lane], z[lane]);
        x[lane] = axes.x_axis.x * a + axes.y_axis.x * b + axes.z_axis.x * c;
        y[lane] = axes.x_axis.y * a + axes.y_axis.y * b + axes.z_axis.y * c;
        z[lane] = axes.x_axis.z * a + axes.y_axis.z * b + axes.z_axis.z * c;
    }
}

/// Returns for each rotation of a block the sign bit that it takes to be on one side with the one before; `sign` is that of
/// the last one.
///
/// What has to wait for the frame before is only a bit: the rotations are compared as they are.
#[inline(always)]
fn signs(block: &Block, sign: &mut u64) -> [u64; LANES] {
    let [x, y, z, w] = block;
    let mut products = [0.0; LANES];
    for lane in 0..LANES {
        let next = lane + 1;
        products[lane] = x[lane] * x[next] + y[lane] * y[next] + z[lane] * z[next] + w[lane] * w[next];
    }
    let mut signs = [0; LANES];
    for (own, product) in signs.iter_mut().zip(products) {
        // Rotations that differ by half a turn are as near with either sign.
        *sign = if product == 0.0 { 0 } else { *sign ^ (product.to_bits() & (1 << 63)) };
        *own = *sign;
    }
    signs
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// The clear version.
    fn one_by_one(order: EulerOrder, angles: &[[f64; 3]], axes: DQuat) -> Vec<DQuat> {
        let mut before = DQuat::IDENTITY;
        let rotation = |angles: &[f64; 3]| {
            let rotation = axes * order.quat(*angles) * axes.conjugate();
            before = if rotation.dot(before) < 0.0 { -rotation } else { rotation };
            before
        };
        angles.iter().map(rotation).collect()
    }

    fn assert_same(order: EulerOrder, angles: &[[f64; 3]], axes: DQuat) {
        let expected = one_by_one(order, angles, axes);
        for found in [order.quats(angles, axes), in_any(order, angles, axes)] {
            assert_eq!(found.len(), expected.len());
            for (frame, (found, expected)) in found.iter().zip(&expected).enumerate() {
                assert!(found.abs_diff_eq(*expected, 3e-15), "{order} frame {frame}: {found} {expected}");
            }
        }
    }

    #[test]
    fn a_figure_that_spins_for_hundreds_of_frames_changes_no_sign() {
        for order in EulerOrder::ALL {
            let angles: Vec<_> =
                (0..500_i32).map(|frame| [0.3, 0.9, -0.2].map(|step| step * f64::from(frame))).collect();
            for length in [0, 1, LANES - 1, LANES, LANES + 1, 500] {
                assert_same(order, &angles[..length], DQuat::IDENTITY);
                assert_same(order, &angles[..length], EulerOrder::Zxy.quat([0.3, -0.8, 1.2]));
            }
            let spun = order.quats(&angles, DQuat::IDENTITY);
            assert!(spun.windows(2).all(|pair| pair[0].dot(pair[1]) >= 0.0), "{order}");
        }
    }

    #[test]
    fn angles_of_zero_are_no_rotation_at_all() {
        let quats = EulerOrder::Yzx.quats(&[[0.0; 3]; 40], EulerOrder::Xyz.quat([1.0, 2.0, 3.0]));
        assert!(quats.iter().all(|quat| *quat == DQuat::IDENTITY));
    }

    proptest! {
        #[test]
        fn many_are_what_each_is_alone(
            angles in proptest::collection::vec(proptest::array::uniform3(-20.0..20.0_f64), 0..100),
            axes in proptest::array::uniform3(-4.0..4.0_f64),
            order in 0..6_usize,
        ) {
            assert_same(EulerOrder::ALL[order], &angles, EulerOrder::Xyz.quat(axes));
        }
    }
}
