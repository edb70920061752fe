//! How fast C3D files are read, against reading and copying the same bytes.
//!
//! `cargo bench -p motion-theater-core --bench read_c3d -- FILE...`; without files, all of the public ones that are at
//! hand. For each file, by turns in one process: *copy*, the file read from disk and copied once; *read*, from the path to
//! a clip: parameters found, and where in the file each number lies; *named*, to markers with names, unit and up axis, and
//! analog channels; *all*, with positions, residuals, cameras and every analog channel in its unit, as arrays of their own.
//! The figures are medians, and the share of *copy* that *read* reaches.

use motion_theater_core::read::read_path;
use std::hint::black_box;
use std::path::{Path, PathBuf};
use std::time::Instant;

const TURNS: usize = 201;

fn main() {
    let named: Vec<PathBuf> = std::env::args().skip(1).filter(|word| !word.starts_with("--")).map(Into::into).collect();
    let files = if named.is_empty() { public_files() } else { named };
    println!(
        "{:>9}  {:>9}  {:>9}  {:>9}  {:>9}  {:>5}  file",
        "bytes", "copy µs", "read µs", "named µs", "all µs", "share"
    );
    let mut sums = [0.0; 4];
    for path in files {
        let Ok(bytes) = std::fs::read(&path) else { continue };
        if read_path(&path, None).is_err() {
            println!("not readable: {}", path.display());
            continue;
        }
        let medians = measure(&path);
        sums.iter_mut().zip(medians).for_each(|(sum, median)| *sum += median);
        print_row(&bytes.len().to_string(), medians, &path.file_name().unwrap_or_default().to_string_lossy());
    }
    print_row("", sums, "all files");
}

fn print_row(bytes: &str, [copy, read, named, all]: [f64; 4], name: &str) {
    println!("{bytes:>9}  {copy:9.1}  {read:9.1}  {named:9.1}  {all:9.1}  {:5.2}  {name}", copy / read);
}

/// Returns the median microseconds of copying, reading, reading with what belongs to markers, and with everything decoded.
fn measure(path: &Path) -> [f64; 4] {
    let copy = || {
        let bytes = std::fs::read(path).unwrap_or_default();
        black_box(bytes.clone());
        black_box(bytes);
    };
    let read = || drop(black_box(read_path(path, None)));
    let named = || read_path(path, None).ok().and_then(|clip| clip.markers().cloned());
    let all = || {
        let Some(markers) = named() else { return };
        black_box(markers.positions.to_f32());
        black_box(markers.quality.residuals());
        black_box(markers.quality.cameras());
        for channel in 0..markers.analog.channels.len() {
            black_box(markers.analog.samples(channel));
        }
    };
    let tasks: [&dyn Fn(); 4] = [&copy, &read, &|| drop(black_box(named())), &all];
    let mut times = [const { Vec::new() }; 4];
    for _ in 0..TURNS {
        for (task, times) in tasks.iter().zip(&mut times) {
            let start = Instant::now();
            task();
            times.push(start.elapsed().as_secs_f64() * 1e6);
        }
    }
    times.map(|mut times: Vec<f64>| {
        times.sort_by(f64::total_cmp);
        times[TURNS / 2]
    })
}

fn public_files() -> Vec<PathBuf> {
    let mut folders = vec![Path::new(env!("CARGO_MANIFEST_DIR")).join("../../shared/data/c3d")];
    let mut files = Vec::new();
    while let Some(folder) = folders.pop() {
        for entry in std::fs::read_dir(folder).into_iter().flatten().flatten() {
            let path = entry.path();
            if path.is_dir() {
                folders.push(path);
            } else {
                files.push(path);
            }
        }
    }
    files.sort();
    files
}
