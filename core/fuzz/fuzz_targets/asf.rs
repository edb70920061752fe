//! Any bytes as an Acclaim skeleton: what is read can be written, read again and used.
#![no_main]

use libfuzzer_sys::fuzz_target;
use motion_theater_core::formats::asf::Asf;

fuzz_target!(|source: &[u8]| {
    let Ok(asf) = Asf::parse(source) else { return };
    let text = asf.to_bytes();
    let again = Asf::parse(&text).expect("what was written can be read");
    assert_eq!(again, asf);
    assert_eq!(again.to_bytes(), text);

    let skeleton = asf.skeleton();
    assert_eq!(skeleton.bones.len(), asf.bones.len() + 1);
    assert!(skeleton.bones.iter().enumerate().all(|(index, bone)| bone.parent.is_none_or(|parent| parent < index)));
    assert!(skeleton.bones.iter().all(|bone| bone.axes.is_normalized()));
    assert!(skeleton.rest_heads().iter().all(|head| head.is_finite()));
    assert!(skeleton.unit.metres > 0.0 && skeleton.unit.metres.is_finite());
    asf.notices();

    let built = Asf::from_skeleton(&skeleton);
    if let Ok(reread) = Asf::parse(&built.to_bytes()) {
        assert_eq!(reread, built);
    }
});
