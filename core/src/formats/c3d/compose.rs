//! [`Markers`] -> the bytes of a new file.

use super::encode::word_in_steps;
use super::encoding::{Encoding, Processor, Storage};
use super::header::{Header, BLOCK_BYTES, KEY};
use super::markers::KINDS;
use super::section::Section;
use super::C3d;
use crate::error::ParameterError;
use crate::markers::{scale, Analog, AnalogChannel, Event, Markers, RawSamples};
use glam::DVec3;

/// What integers are scaled to: a little room is left below 32,767.
pub(super) const INTEGER_RANGE: f64 = 32_000.0;

/// The block of the parameter section in files that we write.
pub(super) const PARAMETER_BLOCK: u8 = 2;

impl C3d {
    /// Returns a file with these markers, their events and analog signals.
    ///
    /// Coordinates keep their unit where the format has a name for it, and become metres else. As floating point they
    /// are exact to 32 bits, as integers to a 32,000th of the largest.
    ///
    /// # Errors
    /// Where there are more points, analog values or parameters than the format can count.
    pub fn compose(markers: &Markers, encoding: Encoding) -> Result<Vec<u8>, ParameterError> {
        let (unit, factor) = match scale::unit_name(markers.unit.metres) {
            Some(name) => (name, 1.0),
            None => ("m", markers.unit.metres),
        };
        let step = point_step(markers, factor, encoding.storage);
        let analog = StoredAnalog::new(&markers.analog, encoding.storage);
        let header = header(markers, step, encoding.storage)?;
        let section_of = |data_block| section(markers, &analog, &header, unit, encoding.processor, data_block);
        let section_blocks = section_of(0).len() / BLOCK_BYTES;
        let data_block = u16::try_from(usize::from(PARAMETER_BLOCK) + section_blocks)
            .map_err(|_| ParameterError("the names are too long for the parameter section of a C3D file".to_owned()))?;
        let header = Header { data_block, ..header.clone() };
        let mut out = vec![0; BLOCK_BYTES];
        if let Some(block) = out.first_chunk_mut::<BLOCK_BYTES>() {
            header.write(block, encoding.processor);
            [block[0], block[1]] = [PARAMETER_BLOCK, KEY];
        }
        out.extend_from_slice(&section_of(data_block));
        write_data(&mut out, markers, &analog, encoding, (step, factor));
        out.resize(out.len().next_multiple_of(BLOCK_BYTES), 0);
        Ok(out)
    }
}

/// Returns how long a step of an integer coordinate is: that of the quality words if all coordinates fit.
fn point_step(markers: &Markers, factor: f64, storage: Storage) -> f32 {
    let known = markers.quality.scale() * factor as f32;
    let frames = (0..markers.count()).flat_map(|marker| (0..markers.frame_count()).map(move |frame| (marker, frame)));
    let positions = frames.filter_map(|(marker, frame)| markers.positions.get(marker, frame));
    let largest = positions.fold(0.0_f64, |largest, at| largest.max(at.abs().max_element())) * factor;
    step_for(largest, known, storage)
}

/// Returns the known step of integers if the largest value fits, or is not stored in it; else one in which it fits.
pub(super) fn step_for(largest: f64, known: f32, storage: Storage) -> f32 {
    let is_known = known.is_finite() && known > 0.0;
    if is_known && (storage == Storage::Float || largest / f64::from(known) <= f64::from(i16::MAX)) {
        known
    } else if largest > 0.0 {
        (largest / INTEGER_RANGE) as f32
    } else {
        1.0
    }
}

fn header(markers: &Markers, step: f32, storage: Storage) -> Result<Header, ParameterError> {
    let count = |count: usize, what: &str| {
        u16::try_from(count).map_err(|_| ParameterError(format!("a C3D file cannot hold {count} {what}")))
    };
    let analog = &markers.analog;
    let last = markers.last_frame().max(0);
    Ok(Header {
        point_count: count(markers.count(), "points")?,
        analog_per_frame: count(analog.channels.len() * analog.samples_per_frame, "analog values in a frame")?,
        first_frame: (markers.first_frame.max(0) & 0xFFFF) as u16,
        last_frame: u16::try_from(last).unwrap_or(u16::MAX),
        longest_gap: 0,
        scale: if storage == Storage::Float { -step } else { step },
        data_block: 0,
        samples_per_frame: count(analog.samples_per_frame, "analog samples in a frame")?,
        rate_hz: markers.rate_hz.unwrap_or(0.0) as f32,
        events: Vec::new(),
    })
}

fn section(
    markers: &Markers,
    analog: &StoredAnalog<'_>,
    header: &Header,
    unit: &str,
    processor: Processor,
    data_block: u16,
) -> Vec<u8> {
    let mut section = Section::new(processor);
    let names: Vec<&str> = markers.names.iter().map(String::as_str).collect();
    section.group("POINT");
    section.integer("USED", header.point_count);
    section.float("SCALE", header.scale);
    section.float("RATE", header.rate_hz);
    section.integer("DATA_START", data_block);
    section.integer("FRAMES", u16::try_from(markers.frame_count()).unwrap_or(u16::MAX));
    section.texts("LABELS", &names);
    section.text("UNITS", unit);
    let up = markers.up.axis;
    section.text("X_SCREEN", scale::axis_name(if up.x == 0.0 { DVec3::X } else { DVec3::Y }));
    section.text("Y_SCREEN", scale::axis_name(up));
    for (list, kind) in KINDS {
        let of_kind = markers.names.iter().zip(&markers.kinds).filter(|(_, known)| **known == kind);
        let names: Vec<&str> = of_kind.map(|(name, _)| name.as_str()).collect();
        if !names.is_empty() {
            section.texts(list, &names);
        }
    }
    analog.write_parameters(&mut section);
    section.group("TRIAL");
    let words = |frame: i64| [frame as u16, (frame >> 16) as u16];
    section.integers("ACTUAL_START_FIELD", 1, &words(markers.first_frame.max(0)));
    section.integers("ACTUAL_END_FIELD", 1, &words(markers.last_frame().max(0)));
    if !markers.events.is_empty() {
        section.group("EVENT");
        section.integer("USED", u16::try_from(markers.events.len()).unwrap_or(u16::MAX));
        let texts = |text: fn(&Event) -> &str| markers.events.iter().map(text).collect::<Vec<_>>();
        section.texts("LABELS", &texts(|event| &event.label));
        section.texts("CONTEXTS", &texts(|event| &event.context));
        section.texts("SUBJECTS", &texts(|event| &event.subject));
        let times: Vec<f32> = markers.events.iter().flat_map(|event| [0.0, event.time_s as f32]).collect();
        section.floats("TIMES", 2, &times);
    }
    section.finish()
}

/// Analog samples as a storage can hold them.
struct StoredAnalog<'a> {
    analog: &'a Analog,
    /// How each channel is stored.
    channels: Vec<StoredChannel>,
}

/// How the recorded numbers of a channel are stored: counted from `zero` in steps of `step`.
struct StoredChannel {
    offset: f64,
    scale: f64,
    zero: f64,
    step: f64,
}

impl<'a> StoredAnalog<'a> {
    fn new(analog: &'a Analog, storage: Storage) -> Self {
        let as_recorded = |channel: &AnalogChannel| StoredChannel {
            offset: channel.offset,
            scale: channel.scale,
            zero: 0.0,
            step: 1.0,
        };
        let range =
            if is_unsigned(analog) { 0.0..=f64::from(u16::MAX) } else { f64::from(i16::MIN)..=f64::from(i16::MAX) };
        let is_integer = |number: f64| number.fract() == 0.0 && range.contains(&number);
        let channels = if storage == Storage::Float || analog.raw.iter().all(is_integer) {
            analog.channels.iter().map(as_recorded).collect()
        } else {
            (0..analog.channels.len()).map(|channel| in_steps(analog, channel)).collect()
        };
        Self { analog, channels }
    }

    fn write_parameters(&self, section: &mut Section) {
        let analog = self.analog;
        // What is counted from zero has a sign.
        let is_unsigned = is_unsigned(analog) && self.channels.iter().all(|channel| channel.step == 1.0);
        section.group("ANALOG");
        section.integer("USED", analog.channels.len() as u16);
        section.float("GEN_SCALE", analog.general_scale as f32);
        section.float("RATE", analog.rate_hz.unwrap_or(0.0) as f32);
        if is_unsigned {
            section.text("FORMAT", "UNSIGNED");
        }
        let texts = |text: fn(&AnalogChannel) -> &str| analog.channels.iter().map(text).collect::<Vec<_>>();
        section.texts("LABELS", &texts(|channel| &channel.name));
        section.texts("DESCRIPTIONS", &texts(|channel| &channel.description));
        section.texts("UNITS", &texts(|channel| &channel.unit));
        section.floats("SCALE", 1, &self.channels.iter().map(|channel| channel.scale as f32).collect::<Vec<_>>());
        let offsets: Vec<f64> = self.channels.iter().map(|channel| channel.offset).collect();
        let range = if is_unsigned { 0.0..=65535.0 } else { -32768.0..=32767.0 };
        if offsets.iter().all(|offset| offset.fract() == 0.0 && range.contains(offset)) {
            section.integers("OFFSET", 1, &offsets.iter().map(|offset| *offset as i32 as u16).collect::<Vec<_>>());
        } else {
            section.floats("OFFSET", 1, &offsets.iter().map(|offset| *offset as f32).collect::<Vec<_>>());
        }
    }

    /// Writes the samples of a frame.
    fn write_frame(&self, out: &mut Vec<u8>, frame: usize, encoding: Encoding) {
        let width = self.channels.len();
        let per_frame = width * self.analog.samples_per_frame;
        let of_frame = frame * per_frame..(frame + 1) * per_frame;
        for (index, at) in of_frame.enumerate() {
            let number = self.analog.raw.get(at).unwrap_or(0.0);
            match encoding.storage {
                Storage::Float => out.extend_from_slice(&encoding.processor.f32_bytes(number as f32)),
                // Unsigned numbers keep their bits.
                Storage::Integer => {
                    let steps = self.channels.get(index % width).map_or(number, |c| (number - c.zero) / c.step);
                    out.extend_from_slice(&encoding.processor.u16_bytes(steps.round() as i32 as u16));
                }
            }
        }
    }
}

fn is_unsigned(analog: &Analog) -> bool {
    matches!(analog.raw, RawSamples::Recorded { is_unsigned: true, .. })
}

/// Returns how a channel is stored whose recorded numbers do not fit into 16 bits as they are.
fn in_steps(analog: &Analog, channel: usize) -> StoredChannel {
    let (zero, scale) = analog.channels.get(channel).map_or((0.0, 1.0), |known| (known.offset, known.scale));
    let own = analog.raw.iter().skip(channel).step_by(analog.channels.len().max(1));
    let largest = own.map(|number| (number - zero).abs()).fold(0.0, f64::max);
    let step = if largest > 0.0 { largest / INTEGER_RANGE } else { 1.0 };
    StoredChannel { offset: 0.0, scale: scale * step, zero, step }
}

fn write_data(out: &mut Vec<u8>, markers: &Markers, analog: &StoredAnalog<'_>, encoding: Encoding, steps: (f32, f64)) {
    let (step, factor) = steps;
    let processor = encoding.processor;
    // How many of the steps that residuals are counted in make one of ours.
    let residual_steps = markers.quality.scale() * factor as f32 / step;
    let frame_count = markers.frame_count();
    for frame in 0..frame_count {
        for marker in 0..markers.count() {
            let position = markers.positions.get(marker, frame);
            let known = markers.quality.word(marker, frame);
            let word = match position {
                None => -1,
                Some(_) if known < 0 => 0,
                Some(_) => word_in_steps(known, residual_steps),
            };
            let xyz = (position.unwrap_or_default() * factor).to_array();
            match encoding.storage {
                Storage::Float => {
                    out.extend(xyz.iter().flat_map(|x| processor.f32_bytes(*x as f32)));
                    out.extend_from_slice(&processor.f32_bytes(word.into()));
                }
                Storage::Integer => {
                    let whole = |x: &f64| (x / f64::from(step)).round() as i16;
                    out.extend(xyz.iter().flat_map(|x| processor.i16_bytes(whole(x))));
                    out.extend_from_slice(&processor.i16_bytes(word));
                }
            }
        }
        analog.write_frame(out, frame, encoding);
    }
}
