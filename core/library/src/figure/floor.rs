//! How far a figure reaches, and on which height it stands.

use glam::Vec3;

/// A figure whose feet are this close above or below the file's own zero stands on it: markers are on ankles, and soles
/// sink in.
const NEAR_ZERO: std::ops::RangeInclusive<f32> = -0.08..=0.2;

/// The share of frames on which something may be below the floor: a marker that was mistaken for another, a jump's
/// landing.
const BELOW: f32 = 0.05;

/// Returns the lowest and the highest coordinates of points; `None` where none is seen.
pub(crate) fn bounds(points: &[Vec3]) -> Option<[Vec3; 2]> {
    let seen = points.iter().copied().filter(|point| !point.is_nan());
    seen.fold(None, |bounds, point| match bounds {
        Some([low, high]) => Some([point.min(low), point.max(high)]),
        None => Some([point, point]),
    })
}

/// Returns the height of the floor: the file's own zero where that is near the feet, as shares of how tall the figure
/// is, and else as low as the figure comes.
pub(crate) fn floor<'a>(frames: impl Iterator<Item = &'a [Vec3]>) -> f32 {
    let reaches: Vec<[Vec3; 2]> = frames.filter_map(bounds).collect();
    let mut lows: Vec<f32> = reaches.iter().map(|[low, _]| low.z).collect();
    let mut heights: Vec<f32> = reaches.iter().map(|[low, high]| high.z - low.z).collect();
    let lowest = at_share(&mut lows, BELOW);
    let height = at_share(&mut heights, 0.5);
    let is_near = NEAR_ZERO.contains(&(lowest / height.max(f32::MIN_POSITIVE)));
    if is_near {
        0.0
    } else {
        lowest
    }
}

/// Returns the value below which that share of values is; 0 of none.
fn at_share(values: &mut [f32], share: f32) -> f32 {
    values.sort_by(f32::total_cmp);
    values.get((values.len() as f32 * share) as usize).copied().unwrap_or(0.0)
}
