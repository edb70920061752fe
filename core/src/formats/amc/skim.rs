//! What an AMC is about, by some of its frames.

use super::frame::FrameLayout;
use super::header::read_header;
use super::read::read_first_frame;
use super::Amc;
use crate::table::Table;
use crate::tally::Tally;
use crate::text::Lines;

/// So many frames are read, spread over the motion from the first to the last.
const LOOKS: usize = 4;

impl Amc {
    /// Reads the head and the first frame; also returns how many frames there are.
    ///
    /// The others are only compared with the first: as many lines, words and letters. `None` where anything is unusual,
    /// so that [`Amc::parse`] should look at it: what this says, that would say too.
    pub(crate) fn skim(source: &[u8]) -> Option<(Self, usize)> {
        let mut lines = Lines::new(source);
        let mut amc = Self { header: read_header(&mut lines).ok()?, frame_count: 1, ..Self::default() };
        let start = lines.at();
        amc.first_frame = read_first_frame(&mut lines, &mut amc).ok()?;
        if source.get(..lines.at())?.contains(&0) {
            return None;
        }
        let frames = Table::of(source.get(start..)?)?;
        let first = Tally::of(source.get(start..lines.at())?);
        // Its number stands on a line of its own.
        let (line_count, word_count) = (1 + amc.bones.len(), 1 + amc.width() + amc.bones.len());
        let count = frames.line_count() / line_count;
        let is_as_first = frames.total.others == first.others * count
            && frames.total.sum == first.sum.wrapping_mul(count as u8)
            && frames.is_of_rows(line_count, word_count, |tally| tally.words);
        if !is_as_first {
            return None;
        }
        let layout = FrameLayout::new(&amc.bones);
        let mut values = Vec::with_capacity(LOOKS * amc.width());
        for frame in (0..LOOKS).map(|look| look * (count - 1) / (LOOKS - 1)) {
            let (number, _) = layout.read_usual(frames.at_line(frame * line_count)?, 0, &mut values)?;
            if amc.first_frame.checked_add_unsigned(frame as u64) != Some(number) {
                return None;
            }
        }
        Some((amc, count))
    }
}
