use super::section::Section;
use super::*;
use crate::markers::{Analog, AnalogChannel, Event, Markers, PointKind, Positions, Quality, RawSamples, UpAxis};
use crate::skeleton::LengthUnit;
use glam::DVec3;
use proptest::prelude::*;

fn unsaid(names: Vec<String>, positions: Positions) -> Markers {
    let reason = String::new;
    Markers {
        kinds: vec![PointKind::Position; names.len()],
        names,
        positions,
        quality: Quality::default(),
        first_frame: 1,
        rate_hz: Some(100.0),
        unit: LengthUnit { metres: 0.001, reason: reason(), is_certain: true },
        up: UpAxis { axis: DVec3::Z, reason: reason(), is_certain: true },
        events: Vec::new(),
        analog: Analog::default(),
    }
}

fn numbered(count: usize) -> Vec<String> {
    (0..count).map(|number| format!("marker {number}")).collect()
}

fn encodings() -> impl Iterator<Item = Encoding> {
    let storages = [Storage::Integer, Storage::Float];
    let of = move |processor| storages.map(|storage| Encoding { processor, storage });
    [Processor::Intel, Processor::Dec, Processor::Mips].into_iter().flat_map(of)
}

/// A file with one point and one analog value in each of two frames, as the header says, and what the parameters say.
fn file(change: impl Fn(&mut Header), parameters: impl Fn(&mut Section), data_bytes: usize) -> C3d {
    let mut header = Header {
        point_count: 1,
        analog_per_frame: 1,
        first_frame: 1,
        last_frame: 2,
        scale: -1.0,
        data_block: 3,
        samples_per_frame: 1,
        rate_hz: 50.0,
        ..Header::default()
    };
    change(&mut header);
    let mut block = [0; BLOCK_BYTES];
    header.write(&mut block, Processor::Intel);
    [block[0], block[1]] = [2, KEY];
    let mut section = Section::new(Processor::Intel);
    parameters(&mut section);
    let mut bytes = block.to_vec();
    bytes.extend(section.finish());
    bytes.resize(bytes.len() + data_bytes, 0);
    C3d::parse(bytes).unwrap()
}

#[test]
fn the_size_of_the_file_decides_between_header_and_parameters() {
    // As the header says.
    let plain = file(|_| {}, |_| {}, 40);
    assert_eq!((plain.layout().frame_count, plain.layout().channel_count, plain.notices().len()), (2, 1, 0));
    // MotionMonitor: the header counts channels, not values.
    let analog = |section: &mut Section| {
        section.group("ANALOG");
        section.integer("USED", 16);
    };
    let wide = |header: &mut Header| {
        (header.analog_per_frame, header.samples_per_frame, header.last_frame) = (16, 7, 100);
    };
    let found = file(wide, analog, 100 * (4 + 112) * 4);
    assert_eq!((found.layout().channel_count, found.layout().samples_per_frame), (16, 7));
    assert_eq!(found.notices().len(), 1);
    // More frames than the header can count, as words, as floating point, and with a stated number that wraps.
    let many = |header: &mut Header| (header.analog_per_frame, header.last_frame) = (0, u16::MAX);
    let trial = |section: &mut Section| {
        section.group("TRIAL");
        section.integers("ACTUAL_START_FIELD", 1, &[1, 0]);
        section.integers("ACTUAL_END_FIELD", 1, &[70_000_u32 as u16, 1]);
    };
    let long = |section: &mut Section| {
        section.group("POINT");
        section.float("FRAMES", 70_000.0);
    };
    assert_eq!(file(many, trial, 70_000 * 16).layout().frame_count, 70_000);
    assert_eq!(file(many, long, 70_000 * 16).layout().frame_count, 70_000);
    let unsigned = |section: &mut Section| {
        section.group("POINT");
        section.integer("FRAMES", 40_000);
    };
    let short = |header: &mut Header| header.analog_per_frame = 0;
    assert_eq!(file(short, unsigned, 40_000 * 16).layout().frame_count, 40_000);
}

#[test]
fn what_is_missing_or_more_than_declared_is_said() {
    let cut = file(|header| header.last_frame = 100, |_| {}, 205);
    assert_eq!(cut.layout().frame_count, 10);
    assert_eq!(cut.notices(), ["The file declares 100 frames but ends after 10: what is there is used"]);
    let more = file(|_| {}, |_| {}, 1000);
    assert_eq!(more.notices(), ["960 bytes follow the last declared frame: they are kept and not used"]);
    assert_eq!((more.data().len(), more.to_bytes().len()), (40, 1024 + 1000));
}

#[test]
fn data_begin_where_the_parameters_say_if_the_header_cannot_be_right() {
    let point = |section: &mut Section| {
        section.group("POINT");
        section.integer("DATA_START", 3);
    };
    let without = |header: &mut Header| header.data_block = 0;
    assert_eq!(file(without, point, 40).layout().data_start, 1024);
    assert_eq!(file(without, |_| {}, 40).layout().data_start, 1024);
    assert_eq!(file(|header| header.data_block = 900, point, 40).layout().data_start, 1024);
}

#[test]
fn rates_are_the_numbers_that_were_meant() {
    for rate in [29.97, 59.94, 119.88, 23.976, 25.0, 1000.0] {
        let found = file(|header| header.rate_hz = rate as f32, |_| {}, 40);
        assert_eq!(found.layout().rate_hz, Some(rate));
    }
    assert_eq!(file(|header| header.rate_hz = 0.0, |_| {}, 40).layout().rate_hz, None);
    assert_eq!(file(|header| header.rate_hz = f32::NAN, |_| {}, 40).layout().rate_hz, None);
}

#[test]
fn many_markers_and_frames_and_channels_are_written_and_read() {
    let positions = (0..600 * 3).map(|number| number as f32).collect();
    let mut markers = unsaid(numbered(600), Positions::of_f32(positions, 1));
    let channel = |number: usize| AnalogChannel {
        name: format!("channel {number}"),
        offset: number as f64,
        scale: 0.5,
        ..AnalogChannel::default()
    };
    let raw = RawSamples::Values((0..600).map(|number| number as f32).collect());
    markers.analog =
        Analog { channels: (0..300).map(channel).collect(), samples_per_frame: 2, raw, ..Analog::default() };
    for encoding in encodings() {
        let c3d = C3d::parse(C3d::compose(&markers, encoding).unwrap()).unwrap();
        assert!(c3d.parameter("POINT", "LABELS3").is_some() && c3d.parameter("ANALOG", "SCALE2").is_some());
        let (again, notices) = c3d.markers();
        assert_eq!((&again.names, notices.len()), (&markers.names, 0));
        assert_eq!(again.analog.channels, markers.analog.channels);
        assert_eq!(again.analog.samples(299), [0.0, 150.0]);
    }
    let long = unsaid(numbered(1), Positions::of_f32(vec![1.0; 3 * 70_000], 70_000));
    let long = Markers { first_frame: 80_000, ..long };
    for encoding in encodings() {
        let (again, _) = C3d::parse(C3d::compose(&long, encoding).unwrap()).unwrap().markers();
        assert_eq!((again.first_frame, again.frame_count()), (80_000, 70_000));
    }
}

#[test]
fn what_the_format_cannot_count_is_refused_in_words() {
    let encoding = Encoding { processor: Processor::Intel, storage: Storage::Float };
    let markers = unsaid(numbered(70_000), Positions::of_f32(Vec::new(), 0));
    let error = C3d::compose(&markers, encoding).unwrap_err();
    assert_eq!(error.to_string(), "a C3D file cannot hold 70000 points");
}

fn event() -> impl Strategy<Value = Event> {
    ("[A-Za-z ]{0,9}[a-z]", "(Left|Right|)", "[a-z]{0,5}", 0.0..1e4_f32).prop_map(
        |(label, context, subject, time_s)| Event {
            label: label.trim_start().to_owned(),
            context,
            subject,
            time_s: time_s.into(),
        },
    )
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(200))]

    #[test]
    fn markers_written_in_any_encoding_read_back(
        samples in proptest::collection::vec(proptest::option::weighted(0.8, [-2e3..2e3_f32, -2e3..2e3, -2e3..2e3]), 1..60),
        marker_count in 1_usize..6,
        events in proptest::collection::vec(event(), 0..5),
        first_frame in 0_i64..100_000,
        raw in proptest::collection::vec(-1e4..1e4_f32, 60),
    ) {
        let frame_count = samples.len() / marker_count;
        prop_assume!(frame_count > 0);
        let samples = &samples[..frame_count * marker_count];
        let values: Vec<f32> = samples.iter().flat_map(|at| at.unwrap_or([f32::NAN; 3])).collect();
        let positions = Positions::of_f32(values, frame_count);
        let channel = AnalogChannel { name: "a".to_owned(), scale: 0.25, ..AnalogChannel::default() };
        let raw = RawSamples::Values(raw[..frame_count].to_vec());
        let analog = Analog { channels: vec![channel], raw, ..Analog::default() };
        let markers = Markers { first_frame, events, analog, ..unsaid(numbered(marker_count), positions) };
        for encoding in encodings() {
            let c3d = C3d::parse(C3d::compose(&markers, encoding).unwrap()).unwrap();
            prop_assert_eq!(c3d.encoding(), encoding);
            let (again, _) = c3d.markers();
            prop_assert_eq!((&again.names, again.first_frame), (&markers.names, first_frame));
            prop_assert_eq!(&again.events, &markers.events);
            let half = match encoding.storage {
                // What is too small for a VAX is 0 there.
                Storage::Float => 1e-30,
                Storage::Integer => f64::from(c3d.layout().scale) * 0.501,
            };
            for marker in 0..marker_count {
                for (a, b) in markers.positions.trajectory(marker).iter().zip(again.positions.trajectory(marker)) {
                    prop_assert!(a.is_nan() == b.is_nan() && (a.is_nan() || (*a - b).abs().max_element() <= half));
                }
            }
            let most = if encoding.storage == Storage::Float { 1e-30 } else { 0.05 };
            for (a, b) in markers.analog.samples(0).iter().zip(again.analog.samples(0)) {
                prop_assert!((a - b).abs() <= most);
            }
        }
    }
}
