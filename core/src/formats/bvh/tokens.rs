//! Words across lines: what a BVH is made of outside of names, which are read by the line.

use crate::error::ParseError;
use crate::text::{error_at, is_blank, Lines, Word};
use std::fmt::Display;

/// Reads a text word by word; a brace is a word of its own, blanks or not.
#[derive(Clone)]
pub(super) struct Tokens<'a> {
    source: &'a [u8],
    at: usize,
}

impl<'a> Tokens<'a> {
    /// Starts behind a byte-order mark.
    pub(super) fn new(source: &'a [u8]) -> Self {
        Self { source, at: Lines::new(source).at() }
    }

    /// Returns the byte behind the last word.
    pub(super) fn at(&self) -> usize {
        self.at
    }

    /// Returns the next word and does not go past it.
    pub(super) fn peek(&self) -> Option<Word<'a>> {
        self.clone().next()
    }

    /// Returns the next word, or the error that the file ends.
    pub(super) fn expect(&mut self, what: impl Display) -> Result<Word<'a>, ParseError> {
        self.next().ok_or_else(|| self.ended(what))
    }

    /// Takes one keyword.
    pub(super) fn keyword(&mut self, keyword: &str) -> Result<Word<'a>, ParseError> {
        let Some(word) = self.next() else { return Err(self.ended(format_args!("`{keyword}`"))) };
        if word.is(keyword) {
            Ok(word)
        } else {
            Err(word.unexpected(format_args!("`{keyword}`")))
        }
    }

    /// Takes one number.
    pub(super) fn number(&mut self, what: impl Display) -> Result<f64, ParseError> {
        self.expect(&what)?.number(&what)
    }

    /// Returns the error of a file that ends too early.
    pub(super) fn ended(&self, expected: impl Display) -> ParseError {
        error_at(self.source, self.source.len(), expected, "the end of the file")
    }

    /// Returns what follows the last word.
    pub(super) fn rest(&self) -> &'a [u8] {
        self.source.get(self.at..).unwrap_or_default()
    }

    /// Goes on `length` bytes further.
    pub(super) fn advance(&mut self, length: usize) {
        self.at += length;
    }
}

impl<'a> Iterator for Tokens<'a> {
    type Item = Word<'a>;

    fn next(&mut self) -> Option<Word<'a>> {
        let rest = self.rest();
        let start = rest.iter().position(|&byte| !is_space(byte))?;
        let rest = rest.get(start..)?;
        let ends = |&byte: &u8| is_space(byte) || matches!(byte, b'{' | b'}');
        let length = match rest.iter().position(ends) {
            Some(0) => 1,
            Some(length) => length,
            None => rest.len(),
        };
        let word = Word::new(self.source, self.at + start, length);
        self.at = word.at + length;
        Some(word)
    }
}

/// What separates words.
pub(super) fn is_space(byte: u8) -> bool {
    is_blank(byte) || matches!(byte, b'\n' | b'\r')
}
