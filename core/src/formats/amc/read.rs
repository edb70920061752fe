//! Bytes -> [`Amc`].
//!
//! There are three ways to read frames. [`FrameLayout::read_all`] takes all of them on all threads, where they are written
//! just like the first and have numbers that ascend by one; [`FrameLayout::read_usual`] takes one that is written so, without
//! searching and without allocating; [`FrameReader::read_frame`] takes any frame, and says what is wrong with it.

use super::frame::FrameLayout;
use super::header::read_header;
use super::{Amc, AmcBone};
use crate::error::ParseError;
use crate::formats::kind::{self, Kind};
use crate::number;
use crate::text::{Lines, Word, Words};
use std::collections::{HashMap, HashSet};

pub(super) fn parse(source: &[u8]) -> Result<Amc, ParseError> {
    kind::check(source, Kind::Amc)?;
    let mut lines = Lines::new(source);
    let mut amc = Amc { header: read_header(&mut lines)?, ..Amc::default() };
    let start = lines.at();
    amc.first_frame = read_first_frame(&mut lines, &mut amc)?;
    let layout = FrameLayout::new(&amc.bones);
    if let Some(values) = layout.read_all(source.get(start..).unwrap_or_default(), amc.first_frame) {
        amc.frame_count = values.len() / layout.width;
        return Ok(Amc { values, ..amc });
    }
    amc.values.reserve_exact(expected_values(source.len(), start, lines.at(), amc.values.len()));
    let mut reader = FrameReader::new(&amc.bones);
    let mut numbers = FrameNumbers::new(amc.first_frame);
    loop {
        if let Some((number, end)) = layout.read_usual(source, lines.at(), &mut amc.values) {
            numbers.push(number);
            lines = Lines::starting_at(source, end);
        } else if let Some(number) = reader.read_frame(&mut lines, &mut amc.values)? {
            numbers.push(number);
        } else {
            break;
        }
    }
    amc.frame_count = numbers.count;
    amc.frame_numbers = numbers.uneven;
    Ok(amc)
}

/// Returns how many values to make room for after the first frame, from how many bytes that took; never more than the
/// rest of the source can hold, for a value takes two bytes.
fn expected_values(source_length: usize, start: usize, end: usize, width: usize) -> usize {
    let rest = source_length.saturating_sub(end);
    let frames = rest / (end - start).max(1);
    // Later frames may be shorter than the first, by an eighth at most as files go; the vector grows if that is wrong.
    (width * (frames + frames / 8 + 1)).min(rest / 2)
}

/// The numbers of the frames: a count while they ascend by one, a list once they do not.
struct FrameNumbers {
    first: i64,
    count: usize,
    uneven: Vec<i64>,
}

impl FrameNumbers {
    fn new(first: i64) -> Self {
        Self { first, count: 1, uneven: Vec::new() }
    }

    #[inline]
    fn push(&mut self, number: i64) {
        let even = self.first.checked_add_unsigned(self.count as u64);
        if !self.uneven.is_empty() || even != Some(number) {
            self.push_uneven(number);
        }
        self.count += 1;
    }

    #[cold]
    fn push_uneven(&mut self, number: i64) {
        if self.uneven.is_empty() {
            self.uneven.extend((0..self.count).map(|frame| self.first.saturating_add_unsigned(frame as u64)));
        }
        self.uneven.push(number);
    }
}

/// Returns the number of a line that holds only a whole number.
fn frame_number(words: &Words<'_>) -> Option<Result<i64, ParseError>> {
    let mut words = words.clone();
    let word = words.next()?;
    let digits = word.bytes.strip_prefix(b"-").or(word.bytes.strip_prefix(b"+")).unwrap_or(word.bytes);
    if digits.is_empty() || !digits.iter().all(u8::is_ascii_digit) || words.next().is_some() {
        return None;
    }
    Some(word.text().parse().map_err(|_| word.unexpected("a frame number of a bearable size")))
}

/// Reads the first frame: its bones become the file's bones.
pub(super) fn read_first_frame(lines: &mut Lines<'_>, amc: &mut Amc) -> Result<i64, ParseError> {
    const WANTED: &str = "the number of the first frame, alone on its line";
    let mut words = lines.next_words().ok_or_else(|| lines.ended(WANTED))?;
    let Some(number) = frame_number(&words) else { return Err(words.expect(WANTED)?.unexpected(WANTED)) };
    let number = number?;
    let mut seen = HashSet::new();
    while let Some(mut words) = lines.peek_words().filter(|words| frame_number(words).is_none()) {
        lines.next_words();
        let name = words.expect("the name of a bone")?;
        check_name(&name)?;
        // As text, for two spellings in bytes can be one name.
        if !seen.insert(name.text()) {
            return Err(second_time(&name, number));
        }
        let values_before = amc.values.len();
        for word in words {
            amc.values.push(word.number(format_args!("a value of bone `{}`", name.text()))?);
        }
        amc.bones.push(AmcBone { name: name.text(), width: amc.values.len() - values_before });
    }
    if amc.bones.is_empty() {
        return Err(lines.peek_words().and_then(|mut words| words.next()).map_or_else(
            || lines.ended("a bone with its values"),
            |word| word.unexpected(format_args!("a bone with its values in frame {number}")),
        ));
    }
    Ok(number)
}

fn check_name(name: &Word<'_>) -> Result<(), ParseError> {
    if name.bytes.starts_with(b":") {
        Err(name.unexpected("a frame number or a bone, for keywords come before the first frame"))
    } else if number::read(name.bytes).is_some() {
        Err(name.unexpected("a frame number alone on its line, or a bone with its values"))
    } else {
        Ok(())
    }
}

fn second_time(name: &Word<'_>, frame: i64) -> ParseError {
    name.problem(format_args!("each bone once in frame {frame}"), format_args!("`{}` a second time", name.text()))
}

/// The clear version: reads any frame.
struct FrameReader<'a> {
    bones: Vec<(&'a AmcBone, usize)>,
    places: HashMap<&'a str, usize>,
    /// In which frame, counted from 1, each bone was last seen.
    last_seen: Vec<usize>,
    frame: usize,
}

impl<'a> FrameReader<'a> {
    fn new(bones: &'a [AmcBone]) -> Self {
        let starts = bones.iter().scan(0, |next, bone| {
            let start = *next;
            *next += bone.width;
            Some((bone, start))
        });
        let places = bones.iter().enumerate().map(|(place, bone)| (bone.name.as_str(), place)).collect();
        Self { bones: starts.collect(), places, last_seen: vec![0; bones.len()], frame: 0 }
    }

    /// Reads the next frame, whose bones may come in any order; `None` at the end of the file.
    fn read_frame(&mut self, lines: &mut Lines<'_>, values: &mut Vec<f64>) -> Result<Option<i64>, ParseError> {
        let Some(mut words) = lines.next_words() else { return Ok(None) };
        let Some(number) = frame_number(&words) else {
            let word = words.expect("a frame number")?;
            check_name(&word)?;
            return Err(word.unexpected("a frame number"));
        };
        let number = number?;
        self.frame += 1;
        let start = values.len();
        values.resize(start + self.bones.iter().map(|(bone, _)| bone.width).sum::<usize>(), 0.0);
        let mut missing = self.bones.len();
        while missing > 0 {
            let words = lines.peek_words().filter(|words| frame_number(words).is_none());
            let words = words.ok_or_else(|| self.ended_early(number, lines))?;
            lines.next_words();
            self.read_bone(words, number, values.get_mut(start..).unwrap_or_default())?;
            missing -= 1;
        }
        Ok(Some(number))
    }

    fn read_bone(&mut self, mut words: Words<'_>, number: i64, row: &mut [f64]) -> Result<(), ParseError> {
        let name = words.expect("a bone")?;
        check_name(&name)?;
        let place = self.places.get(name.text().as_str()).copied();
        let known = place.and_then(|place| Some((self.bones.get(place)?, self.last_seen.get_mut(place)?)));
        let Some(((bone, start), last_seen)) = known else {
            return Err(name.unexpected("a bone that is in the first frame too"));
        };
        if *last_seen == self.frame {
            return Err(second_time(&name, number));
        }
        *last_seen = self.frame;
        let width_wanted = || {
            let plural = if bone.width == 1 { "" } else { "s" };
            format!("{} value{plural} for bone `{}`, as in the first frame", bone.width, bone.name)
        };
        for (index, value) in row.iter_mut().skip(*start).take(bone.width).enumerate() {
            let word = words.next().ok_or_else(|| name.problem(width_wanted(), format_args!("{index}")))?;
            *value = word.number(format_args!("a value of bone `{}`", bone.name))?;
        }
        match words.count() {
            0 => Ok(()),
            more => Err(name.problem(width_wanted(), format_args!("{}", bone.width + more))),
        }
    }

    fn ended_early(&self, number: i64, lines: &Lines<'_>) -> ParseError {
        const MOST_NAMES: usize = 5;
        let absent = self.bones.iter().zip(&self.last_seen).filter(|(_, seen)| **seen != self.frame);
        let mut names: Vec<_> = absent.map(|((bone, _), _)| bone.name.as_str()).collect();
        let more = names.len().saturating_sub(MOST_NAMES);
        names.truncate(MOST_NAMES);
        let and_more = if more > 0 { format!(" and {more} more") } else { String::new() };
        let expected = format!("the values of {}{and_more} in frame {number}", names.join(", "));
        match lines.peek_words().and_then(|mut words| words.next()) {
            Some(word) => word.unexpected(expected),
            None => lines.ended(expected),
        }
    }
}
