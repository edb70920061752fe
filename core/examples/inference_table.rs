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
    print("ASF, scaled and turned", &skeletons::acclaim_copies(&folder));
    print("Markers, scaled and turned, nothing stated", &markers::silent_copies(&folder));
    print("Markers of people, scaled and turned, the original's unit and axis stated", &markers::lying_copies(&folder));
    print("The same in CSM, where all is stated as millimetres and Z up", &markers::csm_copies(&folder));
    println!("\n{:54} {}", "Facing of markers, the files as they are", words(&markers::facing_as_read(&folder)));
    println!("{:54} {}", "Frame times of 4 to 9 decimals", words(&rates::rounded_frame_times()));
}

fn print(title: &str, tallies: &[Tally]) {
    println!(
        "\n{title}\n{:54} {:16} {:16} {:16} {:14} {:>12}",
        "right / unsure / wrong", "unit", "up", "facing", "rate", "height m"
    );
    for tally in tallies {
        let (low, high) =
            tally.heights_m.iter().fold((f64::MAX, f64::MIN), |(low, high), m| (low.min(*m), high.max(*m)));
        let heights = if low > high { String::new() } else { format!("{low:.2} to {high:.2}") };
        let [unit, up, facing, rate] = [&tally.unit, &tally.up, &tally.facing, &tally.rate].map(words);
        println!("{:54} {unit:16} {up:16} {facing:16} {rate:14} {heights:>12}", tally.file);
    }
    let counts =
        [sum(tallies, |t| &t.unit), sum(tallies, |t| &t.up), sum(tallies, |t| &t.facing), sum(tallies, |t| &t.rate)];
    let [unit, up, facing, rate] = counts.each_ref().map(words);
    let people: usize = tallies.iter().map(|tally| tally.heights_m.len()).sum();
    let outside: usize = tallies.iter().map(Tally::outside).sum();
    println!("{:54} {unit:16} {up:16} {facing:16} {rate:14} {outside} of {people} people not of 1 to 2.2 m", "all");
    for fault in counts.iter().flat_map(|counts| &counts.faults) {
        println!("WRONG {fault}");
    }
}

fn words(counts: &Counts) -> String {
    format!("{} / {} / {}", counts.right, counts.unsure, counts.wrong)
}
