//! What a TRC is about, by some of its frames.

use super::read::skip_axes;
use super::Trc;
use crate::formats::rows::Rows;
use crate::markers::Markers;
use crate::number;
use crate::table::Table;
use crate::text::Lines;

/// The lines before the axes: the kind of file, keys, values, names.
const HEAD_LINES: usize = 4;

impl Trc {
    /// Reads the head, and of the frames those that say how large the markers are and how they stand; also returns the
    /// markers on these alone with what the user should know of all, and how many frames there are.
    ///
    /// `None` where anything is unusual (gaps too), so that [`Trc::parse`] should look at it: what this says, that would
    /// say too.
    pub(crate) fn skim(source: &[u8]) -> Option<(Self, (Markers, Vec<String>), usize)> {
        let mut lines = Lines::new(source);
        for _ in 0..HEAD_LINES {
            lines.next_line()?;
        }
        skip_axes(source, &mut lines);
        let (head, table) = source.split_at_checked(lines.at())?;
        let table = Table::of(table)?;
        let rows = Rows::of(&table)?;
        let mut trc = Self::parse(&rows.reduced(head)).ok()?;
        let is_complete = table.total.others == 0
            && table.is_of_rows(1, 2 + 3 * trc.names.len(), |tally| tally.words)
            && trc.values.iter().all(|value| !value.is_nan());
        // Without a rate in the head, the times of all frames would say it.
        number::read(trc.value("DataRate")?.as_bytes()).filter(|rate| *rate > 0.0 && *rate < 1e7)?;
        let (markers, _) = trc.markers();
        trc.frame_numbers = rows.numbers(&trc.frame_numbers).filter(|_| is_complete)?;
        let notices = trc.notices();
        Some((trc, (markers, notices), rows.count))
    }
}
