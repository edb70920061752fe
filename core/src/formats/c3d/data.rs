//! The data section: from frames to trajectories.
//!
//! A file has all points of a frame side by side, an editor wants all frames of a point. A block of frames is turned at
//! a time, few enough to stay in the cache while every point takes its samples from them.

use super::encoding::{Processor, Storage};
use super::layout::Layout;
use super::{vax, C3d};
use crate::markers::RawSamples;

/// How many bytes of frames are turned at a time.
const TURN_BYTES: usize = 64 * 1024;

/// The word of a sample that is none.
const GAP: i16 = -1;

/// Positions and quality of all samples, point after point.
pub(super) struct Trajectories {
    /// x, y, z of each sample; not numbers in a gap.
    pub(super) positions: Vec<f32>,
    /// The fourth word of each sample; negative in a gap.
    pub(super) words: Vec<i16>,
    /// How many fourth words are no such words.
    pub(super) odd_word_count: usize,
}

impl C3d {
    /// Decodes the points.
    pub(super) fn trajectories(&self) -> Trajectories {
        let processor = self.index.processor();
        let scale = self.layout.scale;
        let integers = |read: fn([u8; 2]) -> i16| {
            turn::<8>(self.data(), &self.layout, |b| {
                let [x, y, z, word] = [read([b[0], b[1]]), read([b[2], b[3]]), read([b[4], b[5]]), read([b[6], b[7]])];
                ([f32::from(x) * scale, f32::from(y) * scale, f32::from(z) * scale], Some(word))
            })
        };
        match (self.layout.storage, processor) {
            (Storage::Integer, Processor::Intel | Processor::Dec) => integers(i16::from_le_bytes),
            (Storage::Integer, Processor::Mips) => integers(i16::from_be_bytes),
            (Storage::Float, Processor::Intel) => {
                turn::<16>(self.data(), &self.layout, |b| floats(b, f32::from_le_bytes))
            }
            (Storage::Float, Processor::Dec) => turn::<16>(self.data(), &self.layout, |b| floats(b, vax::to_f32)),
            (Storage::Float, Processor::Mips) => {
                turn::<16>(self.data(), &self.layout, |b| floats(b, f32::from_be_bytes))
            }
        }
    }

    /// Decodes the analog samples, unscaled.
    pub(super) fn raw_samples(&self, is_unsigned: bool) -> RawSamples {
        let layout = &self.layout;
        let frames = || self.data().chunks_exact(layout.frame_bytes().max(1));
        let rows = || frames().map(|frame| frame.get(layout.point_bytes()..).unwrap_or_default());
        let count = layout.frame_count * layout.analog_per_frame();
        match (layout.storage, self.index.processor()) {
            (Storage::Integer, processor) if is_unsigned => {
                RawSamples::Unsigned(collect(rows(), count, |bytes| processor.u16(bytes)))
            }
            (Storage::Integer, Processor::Mips) => RawSamples::Signed(collect(rows(), count, i16::from_be_bytes)),
            (Storage::Integer, _) => RawSamples::Signed(collect(rows(), count, i16::from_le_bytes)),
            (Storage::Float, Processor::Intel) => RawSamples::Float(collect(rows(), count, f32::from_le_bytes)),
            (Storage::Float, Processor::Dec) => RawSamples::Float(collect(rows(), count, vax::to_f32)),
            (Storage::Float, Processor::Mips) => RawSamples::Float(collect(rows(), count, f32::from_be_bytes)),
        }
    }
}

/// Reads a point of four floating-point numbers.
#[inline]
fn floats(b: &[u8; 16], read: impl Fn([u8; 4]) -> f32) -> ([f32; 3], Option<i16>) {
    let position = [read([b[0], b[1], b[2], b[3]]), read([b[4], b[5], b[6], b[7]]), read([b[8], b[9], b[10], b[11]])];
    (position, word_of(read([b[12], b[13], b[14], b[15]])))
}

/// Returns the 16-bit word that stands in a file as a floating-point number.
///
/// Some programs take it as unsigned: 65,535, at the origin, where others have -1. Some write what is none at all
/// (Saga-3RT: 1.7e38 where a marker was seen, -1 where not): only a negative number is a gap, the rest says nothing.
#[inline]
pub(super) fn word_of(number: f32) -> Option<i16> {
    if (-32768.0..65536.0).contains(&number) {
        Some(number as i32 as i16)
    } else if number < 0.0 {
        Some(GAP)
    } else {
        None
    }
}

/// Takes the points of `N` bytes each out of frames, and turns them.
fn turn<const N: usize>(
    data: &[u8],
    layout: &Layout,
    read: impl Fn(&[u8; N]) -> ([f32; 3], Option<i16>),
) -> Trajectories {
    let (point_count, frame_count) = (layout.point_count, layout.frame_count);
    let mut positions = vec![0.0; 3 * point_count * frame_count];
    let mut words = vec![0; point_count * frame_count];
    let mut odd_word_count = 0;
    let frame_bytes = layout.frame_bytes().max(1);
    let frames_per_turn = (TURN_BYTES / frame_bytes).clamp(8, 512);
    for (turn, frames) in data.chunks(frame_bytes * frames_per_turn).enumerate() {
        let first = turn * frames_per_turn;
        let trajectories = positions.chunks_exact_mut(3 * frame_count).zip(words.chunks_exact_mut(frame_count));
        for (point, (positions, words)) in trajectories.enumerate() {
            let positions = positions.as_chunks_mut::<3>().0.iter_mut().skip(first);
            let places = positions.zip(words.iter_mut().skip(first));
            for (frame, (position, word)) in frames.chunks_exact(frame_bytes).zip(places) {
                let Some(bytes) = frame.get(point * N..).and_then(|rest| rest.first_chunk::<N>()) else { continue };
                let (xyz, found) = read(bytes);
                odd_word_count += usize::from(found.is_none());
                let found = found.unwrap_or(0);
                let is_gap = found < 0 || !xyz.iter().all(|x| x.is_finite());
                *position = if is_gap { [f32::NAN; 3] } else { xyz };
                *word = if is_gap { found | GAP } else { found };
            }
        }
    }
    Trajectories { positions, words, odd_word_count }
}

/// Reads all values of rows of bytes.
fn collect<'a, const N: usize, T>(
    rows: impl Iterator<Item = &'a [u8]>,
    count: usize,
    read: impl Fn([u8; N]) -> T,
) -> Vec<T> {
    let mut values = Vec::with_capacity(count);
    for row in rows {
        values.extend(row.as_chunks::<N>().0.iter().map(|bytes| read(*bytes)));
    }
    values
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_floating_point_word_is_the_sixteen_bits_that_it_was() {
        let table = [
            (0.0, Some(0)),
            (770.0, Some(770)),
            (32767.0, Some(32767)),
            (-1.0, Some(-1)),
            (65535.0, Some(-1)),
            (-1e30, Some(-1)),
            (1.708e38, None),
            (f32::NAN, None),
        ];
        for (number, word) in table {
            assert_eq!(word_of(number), word, "{number}");
        }
    }
}
