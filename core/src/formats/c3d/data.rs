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
        let (data, layout) = (self.data(), &self.layout);
        match (layout.storage, self.index.processor()) {
            (Storage::Integer, Processor::Intel | Processor::Dec) => {
                turn(data, layout, integers(layout, i16::from_le_bytes))
            }
            (Storage::Integer, Processor::Mips) => turn(data, layout, integers(layout, i16::from_be_bytes)),
            (Storage::Float, Processor::Intel) => turn(data, layout, floats(f32::from_le_bytes)),
            (Storage::Float, Processor::Dec) => turn(data, layout, floats(vax::to_f32)),
            (Storage::Float, Processor::Mips) => turn(data, layout, floats(f32::from_be_bytes)),
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

/// A point as it is read: its position, also where it is a gap, and its word, where that is one.
type Point = ([f32; 3], Option<i16>);

/// Reads points of four integers.
fn integers(layout: &Layout, read: impl Fn([u8; 2]) -> i16) -> impl Fn(&[u8; 8]) -> Point {
    let scale = layout.scale;
    move |b| {
        let position = [[b[0], b[1]], [b[2], b[3]], [b[4], b[5]]].map(|x| f32::from(read(x)) * scale);
        (position, Some(read([b[6], b[7]])))
    }
}

/// Reads points of four floating-point numbers.
fn floats(read: impl Fn([u8; 4]) -> f32) -> impl Fn(&[u8; 16]) -> Point {
    move |b| {
        let position = [[b[0], b[1], b[2], b[3]], [b[4], b[5], b[6], b[7]], [b[8], b[9], b[10], b[11]]].map(&read);
        (position, word_of(read([b[12], b[13], b[14], b[15]])))
    }
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
fn turn<const N: usize>(data: &[u8], layout: &Layout, read: impl Fn(&[u8; N]) -> Point) -> Trajectories {
    let (point_count, frame_count) = (layout.point_count, layout.frame_count);
    let mut positions = vec![0.0; 3 * point_count * frame_count];
    let mut words = vec![0; point_count * frame_count];
    let (mut odd_word_count, mut is_finite) = (0, true);
    let frame_bytes = layout.frame_bytes().max(1);
    let frames_per_turn = (TURN_BYTES / frame_bytes).clamp(8, 512);
    for (turn, frames) in data.chunks(frame_bytes * frames_per_turn).enumerate() {
        let first = turn * frames_per_turn;
        let points_of = |frame| <[u8]>::get(frame, ..layout.point_bytes()).unwrap_or_default().as_chunks::<N>().0;
        let frames: Vec<&[[u8; N]]> = frames.chunks_exact(frame_bytes).map(points_of).collect();
        let trajectories = positions.chunks_exact_mut(3 * frame_count).zip(words.chunks_exact_mut(frame_count));
        for (point, (positions, words)) in trajectories.enumerate() {
            let positions = positions.as_chunks_mut::<3>().0.get_mut(first..).unwrap_or_default();
            let words = words.get_mut(first..).unwrap_or_default();
            for ((points, position), word) in frames.iter().zip(positions).zip(words) {
                let Some(bytes) = points.get(point) else { continue };
                let (xyz, found) = read(bytes);
                odd_word_count += usize::from(found.is_none());
                *word = found.unwrap_or(0);
                // All bits set are no number: a gap has them, by its sign, without a branch.
                let gap = (i32::from(*word) >> 31) as u32;
                *position = xyz.map(|x| f32::from_bits(x.to_bits() | gap));
                is_finite &= xyz.iter().all(|x| x.abs() < f32::INFINITY);
            }
        }
    }
    if !is_finite {
        mark_damaged(&mut positions, &mut words);
    }
    Trajectories { positions, words, odd_word_count }
}

/// Makes gaps of positions that are no place.
#[cold]
fn mark_damaged(positions: &mut [f32], words: &mut [i16]) {
    for (position, word) in positions.as_chunks_mut::<3>().0.iter_mut().zip(words) {
        if !position.iter().all(|x| x.is_finite()) {
            *position = [f32::NAN; 3];
            *word |= GAP;
        }
    }
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
