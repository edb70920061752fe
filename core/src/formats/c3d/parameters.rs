//! The parameter section: groups and their parameters, in any order.
//!
//! ```text
//! section   = any any BLOCKS PROCESSOR { group | parameter } 0
//! group     = LENGTH -ID NAME next DESCRIPTION
//! parameter = LENGTH ID NAME next TYPE COUNT { DIMENSION } { value } DESCRIPTION
//! ```
//! A negative `LENGTH` of the name locks the entry. `next` counts bytes from itself to the next entry, 0 ends the
//! section. Texts are a first dimension of characters. Real files state block counts that are too small or reach into
//! the data, leave out the final 0, leave out a last description: entries end where the next begins, the section where
//! `next` or a length is 0 or the data begin.

use super::encoding::Processor;
use crate::text::decode;

/// What a parameter holds.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum ParameterType {
    /// Characters.
    Text,
    /// 8-bit integers.
    Byte,
    /// 16-bit integers.
    Integer,
    /// 32-bit floating point.
    Float,
}

impl ParameterType {
    pub(super) fn of_number(number: u8) -> Option<Self> {
        match number as i8 {
            -1 => Some(Self::Text),
            1 => Some(Self::Byte),
            2 => Some(Self::Integer),
            4 => Some(Self::Float),
            _ => None,
        }
    }

    pub(super) fn number(self) -> u8 {
        match self {
            Self::Text => 0xFF,
            Self::Byte => 1,
            Self::Integer => 2,
            Self::Float => 4,
        }
    }

    pub(super) fn width(self) -> usize {
        match self {
            Self::Text | Self::Byte => 1,
            Self::Integer => 2,
            Self::Float => 4,
        }
    }
}

/// A group of parameters.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Group<'a> {
    /// What its parameters refer to.
    pub id: u8,
    /// Its name.
    pub name: &'a [u8],
    /// Whether programs should leave it alone.
    pub is_locked: bool,
    /// What it is for.
    pub description: &'a [u8],
}

/// One parameter, as it is in the file.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Parameter<'a> {
    /// The number of its group.
    pub group: u8,
    /// Its name.
    pub name: &'a [u8],
    /// Whether programs should leave it alone.
    pub is_locked: bool,
    /// What `bytes` are.
    pub kind: ParameterType,
    /// Its size; the first dimension runs fastest. None for a single value.
    pub dimensions: &'a [u8],
    /// Its values, as the file has them.
    pub bytes: &'a [u8],
    /// What it is for.
    pub description: &'a [u8],
    pub(super) processor: Processor,
}

impl Parameter<'_> {
    /// Returns the values as numbers; nothing for text.
    pub fn numbers(&self) -> Vec<f64> {
        let count = if self.kind == ParameterType::Text { 0 } else { self.bytes.len() / self.kind.width() };
        (0..count).filter_map(|index| self.number_at(index)).collect()
    }

    /// Returns the first value.
    pub fn number(&self) -> Option<f64> {
        self.number_at(0)
    }

    #[inline]
    fn number_at(&self, index: usize) -> Option<f64> {
        match self.kind {
            ParameterType::Text => None,
            ParameterType::Byte => self.bytes.get(index).map(|byte| f64::from(*byte as i8)),
            ParameterType::Integer => self.bytes.as_chunks().0.get(index).map(|b| f64::from(self.processor.i16(*b))),
            ParameterType::Float => self.bytes.as_chunks().0.get(index).map(|b| f64::from(self.processor.f32(*b))),
        }
    }

    /// Returns the first value as a count: integers are taken as unsigned, as files with more than 32,767 frames need it.
    pub fn count(&self) -> Option<usize> {
        let number = self.number()?;
        let unsigned = if number < 0.0 && self.kind == ParameterType::Integer { number + 65536.0 } else { number };
        (0.0..1e9).contains(&unsigned).then_some(unsigned.round() as usize)
    }

    /// Returns the texts of a table of characters, without the blanks and zeros that fill them up.
    pub fn texts(&self) -> Vec<String> {
        let length = self.dimensions.first().map_or(1, |length| usize::from(*length));
        match self.kind {
            ParameterType::Text if length > 0 => self.bytes.chunks(length).map(trimmed).collect(),
            _ => Vec::new(),
        }
    }
}

/// Returns a name as text, without the blanks and zeros that fill it up.
pub(super) fn trimmed(bytes: &[u8]) -> String {
    let is_filling = |byte: &u8| matches!(byte, 0 | b' ');
    let length = bytes.iter().rposition(|byte| !is_filling(byte)).map_or(0, |last| last + 1);
    decode(bytes.get(..length).unwrap_or_default())
}
