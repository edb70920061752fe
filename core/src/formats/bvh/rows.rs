//! What stands behind `MOTION`: two lines about the frames, then their values.
//!
//! Values are read twice over, as those of an AMC are: [`usual::read`] takes a file that has exactly one line per frame,
//! fast and on all threads; [`read_any`] takes anything else. Where lines are not frames it goes by what most of
//! them are:
//!
//! - Most lines hold a frame: then a line (or several, if together they are one) is a frame. One that is short or long is
//!   damaged: the frame before it stands in for the short one, the long one loses what is too much. Frames after it are
//!   not shifted.
//! - Otherwise line ends mean nothing, and the values are dealt out one after the other.

use super::faults::Faults;
use super::tokens::Tokens;
use super::Bvh;
use crate::error::ParseError;
use crate::number;
use crate::text::{end_of_line, is_blank, Lines};
use std::fmt;

mod usual;

/// The lines before the values.
#[derive(Debug, Default)]
pub(super) struct Head {
    /// `Frames`.
    pub(super) frame_count: Option<u64>,
    /// `Frame Time`.
    pub(super) frame_time_s: Option<f64>,
}

/// All values, and what is odd about them.
#[derive(Debug, Default)]
pub(super) struct Rows {
    /// Frame by frame.
    pub(super) values: Vec<f64>,
    /// How many frames that are.
    pub(super) frame_count: usize,
    /// What was done about lines that are no frames.
    pub(super) faults: Faults,
}

/// Reads `Frames [:] COUNT` and `Frame Time [:] SECONDS`, in either order; a number may be missing.
pub(super) fn read_head(tokens: &mut Tokens<'_>) -> Result<Head, ParseError> {
    let mut head = Head::default();
    let (mut has_count, mut has_time) = (false, false);
    loop {
        let (label, length) = label(tokens);
        match label.as_str() {
            "frames" if !has_count => {
                has_count = true;
                tokens.advance(length);
                head.frame_count = read_count(tokens)?;
            }
            "frametime" if !has_time => {
                has_time = true;
                tokens.advance(length);
                if has_value(tokens) {
                    head.frame_time_s = Some(tokens.number("a number of seconds for `Frame Time`")?);
                }
            }
            // What is no number either is met by the reader of values.
            _ => return Ok(head),
        }
    }
}

fn read_count(tokens: &mut Tokens<'_>) -> Result<Option<u64>, ParseError> {
    const WHAT: &str = "a whole number of frames";
    if !has_value(tokens) {
        return Ok(None);
    }
    let word = tokens.expect(WHAT)?;
    let count = word.number(WHAT)?;
    if count < 0.0 || count.fract() != 0.0 {
        return Err(word.unexpected(WHAT));
    }
    Ok(Some(count as u64))
}

/// Returns whether a label has something behind it: anything on its line, or a number alone on the next.
fn has_value(tokens: &Tokens<'_>) -> bool {
    let mut line = tokens.rest();
    if end_of_line(line).is_none() {
        return true;
    }
    line = line.trim_ascii_start();
    let length = line.iter().take_while(|byte| !byte.is_ascii_whitespace()).count();
    let (word, behind) = line.split_at(length);
    number::read(word).is_some() && end_of_line(behind).is_some()
}

/// Returns the letters of the next line up to something else, in lower case and without blanks, and how many bytes they
/// take, a colon with them.
fn label(tokens: &Tokens<'_>) -> (String, usize) {
    const LONGEST: usize = 16;
    let rest = tokens.rest();
    let start = rest.iter().position(|byte| !byte.is_ascii_whitespace()).unwrap_or(rest.len());
    let line = rest.get(start..).unwrap_or_default();
    let length = line.iter().take_while(|byte| byte.is_ascii_alphabetic() || is_blank(**byte)).count();
    let letters = line.iter().take(length).filter(|byte| byte.is_ascii_alphabetic()).take(LONGEST);
    let label = letters.map(|byte| char::from(byte.to_ascii_lowercase())).collect();
    let colon = usize::from(line.get(length) == Some(&b':'));
    (label, start + length + colon)
}

/// Reads the values from byte `at` on.
pub(super) fn read(source: &[u8], at: usize, bvh: &Bvh) -> Result<Rows, ParseError> {
    let width = bvh.width();
    if let Some(values) = usual::read(source.get(at..).unwrap_or_default(), width) {
        return Ok(Rows { frame_count: values.len() / width.max(1), values, faults: Faults::default() });
    }
    read_any(source, at, bvh)
}

/// The clear version: reads values however they are laid out.
fn read_any(source: &[u8], at: usize, bvh: &Bvh) -> Result<Rows, ParseError> {
    let width = bvh.width();
    let mut values = Vec::new();
    let mut lines = Vec::new();
    let mut text = Lines::starting_at(source, at);
    for number in line_number(source, at).. {
        let Some(words) = text.next_line() else { break };
        let start = values.len();
        for word in words {
            values.push(word.number(ValueAt { bvh, column: values.len() - start })?);
        }
        if values.len() > start {
            lines.push(Line { number, start, count: values.len() - start });
        }
    }
    let is_frame = |line: &&Line| line.count == width;
    if width == 0 || 2 * lines.iter().filter(is_frame).count() <= lines.len() {
        return Ok(dealt_out(values, width));
    }
    Ok(line_by_line(&values, &lines, width))
}

/// A line of values.
struct Line {
    number: usize,
    start: usize,
    count: usize,
}

/// Returns the line in which byte `at` stands, behind something else, from 1.
fn line_number(source: &[u8], at: usize) -> usize {
    let mut before = Lines::starting_at(source.get(..at).unwrap_or_default(), 0);
    std::iter::from_fn(|| before.next_line()).count()
}

/// What is expected in a column, in words that are made only if they are needed.
struct ValueAt<'a> {
    bvh: &'a Bvh,
    column: usize,
}

impl fmt::Display for ValueAt<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let joints = self.bvh.joints.iter();
        let mut columns = joints.flat_map(|joint| joint.channels.iter().map(move |channel| (joint, channel)));
        match self.column.checked_rem(self.bvh.width()).and_then(|column| columns.nth(column)) {
            Some((joint, channel)) => write!(f, "a number for `{}` of joint `{}`", channel.word(), joint.name),
            None => f.write_str("a number"),
        }
    }
}

/// Takes values one after the other, whatever lines they stand in.
fn dealt_out(mut values: Vec<f64>, width: usize) -> Rows {
    let frame_count = values.len().checked_div(width).unwrap_or_default();
    let left_over = values.len() - frame_count * width;
    values.truncate(frame_count * width);
    Rows { values, frame_count, faults: Faults { left_over, ..Faults::default() } }
}

/// Takes lines as frames.
fn line_by_line(values: &[f64], lines: &[Line], width: usize) -> Rows {
    let mut rows = Rows::default();
    let mut open: Option<Line> = None;
    for line in lines {
        let so_far = open.as_ref().map_or(0, |open| open.count);
        if so_far + line.count > width {
            if let Some(short) = open.take() {
                rows.stand_in(width);
                rows.faults.short.add(short.number, short.count);
            }
        }
        let whole = open.take().map_or(Line { ..*line }, |open| Line { count: open.count + line.count, ..open });
        if whole.count < width {
            open = Some(whole);
            continue;
        }
        let mut count = whole.count;
        if !count.is_multiple_of(width) {
            rows.faults.long.add(whole.number, count);
            count = width;
        }
        rows.values.extend(values.iter().skip(whole.start).take(count));
    }
    rows.faults.left_over = open.map_or(0, |line| line.count);
    rows.frame_count = rows.values.len() / width;
    rows
}

impl Rows {
    /// Repeats the last frame, or where there is none gives one of zeros.
    fn stand_in(&mut self, width: usize) {
        match self.values.len().checked_sub(width) {
            Some(start) => self.values.extend_from_within(start..),
            None => self.values.resize(width, 0.0),
        }
    }
}
