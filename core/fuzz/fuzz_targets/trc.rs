//! Any bytes as a TRC: what is read can be written, read again and put to use.
#![no_main]

use libfuzzer_sys::fuzz_target;
use motion_theater_core::formats::csm::Csm;
use motion_theater_core::formats::trc::Trc;

fuzz_target!(|source: &[u8]| {
    let Ok(trc) = Trc::parse(source) else { return };
    let text = trc.to_bytes();
    let again = Trc::parse(&text).expect("what was written can be read");
    assert_eq!(again, trc);
    assert_eq!(again.to_bytes(), text);
    let (markers, _) = trc.markers();
    assert_eq!(trc.values.len(), 3 * markers.count() * markers.frame_count());
    Csm::parse(&Csm::of_markers(&markers).to_bytes()).expect("what was written can be read");
    Trc::parse(&Trc::of_markers(&markers, "new.trc").to_bytes()).expect("what was written can be read");
});
