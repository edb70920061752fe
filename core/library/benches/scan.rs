//! How long scanning a folder into a new library takes, against reading and hashing the same bytes.
//!
//! ```text
//! cargo bench -p motion-theater-library --bench scan -- FOLDER [THREADS [RUNS]]
//! ```
//! Both walk over the folder, and have as many threads. They take turns, so that other load meets both alike. Beside the
//! median of the time that passed stands the mean of what the processor was busy for both, in user code and in the system:
//! other programs change that less. Only Linux tells it.

use std::fs::File;
use std::io::Read;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::Arc;
use std::time::Instant;

use motion_theater_library::scan::{Options, Scan};
use motion_theater_library::Library;

fn main() {
    let mut arguments = std::env::args().skip(1).filter(|argument| argument != "--bench");
    let Some(folder) = arguments.next().map(PathBuf::from) else {
        println!("which folder?");
        return;
    };
    let mut number = |usual: usize| arguments.next().and_then(|text| text.parse().ok()).unwrap_or(usual);
    let (threads, runs) = (number(2), number(5));
    let mut times = [Vec::new(), Vec::new()];
    for _ in 0..=runs {
        times[0].push(measured(|| plain(&folder, threads)));
        times[1].push(measured(|| scan(&folder, threads)));
    }
    for (name, times) in ["plain", "scan"].into_iter().zip(&mut times) {
        // The first brings the files into memory.
        times.remove(0);
        times.sort_by(|a, b| a.passed_ms.total_cmp(&b.passed_ms));
        let busy_ms = times.iter().map(|time| time.busy_ms).sum::<f64>() / times.len() as f64;
        println!("{name:6} {:8.1} ms {busy_ms:8.1} ms busy", times[times.len() / 2].passed_ms);
    }
}

/// How long something took.
struct Time {
    passed_ms: f64,
    busy_ms: f64,
}

fn measured(task: impl FnOnce()) -> Time {
    let (start, busy_before) = (Instant::now(), busy_ms());
    task();
    Time { passed_ms: start.elapsed().as_secs_f64() * 1e3, busy_ms: busy_ms() - busy_before }
}

/// Returns how long the processor was busy for this process, in steps of 10 ms; 0 where the system does not tell.
fn busy_ms() -> f64 {
    const TICK_MS: f64 = 10.0;
    let told = std::fs::read_to_string("/proc/self/stat").unwrap_or_default();
    // The fields after the program's name, which stands in brackets and may hold anything: the 12th and the 13th.
    let fields = told.rsplit(')').next().unwrap_or_default().split_whitespace();
    fields.skip(11).take(2).filter_map(|ticks| ticks.parse::<f64>().ok()).sum::<f64>() * TICK_MS
}

/// Reads every file once and hashes it.
fn plain(folder: &Path, threads: usize) {
    let files: Vec<PathBuf> = walkdir::WalkDir::new(folder)
        .into_iter()
        .filter_map(Result::ok)
        .filter(|entry| entry.file_type().is_file())
        .map(walkdir::DirEntry::into_path)
        .collect();
    let next = AtomicUsize::new(0);
    let work = || {
        let mut buffer = Vec::new();
        while let Some(path) = files.get(next.fetch_add(1, Ordering::Relaxed)) {
            buffer.clear();
            if File::open(path).and_then(|mut file| file.read_to_end(&mut buffer)).is_ok() {
                std::hint::black_box(blake3::hash(&buffer));
            }
        }
    };
    std::thread::scope(|scope| {
        for _ in 0..threads {
            scope.spawn(work);
        }
    });
}

/// Scans into a library that is new.
fn scan(folder: &Path, threads: usize) {
    let place = tempfile::tempdir().expect("room for a library");
    let library = Arc::new(Library::open(&place.path().join("library.sqlite")).expect("a new library"));
    library.add_folder(folder).expect("the folder");
    let options = Options { folders: None, previews: None, jobs: Some(threads) };
    let scan = Scan::start(&library, &options).expect("a scan");
    scan.wait(None);
    assert_eq!(scan.progress().error, None);
}
