//! How fast an AMC or a BVH is read, against the physical limit of reading its numbers alone.
//!
//! `cargo bench -p motion-theater-core --bench read -- FILE.amc FILE.asf`, or `-- FILE.bvh`; without files, the first of
//! the usual pairs that is there. Every figure is the median of runs that take turns in one process; the best run stands
//! beside it, for on a machine that is busy otherwise the median tells more about the rest of it.
//!
//! - *numbers*: the limit. The same numbers read with the same parser from a text that holds nothing else, into room that
//!   is there already.
//! - *amc*, *bvh*: the file's bytes, with names, frames and checks, into an [`Amc`] or [`Bvh`] made anew each time, on one
//!   thread.
//! - *threads*: the same on two.
//! - *motion*: from there to quaternions in the file's axes, on two.
//! - *disk*: from the path to what the file says, on two.

use motion_theater_core::formats::{amc::Amc, asf::Asf, bvh::Bvh};
use motion_theater_core::number::read_prefix;
use std::hint::black_box;
use std::path::{Path, PathBuf};
use std::time::Instant;

/// Odd, so that the median is one of them.
const RUNS: usize = 31;

const USUAL_FILES: [(&str, &str); 2] = [
    ("../shared/data/asf_amc/cmu01/01_01.amc", "../shared/data/asf_amc/cmu01/01.asf"),
    ("testdata/walk.amc", "testdata/human.asf"),
];

fn main() {
    let files: Vec<PathBuf> =
        std::env::args().skip(1).filter(|word| !word.starts_with("--")).map(PathBuf::from).collect();
    match choose(&files) {
        Some((file, _)) if file.extension().is_some_and(|extension| extension == "bvh") => measure_bvh(&file),
        Some((file, skeleton)) => measure_amc(&file, skeleton.as_deref()),
        None => {
            println!("Nothing to measure: name a BVH, or a motion (.amc) and, for its conversion, a skeleton (.asf)");
        }
    }
}

fn measure_amc(motion_file: &Path, skeleton_file: Option<&Path>) {
    let source = std::fs::read(motion_file).expect("the motion can be read");
    let amc = Amc::parse(&source).expect("the motion is an AMC");
    let skeleton = skeleton_file.map(|file| std::fs::read(file).expect("the skeleton can be read"));
    let skeleton = skeleton.map(|source| Asf::parse(&source).expect("the skeleton is an ASF").skeleton());
    let case = Case { name: "amc", file: motion_file, source: &source, values: &amc.values };
    let convert = || skeleton.as_ref().and_then(|skeleton| amc.motion(skeleton).ok());
    case.measure(&numbers_of_amc(&source), |source| Amc::parse(source).ok(), convert);
}

fn measure_bvh(file: &Path) {
    let source = std::fs::read(file).expect("the file can be read");
    let bvh = Bvh::parse(&source).expect("the file is a BVH");
    let values = &bvh.motion.as_ref().expect("the file has motion").values;
    let case = Case { name: "bvh", file, source: &source, values };
    case.measure(&numbers_of_bvh(&source, values.len()), |source| Bvh::parse(source).ok(), || bvh.motion());
}

/// A file that is measured.
struct Case<'a> {
    name: &'a str,
    file: &'a Path,
    source: &'a [u8],
    values: &'a [f64],
}

impl Case<'_> {
    /// Measures a reader and a conversion against reading `numbers`, the text of nothing but the values.
    fn measure<T, U>(&self, numbers: &[u8], parse: impl Fn(&[u8]) -> T + Sync, convert: impl Fn() -> U + Sync) {
        println!("{}: {} bytes, {} values", self.file.display(), self.source.len(), self.values.len());
        let pool = |threads| rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("threads can be made");
        let (one, two) = (pool(1), pool(2));
        let read = || drop(black_box(parse(black_box(self.source))));
        // By turns, so that whatever else the machine does meanwhile slows all of them down alike; and all of it on the
        // thread of one pool: work that is handed to another thread waits for it on a busy machine.
        let [limit, alone, together, motion, disk] = one.install(|| {
            let mut room = Vec::with_capacity(self.values.len());
            let times = measure([
                &mut || read_numbers(numbers, &mut room),
                &mut || read(),
                &mut || two.install(read),
                &mut || two.install(|| drop(black_box(convert()))),
                &mut || two.install(|| drop(black_box(std::fs::read(self.file).map(|source| parse(&source)).ok()))),
            ]);
            assert_eq!(room, self.values, "both read the same numbers");
            times
        });
        limit.print("numbers", numbers.len(), limit);
        alone.print(self.name, self.source.len(), limit);
        together.print("threads", self.source.len(), limit);
        disk.print("disk", self.source.len(), limit);
        println!("motion   {motion}");
        let (gain, best) = (alone.median_s / together.median_s, alone.best_s / together.best_s);
        println!("Two threads are {gain:.2} times as fast as one (best {best:.2})");
    }
}

/// Returns the files that were named, or the first usual pair that is there.
fn choose(files: &[PathBuf]) -> Option<(PathBuf, Option<PathBuf>)> {
    if let [motion, rest @ ..] = files {
        return Some((motion.clone(), rest.first().cloned()));
    }
    let project = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let usual = USUAL_FILES.map(|(motion, skeleton)| (project.join(motion), Some(project.join(skeleton))));
    usual.into_iter().find(|(motion, _)| motion.is_file())
}

/// Returns the values of all bones, with one blank between: no names, no frame numbers.
fn numbers_of_amc(source: &[u8]) -> Vec<u8> {
    let lines = source.split(|byte| *byte == b'\n').map(<[u8]>::trim_ascii);
    let values = lines
        .filter(|line| !line.starts_with(b"#") && !line.starts_with(b":"))
        .flat_map(|line| line.split(|byte| *byte == b' ').skip(1).filter(|word| !word.is_empty()));
    let mut numbers = values.collect::<Vec<_>>().join(&b' ');
    numbers.push(b'\n');
    numbers
}

/// Returns the last `count` words, with one blank between.
fn numbers_of_bvh(source: &[u8], count: usize) -> Vec<u8> {
    let words = source.split(u8::is_ascii_whitespace).filter(|word| !word.is_empty());
    let words: Vec<_> = words.collect();
    let mut numbers = words[words.len() - count..].join(&b' ');
    numbers.push(b'\n');
    numbers
}

fn read_numbers(mut text: &[u8], values: &mut Vec<f64>) {
    values.clear();
    while let Some((value, length)) = read_prefix(text) {
        values.push(value);
        text = text.get(length + 1..).unwrap_or_default();
    }
}

/// How long something took.
#[derive(Clone, Copy)]
struct Time {
    median_s: f64,
    best_s: f64,
}

impl Time {
    /// Prints it as a speed, and as a share of the limit.
    fn print(self, name: &str, bytes: usize, limit: Self) {
        let speed = bytes as f64 / self.median_s * 1e-6;
        let share = limit.median_s / self.median_s;
        let best_share = limit.best_s / self.best_s;
        println!("{name:8} {self}  {speed:5.0} MB/s  {share:.2} of the limit (best {best_share:.2})");
    }
}

impl std::fmt::Display for Time {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{:7.3} ms (best {:.3})", self.median_s * 1e3, self.best_s * 1e3)
    }
}

/// Runs each by turns.
fn measure<const N: usize>(mut runs: [&mut dyn FnMut(); N]) -> [Time; N] {
    let mut times = [[0.0; RUNS]; N];
    for round in 0..RUNS {
        for (run, times) in runs.iter_mut().zip(&mut times) {
            let start = Instant::now();
            run();
            times[round] = start.elapsed().as_secs_f64();
        }
    }
    times.map(|mut times| {
        times.sort_by(f64::total_cmp);
        Time { median_s: times[RUNS / 2], best_s: times[0] }
    })
}
