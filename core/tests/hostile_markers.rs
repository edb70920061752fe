//! Marker files that no reader should trust: each gives one message or a result that holds together, and none takes more
//! memory than its size allows.

use glam::DVec3;
use motion_theater_core::filter::{Depth, FilterKind};
use motion_theater_core::formats::c3d::{C3d, Encoding, Processor, Storage};
use motion_theater_core::formats::{csm::Csm, trc::Trc};
use motion_theater_core::gaps::{self, Fill};
use motion_theater_core::markers::PointKind;
use motion_theater_core::{Markers, ParseError, Position};
use std::path::Path;

const CSM: &str = "$FileName small.csm\r\n$COMMENTS\r\ntwo\r\nlines\r\n$firstframe 7\r\n$LastFrame\r\n9\r\n$rate 119.88\r\n\
    $Order\r\nHead #1\r\nC7\r\n$points\r\n7  1 2 3  4 5 6  7 8 9\r\n8  DROPOUT  -1e-3 .5 6.  dropout\r\n9  1 2 3  4 5 6  7 8 9";

const TRC: &str = "PathFileType\t4\t(X/Y/Z)\tsmall.trc\t\nDataRate\tCameraRate\tNumFrames\tNumMarkers\tUnits\n\
    59.94\t59.94\t3\t2\tmm\nFrame#\tTime\tHead #1\t\t\tC7\n\t\tX1\tY1\tZ1\tX2\tY2\tZ2\n\n1\t0\t1\t2\t3\t4\t5\t6\n\
    2\t0.017\t\t\t\t-1e-3\t.5\t6.\n3\t0.033\t1\t2\t3\tnan\tNaN\t";

/// Uses markers in every way there is.
fn use_fully(markers: &Markers) {
    let (count, frame_count) = (markers.count(), markers.frame_count());
    assert_eq!((markers.kinds.len(), markers.positions.valid().len()), (count, count * frame_count));
    assert!(markers.unit.metres > 0.0 && markers.unit.metres.is_finite());
    assert!(markers.rate_hz.is_none_or(|rate| rate > 0.0 && rate.is_finite()));
    assert!([0, count * frame_count].contains(&markers.quality.residuals().len()));
    for channel in 0..markers.analog.channels.len().min(8) {
        assert_eq!(markers.analog.samples(channel).len(), markers.analog.sample_count());
    }
    if count * frame_count > 1 << 16 {
        return;
    }
    for marker in 0..count {
        let is_place = |at: &DVec3| at.is_nan() || at.is_finite();
        assert!(markers.positions.trajectory(marker).iter().all(is_place));
    }
    let chosen: Vec<usize> = (0..count.min(8)).collect();
    for how in [Fill::Linear, Fill::Cubic, Fill::Rigid] {
        gaps::fill(&mut markers.positions.clone(), count, &chosen, how, 20);
    }
    if let Ok(depth) = Depth::try_from(3) {
        markers.clone().filter(&chosen, FilterKind::Median, depth);
    }
    if count < 100 {
        gaps::neighbours(&markers.positions, &markers.kinds);
    }
    for storage in [Storage::Integer, Storage::Float] {
        let composed = C3d::compose(markers, Encoding { processor: Processor::Mips, storage });
        let again = composed.map(|bytes| C3d::parse(bytes).expect("what was written can be read"));
        let shape = |c3d: &C3d| (c3d.layout().point_count, c3d.layout().frame_count);
        let is_empty = count + markers.analog.channels.len() == 0;
        assert!(again.is_err() || is_empty || shape(&again.unwrap()) == (count, frame_count));
    }
    assert!(Csm::parse(&Csm::of_markers(markers).to_bytes()).is_ok());
    assert!(Trc::parse(&Trc::of_markers(markers, "new.trc").to_bytes()).is_ok());
}

fn read_c3d(bytes: &[u8]) -> Result<C3d, ParseError> {
    let c3d = C3d::parse(bytes.to_vec())?;
    use_fully(&c3d.markers().0);
    for processor in [Processor::Intel, Processor::Dec, Processor::Mips] {
        for storage in [Storage::Integer, Storage::Float] {
            let encoded = c3d.encoded(Encoding { processor, storage });
            assert!(encoded.is_err() || C3d::parse(encoded.unwrap_or_default()).is_ok());
        }
    }
    Ok(c3d)
}

fn read_csm(text: &str) -> Result<Csm, ParseError> {
    let csm = Csm::parse(text.as_bytes())?;
    assert_eq!(Csm::parse(&csm.to_bytes()).as_ref(), Ok(&csm));
    assert_eq!(csm.values.len(), 3 * csm.order.len() * csm.frame_numbers.len());
    use_fully(&csm.markers().0);
    Ok(csm)
}

fn read_trc(text: &str) -> Result<Trc, ParseError> {
    let trc = Trc::parse(text.as_bytes())?;
    assert_eq!(Trc::parse(&trc.to_bytes()).as_ref(), Ok(&trc));
    assert_eq!(trc.values.len(), 3 * trc.names.len() * trc.frame_numbers.len());
    use_fully(&trc.markers().0);
    Ok(trc)
}

/// Three markers over five frames with a gap, in 1536 bytes and more.
fn small_c3d(storage: Storage) -> Vec<u8> {
    let rows =
        "1 1 2 3 4 5 6 7 8 9\n2 1 2 3 DROPOUT 7 8 9\n3 1 2 3 4 5 6 7 8 9\n4 1 2 3 4 5 6 7 8 9\n5 1 2 3 4 5 6 7 8 9";
    let (markers, _) = Csm::parse(format!("$rate 100\n$order a b c\n$points\n{rows}").as_bytes()).unwrap().markers();
    C3d::compose(&markers, Encoding { processor: Processor::Intel, storage }).unwrap()
}

#[test]
fn a_c3d_cut_at_any_byte_is_refused_with_the_place_or_read_as_far_as_it_goes() {
    for storage in [Storage::Integer, Storage::Float] {
        let whole = small_c3d(storage);
        let data_start = C3d::parse(whole.clone()).unwrap().layout().data_start;
        for length in 0..whole.len() {
            match read_c3d(&whole[..length]) {
                Ok(c3d) => {
                    let room = length.saturating_sub(data_start) / c3d.layout().frame_bytes();
                    assert_eq!(c3d.layout().frame_count, room.min(5), "cut at {length}");
                    assert_eq!(c3d.notices().iter().any(|notice| notice.contains("ends after")), room < 5);
                }
                Err(error) => {
                    let Position::Byte(at) = error.position else { panic!("{error}") };
                    assert!(at <= length.max(1) && length < data_start, "{error} in a file of {length} bytes");
                }
            }
        }
    }
}

#[test]
fn a_c3d_with_any_byte_changed_is_refused_or_holds_together() {
    let whole = small_c3d(Storage::Integer);
    for at in 0..whole.len() {
        for value in [0, 1, 0x50, 0x7F, 0x80, 0xFF] {
            let mut changed = whole.clone();
            changed[at] = value;
            let _ = read_c3d(&changed).map(|c3d| assert!(c3d.layout().point_bytes() <= 8 * 65_535 * 2));
        }
    }
}

#[test]
fn what_is_no_c3d_is_refused_in_words() {
    let whole = small_c3d(Storage::Float);
    let changed = |at: usize, value: u8| {
        let mut bytes = whole.clone();
        bytes[at] = value;
        bytes
    };
    let table: [(Vec<u8>, &str); 7] = [
        (vec![], "byte 0x0: expected a C3D marker file (.c3d), found an empty file"),
        (
            vec![2],
            "byte 0x1: expected a C3D marker file (.c3d), with 0x50 in its second byte, found the end of the file",
        ),
        (b"\x89PNG\r\n\x1a\n\0\0\0\rIHDR".to_vec(), "byte 0x0: expected a C3D marker file (.c3d), found binary data"),
        (
            b"HIERARCHY ROOT".to_vec(),
            "byte 0x1: expected a C3D marker file (.c3d), with 0x50 in its second byte, found a BVH motion (.bvh)",
        ),
        (vec![2, 0x50], "byte 0x2: expected a header of 512 bytes, found the end of the file"),
        (changed(515, 83), "byte 0x203: expected a processor type: 84 (Intel), 85 (DEC) or 86 (MIPS), found 83"),
        (changed(0, 20), "byte 0x600: expected the head of the parameter section, found the end of the file"),
    ];
    for (bytes, message) in table {
        assert_eq!(C3d::parse(bytes).unwrap_err().to_string(), message);
    }
}

#[test]
fn a_csm_or_trc_cut_at_any_byte_is_refused_or_keeps_its_whole_frames() {
    for length in 0..=CSM.len() {
        let frame_count = read_csm(&CSM[..length]).map_or(0, |csm| csm.frame_numbers.len());
        assert!(frame_count <= 3 && (length < CSM.len() || frame_count == 3));
    }
    for length in 0..=TRC.len() {
        let frame_count = read_trc(&TRC[..length]).map_or(0, |trc| trc.frame_numbers.len());
        assert!(frame_count <= 3 && (length < TRC.len() || frame_count == 3));
    }
}

#[test]
fn a_place_without_all_three_coordinates_is_a_gap_and_is_said() {
    let trc = read_trc(&TRC.replace("-1e-3\t.5\t6.", "-1e-3\tnan\t6.")).unwrap();
    let (markers, notices) = trc.markers();
    assert_eq!(markers.positions.valid(), [true, false, true, true, false, false]);
    assert!(notices.contains(&"Places without all three coordinates are taken as gaps: 1".to_owned()), "{notices:?}");
}

#[test]
fn files_that_the_fuzzer_starts_from_are_read_and_used() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("fuzz/corpus");
    let mut count = 0;
    for extension in ["c3d", "csm", "trc"] {
        for entry in std::fs::read_dir(folder.join(extension)).unwrap() {
            let path = entry.unwrap().path();
            // What the fuzzer adds has no extension.
            if path.extension().is_none() {
                continue;
            }
            let source = std::fs::read(&path).unwrap();
            let text = String::from_utf8_lossy(&source);
            let result = match extension {
                "c3d" => read_c3d(&source).map(drop),
                "csm" => read_csm(&text).map(drop),
                _ => read_trc(&text).map(drop),
            };
            assert!(result.is_ok(), "{}: {result:?}", path.display());
            count += 1;
        }
    }
    assert!(count >= 12, "{count}");
}

#[test]
fn a_c3d_of_every_encoding_says_the_same() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("fuzz/corpus/c3d");
    for name in ["intel_integer", "intel_float", "dec_integer", "dec_float", "mips_integer", "mips_float"] {
        let c3d = C3d::parse(std::fs::read(folder.join(name).with_extension("c3d")).unwrap()).unwrap();
        let (markers, _) = c3d.markers();
        assert_eq!((markers.names.as_slice(), markers.first_frame), (["HEAD", "C7"].map(str::to_owned).as_slice(), 7));
        assert_eq!((markers.frame_count(), markers.rate_hz), (3, Some(59.94)), "{name}");
        assert_eq!(markers.kinds, [PointKind::Position, PointKind::Angle]);
        let places = [markers.positions.get(0, 0), markers.positions.get(0, 1), markers.positions.get(1, 2)];
        assert_eq!(places, [Some(DVec3::new(0.0, 10.0, 0.0)), None, Some(DVec3::new(10.5, 10.0, 15.0))], "{name}");
        assert_eq!((markers.quality.residuals()[0], markers.quality.cameras()[0]), (2.5, 3), "{name}");
        assert_eq!(markers.analog.samples(0), [0.0, 0.5, 0.25, 0.75, 0.5, 1.0], "{name}");
        assert_eq!(markers.analog.samples(1)[0], -50.5, "{name}");
        let event = (markers.events[0].label.as_str(), markers.events[0].time_s as f32);
        assert_eq!((event, markers.events.len()), (("STEP", 0.1), 1), "{name}");
        assert_eq!(c3d.header().events[0].label, "HIT", "{name}");
    }
}

#[test]
fn odd_but_right_text_files_are_read() {
    let csm = read_csm(CSM).unwrap();
    assert_eq!((csm.first_frame, csm.last_frame, csm.rate_hz), (Some(7), Some(9), Some(119.88)));
    assert_eq!(csm.order, ["Head", "#1", "C7"]);
    let texts = [("FileName", "small.csm"), ("COMMENTS", "two\nlines")];
    assert_eq!(csm.texts, texts.map(|(name, value)| (name.to_owned(), value.to_owned())));
    assert_eq!(csm.notices(), [] as [&str; 0]);
    let markers = csm.markers().0;
    assert_eq!(
        [0, 1, 2].map(|marker| markers.positions.get(marker, 1)),
        [None, Some(DVec3::new(-1e-3, 0.5, 6.0)), None]
    );

    let trc = read_trc(TRC).unwrap();
    assert_eq!((trc.names.as_slice(), trc.rate_hz()), (["Head #1", "C7"].map(str::to_owned).as_slice(), Some(59.94)));
    let markers = trc.markers().0;
    assert_eq!([0, 1].map(|marker| markers.positions.get(marker, 1)), [None, Some(DVec3::new(-1e-3, 0.5, 6.0))]);
    assert_eq!([0, 1].map(|marker| markers.positions.get(marker, 2)), [Some(DVec3::new(1.0, 2.0, 3.0)), None]);
}

#[test]
fn frames_of_a_csm_may_run_over_lines_as_the_first_one_does() {
    let csm = read_csm("$order a b\n$points\n1\n1 2 3\n4 5 6\n2\n1 2 3\nDROPOUT\n").unwrap();
    assert_eq!(csm.frame_numbers, [1, 2]);
    assert!(csm.values[11].is_nan());
}

macro_rules! messages {
    ($read:ident { $($name:ident: $text:expr => $message:expr;)* }) => {
        $(
            #[test]
            fn $name() {
                assert_eq!($read(&$text).unwrap_err().to_string(), $message);
            }
        )*
    };
}

messages!(read_csm {
    a_csm_without_order: "$rate 120\n$points\n1 2 3 4" =>
        "line 2, column 1: expected `$order` with the names of the markers before `$points`, found `$points`";
    a_csm_without_points: "$order a" => "line 1, column 9: expected `$points`, found the end of the file";
    a_csm_of_nothing_known: "$comments x" =>
        "line 1, column 12: expected `$order` with the names of the markers, found the end of the file";
    a_csm_with_a_word_for_a_number: "$order a\n$points\n1 2 x 4" =>
        "line 3, column 5: expected a coordinate or `DROPOUT`, found `x`";
    a_csm_with_a_frame_that_is_too_short: "$order a b\n$points\n1 1 2 3 4 5 6\n2 1 2 3\n3 1 2 3 4 5 6" =>
        "line 4, column 1: expected coordinates of 2 markers in frame 2, found those of 1";
    a_csm_with_a_frame_that_is_too_long: "$order a\n$points\n1 1 2 3 4" =>
        "line 3, column 9: expected the end of the line after 1 markers, found `4`";
    a_csm_with_a_frame_number_that_is_none: "$order a\n$points\n1.5 1 2 3" =>
        "line 3, column 1: expected the number of a frame, found `1.5`";
    a_csm_with_a_name_that_would_be_a_section: "$order a $b\n$points" =>
        "line 1, column 10: expected the name of a marker, found `$b`";
    a_csm_with_no_rate_behind_rate: "$rate\n$order a\n$points" =>
        "line 1, column 1: expected one number for `$rate`, found none";
    a_csm_with_a_rate_of_zero: "$rate 0\n$order a\n$points" =>
        "line 1, column 7: expected a number of frames per second from 0.001 to 1000000, found `0`";
    a_csm_with_an_infinite_coordinate: "$order a\n$points\n1 1 inf 3" =>
        "line 3, column 5: expected a coordinate or `DROPOUT`, a finite number, found `inf`";
});

messages!(read_trc {
    a_trc_that_ends_in_its_head: "PathFileType\t4\n" =>
        "line 2, column 1: expected the keys of the head, from `DataRate` on, found the end of the file";
    a_trc_without_its_first_line: "DataRate\n60\nFrame#\n" =>
        "line 1, column 1: expected a line that begins with `PathFileType`, found `DataRate`";
    a_trc_without_names: "PathFileType\t4\nDataRate\n60\n1\t0\t1\t2\t3" =>
        "line 4, column 1: expected a line that begins with `Frame#`, found `1\\t0\\t1\\t2\\t3`";
    a_trc_with_a_word_for_a_number: TRC.replace("-1e-3", "x") =>
        "line 8, column 12: expected a coordinate or an empty cell, found `x`";
    a_trc_with_a_row_that_ends_within_a_marker: TRC.replace("\t4\t5\t6\n", "\t4\t5\n") =>
        "line 7, column 14: expected three coordinates for each marker, found 5 coordinates";
    a_trc_with_a_frame_without_time: TRC.replace("2\t0.017", "2\t") =>
        "line 8, column 3: expected the time of a frame, found nothing";
});

#[test]
fn counts_cost_nothing() {
    // The header claims 65,535 points, analog values and frames; the parameters claim more.
    let mut bytes = small_c3d(Storage::Integer);
    bytes[2..6].fill(0xFF);
    bytes[8..10].fill(0xFF);
    bytes.truncate(1100);
    let c3d = C3d::parse(bytes).unwrap();
    assert_eq!((c3d.layout().point_count, c3d.layout().frame_count), (65_535, 0));
    use_fully(&c3d.markers().0);
    let wide = format!("{}\t1\t1\t1\n", "1\t0".to_owned() + &"\t".repeat(299_997));
    let rows = TRC.lines().take(5).collect::<Vec<_>>().join("\n") + "\n" + &wide + &"1\t0\t1\t2\t3\n".repeat(30_000);
    assert_eq!(Trc::parse(rows.as_bytes()).unwrap_err().found, "30001 rows of which one has 300000");
}

#[test]
fn no_reader_takes_a_rate_that_another_would_refuse() {
    for rate in ["6666660", "1e300", "-5", "0", "nan"] {
        let trc = read_trc(&TRC.replacen("59.94", rate, 1).replace("0.017", "1e-9").replace("0.033", "2e-9")).unwrap();
        assert_eq!(trc.rate_hz(), None, "{rate}");
        assert!(read_csm(&CSM.replace("119.88", rate)).is_err(), "{rate}");
    }
}
