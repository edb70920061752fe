//! Any bytes as a C3D: what is read can be written in every encoding, read again and put to use.
#![no_main]

use libfuzzer_sys::fuzz_target;
use motion_theater_core::formats::c3d::{C3d, Encoding, Processor, Storage};
use motion_theater_core::gaps;

fuzz_target!(|source: &[u8]| {
    let Ok(c3d) = C3d::parse(source.to_vec()) else { return };
    assert_eq!(c3d.to_bytes(), source);
    let (markers, _) = c3d.markers();
    let samples = markers.count() * markers.frame_count();
    assert_eq!(markers.positions.valid().len(), samples);
    assert_eq!(markers.positions.to_f32().map(|numbers| numbers.len()), Some(3 * samples));
    assert_eq!(markers.quality.residuals().len(), samples);
    for channel in 0..markers.analog.channels.len().min(4) {
        assert_eq!(markers.analog.samples(channel).len(), markers.analog.sample_count());
    }
    if markers.count() < 50 {
        gaps::neighbours(&markers.positions, &markers.kinds);
    }
    for processor in [Processor::Intel, Processor::Dec, Processor::Mips] {
        for storage in [Storage::Integer, Storage::Float] {
            let encoding = Encoding { processor, storage };
            if let Ok(bytes) = c3d.encoded(encoding) {
                C3d::parse(bytes).expect("what was written can be read");
            }
        }
    }
    let encoding = Encoding { processor: Processor::Intel, storage: Storage::Float };
    if let Ok(bytes) = C3d::compose(&markers, encoding) {
        let (again, _) = C3d::parse(bytes).expect("what was written can be read").markers();
        assert!(samples == 0 || again.positions == markers.positions);
    }
});
