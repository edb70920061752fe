//! Lines that make one figure of groups of markers: from the markers of a thigh to those of the hips.
//!
//! Neighbours that keep their distance are on one bone. Between bones distances change, but not by much from one bone to
//! the next: the shortest such lines that join everything are much like a body.

use super::groups::Groups;
use super::sides::Side;
use super::{actor::is_bone, bounds};
use glam::Vec3;

/// How long a bridge is at most, in heights of the figure.
const LONGEST: f32 = 0.4;

/// By how much longer a line from left to right counts: it would tie the knees together.
const ACROSS: f32 = 2.0;

/// Of more markers than this, nobody could tell the lines apart, and there would be too many pairs to look at.
const MOST_MARKERS: usize = 250;

/// Returns lines to add to those that are there, so that what can hang together does.
pub(super) fn bridges(lines: &[[usize; 2]], sides: &[Side], looks: &[Vec<Vec3>]) -> Vec<[usize; 2]> {
    let count = sides.len();
    if count > MOST_MARKERS {
        return Vec::new();
    }
    let sizes = looks.iter().filter_map(|points| bounds(points)).map(|[low, high]| (high - low).max_element());
    let longest = LONGEST * sizes.fold(0.0, f32::max);
    let mut groups = Groups::new(count);
    for [a, b] in lines {
        groups.join(*a, *b);
    }
    let mut found: Vec<(f32, [usize; 2])> = Vec::new();
    for a in 0..count {
        for b in (a + 1)..count {
            if groups.of(a) == groups.of(b) {
                continue;
            }
            let Some(length) = mean_length([a, b], looks).filter(|length| *length <= longest) else { continue };
            let is_across = matches!((sides[a], sides[b]), (Side::Left, Side::Right) | (Side::Right, Side::Left));
            found.push((if is_across { length * ACROSS } else { length }, [a, b]));
        }
    }
    found.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
    let joins = |(_, [a, b]): &(f32, [usize; 2])| is_bone([*a, *b], looks) && groups.join(*a, *b);
    found.into_iter().filter(joins).map(|(_, line)| line).collect()
}

/// Returns how long a line is in the mean; `None` where it is never seen.
fn mean_length([a, b]: [usize; 2], looks: &[Vec<Vec3>]) -> Option<f32> {
    let lengths = looks.iter().filter_map(|points| Some(points.get(a)?.distance(*points.get(b)?)));
    let seen = lengths.filter(|length| !length.is_nan());
    let (sum, count) = seen.fold((0.0, 0.0), |(sum, count), length| (sum + length, count + 1.0));
    (count > 0.0).then(|| sum / count)
}
