//! What lies where in the data: header, parameters and the size of the file compared.
//!
//! The header counts in words of 16 bits, newer parameters do not, and programs get one or the other wrong. The size of
//! a file is what no program gets wrong: the data fill it, up to the last block. So of all readings of the counts the
//! first one is taken by which the data end within the last block; the header's own comes first. Where none does, the
//! header counts (and what follows the data is kept, or what is missing is said).
//!
//! Seen in public files: the analog word holds the channels of one sample instead of a frame's values (`MotionMonitor`);
//! `ANALOG:USED` holds a frame's values instead of the channels (`FP1`); `ANALOG:RATE` is no multiple of `POINT:RATE`
//! though each frame holds 17 samples (`EvaRT`); frame counts beyond 65,535; no rate among the parameters (BTS);
//! `POINT:DATA_START` of 0 (`OptiTrack`).

use super::encoding::Storage;
use super::header::{Header, BLOCK_BYTES};
use super::index::Index;
use super::parameters::{Parameter, ParameterType};
use crate::rate::RATES_HZ;

/// What lies where in the data.
#[derive(Debug, Clone, PartialEq)]
pub struct Layout {
    /// How values are stored.
    pub storage: Storage,
    /// The first byte of the data.
    pub data_start: usize,
    /// The points of a frame.
    pub point_count: usize,
    /// The analog channels.
    pub channel_count: usize,
    /// The samples of each analog channel in a frame.
    pub samples_per_frame: usize,
    /// The frames that are there.
    pub frame_count: usize,
    /// The number of the first frame.
    pub first_frame: i64,
    /// Frames per second, where the file says.
    pub rate_hz: Option<f64>,
    /// What integer coordinates and all residuals are multiplied by; not negative.
    pub scale: f32,
}

impl Layout {
    /// Returns the bytes of the points of a frame.
    pub fn point_bytes(&self) -> usize {
        4 * self.point_count * self.storage.width()
    }

    /// Returns the analog values of a frame.
    pub fn analog_per_frame(&self) -> usize {
        self.channel_count * self.samples_per_frame
    }

    /// Returns the bytes of a frame.
    pub fn frame_bytes(&self) -> usize {
        self.point_bytes() + self.analog_per_frame() * self.storage.width()
    }
}

/// One way to read the counts.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
struct Reading {
    storage: Storage,
    point_count: usize,
    analog_per_frame: usize,
    frame_count: usize,
}

impl Reading {
    fn frame_bytes(&self) -> usize {
        (4 * self.point_count + self.analog_per_frame) * self.storage.width()
    }

    /// Whether the data end within the last block.
    fn fits(&self, available: usize) -> bool {
        let length = self.frame_bytes().checked_mul(self.frame_count).filter(|length| *length > 0);
        length.and_then(|length| available.checked_sub(length)).is_some_and(|rest| rest < BLOCK_BYTES)
    }
}

/// What the parameters say about the same.
struct Stated {
    points: Option<usize>,
    channels: Option<usize>,
    scale: Option<f64>,
    rate_hz: Option<f64>,
    analog_rate_hz: Option<f64>,
    trial: Option<(i64, i64)>,
    frames: Option<usize>,
}

impl Stated {
    fn new(source: &[u8], index: &Index) -> Self {
        let find = |group, name| index.find(source, group, name);
        let number = |group, name| find(group, name).and_then(|parameter| parameter.number());
        let count = |group, name| find(group, name).and_then(|parameter| parameter.count());
        let field = |name| find("TRIAL", name).and_then(long_number);
        Self {
            points: count("POINT", "USED"),
            channels: count("ANALOG", "USED"),
            scale: number("POINT", "SCALE"),
            rate_hz: find("POINT", "RATE").and_then(rate),
            analog_rate_hz: find("ANALOG", "RATE").and_then(rate),
            trial: field("ACTUAL_START_FIELD").zip(field("ACTUAL_END_FIELD")),
            frames: count("POINT", "LONG_FRAMES").or_else(|| count("POINT", "FRAMES")),
        }
    }
}

/// Two 16-bit words, the lower first; or one number.
fn long_number(parameter: Parameter<'_>) -> Option<i64> {
    let numbers = parameter.numbers();
    let word = |number: &f64| i64::from(*number as i32 as u16);
    match (parameter.kind, numbers.as_slice()) {
        (ParameterType::Integer, [low, high, ..]) => Some(word(low) + (word(high) << 16)),
        (ParameterType::Integer, [low]) => Some(word(low)),
        (_, [number, ..]) if (0.0..1e9).contains(number) => Some(number.round() as i64),
        _ => None,
    }
}

pub(super) fn rate(parameter: Parameter<'_>) -> Option<f64> {
    usable_rate(parameter.number()? as f32)
}

/// Returns the rate, where it is one: with up to three decimals the number that was meant, 59.94 and not the nearest
/// `f32` to it, 59.939998626708984.
fn usable_rate(rate: f32) -> Option<f64> {
    let exact = f64::from(rate);
    let meant = (exact * 1000.0).round() / 1000.0;
    RATES_HZ.contains(&exact).then_some(if meant as f32 == rate { meant } else { exact })
}

/// Compares header, parameters and the size of the file; also returns what the user should know.
pub(super) fn decide(source: &[u8], header: &Header, index: &Index) -> (Layout, Vec<String>) {
    let mut notices = Vec::new();
    let stated = Stated::new(source, index);
    let data_start = data_start(source, header, index, &mut notices);
    let available = source.len() - data_start;
    // Nearly always the first is the one.
    let mut readings = readings(header, &stated).peekable();
    let headers_own = readings.peek().copied().unwrap_or_default();
    let reading = readings.find(|reading| reading.fits(available)).unwrap_or(headers_own);
    if headers_own != reading {
        notices.push(overruled(&headers_own, &reading));
    }
    let room = available.checked_div(reading.frame_bytes()).unwrap_or(0);
    let frame_count = reading.frame_count.min(room);
    if frame_count < reading.frame_count {
        notices.push(format!(
            "The file declares {} frames but ends after {frame_count}: what is there is used",
            reading.frame_count
        ));
    }
    let rest = available - frame_count * reading.frame_bytes();
    if frame_count == reading.frame_count && rest >= BLOCK_BYTES {
        notices.push(format!("{rest} bytes follow the last declared frame: they are kept and not used"));
    }
    let rate_hz = stated.rate_hz.or_else(|| usable_rate(header.rate_hz));
    let (channel_count, samples_per_frame) = split_analog(reading.analog_per_frame, header, &stated, &mut notices);
    if let (Some(rate), Some(stated)) = (rate_hz, stated.analog_rate_hz) {
        if channel_count > 0 && (stated / rate - samples_per_frame as f64).abs() > 0.01 {
            notices.push(format!(
                "{samples_per_frame} analog samples per frame at {rate} Hz are not the {stated} Hz that the file states"
            ));
        }
    }
    let first_frame = first_frame(header, &stated);
    let layout = Layout {
        storage: reading.storage,
        data_start,
        point_count: reading.point_count,
        channel_count,
        samples_per_frame,
        frame_count,
        first_frame,
        rate_hz,
        scale: scale(header, &stated),
    };
    (layout, notices)
}

/// The header says where the data begin; else the parameters do; else they follow the parameters.
fn data_start(source: &[u8], header: &Header, index: &Index, notices: &mut Vec<String>) -> usize {
    let stated = index.find(source, "POINT", "DATA_START").and_then(|parameter| parameter.count()).unwrap_or(0);
    let start_of = |block: usize| block.saturating_sub(1) * BLOCK_BYTES;
    let is_possible = |block: usize| block > 1 && start_of(block) <= source.len() && start_of(block) != index.start;
    let header_block = usize::from(header.data_block);
    if is_possible(header_block) {
        if is_possible(stated) && stated != header_block {
            notices.push(format!(
                "The header puts the data at block {header_block}, POINT:DATA_START at {stated}: the header is taken"
            ));
        }
        return start_of(header_block);
    }
    let after_parameters = index.end.max(index.start + index.block_count * BLOCK_BYTES).div_ceil(BLOCK_BYTES) + 1;
    let block = if is_possible(stated) { stated } else { after_parameters };
    notices
        .push(format!("The header puts the data at block {header_block}, where they cannot be: block {block} taken"));
    start_of(block).min(source.len())
}

/// Every way to read the counts, likely ones first.
fn readings(header: &Header, stated: &Stated) -> impl Iterator<Item = Reading> {
    let storage_of = |is_float: bool| if is_float { Storage::Float } else { Storage::Integer };
    let samples = usize::from(header.samples_per_frame);
    let by_rate = stated.analog_rate_hz.zip(stated.rate_hz).map(|(analog, point)| (analog / point).round() as usize);
    let channels_times = |samples: usize| stated.channels.map(|channels| channels.saturating_mul(samples));
    let storages = [Some(storage_of(header.scale < 0.0)), stated.scale.map(|scale| storage_of(scale < 0.0))];
    let points = [Some(usize::from(header.point_count)), stated.points];
    let analog =
        [Some(usize::from(header.analog_per_frame)), channels_times(samples), by_rate.and_then(channels_times)];
    let frames = frame_counts(header, stated);
    let point_counts = move |storage| points.into_iter().flatten().map(move |point_count| (storage, point_count));
    let widths = move |counts| analog.into_iter().flatten().map(move |analog_per_frame| (counts, analog_per_frame));
    let lengths = move |((storage, point_count), analog_per_frame): ((Storage, usize), usize)| {
        let counts = frames.into_iter().flatten().filter(|count| *count <= MOST_FRAMES);
        counts.map(move |frame_count| Reading {
            storage,
            point_count,
            // Beyond what a file can hold; products stay far from overflow.
            analog_per_frame: analog_per_frame.min(MOST_VALUES),
            frame_count,
        })
    };
    storages.into_iter().flatten().flat_map(point_counts).flat_map(widths).flat_map(lengths)
}

/// More frames than any file has: a month at 1000 Hz.
const MOST_FRAMES: usize = 1 << 31;

/// More analog values than any frame has.
const MOST_VALUES: usize = 1 << 24;

/// A last frame of 65,535 says only that there are many: the parameters know how many.
fn frame_counts(header: &Header, stated: &Stated) -> [Option<usize>; 4] {
    let span = usize::from(header.last_frame).checked_sub(header.first_frame.into()).map(|span| span + 1);
    let trial = stated.trial.and_then(|(first, last)| usize::try_from(last - first + 1).ok());
    if header.last_frame == u16::MAX {
        [trial, stated.frames, span, Some(0)]
    } else {
        [span, trial, stated.frames, Some(0)]
    }
}

fn overruled(own: &Reading, taken: &Reading) -> String {
    let words = |reading: &Reading| {
        let kind = if reading.storage == Storage::Float { "floating point" } else { "integer" };
        format!(
            "{} frames of {} {kind} points and {} analog values",
            reading.frame_count, reading.point_count, reading.analog_per_frame
        )
    };
    format!(
        "The header speaks of {}, but the size of the file and its parameters of {}: the latter are taken",
        words(own),
        words(taken)
    )
}

/// Returns how many channels share the analog values of a frame, and how many samples each has.
fn split_analog(per_frame: usize, header: &Header, stated: &Stated, notices: &mut Vec<String>) -> (usize, usize) {
    let samples = usize::from(header.samples_per_frame);
    if per_frame == 0 {
        return (0, samples.max(1));
    }
    let (channels, samples) = match (per_frame.checked_rem(samples), stated.channels) {
        (Some(0), _) => (per_frame / samples, samples),
        (_, Some(channels)) if channels > 0 && per_frame.is_multiple_of(channels) => (channels, per_frame / channels),
        _ => (per_frame, 1),
    };
    if let Some(stated) = stated.channels.filter(|stated| *stated != channels) {
        notices.push(format!(
            "ANALOG:USED speaks of {stated} channels, but a frame holds {per_frame} values, {samples} of each channel: \
             {channels} channels are taken"
        ));
    }
    (channels, samples)
}

/// The header has the lower 16 bits of a number that `TRIAL:ACTUAL_START_FIELD` has in full.
fn first_frame(header: &Header, stated: &Stated) -> i64 {
    let own = i64::from(header.first_frame);
    match stated.trial {
        Some((first, _)) if first > own && first & 0xFFFF == own => first,
        _ => own,
    }
}

/// `POINT:SCALE` and the header agree but for rounding on the way between encodings.
fn scale(header: &Header, stated: &Stated) -> f32 {
    let usable = |scale: f32| scale.is_finite() && scale != 0.0;
    let scale = stated.scale.map(|scale| scale as f32).filter(|scale| usable(*scale)).unwrap_or(header.scale);
    if usable(scale) {
        scale.abs()
    } else {
        1.0
    }
}
