//! Prints what is inferred of every public file and its copies (see `tests/truths`): how often it was right, unsure, and
//! wrong though certain.
//!
//! `cargo run --package motion-theater-core --example inference_table`, with the public files in `../shared/data`.

#[path = "../tests/truths/mod.rs"]
mod truths;

use truths::{folder, markers, rates, skeletons, sum, Counts, Tally};

fn main() {
    let Some(folder) = folder() else {
        println!("The public files are not at hand");
        return;
    };
    print("BVH, scaled and turned", &skeletons::bvh_copies(&folder));
    print("ASF, scaled", &skeletons::acclaim_copies(&folder));
    print("Markers, scaled and turned, nothing stated", &markers::silent_copies(&folder));
    print("Markers of people, scaled and turned, the original's unit and axis stated", &markers::lying_copies(&folder));
    println!("\n{:54} {}", "Frame times of 4 to 9 decimals", words(&rates::rounded_frame_times()));
}

fn print(title: &str, tallies: &[Tally]) {
    println!("\n{title}\n{:54} {:16} {:16} {:16} {:>11}", "right / unsure / wrong", "unit", "up", "facing", "height m");
    for tally in tallies {
        let (low, high) =
            tally.heights_m.iter().fold((f64::MAX, f64::MIN), |(low, high), m| (low.min(*m), high.max(*m)));
        let heights = if low > high { String::new() } else { format!("{low:.2} to {high:.2}") };
        let [unit, up, facing] = [&tally.unit, &tally.up, &tally.facing].map(words);
        println!("{:54} {unit:16} {up:16} {facing:16} {heights:>11}", tally.file);
    }
    let counts = [sum(tallies, |t| &t.unit), sum(tallies, |t| &t.up), sum(tallies, |t| &t.facing)];
    let [unit, up, facing] = counts.each_ref().map(words);
    println!("{:54} {unit:16} {up:16} {facing:16}", "all");
    for fault in counts.iter().flat_map(|counts| &counts.faults) {
        println!("WRONG {fault}");
    }
}

fn words(counts: &Counts) -> String {
    format!("{} / {} / {}", counts.right, counts.unsure, counts.wrong)
}
