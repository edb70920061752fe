//! Bytes of a binary file taken one after the other, and errors that say where and what.

use crate::error::{ParseError, Position};
use std::fmt::Display;

/// Reads a file from front to back; never past its end.
#[derive(Debug, Clone)]
pub(crate) struct Bytes<'a> {
    source: &'a [u8],
    at: usize,
}

impl<'a> Bytes<'a> {
    /// Starts at byte `at`.
    pub(crate) fn starting_at(source: &'a [u8], at: usize) -> Self {
        Self { source, at }
    }

    /// Returns where the next byte stands.
    pub(crate) fn at(&self) -> usize {
        self.at
    }

    /// Returns the next `count` bytes, or the error that they are not there.
    #[inline]
    pub(crate) fn take(&mut self, count: usize, what: impl Display) -> Result<&'a [u8], ParseError> {
        let taken = self.at.checked_add(count).and_then(|end| self.source.get(self.at..end));
        let taken = taken.ok_or_else(|| self.ended(what))?;
        self.at += count;
        Ok(taken)
    }

    /// Returns the next byte.
    #[inline]
    pub(crate) fn byte(&mut self, what: impl Display) -> Result<u8, ParseError> {
        self.array(what).map(|[byte]| byte)
    }

    /// Returns the next `N` bytes.
    #[inline]
    pub(crate) fn array<const N: usize>(&mut self, what: impl Display) -> Result<[u8; N], ParseError> {
        let rest = self.source.get(self.at..).and_then(|rest| rest.first_chunk::<N>());
        let taken = *rest.ok_or_else(|| self.ended(what))?;
        self.at += N;
        Ok(taken)
    }

    fn ended(&self, what: impl Display) -> ParseError {
        error_at(self.source.len(), what, "the end of the file")
    }
}

/// Returns the error at byte `at`.
pub(crate) fn error_at(at: usize, expected: impl Display, found: impl Display) -> ParseError {
    ParseError { position: Position::Byte(at), expected: expected.to_string(), found: found.to_string() }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bytes_come_one_after_the_other_and_never_past_the_end() {
        let mut bytes = Bytes::starting_at(b"abcdef", 1);
        assert_eq!(bytes.byte("a letter"), Ok(b'b'));
        assert_eq!(bytes.array("two letters"), Ok([b'c', b'd']));
        let error = bytes.take(3, "three letters").unwrap_err();
        assert_eq!(error.to_string(), "byte 0x6: expected three letters, found the end of the file");
        assert_eq!(bytes.take(usize::MAX, "far too many").unwrap_err().position, Position::Byte(6));
        assert_eq!((bytes.take(2, "two letters"), bytes.at()), (Ok(&b"ef"[..]), 6));
        assert!(Bytes::starting_at(b"abc", 9).byte("a letter").is_err());
    }
}
