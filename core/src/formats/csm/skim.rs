//! What a CSM is about, by some of its frames.

use super::read::DROPOUT;
use super::Csm;
use crate::formats::fields::words;
use crate::formats::rows::Rows;
use crate::markers::Markers;
use crate::table::Table;
use crate::tally::Tally;
use crate::text::Lines;

/// The sections before the frames take no more than this.
const MOST_HEAD_BYTES: usize = 1 << 16;

impl Csm {
    /// Reads everything but the frames, and of these those that say how large the markers are and how they stand; also
    /// returns the markers on these alone with what the user should know of all, and how many frames there are.
    ///
    /// `None` where anything is unusual, so that [`Csm::parse`] should look at it: what this says, that would say too.
    pub(crate) fn skim(source: &[u8]) -> Option<(Self, (Markers, Vec<String>), usize)> {
        let (head, table) = source.split_at_checked(table_start(source)?)?;
        let sections = Self::parse(head).ok()?;
        let table = Table::of(table)?;
        // A marker that drops out has one word in place of three.
        let of_dropout = Tally::of(DROPOUT.as_bytes());
        let dropouts = |tally: &Tally| tally.others / of_dropout.others;
        let (total, dropout_count) = (table.total, dropouts(&table.total));
        let is_usual = total.others == dropout_count * of_dropout.others
            && total.sum == of_dropout.sum.wrapping_mul(dropout_count as u8)
            && table.is_of_rows(1, 1 + 3 * sections.order.len(), |tally| tally.words + 2 * dropouts(tally));
        if !is_usual {
            return None;
        }
        let rows = Rows::of(&table)?;
        let mut csm = Self::parse(&rows.reduced(head)).ok()?;
        let (markers, _) = csm.markers();
        csm.frame_numbers = rows.numbers(&csm.frame_numbers)?;
        let notices = csm.notices();
        Some((csm, (markers, notices), rows.count))
    }
}

/// Returns where the line below `$points` begins.
fn table_start(source: &[u8]) -> Option<usize> {
    let mut lines = Lines::new(source);
    while lines.at() < MOST_HEAD_BYTES {
        let line = lines.next_line()?;
        if words(source, &line).next().is_some_and(|word| word.is("$points")) {
            return Some(lines.at());
        }
    }
    None
}
