//! The public marker files, where they are at hand: `../shared/data` beside the project.

use motion_theater_core::formats::c3d::{C3d, Encoding, Processor, Storage};
use motion_theater_core::formats::{csm::Csm, trc::Trc};
use motion_theater_core::read::{read_path, Clip};
use std::path::{Path, PathBuf};

const PROCESSORS: [Processor; 3] = [Processor::Intel, Processor::Dec, Processor::Mips];

fn files(folder: &str, extension: &str) -> Vec<PathBuf> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../shared/data").join(folder);
    let mut found = Vec::new();
    let mut folders = vec![root];
    while let Some(folder) = folders.pop() {
        let Ok(entries) = std::fs::read_dir(folder) else { continue };
        for path in entries.flatten().map(|entry| entry.path()) {
            let is_wanted = path.extension().is_some_and(|known| known.eq_ignore_ascii_case(extension));
            if path.is_dir() {
                folders.push(path);
            } else if is_wanted && path.metadata().is_ok_and(|data| data.len() > 0) {
                found.push(path);
            }
        }
    }
    found.sort();
    found
}

fn name(path: &Path) -> String {
    path.file_name().unwrap_or_default().to_string_lossy().into_owned()
}

fn read(path: &Path) -> Clip {
    read_path(path, None).unwrap_or_else(|error| panic!("{error}"))
}

/// Whether the bytes are a floating-point number that a VAX cannot express: -0, one too small or too large.
fn is_no_vax(bytes: [u8; 4], encoding: Encoding) -> bool {
    let value = match encoding.processor {
        Processor::Intel => f32::from_le_bytes(bytes),
        Processor::Mips => f32::from_be_bytes(bytes),
        Processor::Dec => return false,
    };
    let range = 2.0_f64.powi(-128)..2.0_f64.powi(127);
    encoding.storage == Storage::Float && !range.contains(&f64::from(value).abs())
}

/// The bits of everything that the frames of a file hold, as numbers mean it.
fn values(c3d: &C3d) -> (Vec<Option<[u32; 3]>>, Vec<Vec<u64>>) {
    let (markers, _) = c3d.markers();
    let positions = markers.positions.to_f32().unwrap();
    let positions =
        positions.as_chunks::<3>().0.iter().map(|at| at[0].is_finite().then_some(at.map(|x| (x + 0.0).to_bits())));
    let channels = 0..markers.analog.channels.len();
    let analog = channels.map(|channel| markers.analog.samples(channel).iter().map(|x| (x + 0.0).to_bits()).collect());
    (positions.collect(), analog.collect())
}

/// Group, name, lock, dimensions, numbers, texts and description.
type Parameter = (u8, Vec<u8>, bool, Vec<u8>, Vec<f64>, Vec<String>, Vec<u8>);

fn parameters(c3d: &C3d) -> Vec<Parameter> {
    let is_changed = |name: &[u8]| matches!(name, b"SCALE" | b"DATA_START");
    let kept = c3d.parameters().filter(|parameter| !is_changed(parameter.name));
    let owned = kept.map(|p| {
        let numbers = p.numbers().into_iter().map(|x| if x.is_nan() { 0.0 } else { x + 0.0 }).collect();
        (p.group, p.name.to_vec(), p.is_locked, p.dimensions.to_vec(), numbers, p.texts(), p.description.to_vec())
    });
    owned.collect()
}

#[test]
fn a_c3d_in_its_own_encoding_is_the_file_and_written_anew_its_data_are() {
    for path in files("c3d", "c3d") {
        let c3d = read(&path).c3d.unwrap();
        assert_eq!(c3d.to_bytes(), std::fs::read(&path).unwrap(), "{}", name(&path));
        assert_eq!(c3d.encoded(c3d.encoding()).unwrap(), c3d.to_bytes(), "{}", name(&path));
    }
}

#[test]
fn a_c3d_for_another_processor_and_back_has_the_same_data_to_the_byte_and_every_parameter() {
    for path in files("c3d", "c3d") {
        let c3d = read(&path).c3d.unwrap();
        for processor in PROCESSORS {
            let other = C3d::parse(c3d.encoded(Encoding { processor, ..c3d.encoding() }).unwrap()).unwrap();
            assert_eq!(other.encoding().processor, processor);
            let what = format!("{} {processor:?}", name(&path));
            assert_eq!(values(&other), values(&c3d), "{what}");
            assert_eq!(parameters(&other), parameters(&c3d), "{what}");
            assert_eq!(other.groups().count(), c3d.groups().count(), "{what}");
            assert_eq!(other.events(), c3d.events(), "{what}");
            let back = C3d::parse(other.encoded(c3d.encoding()).unwrap()).unwrap();
            let same = |(own, other): (&[u8; 4], &[u8; 4])| own == other || is_no_vax(*own, c3d.encoding());
            let (own, others) = (c3d.data().as_chunks::<4>().0, back.data().as_chunks::<4>().0);
            assert!(own.len() == others.len() && own.iter().zip(others).all(same), "{what}");
        }
    }
}

#[test]
fn a_c3d_of_integers_means_the_same_as_floating_point() {
    for path in files("c3d", "c3d") {
        let c3d = read(&path).c3d.unwrap();
        for processor in PROCESSORS {
            let float = Encoding { processor, storage: Storage::Float };
            let other = C3d::parse(c3d.encoded(float).unwrap()).unwrap();
            assert_eq!(values(&other), values(&c3d), "{} {processor:?}", name(&path));
            assert_eq!(parameters(&other), parameters(&c3d), "{} {processor:?}", name(&path));
        }
    }
}

#[test]
fn a_c3d_of_floating_point_is_within_half_a_step_as_integers() {
    for path in files("c3d", "c3d") {
        let c3d = read(&path).c3d.unwrap();
        let integer = Encoding { processor: Processor::Intel, storage: Storage::Integer };
        let Ok(bytes) = c3d.encoded(integer) else {
            assert!(c3d.parameter("ANALOG", "SCALE").is_none(), "{}", name(&path));
            continue;
        };
        let other = C3d::parse(bytes).unwrap();
        let ((own, _), (others, _)) = (c3d.markers(), other.markers());
        let half = f64::from(other.layout().scale) * 0.501;
        for marker in 0..own.count() {
            for (a, b) in own.positions.trajectory(marker).iter().zip(others.positions.trajectory(marker)) {
                assert!(a.is_nan() == b.is_nan(), "{}", name(&path));
                assert!(a.is_nan() || (*a - b).abs().max_element() <= half, "{}: {a} {b}", name(&path));
            }
        }
        for channel in 0..own.analog.channels.len() {
            let (a, b) = (own.analog.samples(channel), others.analog.samples(channel));
            let largest = a.iter().fold(0.0_f64, |largest, x| largest.max(x.abs()));
            let worst = a.iter().zip(&b).fold(0.0_f64, |worst, (x, y)| worst.max((x - y).abs()));
            assert!(worst <= largest / 15_000.0, "{} channel {channel}: {worst} of {largest}", name(&path));
        }
    }
}

#[test]
fn what_is_read_all_at_once_is_what_each_sample_says() {
    for path in files("c3d", "c3d") {
        let positions = &read(&path).markers().unwrap().clone().positions;
        let numbers = positions.to_f32().unwrap();
        let mut together = numbers.as_chunks::<3>().0.iter().zip(positions.valid());
        let samples = together.len();
        for marker in 0..samples / positions.frame_count() {
            for at in (0..positions.frame_count()).map(|frame| positions.get(marker, frame)) {
                let (number, is_valid) = together.next().unwrap();
                assert_eq!(is_valid, at.is_some(), "{}", name(&path));
                assert_eq!(at.map(|at| at.as_vec3().to_array()), is_valid.then_some(*number), "{}", name(&path));
            }
        }
    }
}

#[test]
fn markers_of_every_c3d_composed_anew_are_the_same() {
    for path in files("c3d", "c3d") {
        let markers = read(&path).markers().unwrap().clone();
        for processor in PROCESSORS {
            let float = Encoding { processor, storage: Storage::Float };
            let clip = C3d::parse(C3d::compose(&markers, float).unwrap()).unwrap();
            let (again, _) = clip.markers();
            let what = format!("{} {processor:?}", name(&path));
            assert_eq!((&again.names, &again.kinds), (&markers.names, &markers.kinds), "{what}");
            assert_eq!(again.positions, markers.positions, "{what}");
            assert_eq!(again.quality.residuals(), markers.quality.residuals(), "{what}");
            assert_eq!(again.quality.cameras(), markers.quality.cameras(), "{what}");
            assert_eq!((again.first_frame, again.rate_hz), (markers.first_frame, markers.rate_hz), "{what}");
            assert_eq!(again.unit.metres, markers.unit.metres, "{what}");
            assert_eq!(again.up.axis, markers.up.axis, "{what}");
            assert_eq!(again.events, markers.events, "{what}");
            for channel in 0..markers.analog.channels.len() {
                assert_eq!(again.analog.channels[channel], markers.analog.channels[channel], "{what}");
                assert_eq!(again.analog.samples(channel), markers.analog.samples(channel), "{what}");
            }
        }
    }
}

#[test]
fn every_text_file_written_and_read_is_the_same() {
    for path in files("csm", "csm") {
        let csm = read(&path).csm.unwrap();
        assert_eq!(Csm::parse(&csm.to_bytes()).unwrap(), csm, "{}", name(&path));
    }
    for path in files("other/trc", "trc") {
        let trc = read(&path).trc.unwrap();
        assert_eq!(Trc::parse(&trc.to_bytes()).unwrap(), trc, "{}", name(&path));
    }
}

#[test]
fn every_file_is_read_and_its_oddities_are_said() {
    let folders = [("c3d", "c3d"), ("csm", "csm"), ("other/trc", "trc")];
    for path in folders.iter().flat_map(|(folder, extension)| files(folder, extension)) {
        let clip = read(&path);
        let markers = clip.markers().unwrap().clone();
        println!(
            "{}: {} markers, {} frames from {}, {:?} Hz, {} channels, {} events",
            name(&path),
            markers.count(),
            markers.frame_count(),
            markers.first_frame,
            markers.rate_hz,
            markers.analog.channels.len(),
            markers.events.len()
        );
        println!("    {}", clip.notices().join("\n    "));
        assert!(markers.frame_count() > 0, "{}", name(&path));
    }
}
