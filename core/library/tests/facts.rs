//! Looking over a file says the same as reading it.

use std::path::{Path, PathBuf};

use motion_theater_library::facts::{read, skim};
use proptest::prelude::*;

/// Files of our own, and the collection of real ones where it is at hand.
fn files() -> Vec<PathBuf> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let folders = [root.join("testdata"), root.join("../shared/data")];
    let entries = folders.iter().flat_map(walkdir::WalkDir::new).filter_map(Result::ok);
    let files = entries.filter(|entry| entry.file_type().is_file()).map(walkdir::DirEntry::into_path);
    let is_motion = |path: &PathBuf| {
        let extension = path.extension().and_then(|extension| extension.to_str());
        extension.is_some_and(|extension| motion_theater_core::read::Format::from_extension(extension).is_some())
    };
    files.filter(is_motion).collect()
}

/// Checks one file, and returns whether it was looked over.
fn is_skimmed(source: &[u8], path: &Path) -> bool {
    let Some((skimmed, _)) = skim(source, path) else { return false };
    let (facts, _) = read(source, path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    assert_eq!(skimmed, facts, "{}", path.display());
    true
}

/// A BVH, an AMC, a CSM (with a dropout) and a TRC of three frames.
const SMALL: [(&str, &str); 4] = [
    (
        "a.bvh",
        "HIERARCHY\nROOT a\n{\nOFFSET 0 0 0\nCHANNELS 3 Xposition Yposition Zrotation\n}\nMOTION\nFrames: 3\n\
         Frame Time: 0.02\n1.5 2 -3e-2\n4 5 6.25\n7 8 9\n",
    ),
    ("a.amc", ":DEGREES\n1\nroot 1 2.5 -3\nlfemur 1e-2\n2\nroot 4 5 6\nlfemur 7\n3\nroot 7 8 9\nlfemur 1.5\n"),
    (
        "a.csm",
        "$Actor Ada\n$FirstFrame 1\n$LastFrame 3\n$Rate 60\n$Order a b\n$Points\n1 1.5 2 3 4 5 6\n2 DROPOUT 1 2 3\n\
         3 1 2 3 4 5 6\n",
    ),
    (
        "a.trc",
        "PathFileType\t4\t(X/Y/Z)\ta.trc\nDataRate\tNumFrames\tNumMarkers\tUnits\n60\t3\t1\tmm\nFrame#\tTime\ta\n\
         \t\tX1\tY1\tZ1\n1\t0.0\t1.5\t2\t3\n2\t0.1\t4\t5\t6\n3\t0.2\t7\t8\t9\n",
    ),
];

#[test]
fn damage_is_left_to_the_reader() {
    for (name, text) in SMALL {
        assert!(is_skimmed(text.as_bytes(), Path::new(name)), "{name}");
        let damaged = [
            text.replacen("4 5", "4 x", 1).replacen("4\t5", "4\tx", 1),
            text.replacen("4 5", "4", 1).replacen("4\t5", "4", 1),
            text.replacen("8 9", "8 9 9", 1).replacen("8\t9", "8\t9\t9", 1),
            text.replacen("4 5 6", "4 5 nan", 1).replacen("5\t6", "5\tnan", 1),
            text.replacen("8 9", "8 \0", 1).replacen("8\t9", "8\t\0", 1),
            text.replacen("8 9", "8", 1).replacen("8\t9", "8", 1),
        ];
        let others = damaged.iter().filter(|damaged| *damaged != text);
        for damaged in others {
            assert!(skim(damaged.as_bytes(), Path::new(name)).is_none(), "{name}: {damaged:?}");
        }
    }
}

/// What a mistake may put into a file.
const LIKELY: &[u8] = b"0123456789.-+eE \n\r\t#$azN\0";

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]

    /// What both can read they agree on, whatever was done to a file.
    #[test]
    fn both_agree_on_files_with_mistakes(
        which in 0..SMALL.len(), places in prop::collection::vec((any::<prop::sample::Index>(), any::<u8>()), 0..3),
        cut in prop::option::of(any::<prop::sample::Index>()),
    ) {
        let (name, text) = SMALL[which];
        let mut source = text.as_bytes().to_vec();
        for (place, byte) in places {
            let at = place.index(source.len());
            source[at] = LIKELY[usize::from(byte) % LIKELY.len()];
        }
        if let Some(cut) = cut {
            source.truncate(cut.index(text.len()));
        }
        if let (Some((skimmed, _)), Ok((facts, _))) = (skim(&source, Path::new(name)), read(&source, Path::new(name))) {
            prop_assert_eq!(skimmed, facts, "{}", String::from_utf8_lossy(&source));
        }
    }
}

#[test]
fn looking_over_a_file_says_the_same_as_reading_it() {
    let files = files();
    let mut left_to_the_reader = Vec::new();
    for path in &files {
        let source = std::fs::read(path).expect("a file that is there");
        let text = ["amc", "bvh", "csm", "trc"].contains(&path.extension().unwrap().to_str().unwrap());
        if !is_skimmed(&source, path) && text {
            left_to_the_reader.push(path.file_name().unwrap().to_str().unwrap());
        }
    }
    println!("left to the reader: {left_to_the_reader:?}");
    assert!(files.iter().any(|path| path.ends_with("walk.amc")));
    assert!(!left_to_the_reader.contains(&"walk.amc"));
}
