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
use crate::bytes::{error_at, Bytes};
use crate::error::ParseError;
use crate::text::{decode, quoted};
use std::ops::Range;

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
    fn of_number(number: u8) -> Option<Self> {
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

    fn width(self) -> usize {
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
        let byte = |byte: &u8| f64::from(*byte as i8);
        let integer = |bytes: &[u8; 2]| f64::from(self.processor.i16(*bytes));
        let float = |bytes: &[u8; 4]| f64::from(self.processor.f32(*bytes));
        match self.kind {
            ParameterType::Text => Vec::new(),
            ParameterType::Byte => self.bytes.iter().map(byte).collect(),
            ParameterType::Integer => self.bytes.as_chunks().0.iter().map(integer).collect(),
            ParameterType::Float => self.bytes.as_chunks().0.iter().map(float).collect(),
        }
    }

    /// Returns the first value.
    pub fn number(&self) -> Option<f64> {
        let width = self.kind.width();
        Parameter { bytes: self.bytes.get(..width)?, ..*self }.numbers().first().copied()
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

/// One entry of the section.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Item<'a> {
    Group(Group<'a>),
    Parameter(Parameter<'a>),
}

/// Where everything of the section is.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Index {
    entries: Vec<Entry>,
    processor: Processor,
    /// Where the section begins.
    pub(super) start: usize,
    /// Where the last entry ends.
    pub(super) end: usize,
    /// How many blocks the section says it has.
    pub(super) block_count: usize,
}

#[derive(Debug, Clone, PartialEq)]
struct Entry {
    /// Negative for a group.
    id: i8,
    is_locked: bool,
    name: Range<usize>,
    /// A parameter's type, dimensions and values.
    content: Option<(ParameterType, Range<usize>, Range<usize>)>,
    description: Range<usize>,
}

impl Entry {
    fn item<'a>(&self, source: &'a [u8], processor: Processor) -> Item<'a> {
        let group = self.id.unsigned_abs();
        let (name, description) = (part(source, &self.name), part(source, &self.description));
        let is_locked = self.is_locked;
        match &self.content {
            None => Item::Group(Group { id: group, name, is_locked, description }),
            Some((kind, dimensions, values)) => Item::Parameter(Parameter {
                group,
                name,
                is_locked,
                kind: *kind,
                dimensions: part(source, dimensions),
                bytes: part(source, values),
                description,
                processor,
            }),
        }
    }
}

impl Index {
    /// Reads the section at byte `start` that at most reaches to byte `limit`.
    pub(super) fn parse(source: &[u8], start: usize, limit: usize) -> Result<Self, ParseError> {
        let mut bytes = Bytes::starting_at(source, start);
        let [_, _, block_count, number] = bytes.array("the head of the parameter section")?;
        let processor = Processor::of_number(number)
            .ok_or_else(|| error_at(start + 3, "a processor type: 84 (Intel), 85 (DEC) or 86 (MIPS)", number))?;
        let mut index =
            Self { entries: Vec::with_capacity(64), processor, start, end: 0, block_count: block_count.into() };
        let limit = limit.min(source.len());
        let mut is_last = false;
        while !is_last && bytes.at() < limit {
            is_last = index.read_entry(source, &mut bytes)?;
        }
        index.end = bytes.at();
        Ok(index)
    }

    /// Reads one entry, and returns true where it was the last.
    fn read_entry<'a>(&mut self, source: &'a [u8], bytes: &mut Bytes<'a>) -> Result<bool, ParseError> {
        let length = bytes.byte("a parameter")? as i8;
        if length == 0 {
            return Ok(true);
        }
        let id = bytes.byte("the group of a parameter")? as i8;
        let name = range(bytes, length.unsigned_abs().into(), "the name of a parameter")?;
        let pointer_at = bytes.at();
        let pointer = self.processor.u16(bytes.array("the way to the next parameter")?);
        let content = if id < 0 { None } else { Some(read_content(source, bytes, &name)?) };
        let is_last = pointer == 0;
        let end = if is_last { source.len() } else { pointer_at + usize::from(pointer) };
        let description = if bytes.at() < end {
            // A description that would run into the next entry ends there.
            let stated = bytes.byte("the length of a description")?;
            let length = usize::from(stated).min(end.saturating_sub(bytes.at()));
            range(bytes, length, "a description")?
        } else {
            bytes.at()..bytes.at()
        };
        self.entries.push(Entry { id, is_locked: length < 0, name, content, description });
        if !is_last {
            *bytes = Bytes::starting_at(source, end);
        }
        Ok(is_last)
    }

    pub(super) fn processor(&self) -> Processor {
        self.processor
    }

    /// Returns groups and parameters in file order.
    pub(super) fn items<'a>(&'a self, source: &'a [u8]) -> impl Iterator<Item = Item<'a>> + use<'a> {
        self.entries.iter().map(|entry| entry.item(source, self.processor))
    }

    pub(super) fn groups<'a>(&'a self, source: &'a [u8]) -> impl Iterator<Item = Group<'a>> + use<'a> {
        self.items(source).filter_map(|item| if let Item::Group(group) = item { Some(group) } else { None })
    }

    pub(super) fn parameters<'a>(&'a self, source: &'a [u8]) -> impl Iterator<Item = Parameter<'a>> + use<'a> {
        self.items(source).filter_map(|item| if let Item::Parameter(known) = item { Some(known) } else { None })
    }

    /// Returns the first parameter of that name; letters match in either case.
    pub(super) fn find<'a>(&'a self, source: &'a [u8], group: &str, name: &str) -> Option<Parameter<'a>> {
        // Lengths first: nearly all others differ there already.
        let is = |found: &Range<usize>, wanted: &str| {
            found.len() == wanted.len() && part(source, found).eq_ignore_ascii_case(wanted.as_bytes())
        };
        let group = self.entries.iter().find(|entry| entry.id < 0 && is(&entry.name, group))?.id.unsigned_abs();
        let is_own = |entry: &&Entry| entry.id >= 0 && entry.id.unsigned_abs() == group;
        let own = self.entries.iter().find(|entry| is_own(entry) && is(&entry.name, name))?;
        match own.item(source, self.processor) {
            Item::Parameter(parameter) => Some(parameter),
            Item::Group(_) => None,
        }
    }
}

/// Reads type, dimensions and values.
fn read_content(
    source: &[u8],
    bytes: &mut Bytes<'_>,
    name: &Range<usize>,
) -> Result<(ParameterType, Range<usize>, Range<usize>), ParseError> {
    const MOST_DIMENSIONS: u8 = 7;
    let name = || quoted(part(source, name));
    let at = bytes.at();
    let number = bytes.byte("the type of a parameter")?;
    let kind = ParameterType::of_number(number).ok_or_else(|| {
        let expected = format_args!("a type of parameter {}: -1, 1, 2 or 4", name()).to_string();
        error_at(at, expected, number as i8)
    })?;
    let at = bytes.at();
    let count = bytes.byte("the number of dimensions of a parameter")?;
    if count > MOST_DIMENSIONS {
        return Err(error_at(at, format!("at most 7 dimensions of parameter {}", name()), count));
    }
    let dimensions = range(bytes, count.into(), "the dimensions of a parameter")?;
    // Seven dimensions of at most 255 and four bytes stay below 2^58.
    let product: u64 = part(source, &dimensions).iter().map(|dimension| u64::from(*dimension)).product();
    let length = usize::try_from(product).unwrap_or(usize::MAX).saturating_mul(kind.width());
    let at = bytes.at();
    let values = range(bytes, length, "").map_err(|error| {
        let expected = format!("{length} bytes of parameter {}", name());
        error_at(at, expected, error.found)
    })?;
    Ok((kind, dimensions, values))
}

fn range(bytes: &mut Bytes<'_>, length: usize, what: &str) -> Result<Range<usize>, ParseError> {
    let start = bytes.at();
    bytes.take(length, what)?;
    Ok(start..bytes.at())
}

fn part<'a>(source: &'a [u8], range: &Range<usize>) -> &'a [u8] {
    source.get(range.clone()).unwrap_or_default()
}
