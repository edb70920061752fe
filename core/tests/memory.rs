//! A small file never takes much memory, whatever it claims. In a process of its own, for the allocator counts.

use motion_theater_core::read::read_bytes;
use std::alloc::{GlobalAlloc, Layout, System};
use std::path::Path;
use std::sync::atomic::{AtomicUsize, Ordering};

/// Counts what is allocated at the same time.
struct Counting;

static NOW: AtomicUsize = AtomicUsize::new(0);
static MOST: AtomicUsize = AtomicUsize::new(0);

// SAFETY: all work is left to the system's allocator, with the same layouts; the counters touch no memory of others.
unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        let now = NOW.fetch_add(layout.size(), Ordering::Relaxed) + layout.size();
        MOST.fetch_max(now, Ordering::Relaxed);
        // SAFETY: the caller keeps the promises of `alloc`.
        unsafe { System.alloc(layout) }
    }

    unsafe fn dealloc(&self, pointer: *mut u8, layout: Layout) {
        NOW.fetch_sub(layout.size(), Ordering::Relaxed);
        // SAFETY: the caller keeps the promises of `dealloc`.
        unsafe { System.dealloc(pointer, layout) }
    }
}

#[global_allocator]
static ALLOCATOR: Counting = Counting;

const ALLOWED_BYTES: usize = 50_000_000;

/// Reads a file, and returns how many bytes were allocated at most at the same time.
fn peak_of_reading(source: &[u8], name: &str) -> usize {
    let before = NOW.load(Ordering::Relaxed);
    MOST.store(before, Ordering::Relaxed);
    drop(read_bytes(source, Path::new(name), None));
    MOST.load(Ordering::Relaxed) - before
}

/// A header, an empty parameter section and no data: 1 KB.
fn claims(words: [u16; 6], processor: u8) -> Vec<u8> {
    let mut bytes = vec![0; 1024];
    bytes[..2].copy_from_slice(&[2, 0x50]);
    // Points, analog values, first and last frame, data start, samples per frame.
    for (at, word) in [2, 4, 6, 8, 16, 18].into_iter().zip(words) {
        bytes[at..at + 2].copy_from_slice(&word.to_le_bytes());
    }
    bytes[512..516].copy_from_slice(&[1, 0x50, 1, processor]);
    bytes
}

/// Skeletons and motions that claim more than they hold.
fn skeletons() -> [(&'static str, String); 6] {
    let joint = |channels: &str| format!("ROOT a\n{{\nOFFSET 0 0 0\nCHANNELS {channels}\n");
    let head = "MOTION\nFrames: 4000000000\nFrame Time: 1e-9\n";
    let open = "JOINT b { OFFSET 1 1 1 ".repeat(40);
    let nested = format!("HIERARCHY\n{}{open}{}", joint("1 Xrotation"), "}".repeat(41));
    let bone = |i| format!("begin\nname b{i}\ndirection 1 0 0\nlength 1\ndof rx ry rz\nlimits (-inf inf)\nend\n");
    let bones: String = (0..10).map(bone).collect();
    let children: String = (0..10).map(|i| format!(" b{i}")).collect();
    [
        ("frames.bvh", format!("HIERARCHY\n{}}}\n{head}{}", joint("1 Xrotation"), "1\n".repeat(400))),
        ("channels.bvh", format!("HIERARCHY\n{}}}\n{head}1\n", joint("4000000000 Xrotation"))),
        ("nested.bvh", format!("{nested}\n{head}1 2 3")),
        ("bones.asf", format!(":units\nlength 1e-9\n:bonedata\n{bones}:hierarchy\nbegin\nroot{children}\nend\n")),
        ("numbers.amc", (0..90_u64).map(|i| format!("{}\nroot 1 2\n", i * 99_999_999)).collect()),
        ("width.amc", format!("1\nroot{}\n2\nroot 1\n", " 1".repeat(490))),
    ]
}

#[test]
fn a_file_of_a_kilobyte_takes_no_more_than_50_megabytes() {
    for most in [1, 255, 65_535] {
        for processor in [84, 85, 86] {
            for words in [
                [most, most, 0, most, 2, 1],
                [most, 0, 1, most, 3, most],
                [0, most, 1, 1, 3, 1],
                [1, most, 1, most, 2, most],
                [most, most, most, 0, 0, 0],
            ] {
                let peak = peak_of_reading(&claims(words, processor), "claims.c3d");
                assert!(peak <= ALLOWED_BYTES, "{peak} bytes for {words:?}");
            }
        }
    }
    let head = "PathFileType\t4\nDataRate\n60\nFrame#\tTime\n";
    let wide = format!("{head}1\t1{}\t1\t1\t1\n{}", "\t".repeat(300), "1\t1\n".repeat(150));
    let texts = [
        ("narrow.trc", format!("{head}{}", "1\t1\t1\t2\t3\n".repeat(100))),
        ("wide.trc", wide),
        ("names.csm", format!("$order {}\n$points", "a ".repeat(500))),
        ("dropouts.csm", format!("$order a\n$points\n{}", "1 DROPOUT\n".repeat(100))),
        ("frames.csm", "$firstframe 1\n$lastframe 999999999999\n$order a\n$points\n1 DROPOUT\n".to_owned()),
    ];
    for (name, text) in texts.into_iter().chain(skeletons()) {
        let peak = peak_of_reading(text.as_bytes(), name);
        assert!(peak <= ALLOWED_BYTES, "{peak} bytes for {name}");
    }
}
