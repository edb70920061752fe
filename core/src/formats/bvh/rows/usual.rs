//! The fast version: one line per frame, nothing else, on all threads.

use crate::number::read_prefix;
use crate::text::{end_of_line, skip_blanks, LARGEST};
use rayon::prelude::*;

/// A thread gets at least this much text: less is read before another has woken up.
const CHUNK_BYTES: usize = 1 << 17;

/// Parts per thread, so that one that was interrupted does not keep the others waiting.
const CHUNKS_PER_THREAD: usize = 4;

/// Reads all values of a text in which every line that is not blank has exactly `width` numbers. Anything else is `None`.
///
/// Each part of the text is read into its own part of the result, which is as large as its lines ask for.
pub(super) fn read(text: &[u8], width: usize) -> Option<Vec<f64>> {
    let chunks = split_at_lines(text);
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

/// Splits a text into parts that begin where lines do.
fn split_at_lines(text: &[u8]) -> Vec<&[u8]> {
    let threads = rayon::current_num_threads();
    let count = if threads == 1 { 1 } else { (text.len() / CHUNK_BYTES).clamp(1, threads * CHUNKS_PER_THREAD) };
    let length = text.len().div_ceil(count);
    let mut chunks = Vec::with_capacity(count);
    let mut rest = text;
    while rest.len() > length {
        let after = rest.get(length..).unwrap_or_default();
        let end = after.iter().position(|byte| *byte == b'\n').map_or(rest.len(), |at| length + at + 1);
        let (chunk, others) = rest.split_at(end);
        chunks.push(chunk);
        rest = others;
    }
    chunks.push(rest);
    chunks
}

/// Returns how many lines there are, blank ones too.
fn count_lines(text: &[u8]) -> usize {
    // As many bytes at a time as a byte can count: that adds up 16 of them in one step.
    let ends_in = |block: &[u8]| block.iter().map(|byte| u8::from(*byte == b'\n')).sum::<u8>();
    let ends = text.chunks(u8::MAX.into()).map(|block| usize::from(ends_in(block))).sum::<usize>();
    ends + usize::from(!matches!(text.last(), None | Some(b'\n')))
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

/// Fills a row with the numbers that a text begins with, and returns the text from the next line on. `None` where the line
/// has fewer, more, or others.
#[inline]
pub(in super::super) fn read_row<'a>(mut text: &'a [u8], row: &mut [f64]) -> Option<&'a [u8]> {
    for value in row {
        text = skip_blanks(text);
        let (number, length) = read_prefix(text)?;
        text = text.get(length..)?;
        // Also refuses what is not finite, and a number that is the start of a longer word.
        let is_usable = number.abs() <= LARGEST;
        if !is_usable || !text.first().is_none_or(u8::is_ascii_whitespace) {
            return None;
        }
        *value = number;
    }
    end_of_line(text)
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
