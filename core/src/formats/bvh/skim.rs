//! What a BVH is about, by some of its frames.

use super::tokens::Tokens;
use super::{hierarchy, rows, Bvh, BvhMotion};
use crate::formats::parts::read_row;
use crate::infer::frames_to_look_at;
use crate::table::Table;

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
        let frames = Table::of(source.get(tokens.at()..)?)?;
        let count = frames.line_count();
        let is_usual = frames.total.others == 0 && frames.is_of_rows(1, width, |tally| tally.words);
        if !is_usual || usize::try_from(head.frame_count?) != Ok(count) {
            return None;
        }
        let chosen: Vec<usize> = frames_to_look_at(count, bvh.joints.len()).collect();
        let mut values = vec![0.0; chosen.len() * width];
        for (frame, row) in chosen.iter().zip(values.chunks_exact_mut(width)) {
            read_row(frames.at_line(*frame)?, row)?;
        }
        bvh.motion = Some(BvhMotion { frame_time_s: head.frame_time_s, frame_count: chosen.len(), values });
        Some((bvh, count))
    }
}
