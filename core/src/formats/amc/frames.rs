//! The fastest version: all frames are usual ones, with numbers that ascend by one, and are read on all threads.

use super::frame::{frame_number, FrameLayout};
use crate::formats::parts::{count_lines, split};
use rayon::prelude::*;

impl FrameLayout {
    /// Reads the values of all frames of a text that has nothing else, the first one with the number `first`. Anything unusual
    /// is `None`.
    ///
    /// Each part of the text is read into its own part of the result, which is as large as its lines ask for.
    pub(super) fn read_all(&self, text: &[u8], first: i64) -> Option<Vec<f64>> {
        let parts = split(text.trim_ascii_end(), to_frame);
        let line_counts: Vec<usize> = parts.par_iter().map(|part| count_lines(part)).collect();
        let whole = |lines: &usize| lines.is_multiple_of(self.line_count()).then_some(lines / self.line_count());
        let frame_counts: Vec<usize> = line_counts.iter().map(whole).collect::<Option<_>>()?;
        let count = frame_counts.iter().sum::<usize>().checked_mul(self.width)?;
        // A value takes two bytes at least; a file of blank lines must not ask for more memory than that.
        if self.width == 0 || count > text.len() / 2 {
            return None;
        }
        let mut values = vec![0.0; count];
        let mut rest = values.as_mut_slice();
        let mut next = first;
        let mut tasks = Vec::with_capacity(parts.len());
        for (part, frame_count) in parts.into_iter().zip(frame_counts) {
            let (rows, others) = std::mem::take(&mut rest).split_at_mut_checked(frame_count * self.width)?;
            tasks.push((part, rows, next));
            (rest, next) = (others, next.checked_add(i64::try_from(frame_count).ok()?)?);
        }
        tasks.into_par_iter().all(|(part, rows, first)| self.read_part(part, rows, first)).then_some(values)
    }

    /// Fills all rows, and returns whether there was nothing else to read.
    fn read_part(&self, mut text: &[u8], rows: &mut [f64], first: i64) -> bool {
        for (row, expected) in rows.chunks_exact_mut(self.width).zip(first..) {
            match self.read(text, row) {
                Some((number, rest)) if number == expected => text = rest,
                _ => return false,
            }
        }
        text.is_empty()
    }
}

/// Returns how far it is to the next line that holds a number alone.
fn to_frame(text: &[u8]) -> usize {
    let mut rest = text;
    while frame_number(rest).is_none() {
        let Some(end) = memchr::memchr(b'\n', rest) else { return text.len() };
        rest = rest.get(end + 1..).unwrap_or_default();
    }
    text.len() - rest.len()
}
