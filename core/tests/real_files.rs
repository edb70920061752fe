//! The public data sets, where they are at hand: `../shared/data` beside the project.

use motion_theater_core::formats::{amc::Amc, asf::Asf};
use motion_theater_core::read::{read_path, Format};
use std::path::{Path, PathBuf};

/// A motion and its frames.
type MotionFile = (&'static str, usize);

/// Every skeleton with its bones and its motions.
const FILES: [(&str, usize, &[MotionFile]); 5] = [
    ("cmu01/01.asf", 30, &[("cmu01/01_01.amc", 2751)]),
    ("cmu02/02.asf", 30, &[("cmu02/02_03.amc", 173), ("cmu02/02_04.amc", 483)]),
    ("cmu09/09-run.asf", 30, &[("cmu09/09_06-run.amc", 141)]),
    (
        "cmu135/135-martialArts.asf",
        30,
        &[("cmu135/135_06-martialArts.amc", 3261), ("cmu135/135_06-martialArts-le-N40.amc", 3261)],
    ),
    ("endorphin/skeleton.asf", 33, &[("endorphin/walking.amc", 1741)]),
];

fn folder() -> Option<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../shared/data/asf_amc");
    folder.is_dir().then_some(folder)
}

#[test]
fn every_file_is_read_and_survives_writing() {
    let Some(folder) = folder() else { return };
    for (skeleton_file, bone_count, motions) in FILES {
        let clip = read_path(&folder.join(skeleton_file), None).unwrap();
        let (asf, skeleton) = (clip.asf.clone().unwrap(), clip.skeleton.clone().unwrap());
        assert_eq!((clip.format, asf.bones.len(), skeleton.bones.len()), (Format::Asf, bone_count, bone_count + 1));
        assert_eq!(Asf::parse(&asf.to_bytes()).unwrap(), asf, "{skeleton_file}");
        assert!(skeleton.unit.is_certain, "{}", skeleton.unit.reason);
        for (motion_file, frame_count) in motions {
            let clip = read_path(&folder.join(motion_file), Some(&skeleton)).unwrap();
            let (amc, motion) = (clip.amc.clone().unwrap(), clip.motion.clone().unwrap());
            assert_eq!((amc.frame_count, motion.frame_count, motion.first_frame), (*frame_count, *frame_count, 1));
            assert_eq!(amc.values.len(), frame_count * amc.width(), "{motion_file}");
            let again = Amc::parse(&amc.to_bytes()).unwrap();
            let bits = |amc: &Amc| amc.values.iter().map(|value| value.to_bits()).collect::<Vec<_>>();
            assert_eq!(bits(&again), bits(&amc), "{motion_file}");
            assert_eq!(again, amc, "{motion_file}");
            println!("{motion_file}: {:?}", clip.notices());
        }
        println!("{skeleton_file}: {:?}", clip.notices());
    }
}
