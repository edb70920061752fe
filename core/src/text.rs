//! Lines and words of a text file, and errors that say where and what.
//!
//! Shared by all text formats: comments from `#` to the end of the line, blanks and tabs between words, lines that end
//! in LF, CRLF or (old Macs) CR, a byte-order mark. Text is UTF-8, or Latin-1 where it is not valid UTF-8.

use crate::error::{ParseError, Position};
use crate::number;
use std::fmt::Display;

/// Numbers beyond this are damage, not data: it is a thousand times the way to the moon in millimetres, and what
/// is made of smaller ones (sums, squares, products with unit factors) stays finite, also in 32 bits.
pub(crate) const LARGEST: f64 = 1e15;

const BYTE_ORDER_MARK: &[u8] = b"\xEF\xBB\xBF";

/// Reads a text line by line.
#[derive(Clone)]
pub(crate) struct Lines<'a> {
    source: &'a [u8],
    at: usize,
}

impl<'a> Lines<'a> {
    /// Starts behind a byte-order mark.
    pub(crate) fn new(source: &'a [u8]) -> Self {
        let at = if source.starts_with(BYTE_ORDER_MARK) { BYTE_ORDER_MARK.len() } else { 0 };
        Self { source, at }
    }

    /// Starts at byte `at`, where a line begins.
    pub(crate) fn starting_at(source: &'a [u8], at: usize) -> Self {
        Self { source, at }
    }

    /// Returns the byte where the next line begins.
    pub(crate) fn at(&self) -> usize {
        self.at
    }

    /// Returns the next line, whatever it holds, without its end.
    pub(crate) fn next_line(&mut self) -> Option<Words<'a>> {
        let rest = self.source.get(self.at..).filter(|rest| !rest.is_empty())?;
        let length = rest.iter().position(|byte| matches!(byte, b'\n' | b'\r')).unwrap_or(rest.len());
        let line = Words { source: self.source, at: self.at, end: self.at + length };
        let break_length = match rest.get(length..) {
            Some([b'\r', b'\n', ..]) => 2,
            Some([_, ..]) => 1,
            _ => 0,
        };
        self.at += length + break_length;
        Some(line)
    }

    /// Returns the next line that holds a word.
    pub(crate) fn next_words(&mut self) -> Option<Words<'a>> {
        loop {
            let line = self.next_line()?;
            if line.clone().next().is_some() {
                return Some(line);
            }
        }
    }

    /// Returns the next line that holds a word and does not go past it.
    pub(crate) fn peek_words(&self) -> Option<Words<'a>> {
        self.clone().next_words()
    }

    /// Returns the error of a file that ends too early.
    pub(crate) fn ended(&self, expected: impl Display) -> ParseError {
        error_at(self.source, self.source.len(), expected, "the end of the file")
    }
}

/// One word and where it stands.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Word<'a> {
    source: &'a [u8],
    /// The word itself.
    pub(crate) bytes: &'a [u8],
    /// Its first byte in the source.
    pub(crate) at: usize,
}

impl<'a> Word<'a> {
    /// Takes the bytes of `source` from `at` on as a word.
    pub(crate) fn new(source: &'a [u8], at: usize, length: usize) -> Self {
        Self { source, bytes: source.get(at..at + length).unwrap_or_default(), at }
    }

    /// Compares as keywords are compared: case does not matter.
    pub(crate) fn is(&self, keyword: &str) -> bool {
        self.bytes.eq_ignore_ascii_case(keyword.as_bytes())
    }

    /// Returns the word as text.
    pub(crate) fn text(&self) -> String {
        decode(self.bytes)
    }

    /// Returns the error that this word is not what was expected.
    pub(crate) fn unexpected(&self, expected: impl Display) -> ParseError {
        self.problem(expected, quoted(self.bytes))
    }

    /// Returns an error at this word.
    pub(crate) fn problem(&self, expected: impl Display, found: impl Display) -> ParseError {
        error_at(self.source, self.at, expected, found)
    }

    /// Reads the word as a number that can be worked with.
    pub(crate) fn number(&self, what: impl Display) -> Result<f64, ParseError> {
        match number::read(self.bytes) {
            Some(value) if value.abs() <= LARGEST => Ok(value),
            Some(value) if value.is_finite() => {
                Err(self.unexpected(format_args!("{what} between -{LARGEST:e} and {LARGEST:e}")))
            }
            _ if is_not_finite(self.bytes) => Err(self.unexpected(format_args!("{what}, a finite number"))),
            _ => Err(self.unexpected(what)),
        }
    }
}

/// The words of the rest of one line; a `#` where a word could begin ends it.
#[derive(Debug, Clone)]
pub(crate) struct Words<'a> {
    source: &'a [u8],
    at: usize,
    end: usize,
}

impl<'a> Words<'a> {
    /// Returns where the next word or blank stands.
    pub(crate) fn at(&self) -> usize {
        self.at
    }

    /// Returns the rest of the line as it is, comment and blanks too.
    pub(crate) fn raw(&self) -> &'a [u8] {
        self.source.get(self.at..self.end).unwrap_or_default()
    }

    /// Returns the rest of the line as text, without comment and outer blanks.
    pub(crate) fn rest(&self) -> String {
        let mut words = self.clone();
        let Some(first) = words.next() else { return String::new() };
        let last = words.last().unwrap_or(first);
        decode(self.source.get(first.at..last.at + last.bytes.len()).unwrap_or_default())
    }

    /// Returns the next word, or the error that the line ends.
    pub(crate) fn expect(&mut self, what: impl Display) -> Result<Word<'a>, ParseError> {
        self.next().ok_or_else(|| error_at(self.source, self.at, what, "the end of the line"))
    }

    /// Reads the next word as a number.
    pub(crate) fn number(&mut self, what: impl Display) -> Result<f64, ParseError> {
        self.expect(&what)?.number(&what)
    }

    /// Checks that the line holds nothing more.
    pub(crate) fn finish(&mut self) -> Result<(), ParseError> {
        self.next().map_or(Ok(()), |word| Err(word.unexpected("the end of the line")))
    }

    /// Splits the rest of the line at brackets and commas too.
    pub(crate) fn split_at_brackets(&mut self) -> impl Iterator<Item = Word<'a>> + use<'a, '_> {
        let source = self.source;
        self.by_ref().flat_map(move |word| {
            let mut at = word.at;
            word.bytes.split(|byte| matches!(byte, b'(' | b')' | b',')).filter_map(move |bytes| {
                let part = Word { source, bytes, at };
                at += bytes.len() + 1;
                (!bytes.is_empty()).then_some(part)
            })
        })
    }
}

impl<'a> Iterator for Words<'a> {
    type Item = Word<'a>;

    fn next(&mut self) -> Option<Word<'a>> {
        let rest = self.raw();
        let start = rest.iter().position(|&byte| !is_blank(byte)).unwrap_or(rest.len());
        let rest = rest.get(start..).unwrap_or_default();
        if matches!(rest.first(), None | Some(b'#')) {
            self.at = self.end;
            return None;
        }
        let length = rest.iter().position(|&byte| is_blank(byte)).unwrap_or(rest.len());
        let word = Word { source: self.source, bytes: rest.get(..length)?, at: self.at + start };
        self.at = word.at + length;
        Some(word)
    }
}

/// What separates words within a line.
#[inline]
pub(crate) fn is_blank(byte: u8) -> bool {
    matches!(byte, b' ' | b'\t' | b'\x0B' | b'\x0C')
}

/// Returns the text behind blanks at its start.
#[inline]
pub(crate) fn skip_blanks(mut text: &[u8]) -> &[u8] {
    while let [byte, rest @ ..] = text {
        if !is_blank(*byte) {
            break;
        }
        text = rest;
    }
    text
}

/// Returns the text behind blanks and one line end, or at the end of the file; `None` where the line goes on.
#[inline]
pub(crate) fn end_of_line(text: &[u8]) -> Option<&[u8]> {
    match skip_blanks(text) {
        [b'\r', b'\n', rest @ ..] | [b'\n' | b'\r', rest @ ..] => Some(rest),
        [] => Some(&[]),
        _ => None,
    }
}

/// Returns the error at byte `at` of `source`.
pub(crate) fn error_at(source: &[u8], at: usize, expected: impl Display, found: impl Display) -> ParseError {
    ParseError { position: position(source, at), expected: expected.to_string(), found: found.to_string() }
}

/// Returns the bytes as text: UTF-8, or Latin-1 where they are not that.
pub(crate) fn decode(bytes: &[u8]) -> String {
    std::str::from_utf8(bytes).map_or_else(|_| bytes.iter().map(|&byte| char::from(byte)).collect(), str::to_owned)
}

/// Returns the bytes in quotation marks for a message: one line, and not a long one.
pub(crate) fn quoted(bytes: &[u8]) -> String {
    const LONGEST: usize = 40;
    let text = decode(bytes.get(..4 * LONGEST).unwrap_or(bytes));
    let mut shown = String::new();
    for character in text.chars().take(LONGEST) {
        if character.is_control() {
            shown.extend(character.escape_default());
        } else {
            shown.push(character);
        }
    }
    let more = if text.chars().nth(LONGEST).is_some() { "..." } else { "" };
    format!("`{shown}{more}`")
}

fn is_not_finite(word: &[u8]) -> bool {
    let unsigned = word.strip_prefix(b"-").or(word.strip_prefix(b"+")).unwrap_or(word);
    let names: [&[u8]; 6] = [b"nan", b"inf", b"infinity", b"1.#inf", b"1.#qnan", b"1.#ind"];
    names.iter().any(|name| unsigned.eq_ignore_ascii_case(name)) || number::read(word).is_some_and(f64::is_infinite)
}

fn position(source: &[u8], at: usize) -> Position {
    let mut lines = Lines::starting_at(source, 0);
    let mut position = (1, 0);
    for line in 1.. {
        position = (line, lines.at());
        if lines.next_line().is_none() || lines.at() > at || lines.at() == source.len() && !ends_line(source) {
            break;
        }
    }
    let (line, start) = position;
    Position::Text { line, column: at.saturating_sub(start) + 1 }
}

fn ends_line(source: &[u8]) -> bool {
    matches!(source.last(), Some(b'\n' | b'\r'))
}
