//! Sidecars (`NAME.i3d`): what people say of a clip, in a small text beside it.
//!
//! ```text
//! Date: 2004-05-31
//! Group: locomotion
//! Subject: 07
//! Duration: 2.63
//! Framerate: 120
//! Cleaned: Yes
//! Last changed on: 2004-06-02
//! Modified by: jo
//! Usable segments: 20-180, 200-316
//! ASF file: 07.asf
//! Comment: starts from a T-pose: cut that
//! ```
//! Eleven lines, `label: value`; a value may have colons. People write them by hand, so labels come in other words and in
//! any order, lines are missing or there twice, between them stands what nobody expected. All of that is kept where it is:
//! a file that is read and written again has the same bytes, and an edit changes the one line that it means.

mod encoding;
mod field;
mod lines;
mod value;

use std::fs::File;
use std::io::Read;
use std::path::{Path, PathBuf};

pub use encoding::Encoding;
pub use field::Field;
pub use value::{cleaned, day, segments, Segment};

use lines::Line;

/// The extension of a sidecar, without the dot.
pub const EXTENSION: &str = "i3d";

/// No sidecar is larger; of what is, only so much is read where a scan looks into it.
pub const MOST_BYTES: u64 = 1 << 20;

/// A value that a field cannot hold, and why.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum ValueError {
    /// *Cleaned* is a word that is neither yes nor no.
    #[error("Cleaned is empty or one of J, Ja, Y, Yes, N, Nein, No, not “{0}”")]
    Cleaned(String),
    /// The value would be more than a line.
    #[error("{0} is one line of text")]
    Lines(&'static str),
}

/// A sidecar, line by line as it is.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Sidecar {
    lines: Vec<Line>,
    encoding: Encoding,
}

impl Default for Sidecar {
    /// The eleven lines without values.
    fn default() -> Self {
        let text: String = Field::ALL.map(|field| format!("{}:\n", field.label())).concat();
        Self { lines: lines::split(&text), encoding: Encoding::Utf8 }
    }
}

impl Sidecar {
    /// Reads any bytes: what is not understood is kept all the same.
    pub fn parse(bytes: &[u8]) -> Self {
        let (text, encoding) = encoding::decode(bytes);
        Self { lines: lines::split(&text), encoding }
    }

    /// Returns the file anew. Bytes that nobody edited are what they were.
    ///
    /// The encoding stays. Where the text needs a character that it does not have, or would be taken for another encoding
    /// when it is read again, it becomes UTF-8.
    pub fn to_bytes(&self) -> Vec<u8> {
        let text: String = self.lines.iter().flat_map(|line| [line.text.as_str(), line.end]).collect();
        let written = |encoding| encoding::encode(&text, encoding).filter(|bytes| encoding::decode(bytes).0 == text);
        let ways = [self.encoding, Encoding::Utf8, Encoding::Utf8Marked];
        ways.into_iter().find_map(written).unwrap_or_else(|| text.clone().into_bytes())
    }

    /// Returns the value of a field, without outer blanks; `None` where there is no such line.
    pub fn get(&self, field: Field) -> Option<&str> {
        self.lines.get(self.find(field)?).map(Line::value)
    }

    /// Returns whether a field has a value.
    pub fn has(&self, field: Field) -> bool {
        self.get(field).is_some_and(|value| !value.is_empty())
    }

    /// Returns the lines that no field means, blank ones aside.
    pub fn unknown(&self) -> impl Iterator<Item = &str> {
        let known: Vec<usize> = Field::ALL.into_iter().filter_map(|field| self.find(field)).collect();
        let others = self.lines.iter().enumerate().filter(move |(index, _)| !known.contains(index));
        others.map(|(_, line)| line.text.trim()).filter(|text| !text.is_empty())
    }

    /// Returns what is wrong with the values, a sentence each; they are kept all the same.
    pub fn faults(&self) -> Vec<String> {
        let said = self.get(Field::Cleaned).unwrap_or_default();
        cleaned(said).err().map(|error| error.to_string()).into_iter().collect()
    }

    /// Gives a field a value: in its line, or in a new one where it would stand in order. An equal value changes nothing.
    ///
    /// # Errors
    /// Where the field cannot hold the value; nothing was changed then.
    pub fn set(&mut self, field: Field, value: &str) -> Result<(), ValueError> {
        let value = value.trim();
        if value.contains(['\n', '\r']) {
            return Err(ValueError::Lines(field.label()));
        }
        if self.get(field).unwrap_or_default() == value {
            return Ok(());
        }
        if field == Field::Cleaned {
            cleaned(value)?;
        }
        match self.find(field).and_then(|index| self.lines.get_mut(index)) {
            Some(line) => line.set_value(value),
            None => self.insert(field, value),
        }
        Ok(())
    }

    /// Puts a new line behind the nearest field before it, or else before the first one after it.
    fn insert(&mut self, field: Field, value: &str) {
        let place = Field::ALL.iter().position(|known| *known == field).unwrap_or_default();
        let (before, after) = Field::ALL.split_at(place);
        let before = before.iter().rev().find_map(|known| self.find(*known)).map(|index| index + 1);
        let after = || after.iter().find_map(|known| self.find(*known));
        let at = before.or_else(after).unwrap_or(self.lines.len());
        let end = lines::usual_end(&self.lines);
        if let Some(previous) = at.checked_sub(1).and_then(|index| self.lines.get_mut(index)) {
            // The last line of a file may have no end.
            if previous.end.is_empty() {
                previous.end = end;
            }
        }
        let separator = if value.is_empty() { "" } else { " " };
        self.lines.insert(at, Line { text: format!("{}:{separator}{value}", field.label()), end });
    }

    /// Returns the line of a field: the first of those whose labels mean it the most clearly; or else, where there are eleven
    /// lines with labels, the one in its place, if nothing else claims that.
    fn find(&self, field: Field) -> Option<usize> {
        let by_label = |line: &Line| line.label().and_then(Field::of_label);
        let distances = self.lines.iter().map(|line| line.label().and_then(|label| field.distance(label)));
        let own = distances.enumerate().filter_map(|(index, distance)| Some((distance?, index))).min();
        own.map(|(_, index)| index).or_else(|| {
            let labelled: Vec<usize> =
                (0..self.lines.len()).filter(|index| self.lines[*index].label().is_some()).collect();
            let place = Field::ALL.iter().position(|known| *known == field)?;
            let index = *labelled.get(place).filter(|_| labelled.len() == Field::ALL.len())?;
            let is_in_order = labelled
                .iter()
                .zip(Field::ALL)
                .all(|(index, expected)| by_label(&self.lines[*index]).is_none_or(|known| known == expected));
            Some(index).filter(|_| is_in_order)
        })
    }
}

/// Returns the sidecar's place beside a clip: the one that is there, in either case, or `NAME.i3d`.
pub fn path_beside(clip: &Path) -> PathBuf {
    let usual = clip.with_extension(EXTENSION);
    let upper = clip.with_extension(EXTENSION.to_uppercase());
    if !usual.exists() && upper.exists() {
        return upper;
    }
    usual
}

/// Reads the sidecar beside a clip, where there is one that can be read.
pub fn read_beside(clip: &Path) -> Option<Sidecar> {
    read(&path_beside(clip))
}

/// Reads a sidecar, where it can be read.
pub fn read(path: &Path) -> Option<Sidecar> {
    let mut bytes = Vec::new();
    File::open(path).ok()?.take(MOST_BYTES).read_to_end(&mut bytes).ok()?;
    Some(Sidecar::parse(&bytes))
}

#[cfg(test)]
mod tests;
