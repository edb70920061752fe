//! From frames to trajectories, all at once.
//!
//! A block of frames is turned at a time, few enough to stay in the cache while every point takes its samples from them.

use super::encoding::{Processor, Storage};
use super::frames::{is_gap, is_place, word_of, Frames, GAP};
use super::vax;
use rayon::prelude::*;

/// How many bytes of frames are turned at a time.
const TURN_BYTES: usize = 64 * 1024;

/// From so many values on it pays to wake other threads.
const PARALLEL_VALUES: usize = 1 << 20;

impl Frames {
    /// Returns x, y and z of every sample, point after point; not numbers in a gap.
    pub(crate) fn positions(&self) -> Vec<f32> {
        let scale = self.layout.scale;
        match (self.layout.storage, self.processor) {
            (Storage::Integer, Processor::Intel | Processor::Dec) => self.scaled(scale, i16::from_le_bytes),
            (Storage::Integer, Processor::Mips) => self.scaled(scale, i16::from_be_bytes),
            (Storage::Float, Processor::Intel) => self.unscaled(f32::from_le_bytes),
            (Storage::Float, Processor::Dec) => self.unscaled(vax::to_f32),
            (Storage::Float, Processor::Mips) => self.unscaled(f32::from_be_bytes),
        }
    }

    /// Returns the word of every sample, point after point; negative in a gap, 0 where it is none.
    pub(crate) fn words(&self) -> Vec<i16> {
        let processor = self.processor;
        match self.layout.storage {
            Storage::Integer => self.turn(|b: &[u8; 8]| [processor.i16([b[6], b[7]])]),
            Storage::Float => self.turn(|b: &[u8; 16]| {
                let [x, y, z, word] = four(b, |bytes| processor.f32(bytes));
                let word = word_of(word).unwrap_or(0);
                [if is_place(&[x, y, z]) { word } else { word | GAP }]
            }),
        }
    }

    /// Returns for every sample whether the marker was seen, point after point.
    pub(crate) fn seen(&self) -> Vec<bool> {
        let (processor, scale) = (self.processor, self.layout.scale);
        match self.layout.storage {
            Storage::Integer => self.turn(|b: &[u8; 8]| {
                let [x, y, z, word] = [[b[0], b[1]], [b[2], b[3]], [b[4], b[5]], [b[6], b[7]]];
                let place = [x, y, z].map(|bytes| f32::from(processor.i16(bytes)) * scale);
                [processor.i16(word) >= 0 && is_place(&place)]
            }),
            Storage::Float => self.turn(|b: &[u8; 16]| {
                let [x, y, z, word] = four(b, |bytes| processor.f32(bytes));
                [!is_gap(word) && is_place(&[x, y, z])]
            }),
        }
    }

    /// Returns every `step`th analog value from `first` on, of as many as a frame has samples.
    pub(crate) fn channel(&self, first: usize, step: usize, is_unsigned: bool) -> Vec<f64> {
        let processor = self.processor;
        let frames = self.data().chunks_exact(self.layout.frame_bytes().max(1));
        let analog = frames.map(|frame| frame.get(self.layout.point_bytes()..).unwrap_or_default());
        let step = step.max(1);
        let mut values = Vec::with_capacity(self.analog_count() / step);
        for frame in analog {
            match self.layout.storage {
                Storage::Float => {
                    let own = frame.as_chunks().0.iter().skip(first).step_by(step);
                    values.extend(own.map(|bytes| f64::from(processor.f32(*bytes))));
                }
                Storage::Integer => {
                    let own = frame.as_chunks().0.iter().skip(first).step_by(step);
                    let number = |bytes| {
                        if is_unsigned {
                            f64::from(processor.u16(bytes))
                        } else {
                            f64::from(processor.i16(bytes))
                        }
                    };
                    values.extend(own.map(|bytes| number(*bytes)));
                }
            }
        }
        values
    }

    fn scaled(&self, scale: f32, read: impl Fn([u8; 2]) -> i16 + Sync) -> Vec<f32> {
        self.turn(|b: &[u8; 8]| {
            let gap = mask(read([b[6], b[7]]) < 0);
            [[b[0], b[1]], [b[2], b[3]], [b[4], b[5]]].map(|x| or(f32::from(read(x)) * scale, gap))
        })
    }

    fn unscaled(&self, read: impl Fn([u8; 4]) -> f32 + Sync) -> Vec<f32> {
        self.turn(|b: &[u8; 16]| {
            let [x, y, z, word] = four(b, &read);
            let gap = mask(is_gap(word) | !is_place(&[x, y, z]));
            [or(x, gap), or(y, gap), or(z, gap)]
        })
    }

    /// Reads something of every point, of which each takes `N` bytes of its frame, into `M` values; of large files on all
    /// threads.
    fn turn<const N: usize, const M: usize, T: Copy + Default + Send>(
        &self,
        read: impl Fn(&[u8; N]) -> [T; M] + Sync,
    ) -> Vec<T> {
        let (point_count, frame_count) = (self.point_count(), self.frame_count());
        let mut values = vec![T::default(); M * point_count * frame_count];
        if values.len() < PARALLEL_VALUES {
            self.turn_points(0, &mut values, &read);
        } else {
            let points = point_count.div_ceil(rayon::current_num_threads()).max(1);
            let parts = values.par_chunks_mut(M * frame_count * points).enumerate();
            parts.for_each(|(part, values)| self.turn_points(part * points, values, &read));
        }
        values
    }

    /// Reads as many points as there is room for, from `first_point` on.
    fn turn_points<const N: usize, const M: usize, T>(
        &self,
        first_point: usize,
        values: &mut [T],
        read: impl Fn(&[u8; N]) -> [T; M],
    ) {
        let frame_count = self.frame_count();
        let (frame_bytes, point_bytes) = (self.layout.frame_bytes().max(1), self.layout.point_bytes());
        let frames_per_turn = (TURN_BYTES / frame_bytes).clamp(8, 512);
        for (turn, frames) in self.data().chunks(frame_bytes * frames_per_turn).enumerate() {
            let first = turn * frames_per_turn;
            let points_of = |frame| <[u8]>::get(frame, ..point_bytes).unwrap_or_default().as_chunks::<N>().0;
            let frames: Vec<&[[u8; N]]> = frames.chunks_exact(frame_bytes).map(points_of).collect();
            for (point, trajectory) in (first_point..).zip(values.chunks_exact_mut(M * frame_count)) {
                let places = trajectory.as_chunks_mut::<M>().0.get_mut(first..).unwrap_or_default();
                for (points, place) in frames.iter().zip(places) {
                    if let Some(bytes) = points.get(point) {
                        *place = read(bytes);
                    }
                }
            }
        }
    }
}

#[inline]
fn four(b: &[u8; 16], read: impl Fn([u8; 4]) -> f32) -> [f32; 4] {
    [[b[0], b[1], b[2], b[3]], [b[4], b[5], b[6], b[7]], [b[8], b[9], b[10], b[11]], [b[12], b[13], b[14], b[15]]]
        .map(read)
}

/// All bits set, or none.
#[inline]
fn mask(is_gap: bool) -> u32 {
    u32::from(is_gap).wrapping_neg()
}

/// No number where the mask is set: without a branch.
#[inline]
fn or(x: f32, mask: u32) -> f32 {
    f32::from_bits(x.to_bits() | mask)
}
