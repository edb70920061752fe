//! The frames of a table of markers, one per line, some of them picked out.

use crate::markers::scale::frames_to_look_at;
use crate::table::Table;

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
    /// Picks the lines of a table that are to be looked at, and checks that each of them, and the last, begins with a
    /// number that is as far above that of the first as the line is below it. `None` where one does not.
    pub(super) fn of(table: &Table<'a>) -> Option<Self> {
        let count = table.line_count();
        let first = leading_number(table.line(0)?)?;
        let numbered = |frame: usize| {
            let line = table.line(frame)?;
            (leading_number(line)? == first.checked_add_unsigned(frame as u64)?).then_some(line)
        };
        numbered(count - 1)?;
        let looked_at = frames_to_look_at(count).map(numbered).collect::<Option<_>>()?;
        Some(Self { first, count, looked_at })
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
