//! The fast version: one line per frame, nothing else, on all threads.

use crate::formats::parts::{count_lines, read_row, split};
use rayon::prelude::*;

/// Reads all values of a text in which every line that is not blank has exactly `width` numbers. Anything else is `None`.
///
/// Each part of the text is read into its own part of the result, which is as large as its lines ask for.
pub(super) fn read(text: &[u8], width: usize) -> Option<Vec<f64>> {
    let chunks = split(text, |_| 0);
    let line_counts: Vec<usize> = chunks.par_iter().map(|chunk| count_lines(chunk)).collect();
    let count = line_counts.iter().sum::<usize>().checked_mul(width)?;
    // A value takes two bytes at least, but for the last; a file of blank lines must not ask for more memory than that.
    if width == 0 || count > text.len() / 2 + width {
        return None;
    }
    let mut values = vec![0.0; count];
    let mut rest = values.as_mut_slice();
    let parts = chunks.iter().zip(&line_counts).map(|(chunk, line_count)| {
        let (part, others) = std::mem::take(&mut rest).split_at_mut(line_count * width);
        rest = others;
        (*chunk, part)
    });
    let parts: Vec<_> = parts.collect();
    let filled: Vec<usize> =
        parts.into_par_iter().map(|(chunk, part)| read_lines(chunk, width, part)).collect::<Option<_>>()?;
    close_gaps(&mut values, width, &line_counts, &filled);
    Some(values)
}

/// Fills `values` line by line and returns how many lines were not blank.
fn read_lines(mut text: &[u8], width: usize, values: &mut [f64]) -> Option<usize> {
    let mut count = 0;
    for row in values.chunks_exact_mut(width) {
        text = text.trim_ascii_start();
        if text.is_empty() {
            break;
        }
        text = read_row(text, row)?;
        count += 1;
    }
    text.trim_ascii_start().is_empty().then_some(count)
}

/// Moves the values of each part up to those before, where blank lines left room.
fn close_gaps(values: &mut Vec<f64>, width: usize, line_counts: &[usize], filled: &[usize]) {
    let (mut from, mut to) = (0, 0);
    for (lines, filled) in line_counts.iter().zip(filled) {
        if from != to {
            values.copy_within(from..from + filled * width, to);
        }
        from += lines * width;
        to += filled * width;
    }
    values.truncate(to);
}
