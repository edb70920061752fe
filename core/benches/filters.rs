//! Speed of the filters in million values per second: medians of several runs, per kind, depth and size.
//!
//! `cargo bench -p motion-theater-core --bench filters`; compare with scipy by `tests/bench/filters_vs_scipy.py`.

use std::hint::black_box;
use std::time::Instant;

use glam::DQuat;
use motion_theater_core::filter::{filter_channels, filter_rotations, Depth, FilterKind};

const KINDS: [FilterKind; 3] = [FilterKind::Median, FilterKind::Average, FilterKind::Weighted];
const DEPTHS: [usize; 5] = [3, 5, 7, 31, 101];

/// Channels and frames: the size the original was measured with, a day in the studio, and one endless channel.
const SHAPES: [(usize, usize); 4] = [(90, 267), (1, 24_000), (3000, 9000), (1, 27_000_000)];

/// Bones and frames of a long take.
const ROTATIONS: (usize, usize) = (30, 5000);

fn main() {
    println!("{:<12} {:>16} {:>6} {:>14}", "filter", "channels x frames", "depth", "Mvalues/s");
    for (channels, frames) in SHAPES {
        let values: Vec<f64> = (0..channels * frames).map(wobble).collect();
        for kind in KINDS {
            for depth in DEPTHS.map(depth_of) {
                let seconds = median_seconds(values.len(), || {
                    let mut out = vec![0.0; values.len()];
                    filter_channels(black_box(&values), frames, &mut out, kind, depth);
                    black_box(out);
                });
                report(&format!("{kind:?}"), (channels, frames), depth, seconds);
            }
        }
    }
    let (bones, frames) = ROTATIONS;
    let motion: Vec<_> = (0..frames).map(|frame| DQuat::from_rotation_x(wobble(frame))).collect();
    for kind in KINDS {
        for depth in [3, 5, 7, 31].map(depth_of) {
            let seconds = median_seconds(bones * frames, || {
                for _ in 0..bones {
                    let mut out = vec![DQuat::IDENTITY; frames];
                    filter_rotations(black_box(&motion), &mut out, kind, depth);
                    black_box(out);
                }
            });
            report(&format!("{kind:?} (q)"), ROTATIONS, depth, seconds);
        }
    }
}

fn depth_of(depth: usize) -> Depth {
    Depth::try_from(depth).expect("the depths of the bench are odd")
}

/// A swing with a tremble, in no order a median could profit from.
fn wobble(frame: usize) -> f64 {
    let time = frame as f64;
    (time * 0.01).sin() + 0.1 * ((time * time) * 0.618_034).fract()
}

/// Returns the median duration of at least seven runs, more of short ones.
fn median_seconds(values: usize, mut run: impl FnMut()) -> f64 {
    run();
    let runs = (5_000_000 / values).clamp(7, 201) | 1;
    let mut seconds: Vec<f64> = (0..runs)
        .map(|_| {
            let start = Instant::now();
            run();
            start.elapsed().as_secs_f64()
        })
        .collect();
    seconds.sort_by(f64::total_cmp);
    seconds[runs / 2]
}

fn report(kind: &str, (channels, frames): (usize, usize), depth: Depth, seconds: f64) {
    let rate = (channels * frames) as f64 / seconds / 1e6;
    println!("{kind:<12} {channels:>6} x {frames:>9} {:>6} {rate:>14.1}", depth.get());
}
