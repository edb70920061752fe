//! Bytes -> [`Trc`].

use super::Trc;
use crate::error::ParseError;
use crate::formats::fields::{cells, words};
use crate::formats::kind::{self, Kind};
use crate::number::read;
use crate::text::{error_at, Lines, Word, Words, LARGEST};

/// What every file begins with.
const FIRST: &str = "a line that begins with `PathFileType`";

/// The cells of a row before its first marker: number and time.
const LEADING_CELLS: usize = 2;

pub(super) fn parse(source: &[u8]) -> Result<Trc, ParseError> {
    kind::check(source, Kind::Trc)?;
    let mut lines = Lines::new(source);
    let texts = |line: &Words<'_>| without_empty_end(cells(source, line).map(|cell| cell.text()).collect());
    let mut head = |what: &str| lines.next_line().ok_or_else(|| lines.clone().ended(what));
    let first_line = head(FIRST)?;
    let is_first = first_line.raw().trim_ascii_start().to_ascii_lowercase().starts_with(b"pathfiletype");
    if !is_first {
        return Err(Word::new(source, first_line.at(), first_line.raw().len()).unexpected(FIRST));
    }
    let path_file_type = texts(&first_line);
    let keys = texts(&head("the keys of the head, from `DataRate` on")?);
    let mut values = texts(&head("the values of the head")?).into_iter();
    let names_line = head("a line that begins with `Frame#`")?;
    let first = cells(source, &names_line).next().filter(|cell| cell.bytes.to_ascii_lowercase().starts_with(b"frame"));
    if first.is_none() {
        let found = Word::new(source, names_line.at(), names_line.raw().len());
        return Err(found.unexpected("a line that begins with `Frame#`"));
    }
    let names = names_of(cells(source, &names_line).skip(LEADING_CELLS).map(|cell| cell.text()).collect());
    skip_axes(source, &mut lines);
    let header = keys.into_iter().map(|key| (key, values.next().unwrap_or_default())).collect();
    let mut table = Table { source, width: 3 * names.len(), rows: Vec::new(), trc: Trc::default() };
    while let Some(line) = lines.next_line() {
        table.read_row(&line)?;
    }
    let mut trc = table.finish()?;
    let count = trc.values.len().checked_div(trc.frame_numbers.len()).map_or(names.len(), |width| width / 3);
    trc.names = names;
    trc.names.resize(count, String::new());
    Ok(Trc { path_file_type, header, ..trc })
}

/// Leaves out empty cells at the end: tabs that some programs write there.
fn without_empty_end(mut cells: Vec<String>) -> Vec<String> {
    let length = cells.iter().rposition(|cell| !cell.is_empty()).map_or(0, |last| last + 1);
    cells.truncate(length);
    cells
}

/// A name stands over the first of the three columns of its marker; some programs leave the other two cells out.
fn names_of(cells: Vec<String>) -> Vec<String> {
    let cells = without_empty_end(cells);
    let is_spaced = cells.iter().enumerate().all(|(index, cell)| index % 3 == 0 || cell.is_empty());
    cells.into_iter().step_by(if is_spaced { 3 } else { 1 }).collect()
}

/// Goes past the line of `X1 Y1 Z1 ...`, where it is there.
pub(super) fn skip_axes(source: &[u8], lines: &mut Lines<'_>) {
    let mut ahead = lines.clone();
    while let Some(line) = ahead.next_line() {
        let Some(first) = words(source, &line).next() else { continue };
        if first.bytes.first().is_some_and(u8::is_ascii_alphabetic) {
            *lines = ahead;
        }
        return;
    }
}

/// The rows as they come in; later ones may be wider than earlier ones.
struct Table<'a> {
    source: &'a [u8],
    /// The most coordinates of a row so far.
    width: usize,
    /// How many coordinates each row has.
    rows: Vec<usize>,
    trc: Trc,
}

impl Table<'_> {
    fn read_row(&mut self, line: &Words<'_>) -> Result<(), ParseError> {
        let has_tabs = line.raw().contains(&b'\t');
        let source = self.source;
        let mut cells: Vec<Word<'_>> =
            if has_tabs { cells(source, line).collect() } else { words(source, line).collect() };
        let filled = cells.iter().rposition(|cell| !cell.bytes.is_empty()).map_or(0, |last| last + 1);
        if filled == 0 {
            return Ok(());
        }
        cells.truncate(filled);
        let mut cells = cells.into_iter();
        let number = cells.next().map_or(Ok(0), |cell| whole(&cell))?;
        let end = Word::new(source, line.at() + line.raw().len(), 0);
        let time = cells.next().unwrap_or(end);
        let time = if time.bytes.is_empty() {
            Err(time.problem("the time of a frame", "nothing"))
        } else {
            time.number("the time of a frame")
        }?;
        let start = self.trc.values.len();
        for cell in cells {
            let value = coordinate(&cell)?;
            self.trc.values.push(value);
        }
        let mut count = self.trc.values.len() - start;
        if !count.is_multiple_of(3) {
            if !has_tabs || self.trc.values.last().is_some_and(|last| !last.is_nan()) {
                return Err(end.problem("three coordinates for each marker", format_args!("{count} coordinates")));
            }
            let missing = 3 - count % 3;
            self.trc.values.extend(std::iter::repeat_n(f64::NAN, missing));
            count += missing;
        }
        for place in self.trc.values.get_mut(start..).unwrap_or_default().as_chunks_mut::<3>().0 {
            if place.iter().any(|x| x.is_nan()) && !place.iter().all(|x| x.is_nan()) {
                *place = [f64::NAN; 3];
                self.trc.broken_places += 1;
            }
        }
        // Gaps at the end are what shorter rows have too.
        while count >= 3 && ends_with_gap(&self.trc.values) {
            self.trc.values.truncate(self.trc.values.len() - 3);
            count -= 3;
        }
        self.rows.push(count);
        self.width = self.width.max(count);
        self.trc.frame_numbers.push(number);
        self.trc.times.push(time);
        Ok(())
    }

    /// Fills all rows up to the same width with gaps.
    fn finish(mut self) -> Result<Trc, ParseError> {
        // Each value that a file shows takes two bytes, each gap a tab: a table many times as large is damage.
        const MOST_PER_BYTE: usize = 4;
        const ALWAYS: usize = 1 << 16;
        let size = self.rows.len().saturating_mul(self.width);
        if size > self.source.len().saturating_mul(MOST_PER_BYTE).max(ALWAYS) {
            let found = format_args!("{} rows of which one has {}", self.rows.len(), self.width).to_string();
            return Err(error_at(self.source, self.source.len(), "rows of about as many coordinates", found));
        }
        if self.rows.iter().any(|width| *width != self.width) {
            let values = std::mem::take(&mut self.trc.values);
            let mut rest = values.as_slice();
            for width in &self.rows {
                let (row, later) = rest.split_at_checked(*width).unwrap_or((rest, &[]));
                rest = later;
                self.trc.values.extend_from_slice(row);
                self.trc.values.extend(std::iter::repeat_n(f64::NAN, self.width - row.len()));
            }
        }
        Ok(self.trc)
    }
}

fn ends_with_gap(values: &[f64]) -> bool {
    values.last_chunk::<3>().is_some_and(|place| place.iter().all(|x| x.is_nan()))
}

fn coordinate(cell: &Word<'_>) -> Result<f64, ParseError> {
    match read(cell.bytes) {
        Some(value) if value.abs() <= LARGEST => Ok(value),
        _ if cell.bytes.is_empty() || cell.is("nan") => Ok(f64::NAN),
        _ => cell.number("a coordinate or an empty cell"),
    }
}

fn whole(cell: &Word<'_>) -> Result<i64, ParseError> {
    let what = "the number of a frame";
    let value = cell.number(what)?;
    if value.fract() == 0.0 {
        Ok(value as i64)
    } else {
        Err(cell.unexpected(what))
    }
}
