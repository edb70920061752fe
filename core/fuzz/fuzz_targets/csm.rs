//! Any bytes as a CSM: what is read can be written, read again and put to use.
#![no_main]

use libfuzzer_sys::fuzz_target;
use motion_theater_core::formats::c3d::{C3d, Encoding, Processor, Storage};
use motion_theater_core::formats::csm::Csm;
use motion_theater_core::gaps::{self, Fill};

fuzz_target!(|source: &[u8]| {
    let Ok(csm) = Csm::parse(source) else { return };
    let text = csm.to_bytes();
    let again = Csm::parse(&text).expect("what was written can be read");
    assert_eq!(again, csm);
    assert_eq!(again.to_bytes(), text);
    let (mut markers, _) = csm.markers();
    let count = markers.count();
    assert_eq!(csm.values.len(), 3 * count * markers.frame_count());
    let chosen: Vec<usize> = (0..count).collect();
    for how in [Fill::Rigid, Fill::Cubic, Fill::Linear] {
        gaps::fill(&mut markers.positions, count, &chosen, how, usize::MAX);
    }
    assert!(gaps::find(&markers.positions, count).is_empty());
    let encoding = Encoding { processor: Processor::Dec, storage: Storage::Integer };
    if let Ok(bytes) = C3d::compose(&markers, encoding) {
        C3d::parse(bytes).expect("what was written can be read");
    }
});
