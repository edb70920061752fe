//! What an AMC is about, by its first and its last frame.

use super::frame::{frame_number, FrameLayout};
use super::header::read_header;
use super::read::read_first_frame;
use super::Amc;
use crate::tally::Tally;
use crate::text::Lines;
use memchr::memmem::Finder;

impl Amc {
    /// Reads the head and the first frame; also returns how many frames there are.
    ///
    /// The others are only compared with the first: as many lines, words and letters. `None` where anything is unusual,
    /// so that [`Amc::parse`] should look at it: what this says, that would say too.
    pub(crate) fn skim(source: &[u8]) -> Option<(Self, usize)> {
        let source = source.trim_ascii_end();
        let mut lines = Lines::new(source);
        let mut amc = Self { header: read_header(&mut lines).ok()?, frame_count: 1, ..Self::default() };
        let mut at = lines.at();
        amc.first_frame = read_first_frame(&mut lines, &mut amc).ok()?;
        if source.get(..lines.at())?.contains(&0) {
            return None;
        }
        // Every frame begins with the first bone: its name is found faster than the number on the line above.
        let first_bone = [b"\n", amc.bones.first()?.name.as_bytes(), b" "].concat();
        let finder = Finder::new(&first_bone);
        let words = amc.width() + amc.bones.len();
        let (mut wanted, mut count, mut last) = (None, 0, at);
        while at < source.len() {
            let (number, frame, next) = frame(source, at, &finder)?;
            let tally = Tally::of(frame);
            let shape = Tally { points: 0, ..tally };
            let is_regular = shape.words == words && shape.lines + 1 == amc.bones.len();
            let is_next = amc.first_frame.checked_add(count) == Some(number);
            if !is_next || !is_regular || tally.points > words || *wanted.get_or_insert(shape) != shape {
                return None;
            }
            (last, at) = (at, next);
            count += 1;
        }
        FrameLayout::new(&amc.bones).read_usual(source, last, &mut Vec::new())?;
        Some((amc, usize::try_from(count).ok()?))
    }
}

/// Returns the number of the frame at byte `at`, its lines, and where the next frame begins.
fn frame<'a>(source: &'a [u8], at: usize, first_bone: &Finder<'_>) -> Option<(i64, &'a [u8], usize)> {
    let (number, rest) = frame_number(source.get(at..)?)?;
    let length = match first_bone.find(rest) {
        Some(next) => memchr::memrchr(b'\n', rest.get(..next)?)?,
        None => rest.len(),
    };
    let start = source.len() - rest.len();
    Some((number, rest.get(..length)?, start + length + 1))
}
