//! The data section where it lies: any sample is found without reading the others.
//!
//! A file has all points of a frame side by side, then the analog samples of that frame; whoever wants a trajectory jumps
//! from frame to frame. All of them at once are turned block by block (see [`super::turn`]).

use super::encoding::{Processor, Storage};
use super::layout::Layout;
use crate::text::LARGEST;
use std::sync::Arc;

/// The word of a sample that is none.
pub(super) const GAP: i16 = -1;

/// The frames of a file, in its bytes. A copy costs nothing.
#[derive(Debug, Clone)]
pub struct Frames {
    /// The whole file.
    pub(super) bytes: Arc<Vec<u8>>,
    pub(super) layout: Layout,
    pub(super) processor: Processor,
}

impl Frames {
    /// Returns how many frames there are.
    pub(crate) fn frame_count(&self) -> usize {
        self.layout.frame_count
    }

    /// Returns how many points a frame has.
    pub(crate) fn point_count(&self) -> usize {
        self.layout.point_count
    }

    /// Returns what residuals are multiplied by.
    pub(crate) fn scale(&self) -> f32 {
        self.layout.scale
    }

    /// Returns how many analog values there are.
    pub(crate) fn analog_count(&self) -> usize {
        self.layout.frame_count * self.layout.analog_per_frame()
    }

    /// Returns the bytes of the frames.
    pub(super) fn data(&self) -> &[u8] {
        let start = self.layout.data_start;
        let length = self.layout.frame_count * self.layout.frame_bytes();
        self.bytes.get(start..start + length).unwrap_or_default()
    }

    /// Returns where a point is on a frame; `None` in a gap, or where there is no such sample.
    #[inline]
    pub(crate) fn position(&self, point: usize, frame: usize) -> Option<[f32; 3]> {
        let position = match self.layout.storage {
            Storage::Integer => {
                let [x, y, z, word] = self.integers(point, frame)?;
                (word >= 0).then(|| [x, y, z].map(|x| f32::from(x) * self.layout.scale))
            }
            Storage::Float => {
                let [x, y, z, word] = self.floats(point, frame)?;
                (!is_gap(word)).then_some([x, y, z])
            }
        };
        position.filter(is_place)
    }

    /// Returns the word of cameras and residual: negative in a gap, 0 where a file has no such word.
    pub(crate) fn word(&self, point: usize, frame: usize) -> i16 {
        let word = match self.layout.storage {
            Storage::Integer => self.integers(point, frame).map(|[.., word]| word),
            Storage::Float => self.floats(point, frame).map(|[.., word]| word_of(word).unwrap_or(0)),
        };
        match word {
            Some(word) if word < 0 || self.position(point, frame).is_some() => word,
            _ => GAP,
        }
    }

    /// Returns whether the word of a sample is no word of cameras and residual.
    pub(super) fn has_odd_word(&self, point: usize, frame: usize) -> bool {
        let is_float = self.layout.storage == Storage::Float;
        is_float && self.floats(point, frame).is_some_and(|[.., word]| word_of(word).is_none())
    }

    /// Returns an analog value, unscaled: sample after sample, and for each sample channel after channel.
    #[inline]
    pub(crate) fn analog(&self, at: usize, is_unsigned: bool) -> Option<f64> {
        let per_frame = self.layout.analog_per_frame();
        let (frame, index) = (at.checked_div(per_frame)?, at.checked_rem(per_frame)?);
        let bytes = self.frame(frame)?.get(self.layout.point_bytes()..)?;
        Some(match self.layout.storage {
            Storage::Float => self.processor.f32(*bytes.as_chunks().0.get(index)?).into(),
            Storage::Integer if is_unsigned => self.processor.u16(*bytes.as_chunks().0.get(index)?).into(),
            Storage::Integer => self.processor.i16(*bytes.as_chunks().0.get(index)?).into(),
        })
    }

    #[inline]
    fn frame(&self, frame: usize) -> Option<&[u8]> {
        if frame >= self.layout.frame_count {
            return None;
        }
        let length = self.layout.frame_bytes();
        let start = self.layout.data_start + frame * length;
        self.bytes.get(start..start + length)
    }

    #[inline]
    fn integers(&self, point: usize, frame: usize) -> Option<[i16; 4]> {
        let points = self.frame(frame)?.get(..self.layout.point_bytes())?.as_chunks::<8>().0;
        let bytes = points.get(point)?;
        let [x, y, z, word] = [[bytes[0], bytes[1]], [bytes[2], bytes[3]], [bytes[4], bytes[5]], [bytes[6], bytes[7]]];
        Some([x, y, z, word].map(|bytes| self.processor.i16(bytes)))
    }

    #[inline]
    fn floats(&self, point: usize, frame: usize) -> Option<[f32; 4]> {
        let points = self.frame(frame)?.get(..self.layout.point_bytes())?.as_chunks::<16>().0;
        let four = points.get(point)?.as_chunks::<4>().0;
        let mut numbers = [0.0; 4];
        numbers.iter_mut().zip(four).for_each(|(number, bytes)| *number = self.processor.f32(*bytes));
        Some(numbers)
    }
}

/// Returns the 16-bit word that stands in a file as a floating-point number.
///
/// Some programs take it as unsigned: 65,535, at the origin, where others have -1. Some write what is none at all
/// (Saga-3RT: 1.7e38 where a marker was seen, -1 where not): only a negative number is a gap, the rest says nothing.
#[inline]
pub(super) fn word_of(number: f32) -> Option<i16> {
    if number < 0.0 {
        Some(if number >= -32768.0 { (number as i32 as i16).min(GAP) } else { GAP })
    } else if number < 65536.0 {
        Some(number as i32 as i16)
    } else {
        None
    }
}

/// Whether coordinates can be those of a place, and are no damage.
#[inline]
pub(super) fn is_place(position: &[f32; 3]) -> bool {
    // What is no number is not smaller than anything.
    position.iter().all(|x| x.abs() <= LARGEST as f32)
}

/// Whether a floating-point word marks a gap, as [`word_of`] has it.
#[inline]
pub(super) fn is_gap(number: f32) -> bool {
    // Without branches: this decides on every sample.
    (number < 0.0) | ((number >= 32768.0) & (number < 65536.0))
}

/// The same values, however they are stored.
impl PartialEq for Frames {
    fn eq(&self, other: &Self) -> bool {
        let layout = |frames: &Self| (frames.point_count(), frames.frame_count(), frames.layout.channel_count);
        let samples =
            || (0..self.point_count()).flat_map(|point| (0..self.frame_count()).map(move |frame| (point, frame)));
        let is_same = |(point, frame)| {
            self.position(point, frame) == other.position(point, frame)
                && self.word(point, frame) == other.word(point, frame)
        };
        let is_same_analog = |at| self.analog(at, false) == other.analog(at, false);
        layout(self) == layout(other) && samples().all(is_same) && (0..self.analog_count()).all(is_same_analog)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn a_floating_point_word_is_the_sixteen_bits_that_it_was() {
        let table = [
            (0.0, Some(0)),
            (770.0, Some(770)),
            (32767.0, Some(32767)),
            (-1.0, Some(-1)),
            (-0.5, Some(-1)),
            (65535.0, Some(-1)),
            (-1e30, Some(-1)),
            (1.708e38, None),
            (f32::NAN, None),
        ];
        for (number, word) in table {
            assert_eq!(word_of(number), word, "{number}");
        }
    }

    proptest! {
        #[test]
        fn a_gap_is_a_negative_word(bits in any::<u32>(), near in -70_000.0..70_000.0_f32) {
            for number in [f32::from_bits(bits), near] {
                prop_assert_eq!(is_gap(number), word_of(number).is_some_and(|word| word < 0), "{}", number);
            }
        }
    }
}
