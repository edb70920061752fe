//! Any bytes as a BVH: what is read can be written, read again, built, inferred and moved.
#![no_main]

use libfuzzer_sys::fuzz_target;
use motion_theater_core::formats::bvh::Bvh;
use motion_theater_core::pose::pose;

fuzz_target!(|source: &[u8]| {
    let Ok(bvh) = Bvh::parse(source) else { return };
    let text = bvh.to_bytes();
    let again = Bvh::parse(&text).expect("what was written can be read");
    assert_eq!((&again.joints, &again.motion), (&bvh.joints, &bvh.motion));
    assert_eq!(again.to_bytes(), text);
    bvh.notices();

    let (skeleton, motion) = bvh.skeleton_and_motion();
    assert_eq!(skeleton.bones.len(), bvh.joints.len());
    assert!(skeleton.bones.iter().enumerate().all(|(index, bone)| bone.parent.is_none_or(|parent| parent < index)));
    assert!(skeleton.unit.metres > 0.0 && skeleton.unit.metres.is_finite());
    let Some(motion) = motion else { return };
    assert_eq!(bvh.motion.map(|motion| motion.values.len()), Some(motion.frame_count * again.width()));
    for channels in &motion.bones {
        assert!([0, motion.frame_count].contains(&channels.rotations.len()));
        assert!(channels.rotations.iter().all(|rotation| rotation.is_normalized()));
    }
    assert!(pose(&skeleton, &motion, 1.0).heads.iter().all(|head| head.is_finite()));
    let built = Bvh::from_motion(&skeleton, &motion);
    assert_eq!(Bvh::parse(&built.to_bytes()).expect("what was built can be read"), built);
});
