//! The fast version of reading a frame: it takes frames that are written as nearly all are, and leaves the others alone.

use super::AmcBone;
use crate::formats::parts::read_row;
use crate::text::end_of_line;

/// What a usual frame looks like: the bones of the first frame, in the same order.
pub(super) struct FrameLayout {
    /// The names, one after the other, each with the blank that follows it.
    names: Vec<u8>,
    /// For each bone the length of its name with the blank, and how many values follow.
    bones: Vec<(usize, usize)>,
    /// How many values a frame has.
    pub(super) width: usize,
}

impl FrameLayout {
    pub(super) fn new(bones: &[AmcBone]) -> Self {
        let names = bones.iter().flat_map(|bone| bone.name.bytes().chain([b' '])).collect();
        let width = bones.iter().map(|bone| bone.width).sum();
        Self { names, bones: bones.iter().map(|bone| (bone.name.len() + 1, bone.width)).collect(), width }
    }

    /// Returns how many lines a usual frame has.
    pub(super) fn line_count(&self) -> usize {
        1 + self.bones.len()
    }

    /// Reads a frame at byte `at` if it has one line per bone in the usual order, with nothing else between, and returns
    /// its number and where the next begins. Anything unusual is `None`, with `values` as they were.
    pub(super) fn read_usual(&self, source: &[u8], at: usize, values: &mut Vec<f64>) -> Option<(i64, usize)> {
        let start = values.len();
        values.resize(start + self.width, 0.0);
        let frame = self.read(source.get(at..)?, values.get_mut(start..)?);
        if frame.is_none() {
            values.truncate(start);
        }
        let (number, rest) = frame?;
        Some((number, source.len() - rest.len()))
    }

    /// Reads the usual frame that a text begins with into a row: returns its number and the text behind it.
    #[inline]
    pub(super) fn read<'a>(&self, source: &'a [u8], mut row: &mut [f64]) -> Option<(i64, &'a [u8])> {
        let (number, mut rest) = frame_number(source)?;
        let mut names = self.names.as_slice();
        for (name_length, width) in &self.bones {
            let (name, later_names) = names.split_at_checked(*name_length)?;
            let (values, later_values) = std::mem::take(&mut row).split_at_mut_checked(*width)?;
            (names, row) = (later_names, later_values);
            rest = read_row(rest.strip_prefix(name)?, values)?;
        }
        Some((number, rest))
    }
}

/// Reads up to eighteen digits alone on a line.
#[inline]
pub(super) fn frame_number(source: &[u8]) -> Option<(i64, &[u8])> {
    let length = source.iter().take(19).take_while(|byte| byte.is_ascii_digit()).count();
    let (digits, rest) = source.split_at_checked(length)?;
    if !(1..19).contains(&length) {
        return None;
    }
    let number = digits.iter().fold(0, |number, digit| 10 * number + i64::from(digit - b'0'));
    Some((number, end_of_line(rest)?))
}
