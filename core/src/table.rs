//! A text of rows of numbers, seen from afar: how many lines and words there are, and where a line begins.
//!
//! Nothing is looked at line by line, for that takes several times as long. Whether each row has its words is checked at
//! the end of every block of some thousand bytes.

use crate::tally::{Tally, BLOCK_BYTES};

/// A text that was looked over.
pub(crate) struct Table<'a> {
    text: &'a [u8],
    /// What the text holds up to the end of each block.
    up_to: Vec<Tally>,
    /// What all of it holds.
    pub(crate) total: Tally,
}

impl<'a> Table<'a> {
    /// Looks over a text, but for the blanks around it. `None` where there is nothing else.
    ///
    /// Lines end in LF: where some end in CR alone, several of them are one here, with too many words.
    pub(crate) fn of(text: &'a [u8]) -> Option<Self> {
        let text = text.trim_ascii();
        let up_to = Tally::up_to_blocks(text);
        let total = *up_to.last()?;
        Some(Self { text, up_to, total })
    }

    /// Returns how many lines there are, blank ones too.
    pub(crate) fn line_count(&self) -> usize {
        self.total.lines + 1
    }

    /// Whether the lines are rows of so many lines and words each, as far as that is seen; `words` counts what is to be
    /// taken for words.
    pub(crate) fn is_of_rows(&self, lines: usize, words: usize, counted: impl Fn(&Tally) -> usize) -> bool {
        if lines == 0 || words == 0 || !self.line_count().is_multiple_of(lines) {
            return false;
        }
        let expected = |tally: &Tally| (tally.lines / lines).checked_mul(words);
        let is_within = |tally: &Tally| {
            expected(tally).is_some_and(|before| (before..=before.saturating_add(words)).contains(&counted(tally)))
        };
        let rows = self.line_count() / lines;
        self.up_to.iter().all(is_within) && rows.checked_mul(words) == Some(counted(&self.total))
    }

    /// Returns the text from a line on, the first of which is 0; `None` behind the last.
    pub(crate) fn at_line(&self, line: usize) -> Option<&'a [u8]> {
        let block = self.up_to.partition_point(|tally| tally.lines < line);
        let lines_before =
            block.checked_sub(1).and_then(|before| self.up_to.get(before)).map_or(0, |tally| tally.lines);
        let rest = self.text.get(block * BLOCK_BYTES..)?;
        let start = match line.checked_sub(lines_before + 1) {
            Some(skipped) => memchr::memchr_iter(b'\n', rest).nth(skipped)? + 1,
            None => 0,
        };
        rest.get(start..)
    }

    /// Returns a line without its end; `None` behind the last.
    pub(crate) fn line(&self, line: usize) -> Option<&'a [u8]> {
        let rest = self.at_line(line)?;
        let line = rest.get(..memchr::memchr(b'\n', rest).unwrap_or(rest.len()))?;
        Some(line.strip_suffix(b"\r").unwrap_or(line))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn is_of_rows(text: &str, lines: usize, words: usize) -> bool {
        Table::of(text.as_bytes()).is_some_and(|table| table.is_of_rows(lines, words, |tally| tally.words))
    }

    #[test]
    fn every_line_is_found_whatever_block_it_is_in() {
        for end in ["\n", "\r\n"] {
            let lines: Vec<String> = (0..5000).map(|number| "9".repeat(number * 7 % 41) + "x").collect();
            let text = format!(" \n{}{end}\n", lines.join(end));
            let table = Table::of(text.as_bytes()).unwrap();
            assert_eq!(table.line_count(), lines.len());
            for (number, line) in lines.iter().enumerate() {
                assert_eq!(table.line(number), Some(line.as_bytes()), "{number}");
                assert!(table.at_line(number).unwrap().starts_with(line.as_bytes()));
            }
            assert_eq!(table.line(lines.len()), None);
        }
    }

    #[test]
    fn a_line_that_is_longer_than_a_block_is_found() {
        let text = format!("1\n{}\n3", "2 ".repeat(3 * BLOCK_BYTES));
        let table = Table::of(text.as_bytes()).unwrap();
        let lines: Vec<_> = (0..3).map(|number| table.line(number).unwrap().first().copied()).collect();
        assert_eq!(lines, [Some(b'1'), Some(b'2'), Some(b'3')]);
    }

    #[test]
    fn rows_have_as_many_lines_and_words() {
        assert!(is_of_rows("1 2\n3 4\n5 6\n", 1, 2));
        assert!(is_of_rows("1\na 2 3\n2\na 3 4", 2, 4));
        for (text, lines, words) in [
            ("1 2\n3 4", 1, 3),
            ("1 2\n3", 1, 2),
            ("1 2\n\n3 4", 1, 2),
            ("1 2\n3 4\n5 6", 2, 4),
            ("1\n2", 0, 1),
            ("1 2\r3 4\n5 6", 1, 2),
        ] {
            assert!(!is_of_rows(text, lines, words), "{text:?}");
        }
        assert!(Table::of(b" \n ").is_none());
    }

    #[test]
    fn rows_that_only_match_in_sum_are_seen_where_they_are_far_apart() {
        let rows = "1 2 3\n".repeat(BLOCK_BYTES / 2);
        assert!(is_of_rows(&format!("1 2 3\n{rows}4 5 6\n"), 1, 3));
        assert!(!is_of_rows(&format!("1 2\n{rows}3 4 5 6\n"), 1, 3));
    }
}
