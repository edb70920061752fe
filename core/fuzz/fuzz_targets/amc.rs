//! Any bytes as an Acclaim motion: what is read can be written, read again and put on a skeleton.
#![no_main]

use libfuzzer_sys::fuzz_target;
use motion_theater_core::formats::amc::Amc;
use motion_theater_core::formats::asf::{Asf, AsfBone};
use motion_theater_core::formats::AngleUnit;
use motion_theater_core::{Dof, Skeleton};

fuzz_target!(|source: &[u8]| {
    let Ok(amc) = Amc::parse(source) else { return };
    let text = amc.to_bytes();
    let again = Amc::parse(&text).expect("what was written can be read");
    assert_eq!(again, amc);
    assert_eq!(again.to_bytes(), text);
    assert_eq!(amc.values.len(), amc.frame_count * amc.width());

    let skeleton = fitting_skeleton(&amc);
    let Ok((motion, _)) = amc.motion(&skeleton) else { return };
    assert_eq!((motion.bones.len(), motion.frame_count), (skeleton.bones.len(), amc.frame_count));
    for channels in &motion.bones {
        assert!([0, amc.frame_count].contains(&channels.rotations.len()));
        assert!(channels.rotations.iter().all(|rotation| rotation.is_normalized()));
    }
    Amc::from_motion(&skeleton, &motion, AngleUnit::Degrees).to_bytes();
});

/// Returns a skeleton of the motion's bones with as many degrees of freedom as they have values, where that can be.
fn fitting_skeleton(amc: &Amc) -> Skeleton {
    let all = [4, 3, 5, 0, 2, 1, 6].map(|kind| match kind {
        0..3 => Dof::Translate(kind),
        3..6 => Dof::Rotate(kind - 3),
        _ => Dof::Length,
    });
    let bones = amc.bones.iter().map(|bone| AsfBone {
        name: bone.name.clone(),
        axis: [10.0, 20.0, 30.0],
        length: 1.0,
        dofs: all.into_iter().take(bone.width).collect(),
        ..AsfBone::default()
    });
    Asf { bones: bones.collect(), ..Asf::default() }.skeleton()
}
