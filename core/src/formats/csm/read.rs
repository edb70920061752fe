//! Bytes -> [`Csm`].

use super::Csm;
use crate::error::ParseError;
use crate::formats::fields::words;
use crate::formats::kind::{self, Kind};
use crate::number::read_prefix;
use crate::rate::RATES_HZ;
use crate::text::{decode, is_blank, Lines, Word, Words, LARGEST};

/// The word in place of the coordinates of a marker that was not seen.
pub(super) const DROPOUT: &str = "DROPOUT";

pub(super) fn parse(source: &[u8]) -> Result<Csm, ParseError> {
    kind::check(source, Kind::Csm)?;
    let mut reader = Reader { source, lines: Lines::new(source), csm: Csm::default() };
    let (mut has_order, mut has_points) = (false, false);
    while let Some(line) = reader.lines.next_line() {
        let mut line_words = words(source, &line);
        let Some(keyword) = line_words.next() else { continue };
        let Some(name) = keyword.bytes.strip_prefix(b"$") else {
            return Err(keyword.unexpected("the start of a section, `$` and its name"));
        };
        let rest: Vec<Word<'_>> = line_words.collect();
        match name.to_ascii_lowercase().as_slice() {
            b"order" if has_order => return Err(keyword.problem("`$order` once", "a second one")),
            b"points" if has_points => return Err(keyword.problem("`$points` once", "a second one")),
            b"order" => {
                has_order = true;
                reader.read_order(&rest)?;
            }
            b"points" => {
                if !has_order {
                    return Err(keyword.unexpected("`$order` with the names of the markers before `$points`"));
                }
                has_points = true;
                reader.read_points(&rest)?;
            }
            b"firstframe" => reader.csm.first_frame = Some(reader.whole(&keyword, &rest)?),
            b"lastframe" => reader.csm.last_frame = Some(reader.whole(&keyword, &rest)?),
            b"rate" => reader.csm.rate_hz = Some(reader.rate(&keyword, &rest)?),
            _ => {
                let value = reader.text(&line, &keyword);
                reader.csm.texts.push((Word::new(source, keyword.at + 1, name.len()).text(), value));
            }
        }
    }
    match (has_order, has_points) {
        (true, true) => Ok(reader.csm),
        (false, _) => Err(reader.lines.ended("`$order` with the names of the markers")),
        (true, false) => Err(reader.lines.ended("`$points`")),
    }
}

struct Reader<'a> {
    source: &'a [u8],
    lines: Lines<'a>,
    csm: Csm,
}

impl<'a> Reader<'a> {
    /// Returns the next line of the section, and goes past it.
    fn next_of_section(&mut self) -> Option<Words<'a>> {
        let mut ahead = self.lines.clone();
        let line = ahead.next_line()?;
        if words(self.source, &line).next().is_some_and(|word| word.bytes.starts_with(b"$")) {
            return None;
        }
        self.lines = ahead;
        Some(line)
    }

    fn read_order(&mut self, first: &[Word<'a>]) -> Result<(), ParseError> {
        // Where a name that begins so stood first on a line, it would be a section.
        if let Some(word) = first.iter().find(|word| word.bytes.starts_with(b"$")) {
            return Err(word.unexpected("the name of a marker"));
        }
        self.csm.order.extend(first.iter().map(Word::text));
        while let Some(line) = self.next_of_section() {
            self.csm.order.extend(words(self.source, &line).map(|word| word.text()));
        }
        Ok(())
    }

    /// Reads the value behind a keyword or on the lines below.
    fn value(&mut self, keyword: &Word<'a>, rest: &[Word<'a>]) -> Result<Word<'a>, ParseError> {
        let mut values = rest.to_vec();
        while let Some(line) = self.next_of_section() {
            values.extend(words(self.source, &line));
        }
        let what = format!("one number for `{}`", keyword.text());
        match values.as_slice() {
            [] => Err(keyword.problem(what, "none")),
            [value] => Ok(*value),
            [_, second, ..] => Err(second.unexpected(what)),
        }
    }

    fn whole(&mut self, keyword: &Word<'a>, rest: &[Word<'a>]) -> Result<i64, ParseError> {
        let value = self.value(keyword, rest)?;
        whole(&value, format_args!("a whole number for `{}`", keyword.text()))
    }

    fn rate(&mut self, keyword: &Word<'a>, rest: &[Word<'a>]) -> Result<f64, ParseError> {
        let word = self.value(keyword, rest)?;
        let what = "a number of frames per second";
        let rate = word.number(what)?;
        if RATES_HZ.contains(&rate) {
            Ok(rate)
        } else {
            Err(word.unexpected(format_args!("{what} from {} to {}", RATES_HZ.start(), RATES_HZ.end())))
        }
    }

    /// Returns the text behind a keyword, and that of the lines below up to the last that is not blank.
    fn text(&mut self, line: &Words<'a>, keyword: &Word<'a>) -> String {
        let end = line.at() + line.raw().len();
        let from = keyword.at + keyword.bytes.len();
        let trimmed = |bytes: &'a [u8]| {
            let is_text = |byte: &u8| !is_blank(*byte);
            let start = bytes.iter().position(is_text).unwrap_or(bytes.len());
            let end = bytes.iter().rposition(is_text).map_or(start, |last| last + 1);
            decode(bytes.get(start..end).unwrap_or_default())
        };
        let mut lines = vec![trimmed(self.source.get(from..end).unwrap_or_default())];
        while let Some(line) = self.next_of_section() {
            lines.push(trimmed(line.raw()));
        }
        lines.join("\n").trim_matches('\n').to_owned()
    }

    fn read_points(&mut self, first: &[Word<'a>]) -> Result<(), ParseError> {
        if let Some(word) = first.first() {
            return Err(word.unexpected("the frames on the lines below `$points`"));
        }
        let frame = Frame { source: self.source, width: 3 * self.csm.order.len() };
        let mut lines_per_frame = None;
        while let Some(line) = self.next_of_section() {
            let start = self.csm.values.len();
            let Some(number) = frame.start(&line)? else { continue };
            let mut at = number.1;
            let mut lines = 1;
            let mut line = line;
            loop {
                let is_complete = frame.read_line(&mut self.csm.values, start, at, &line)?;
                if is_complete {
                    break;
                }
                // Only if the first frame does so may a frame go on below.
                let next = if lines_per_frame.is_none_or(|most| lines < most) { self.next_of_section() } else { None };
                let found = || (self.csm.values.len() - start) / 3;
                let ended = || frame.too_few(&line, number.0, found());
                line = next.ok_or_else(ended)?;
                at = line.at();
                lines += 1;
            }
            lines_per_frame.get_or_insert(lines);
            self.csm.frame_numbers.push(number.0);
        }
        Ok(())
    }
}

/// Reads frames of so many coordinates.
struct Frame<'a> {
    source: &'a [u8],
    width: usize,
}

impl<'a> Frame<'a> {
    /// Reads the number of a frame and returns it with where the line goes on; `None` for a blank line.
    fn start(&self, line: &Words<'a>) -> Result<Option<(i64, usize)>, ParseError> {
        let Some(word) = words(self.source, line).next() else { return Ok(None) };
        let number = whole(&word, "the number of a frame")?;
        Ok(Some((number, word.at + word.bytes.len())))
    }

    /// Reads coordinates from byte `at` to the end of the line, and returns true where the frame is complete.
    fn read_line(&self, values: &mut Vec<f64>, start: usize, at: usize, line: &Words<'a>) -> Result<bool, ParseError> {
        let end = line.at() + line.raw().len();
        let mut at = at;
        loop {
            let rest = self.source.get(at..end).unwrap_or_default();
            let blanks = rest.iter().position(|byte| !is_blank(*byte)).unwrap_or(rest.len());
            let rest = rest.get(blanks..).unwrap_or_default();
            at += blanks;
            if rest.is_empty() {
                return Ok(values.len() - start == self.width);
            }
            let usual = read_prefix(rest).filter(|(value, length)| {
                value.abs() <= LARGEST && rest.get(*length).is_none_or(|next| is_blank(*next))
            });
            let is_full = values.len() - start == self.width;
            match usual {
                Some((value, length)) if !is_full => {
                    values.push(value);
                    at += length;
                }
                _ => {
                    let length = rest.iter().position(|byte| is_blank(*byte)).unwrap_or(rest.len());
                    let word = Word::new(self.source, at, length);
                    if is_full {
                        return Err(
                            word.unexpected(format_args!("the end of the line after {} markers", self.width / 3))
                        );
                    }
                    if (values.len() - start).is_multiple_of(3) && word.is(DROPOUT) {
                        values.extend([f64::NAN; 3]);
                    } else {
                        values.push(word.number("a coordinate or `DROPOUT`")?);
                    }
                    at += length;
                }
            }
        }
    }

    fn too_few(&self, line: &Words<'a>, number: i64, found: usize) -> ParseError {
        let word = Word::new(self.source, line.at(), line.raw().len());
        word.problem(
            format_args!("coordinates of {} markers in frame {number}", self.width / 3),
            format_args!("those of {found}"),
        )
    }
}

fn whole(word: &Word<'_>, what: impl std::fmt::Display) -> Result<i64, ParseError> {
    let value = word.number(&what)?;
    // Some programs write frame numbers with a point.
    if value.fract() == 0.0 {
        Ok(value as i64)
    } else {
        Err(word.unexpected(what))
    }
}
