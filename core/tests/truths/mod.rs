//! What is true of the real files, and copies of them: scaled, turned, at other rates. The tests ask whether what is
//! inferred is right where it is certain; `cargo run --example inference_table` prints all of it.

mod acclaim;
pub mod markers;
pub mod rates;
pub mod skeletons;

use glam::DVec3;
use motion_theater_core::infer::Answer;
use std::path::{Path, PathBuf};

/// What copies are scaled by.
pub const SCALES: [f64; 6] = [1.0, 0.01, 0.0254, 0.1, 10.0, 100.0];

/// How often answers were certain and right, unsure, and certain and wrong.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Counts {
    pub right: usize,
    pub unsure: usize,
    pub wrong: usize,
    /// The wrong ones, in words.
    pub faults: Vec<String>,
}

impl Counts {
    pub fn add<T>(&mut self, what: &str, answer: &Answer<T>, is_right: bool) {
        match (answer.is_certain, is_right) {
            (false, _) => self.unsure += 1,
            (true, true) => self.right += 1,
            (true, false) => {
                self.wrong += 1;
                self.faults.push(format!("{what}: {}", answer.reason));
            }
        }
    }

    /// Adds those of others.
    pub fn extend(&mut self, others: &Self) {
        self.right += others.right;
        self.unsure += others.unsure;
        self.wrong += others.wrong;
        self.faults.extend(others.faults.iter().cloned());
    }
}

/// What was inferred of one file and its copies.
#[derive(Debug, Default)]
pub struct Tally {
    pub file: &'static str,
    pub unit: Counts,
    pub up: Counts,
    pub facing: Counts,
    pub rate: Counts,
    /// How tall the figure came out on every copy, certain or not, of files that allow it to be known.
    pub heights_m: Vec<f64>,
}

/// Returns the sum of the counts of something.
pub fn sum(tallies: &[Tally], of: fn(&Tally) -> &Counts) -> Counts {
    let mut sum = Counts::default();
    for tally in tallies {
        sum.extend(of(tally));
    }
    sum
}

/// Between which heights a person comes out, in metres, from the lowest joint or marker to the highest.
pub const PERSON_M: std::ops::RangeInclusive<f64> = 1.0..=2.2;

impl Tally {
    /// Returns how often people came out as none.
    pub fn outside(&self) -> usize {
        self.heights_m.iter().filter(|height| !PERSON_M.contains(height)).count()
    }
}

/// Returns the folder with the public files, where it is at hand.
pub fn folder() -> Option<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../shared/data");
    folder.is_dir().then_some(folder)
}

fn answer(reason: &str, is_certain: bool) -> Answer<()> {
    Answer { value: (), reason: reason.to_owned(), is_certain }
}

fn is_near(value: f64, truth: Option<f64>) -> bool {
    truth.is_some_and(|truth| (value / truth - 1.0).abs() < 1e-3)
}

/// Returns the extent of what is seen along an axis.
fn extent(points: impl Iterator<Item = DVec3>, axis: DVec3) -> f64 {
    let seen = points.map(|point| point.dot(axis)).filter(|height| height.is_finite());
    let (low, high) = seen.fold((f64::MAX, f64::MIN), |(low, high), height| (low.min(height), high.max(height)));
    high - low
}

/// Returns the axes of a vector moved on, `turns` times X to Y, Y to Z, Z to X: a rotation.
fn turned(vector: DVec3, turns: usize) -> DVec3 {
    (0..turns).fold(vector, |v, _| DVec3::new(v.z, v.x, v.y))
}
