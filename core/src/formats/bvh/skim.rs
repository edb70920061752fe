//! What a BVH is about, by some of its frames.

use super::tokens::Tokens;
use super::{hierarchy, rows, Bvh, BvhMotion};
use crate::infer::frames_to_look_at;
use crate::number;
use crate::tally::Tally;
use crate::text::LARGEST;

impl Bvh {
    /// Reads the hierarchy and only those frames that say how the figure stands; also returns how many there are.
    ///
    /// `None` where anything is unusual, so that [`Bvh::parse`] should look at it: what this says, that would say too.
    pub(crate) fn skim(source: &[u8]) -> Option<(Self, usize)> {
        let mut tokens = Tokens::new(source);
        let joints = hierarchy::read(&mut tokens).ok()?;
        tokens.next()?;
        let head = rows::read_head(&mut tokens).ok()?;
        let mut bvh = Self::new(joints, None);
        let width = bvh.width();
        let frames = lines_of_numbers(source.get(tokens.at()..)?, width)?;
        if width == 0 || head.frame_count != Some(frames.len() as u64) {
            return None;
        }
        let mut values = Vec::new();
        let mut count = 0;
        for frame in frames_to_look_at(frames.len(), bvh.joints.len()) {
            let words = frames.get(frame)?.split(u8::is_ascii_whitespace).filter(|word| !word.is_empty());
            for word in words {
                values.push(number::read(word).filter(|value| value.abs() <= LARGEST)?);
            }
            count += 1;
        }
        bvh.motion = Some(BvhMotion { frame_time_s: head.frame_time_s, frame_count: count, values });
        Some((bvh, frames.len()))
    }
}

/// Returns the lines of a text, blank ones left out, if all others look like so many numbers.
///
/// A carriage return within a line ends one too, but what it divides is one frame for the reader as well.
fn lines_of_numbers(text: &[u8], width: usize) -> Option<Vec<&[u8]>> {
    let mut lines = Vec::new();
    let mut rest = text;
    while !rest.is_empty() {
        let length = memchr::memchr(b'\n', rest).unwrap_or(rest.len());
        let (line, later) = rest.split_at(length);
        rest = later.get(1..).unwrap_or_default();
        let tally = Tally::of(line);
        if tally.words == 0 {
            continue;
        }
        if !tally.is_numbers(width) {
            return None;
        }
        lines.push(line);
    }
    Some(lines)
}
