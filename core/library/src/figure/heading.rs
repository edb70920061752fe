//! Left and right of a figure whose names say nothing: by the way it goes, for people mostly walk forwards.

use super::sides::Side;
use glam::Vec3;

/// Who goes less far than this many times their own height may go sideways or backwards.
const FAR: f32 = 1.0;

/// What is farther from the middle than this share of the height is on a side.
const BESIDE: f32 = 0.04;

/// Returns the side of each line; the middle for all of a figure that does not go far.
pub(super) fn sides(lines: &[[usize; 2]], looks: &[Vec<Vec3>]) -> Vec<Side> {
    let centres: Vec<Option<Vec3>> = looks.iter().map(|points| middle(points)).collect();
    let mut way = 0.0;
    let mut beside = vec![0.0; lines.len()];
    for (points, pair) in looks.iter().zip(centres.windows(2)) {
        let [Some(from), Some(to)] = pair else { continue };
        let step = (*to - *from).with_z(0.0);
        // As long as the step, so that the far ones count most.
        let leftward = Vec3::Z.cross(step);
        way += step.length();
        for (line, sum) in lines.iter().zip(&mut beside) {
            let ends = line.map(|point| points.get(point).copied().unwrap_or(Vec3::NAN));
            let offset = leftward.dot((ends[0] + ends[1]) / 2.0 - *from);
            *sum += if offset.is_nan() { 0.0 } else { offset };
        }
    }
    let height = looks.iter().filter_map(|points| super::bounds(points)).map(|[low, high]| high.z - low.z);
    let height = height.fold(0.0, f32::max);
    if way <= FAR * height {
        return vec![Side::Middle; lines.len()];
    }
    let side = |sum: f32| match sum / way {
        offset if offset > BESIDE * height => Side::Left,
        offset if offset < -BESIDE * height => Side::Right,
        _ => Side::Middle,
    };
    beside.into_iter().map(side).collect()
}

/// Returns the mean of the points that are seen.
pub(crate) fn middle(points: &[Vec3]) -> Option<Vec3> {
    let (sum, count) = points
        .iter()
        .filter(|point| !point.is_nan())
        .fold((Vec3::ZERO, 0.0), |(sum, count), point| (sum + *point, count + 1.0));
    (count > 0.0).then(|| sum / count)
}

/// Returns the direction of a figure's own left, level and of length 1; `None` where it has no sides, or lies on one.
pub(crate) fn leftward(lines: &[[usize; 2]], sides: &[Side], points: &[Vec3]) -> Option<Vec3> {
    let mean = |wanted: Side| {
        let own = lines.iter().zip(sides).filter(|(_, side)| **side == wanted);
        let ends: Vec<Vec3> =
            own.flat_map(|(line, _)| line.map(|point| points.get(point).copied())).flatten().collect();
        middle(&ends)
    };
    (mean(Side::Left)? - mean(Side::Right)?).with_z(0.0).try_normalize()
}
