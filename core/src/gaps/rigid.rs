//! A marker is taken to be fixed to the neighbours that keep their distance from it best.

use super::kabsch::RigidMotion;
use crate::markers::Positions;
use glam::DVec3;
use std::ops::Range;

/// How many neighbours are followed, at most; more stiff ones would be on other bones.
const MOST: usize = 5;

/// As few as make a rotation.
const FEWEST: usize = 3;

/// By how much of its mean a distance may deviate (standard deviation) to be that of a rigid body.
pub(super) const RIGID: f64 = 0.05;

/// On how many frames distances are compared, at most.
const LOOKS: usize = 256;

/// How constant the distance of two markers is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Distance {
    /// Its mean.
    pub(super) mean: f64,
    /// Its standard deviation, in means.
    pub(super) deviation: f64,
}

/// Returns how constant the distance of two markers is; `None` where they are never seen together or are one place.
pub(super) fn distance(positions: &Positions, a: usize, b: usize, step: usize) -> Option<Distance> {
    let frames = (0..positions.frame_count()).step_by(step.max(1));
    let both = frames.filter_map(|frame| Some((positions.get(a, frame)?, positions.get(b, frame)?)));
    let (mut count, mut mean, mut squares) = (0.0, 0.0, 0.0);
    for (a, b) in both {
        // Welford: no difference of large sums.
        let distance = a.distance(b);
        count += 1.0;
        let delta = distance - mean;
        mean += delta / count;
        squares += delta * (distance - mean);
    }
    (count > 0.0 && mean > 0.0).then(|| Distance { mean, deviation: (squares / count).sqrt() / mean })
}

/// Returns how many frames to go on between looks.
pub(super) fn step(frame_count: usize) -> usize {
    frame_count.div_ceil(LOOKS).max(1)
}

/// Returns the markers that keep their distance from one, stiffest first.
///
/// What is far away changes its distance by small parts of it, whatever it does: lengths are compared, and those of the
/// three stiffest say what is much.
pub(super) fn stiffest(positions: &Positions, marker_count: usize, marker: usize) -> Vec<usize> {
    let step = step(positions.frame_count());
    let others = (0..marker_count).filter(|other| *other != marker);
    let known = others.filter_map(|other| Some((other, distance(positions, marker, other, step)?)));
    let mut known: Vec<(usize, Distance)> = known.collect();
    let length = |distance: &Distance| distance.deviation * distance.mean;
    known.sort_by(|a, b| length(&a.1).total_cmp(&length(&b.1)));
    let near: f64 = known.iter().take(FEWEST).map(|(_, distance)| distance.mean).sum();
    let most = RIGID * near / FEWEST as f64;
    known.into_iter().filter(|(_, distance)| length(distance) <= most).map(|(other, _)| other).collect()
}

/// Fills a gap by the motion of neighbours that were seen all the time; returns false where there are too few.
///
/// The neighbours carry the marker on from the last sample before the gap and back from the first after it; in between
/// one passes into the other, so that the trajectory has no step at either end.
pub(super) fn fill(trajectory: &mut [DVec3], gap: &Range<usize>, positions: &Positions, stiffest: &[usize]) -> bool {
    let Some(last) = gap.start.checked_sub(1) else { return false };
    let first = gap.end;
    let is_seen = |other: &usize| (last..=first).all(|frame| positions.get(*other, frame).is_some());
    let seen: Vec<usize> = stiffest.iter().copied().filter(is_seen).collect();
    let place = |other: usize, frame: usize| positions.get(other, frame).unwrap_or_default();
    let cluster = choose(&seen, |other| place(other, last));
    if cluster.len() < FEWEST {
        return false;
    }
    let places = |frame: usize| cluster.iter().map(|other| place(*other, frame)).collect::<Vec<DVec3>>();
    let (at_last, at_first) = (places(last), places(first));
    let (Some(before), Some(after)) = (trajectory.get(last).copied(), trajectory.get(first).copied()) else {
        return false;
    };
    for frame in gap.clone() {
        let now = places(frame);
        let forward = RigidMotion::between(&at_last, &now).apply(before);
        let backward = RigidMotion::between(&at_first, &now).apply(after);
        if let Some(place) = trajectory.get_mut(frame) {
            *place = forward.lerp(backward, (frame - last) as f64 / (first - last) as f64);
        }
    }
    true
}

/// Returns the stiffest neighbours of which three are in no line: a line leaves open how things turn about it.
fn choose(stiffest: &[usize], place: impl Fn(usize) -> DVec3) -> Vec<usize> {
    /// How far the third is away from the line of the first two at least, in their distances.
    const OFF_LINE: f64 = 0.1;
    let [first, second, rest @ ..] = stiffest else { return Vec::new() };
    let (origin, along) = (place(*first), place(*second) - place(*first));
    let is_off_line = |other: usize| {
        let area = along.cross(place(other) - origin).length();
        area > OFF_LINE * along.length_squared()
    };
    let Some(third) = rest.iter().position(|other| is_off_line(*other)) else { return Vec::new() };
    let others = rest.iter().enumerate().filter(|(index, _)| *index != third).map(|(_, other)| *other);
    let chosen = [*first, *second].into_iter().chain(rest.get(third).copied()).chain(others);
    chosen.take(MOST).collect()
}
