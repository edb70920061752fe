//! Which frames of a clip are drawn.
//!
//! A strip shows three seconds at the clip's own speed, for a minute squeezed into three seconds looks like nothing. They
//! are the liveliest three: most recordings begin and end with somebody who stands and waits, often with the arms held out.
//! The still is the pose of the strip that is farthest from the clip's mean posture: the height of a kick, the longest
//! stride. The mean itself, and the first frame, look alike in all clips.

use crate::figure::{evenly, leftward, middle, Actor};
use glam::{Quat, Vec3};

/// How long a strip is, in seconds.
const STRIP_S: f64 = 3.0;

/// A strip has at least so many frames per second, where the clip has.
const RATE_HZ: f64 = 12.0;

/// A strip never has more frames.
const MOST_FRAMES: usize = 48;

/// At how many places of a clip it is looked at how lively it is.
const LOOKS: usize = 48;

/// Over how long a time speed is measured, in seconds.
const SPEED_S: f64 = 0.1;

/// First frames from which all of the body flies to the next one at this speed, in metres per second, are no part of the
/// motion: many programs put a pose with outstretched arms there, and filters smear it over the next frames ...
const LEAP_M_PER_S: f32 = 2.0;

/// ... of which so many are left out at most.
const MOST_LEAPS: usize = 5;

/// The frames of a strip, with the poses on them.
#[derive(Debug)]
pub(super) struct Moments {
    /// Where all points are on each of them.
    pub(super) poses: Vec<Vec<Vec3>>,
    /// Which of these is the most telling, ...
    pub(super) still: usize,
    /// ... and its frame in the clip, counted from 0.
    pub(super) still_frame: usize,
    /// How many frames of the strip make a second.
    pub(super) rate_hz: f64,
}

impl Moments {
    /// Chooses.
    pub(super) fn of(actor: &Actor<'_>) -> Self {
        let start = leaps(actor);
        let count = actor.frame_count - start;
        // Whole frames only: nothing between frames is made up.
        let step = ((actor.rate_hz / RATE_HZ) as usize).max(1);
        let length = ((STRIP_S * actor.rate_hz) as usize).clamp(1, step.saturating_mul(MOST_FRAMES)).min(count);
        let looks: Vec<Look> = evenly(count, LOOKS).map(|frame| Look::at(actor, start + frame)).collect();
        let from = liveliest(&looks, length).unwrap_or(start).min(start + count - length);
        let frames: Vec<usize> = (from..from + length).step_by(step).collect();
        let poses: Vec<Vec<Vec3>> = frames.iter().map(|frame| actor.placed(*frame)).collect();
        let mean = mean_posture(looks.iter().map(|look| &look.posture), actor.names.len());
        let most = poses.iter().map(|pose| seen(pose)).max().unwrap_or(0);
        let distances = poses.iter().map(|pose| distance(&posture(actor, pose), &mean) * share(seen(pose), most));
        let still = distances.enumerate().fold((0, f32::NEG_INFINITY), |best, (index, distance)| {
            if distance > best.1 {
                (index, distance)
            } else {
                best
            }
        });
        let still_frame = frames.get(still.0).copied().unwrap_or(0);
        Self { poses, still: still.0, still_frame, rate_hz: actor.rate_hz / step as f64 }
    }
}

/// What is to be seen at one place of a clip.
struct Look {
    frame: usize,
    posture: Vec<Vec3>,
    /// In metres per second, the mean of all points, without the way the figure goes.
    speed: f32,
    /// How many points are seen.
    seen: usize,
}

impl Look {
    fn at(actor: &Actor<'_>, frame: usize) -> Self {
        let apart = ((SPEED_S * actor.rate_hz).round() as usize).max(1);
        let later = frame.saturating_add(apart);
        let other = if later < actor.frame_count { later } else { frame.saturating_sub(apart) };
        let (here, there) = (actor.placed(frame), actor.placed(other));
        let seconds = (frame.abs_diff(other).max(1) as f64 / actor.rate_hz) as f32;
        let speed = distance(&around_middle(&here), &around_middle(&there)) / seconds;
        Self { frame, posture: posture(actor, &here), speed, seen: seen(&here) }
    }
}

/// Returns the first frame of the `length` frames in which looks are fastest in the mean.
fn liveliest(looks: &[Look], length: usize) -> Option<usize> {
    let mut best = (None, f32::NEG_INFINITY);
    let most = looks.iter().map(|look| look.seen).max().unwrap_or(0);
    for (index, first) in looks.iter().enumerate() {
        let inside = looks.iter().skip(index).take_while(|look| look.frame < first.frame + length);
        let (sum, count) =
            inside.fold((0.0, 0.0), |(sum, count), look| (sum + look.speed * share(look.seen, most), count + 1.0));
        let is_whole = looks.last().is_some_and(|last| last.frame + 1 >= first.frame + length);
        if (is_whole || best.0.is_none()) && sum / count > best.1 {
            best = (Some(first.frame), sum / count);
        }
    }
    best.0
}

/// Returns how many points are seen.
pub(super) fn seen(pose: &[Vec3]) -> usize {
    pose.iter().filter(|point| !point.is_nan()).count()
}

/// Returns what a frame counts on which not everything is seen: somebody who comes into sight is not lively.
fn share(seen: usize, most: usize) -> f32 {
    (seen as f32 / most.max(1) as f32).powi(2)
}

/// Returns how many frames at the beginning are no part of the motion.
fn leaps(actor: &Actor<'_>) -> usize {
    let most = MOST_LEAPS.min(actor.frame_count.saturating_sub(1));
    let poses: Vec<Vec<Vec3>> = (0..=most).map(|frame| around_middle(&actor.placed(frame))).collect();
    let speeds = poses.windows(2).map(|pair| distance(&pair[0], &pair[1]) * actor.rate_hz as f32);
    speeds.take_while(|speed| *speed > LEAP_M_PER_S).count()
}

/// Returns points around the middle of all, each as high above the floor as it is: to go somewhere is no posture.
fn around_middle(pose: &[Vec3]) -> Vec<Vec3> {
    let centre = middle(pose).unwrap_or_default().with_z(0.0);
    pose.iter().map(|point| *point - centre).collect()
}

/// Returns points around the middle of a figure that looks towards -Y: to turn round is no posture either.
fn posture(actor: &Actor<'_>, pose: &[Vec3]) -> Vec<Vec3> {
    let left = leftward(&actor.lines, &actor.sides, pose);
    let turn = left.map_or(Quat::IDENTITY, |left| Quat::from_rotation_z(-left.y.atan2(left.x)));
    around_middle(pose).into_iter().map(|point| turn * point).collect()
}

fn mean_posture<'a>(postures: impl Iterator<Item = &'a Vec<Vec3>>, count: usize) -> Vec<Vec3> {
    let mut sums = vec![(Vec3::ZERO, 0.0); count];
    for posture in postures {
        for ((sum, seen), point) in sums.iter_mut().zip(posture).filter(|(_, point)| !point.is_nan()) {
            *sum += *point;
            *seen += 1.0;
        }
    }
    sums.into_iter().map(|(sum, seen)| sum / seen).collect()
}

/// Returns how far two poses are apart: the mean over points that are seen in both.
fn distance(a: &[Vec3], b: &[Vec3]) -> f32 {
    let apart = a.iter().zip(b).map(|(a, b)| a.distance(*b)).filter(|apart| !apart.is_nan());
    let (sum, count) = apart.fold((0.0, 0.0), |(sum, count), apart| (sum + apart, count + 1.0));
    if count > 0.0 {
        sum / count
    } else {
        0.0
    }
}
