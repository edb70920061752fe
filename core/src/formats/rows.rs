//! The frames of a table of markers, one per line, some of them picked out.

use crate::markers::scale::frames_to_look_at;
use crate::tally::Tally;

/// What a look over a table says.
pub(super) struct Rows<'a> {
    /// The number of the first frame.
    pub(super) first: i64,
    /// How many frames there are.
    pub(super) count: usize,
    /// Those that say how large the markers are and how they stand.
    looked_at: Vec<&'a [u8]>,
}

impl<'a> Rows<'a> {
    /// Looks over the lines of a table: each begins with a number one above that of the line before, and is as `is_usual`
    /// wants it. Blank lines are left out. `None` where anything is unusual.
    pub(super) fn of(text: &'a [u8], mut is_usual: impl FnMut(&Tally) -> bool) -> Option<Self> {
        let mut lines: Vec<&[u8]> = Vec::new();
        let mut rest = text;
        let mut first = None;
        while !rest.is_empty() {
            let length = memchr::memchr(b'\n', rest).unwrap_or(rest.len());
            let (line, later) = rest.split_at(length);
            rest = later.get(1..).unwrap_or_default();
            let line = line.strip_suffix(b"\r").unwrap_or(line);
            let tally = Tally::of(line);
            // A carriage return within a line ends it too: that is for the reader.
            if memchr::memchr(b'\r', line).is_some() {
                return None;
            }
            if tally.words == 0 {
                continue;
            }
            let number = leading_number(line)?;
            let expected =
                i64::try_from(lines.len()).ok().and_then(|count| first.get_or_insert(number).checked_add(count));
            if expected != Some(number) || tally.points > tally.words || !is_usual(&tally) {
                return None;
            }
            lines.push(line);
        }
        let looked_at = frames_to_look_at(lines.len()).filter_map(|frame| lines.get(frame).copied()).collect();
        Some(Self { first: first?, count: lines.len(), looked_at })
    }

    /// Returns a file of the same head with only those frames that are to be looked at.
    pub(super) fn reduced(&self, head: &[u8]) -> Vec<u8> {
        let mut reduced = head.to_vec();
        for line in &self.looked_at {
            reduced.extend_from_slice(line);
            reduced.push(b'\n');
        }
        reduced
    }

    /// Returns the numbers of all frames, if those of the reduced file are among them, in its order.
    pub(super) fn numbers(&self, looked_at: &[i64]) -> Option<Vec<i64>> {
        let wanted = frames_to_look_at(self.count).map(|frame| self.first + frame as i64);
        wanted.eq(looked_at.iter().copied()).then(|| (self.first..).take(self.count).collect())
    }
}

/// Reads the digits that a line begins with, up to a blank.
fn leading_number(line: &[u8]) -> Option<i64> {
    const MOST_DIGITS: usize = 15;
    let line = line.trim_ascii_start();
    let length = line.iter().position(|byte| !byte.is_ascii_digit())?;
    let (digits, rest) = line.split_at(length);
    if !(1..=MOST_DIGITS).contains(&length) || !matches!(rest.first(), Some(b' ' | b'\t')) {
        return None;
    }
    Some(digits.iter().fold(0, |number, digit| 10 * number + i64::from(digit - b'0')))
}
