//! Text of numbers in parts, one after the other for each thread that reads them.

use crate::number::read_prefix;
use crate::text::{end_of_line, skip_blanks, LARGEST};

/// A thread gets at least this much text: less is read before another has woken up.
const PART_BYTES: usize = 1 << 17;

/// Parts per thread, so that one that was interrupted does not keep the others waiting.
const PARTS_PER_THREAD: usize = 4;

/// Splits a text into parts that begin where lines do. `to_start` says how far it is from a line, with all that follows, to
/// one with which a part may begin.
pub(super) fn split(text: &[u8], to_start: impl Fn(&[u8]) -> usize) -> Vec<&[u8]> {
    let threads = rayon::current_num_threads();
    let count = if threads == 1 { 1 } else { (text.len() / PART_BYTES).clamp(1, threads * PARTS_PER_THREAD) };
    let length = text.len().div_ceil(count);
    let mut parts = Vec::with_capacity(count);
    let mut rest = text;
    while rest.len() > length {
        let after = rest.get(length..).unwrap_or_default();
        let line = after.iter().position(|byte| *byte == b'\n').map_or(rest.len(), |at| length + at + 1);
        let end = line + to_start(rest.get(line..).unwrap_or_default());
        let Some((part, others)) = rest.split_at_checked(end) else { break };
        parts.push(part);
        rest = others;
    }
    parts.push(rest);
    parts
}

/// Returns how many lines there are, blank ones too.
pub(super) fn count_lines(text: &[u8]) -> usize {
    // As many bytes at a time as a byte can count: that adds up 16 of them in one step.
    let ends_in = |block: &[u8]| block.iter().map(|byte| u8::from(*byte == b'\n')).sum::<u8>();
    let ends = text.chunks(u8::MAX.into()).map(|block| usize::from(ends_in(block))).sum::<usize>();
    ends + usize::from(!matches!(text.last(), None | Some(b'\n')))
}

/// Fills a row with the numbers that a text begins with, and returns the text from the next line on. `None` where the line
/// has fewer, more, or others.
#[inline]
pub(super) fn read_row<'a>(mut text: &'a [u8], row: &mut [f64]) -> Option<&'a [u8]> {
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn parts_begin_where_they_may_and_are_the_whole_text() {
        let text = "1\n2 3\n4\n".repeat(100_000);
        let pool = rayon::ThreadPoolBuilder::new().num_threads(3).build().expect("threads can be made");
        for starts in [b"1".as_slice(), b"4", b"none"] {
            let to_start = |rest: &[u8]| rest.windows(starts.len()).position(|at| at == starts).unwrap_or(rest.len());
            let parts = pool.install(|| split(text.as_bytes(), to_start));
            assert_eq!(parts.concat(), text.as_bytes());
            assert!(parts.iter().skip(1).all(|part| part.is_empty() || part.starts_with(starts)));
            assert!(parts.len() > 3 || starts == b"none");
            assert_eq!(parts.iter().map(|part| count_lines(part)).sum::<usize>(), 300_000);
        }
    }

    #[test]
    fn a_last_line_needs_no_end() {
        assert_eq!([&b""[..], b"1", b"1\n", b"1\n2", b"\n\n"].map(count_lines), [0, 1, 1, 2, 2]);
    }
}
