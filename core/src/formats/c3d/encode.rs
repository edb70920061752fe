//! [`C3d`] -> the bytes of the same file in another encoding.

use super::compose::{step_for, INTEGER_RANGE, PARAMETER_BLOCK};

use super::encoding::{Encoding, Processor, Storage};
use super::frames::word_of;
use super::header::{word_at, Header, BLOCK_BYTES, KEY};
use super::index::Item;
use super::parameters::{Parameter, ParameterType};
use super::section::Section;
use super::C3d;
use crate::error::ParameterError;

/// What changes of the numbers when floating point becomes integer.
struct Change {
    encoding: Encoding,
    /// What integer coordinates are multiplied by.
    step: f32,
    /// What the recorded numbers of each analog channel are counted from, and in which steps; nothing where they stay.
    analog: Vec<(f64, f64)>,
    data_block: u16,
}

impl Change {
    /// Returns an analog number as it is stored.
    fn stored(&self, channel: usize, number: f64) -> f64 {
        self.analog.get(channel).map_or(number, |(zero, step)| (number - zero) / step)
    }
}

impl C3d {
    /// Returns the file in an encoding: every parameter, header word and value. In the file's own, it is the file as it
    /// was, to the byte.
    ///
    /// Between processors nothing changes but what one of them cannot express (see the VAX format). Integers become the
    /// floating-point numbers that they stand for. Floating-point coordinates become integers in steps of `POINT:SCALE`,
    /// or larger ones if need be; analog numbers that are no 16-bit integers get another scale.
    ///
    /// # Errors
    /// Where the parameters are too long for the format, or analog numbers need a scale and the file has none.
    pub fn encoded(&self, encoding: Encoding) -> Result<Vec<u8>, ParameterError> {
        if encoding == self.encoding() {
            Ok(self.to_bytes())
        } else {
            self.re_encoded(encoding)
        }
    }

    pub(super) fn re_encoded(&self, encoding: Encoding) -> Result<Vec<u8>, ParameterError> {
        let mut change = self.change(encoding);
        if !change.analog.is_empty() && self.parameter("ANALOG", "SCALE").is_none() {
            let why = "analog numbers become integers by ANALOG:SCALE, which the file does not have";
            return Err(ParameterError(why.to_owned()));
        }
        let section_blocks = self.section(&change).len() / BLOCK_BYTES;
        change.data_block = u16::try_from(usize::from(PARAMETER_BLOCK) + section_blocks)
            .map_err(|_| ParameterError("the parameters are too long for a C3D file".to_owned()))?;
        let mut out = self.header_block(&change);
        out.extend_from_slice(&self.section(&change));
        self.write_data(&mut out, &change);
        let end = self.layout().data_start + self.data().len();
        if !out.len().is_multiple_of(BLOCK_BYTES) && end < self.bytes().len() {
            out.resize(out.len().next_multiple_of(BLOCK_BYTES), 0);
        }
        Ok(out)
    }

    fn change(&self, encoding: Encoding) -> Change {
        let layout = self.layout();
        let mut change = Change { encoding, step: layout.scale, analog: Vec::new(), data_block: 0 };
        if (layout.storage, encoding.storage) != (Storage::Float, Storage::Integer) {
            return change;
        }
        let zeros: Vec<f64> = self.analog().channels.iter().map(|channel| channel.offset).collect();
        let (mut largest, mut largest_analog) = (0.0_f32, vec![0.0_f64; layout.channel_count]);
        let range =
            if self.is_unsigned() { 0.0..=f32::from(u16::MAX) } else { f32::from(i16::MIN)..=f32::from(i16::MAX) };
        let mut are_integers = true;
        self.each_float(|is_point, index, value| {
            if is_point && index % 4 != 3 && value.is_finite() {
                largest = largest.max(value.abs());
            }
            if !is_point {
                are_integers &= value.fract() == 0.0 && range.contains(&value);
                let channel = index % layout.channel_count.max(1);
                if let (Some(place), Some(zero)) = (largest_analog.get_mut(channel), zeros.get(channel)) {
                    *place = place.max((f64::from(value) - zero).abs());
                }
            }
        });
        change.step = step_for(largest.into(), layout.scale, Storage::Integer);
        if !are_integers {
            let step = |largest: &f64| if *largest > 0.0 { largest / INTEGER_RANGE } else { 1.0 };
            change.analog = zeros.into_iter().zip(largest_analog.iter().map(step)).collect();
        }
        change
    }

    /// Calls with every value of a floating-point file: whether it is one of a point, its place in the frame, and it.
    fn each_float(&self, mut call: impl FnMut(bool, usize, f32)) {
        let processor = self.index.processor();
        for frame in self.data().chunks_exact(self.layout().frame_bytes().max(1)) {
            let (points, analog) = frame.split_at_checked(self.layout().point_bytes()).unwrap_or_default();
            for (is_point, bytes) in [(true, points), (false, analog)] {
                let values = bytes.as_chunks::<4>().0.iter().enumerate();
                values.for_each(|(index, bytes)| call(is_point, index, processor.f32(*bytes)));
            }
        }
    }

    fn header_block(&self, change: &Change) -> Vec<u8> {
        let (from, to) = (self.index.processor(), change.encoding.processor);
        let mut out = self.bytes().get(..BLOCK_BYTES).unwrap_or_default().to_vec();
        // What has no meaning, or none here, is words too.
        for word in (13..=152).chain(235..=256) {
            if let Some(place) = out.get_mut(word_at(word)..).and_then(|rest| rest.first_chunk_mut::<2>()) {
                *place = to.u16_bytes(from.u16(*place));
            }
        }
        let scale = if change.encoding.storage == Storage::Float { -change.step } else { change.step };
        let header = Header { scale, data_block: change.data_block, ..self.header.clone() };
        if let Some(block) = out.first_chunk_mut::<BLOCK_BYTES>() {
            header.write(block, to);
            [block[0], block[1]] = [PARAMETER_BLOCK, KEY];
        }
        out
    }

    fn section(&self, change: &Change) -> Vec<u8> {
        let mut section = Section::new(change.encoding.processor);
        let id_of = |name: &str| {
            let group = self.groups().find(|group| group.name.eq_ignore_ascii_case(name.as_bytes()));
            group.map(|group| group.id)
        };
        let (point, analog) = (id_of("POINT"), id_of("ANALOG"));
        let processor = change.encoding.processor;
        let scale = if change.encoding.storage == Storage::Float { -change.step } else { change.step };
        for item in self.index.items(self.bytes()) {
            let parameter = match item {
                Item::Group(group) => {
                    section.push_group(&group);
                    continue;
                }
                Item::Parameter(parameter) => parameter,
            };
            let place = |group: Option<u8>, name: &str| {
                let place = place_in_series(parameter.name, name)?;
                (group == Some(parameter.group)).then_some(place)
            };
            let changes = |from: usize| change.analog.iter().skip(from);
            let others: Vec<f64> = if place(point, "SCALE") == Some(0) {
                vec![scale.into()]
            } else if place(point, "DATA_START") == Some(0) {
                vec![change.data_block.into()]
            } else if let Some(from) = place(analog, "SCALE") {
                parameter.numbers().into_iter().zip(changes(from)).map(|(scale, (_, step))| scale * step).collect()
            } else if let Some(from) = place(analog, "OFFSET") {
                changes(from).map(|_| 0.0).collect()
            } else {
                Vec::new()
            };
            let bytes = numbers(&parameter, processor, &others);
            // What is counted from zero has a sign.
            let is_signed_now = place(analog, "FORMAT") == Some(0) && !change.analog.is_empty();
            let bytes = if is_signed_now { signed_format(bytes.len()) } else { bytes };
            section.push(&Parameter { bytes: &bytes, ..parameter });
        }
        section.finish()
    }

    fn write_data(&self, out: &mut Vec<u8>, change: &Change) {
        let (from, to) = (self.index.processor(), change.encoding.processor);
        let scale = self.layout().scale;
        let step = change.step;
        let channel_count = self.layout().channel_count.max(1);
        let is_unsigned = self.is_unsigned();
        match (self.layout().storage, change.encoding.storage) {
            (Storage::Integer, storage) => {
                for frame in self.data().chunks_exact(self.layout().frame_bytes().max(1)) {
                    let (words, _) = frame.as_chunks::<2>();
                    for (index, bytes) in words.iter().enumerate() {
                        let is_point = index < 4 * self.layout().point_count;
                        let value = match storage {
                            Storage::Integer => {
                                out.extend_from_slice(&to.i16_bytes(from.i16(*bytes)));
                                continue;
                            }
                            Storage::Float if is_point && index % 4 != 3 => f32::from(from.i16(*bytes)) * scale,
                            Storage::Float if is_unsigned && !is_point => f32::from(from.u16(*bytes)),
                            Storage::Float => f32::from(from.i16(*bytes)),
                        };
                        out.extend_from_slice(&to.f32_bytes(value));
                    }
                }
            }
            (Storage::Float, Storage::Float) => {
                self.each_float(|_, _, value| out.extend_from_slice(&to.f32_bytes(value)));
            }
            (Storage::Float, Storage::Integer) => self.each_float(|is_point, index, value| {
                let number = f64::from(value);
                let whole = match (is_point, index % 4) {
                    (true, 3) => word_in_steps(word_of(value).unwrap_or(0), scale / step).into(),
                    (true, _) => number / f64::from(step),
                    (false, _) => change.stored(index % channel_count, number),
                };
                // Numbers without a sign keep their bits.
                let whole = whole.round().clamp(-32768.0, 65535.0) as i32;
                out.extend_from_slice(&to.u16_bytes(whole as u16));
            }),
        }
    }
}

/// Returns the value of `ANALOG:FORMAT` for samples with a sign.
fn signed_format(length: usize) -> Vec<u8> {
    b"SIGNED".iter().copied().chain(std::iter::repeat(b' ')).take(length).collect()
}

/// Returns which value is the first of a parameter of the series `LABELS`, `LABELS2` ...
fn place_in_series(name: &[u8], series: &str) -> Option<usize> {
    const FULL: usize = 255;
    let (start, number) = name.split_at_checked(series.len())?;
    if !start.eq_ignore_ascii_case(series.as_bytes()) {
        return None;
    }
    match number {
        [] => Some(0),
        [digit @ b'2'..=b'9'] => Some(FULL * usize::from(digit - b'1')),
        _ => None,
    }
}

/// Returns the word of cameras and residual when the residual is counted in `ratio` times as many steps.
pub(super) fn word_in_steps(word: i16, ratio: f32) -> i16 {
    if ratio == 1.0 || word < 0 {
        return word;
    }
    (word & 0x7F00) | (f32::from(word & 0xFF) * ratio).round().min(255.0) as i16
}

/// Returns the bytes of a parameter for another processor, its first values replaced by others.
fn numbers(parameter: &Parameter<'_>, to: Processor, others: &[f64]) -> Vec<u8> {
    let from = parameter.processor;
    let mut bytes = parameter.bytes.to_vec();
    match parameter.kind {
        ParameterType::Text | ParameterType::Byte => {}
        ParameterType::Integer => {
            let places = bytes.as_chunks_mut::<2>().0;
            for place in &mut *places {
                *place = to.i16_bytes(from.i16(*place));
            }
            places.iter_mut().zip(others).for_each(|(place, other)| *place = to.u16_bytes(*other as i32 as u16));
        }
        ParameterType::Float => {
            let places = bytes.as_chunks_mut::<4>().0;
            // The same bits where nothing changes, numbers that are none too.
            if from != to {
                for place in &mut *places {
                    *place = to.f32_bytes(from.f32(*place));
                }
            }
            places.iter_mut().zip(others).for_each(|(place, other)| *place = to.f32_bytes(*other as f32));
        }
    }
    bytes
}
