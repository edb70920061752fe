//! What a BVH is about, by some of its frames.

use super::tokens::Tokens;
use super::{hierarchy, rows, Bvh, BvhMotion};
use crate::formats::parts::read_row;
use crate::infer::frames_to_look_at;
use crate::tally::Tally;

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
        let text = source.get(tokens.at()..)?;
        let declared = usize::try_from(head.frame_count?).ok()?;
        let frames = lines_of_numbers(text, width, declared)?;
        if width == 0 || frames.len() != declared {
            return None;
        }
        let chosen: Vec<usize> = frames_to_look_at(frames.len(), bvh.joints.len()).collect();
        let mut values = vec![0.0; chosen.len() * width];
        for (frame, row) in chosen.iter().zip(values.chunks_exact_mut(width)) {
            read_row(text.get(*frames.get(*frame)?..)?, row)?;
        }
        bvh.motion = Some(BvhMotion { frame_time_s: head.frame_time_s, frame_count: chosen.len(), values });
        Some((bvh, frames.len()))
    }
}

/// Returns where the lines of a text begin, blank ones left out, if all others look like so many numbers.
///
/// A carriage return within a line ends one too, but what it divides is one frame for the reader as well.
fn lines_of_numbers(text: &[u8], width: usize, declared: usize) -> Option<Vec<usize>> {
    // A value takes two bytes at least: what a file says of itself asks for no more memory than its size allows.
    let mut lines = Vec::with_capacity(declared.min(text.len() / 2));
    let mut at = 0;
    while let Some(rest) = text.get(at..).filter(|rest| !rest.is_empty()) {
        let length = memchr::memchr(b'\n', rest).unwrap_or(rest.len());
        let tally = Tally::of(rest.get(..length)?);
        if tally.words > 0 {
            if !tally.is_numbers(width) {
                return None;
            }
            lines.push(at);
        }
        at += length + 1;
    }
    Some(lines)
}
