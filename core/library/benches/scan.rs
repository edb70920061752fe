//! How long scanning a folder into a new library takes, against reading and hashing the same bytes.
//!
//! ```text
//! cargo bench -p motion-theater-library --bench scan -- FOLDER [THREADS [RUNS]]
//! ```
//! Both walk over the folder, and have as many threads. They take turns, so that other load meets both alike.

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
        times.sort_by(f64::total_cmp);
        println!("{name:6} {:8.1} ms", times[times.len() / 2]);
    }
}

fn measured(task: impl FnOnce()) -> f64 {
    let start = Instant::now();
    task();
    start.elapsed().as_secs_f64() * 1e3
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
