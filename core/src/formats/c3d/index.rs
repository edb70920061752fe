//! Where everything of a parameter section is (see [`super::parameters`]).

use super::encoding::Processor;
use super::parameters::{Group, Parameter, ParameterType};
use crate::bytes::{error_at, Bytes};
use crate::error::ParseError;
use crate::text::quoted;

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

/// A group or a parameter: where it begins, and how long its parts are, which follow each other.
#[derive(Debug, Clone, PartialEq)]
struct Entry {
    start: usize,
    /// Negative for a group.
    id: i8,
    is_locked: bool,
    name_length: u8,
    /// Of a parameter.
    content: Option<Content>,
    description_length: u8,
}

/// A parameter's type, dimensions and values.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Content {
    kind: ParameterType,
    dimension_count: u8,
    value_bytes: usize,
}

impl Entry {
    /// Behind its length and its group.
    fn name<'a>(&self, source: &'a [u8]) -> &'a [u8] {
        part(source, self.start + 2, self.name_length.into())
    }

    fn item<'a>(&self, source: &'a [u8], processor: Processor) -> Item<'a> {
        let (group, name, is_locked) = (self.id.unsigned_abs(), self.name(source), self.is_locked);
        let content_at = self.start + 2 + name.len() + 2;
        let Some(content) = self.content else {
            let description = part(source, content_at + 1, self.description_length.into());
            return Item::Group(Group { id: group, name, is_locked, description });
        };
        let dimensions = part(source, content_at + 2, content.dimension_count.into());
        let values_at = content_at + 2 + dimensions.len();
        let bytes = part(source, values_at, content.value_bytes);
        let description = part(source, values_at + bytes.len() + 1, self.description_length.into());
        Item::Parameter(Parameter {
            group,
            name,
            is_locked,
            kind: content.kind,
            dimensions,
            bytes,
            description,
            processor,
        })
    }
}

/// What a section begins with, in words.
const HEAD: &str = "the head of the parameter section";

/// Few files have more groups and parameters.
const USUAL_ENTRIES: usize = 128;

/// No parameter has more dimensions.
const MOST_DIMENSIONS: u8 = 7;

/// Eight bytes of 1.
const EACH_1: u64 = u64::MAX / 0xFF;

/// Returns for which processor the section at byte `start` was written, and with it the file.
pub(super) fn processor(source: &[u8], start: usize) -> Result<Processor, ParseError> {
    let [.., number] = Bytes::starting_at(source, start).array::<4>(HEAD)?;
    let known = Processor::of_number(number);
    known.ok_or_else(|| error_at(start + 3, "a processor type: 84 (Intel), 85 (DEC) or 86 (MIPS)", number))
}

impl Index {
    /// Reads the section at byte `start` that at most reaches to byte `limit`.
    pub(super) fn parse(source: &[u8], start: usize, limit: usize) -> Result<Self, ParseError> {
        let mut bytes = Bytes::starting_at(source, start);
        let [_, _, block_count, _] = bytes.array(HEAD)?;
        let (processor, block_count) = (processor(source, start)?, block_count.into());
        let mut index = Self { entries: Vec::with_capacity(USUAL_ENTRIES), processor, start, end: 0, block_count };
        let limit = limit.min(source.len());
        let mut is_last = false;
        while !is_last && bytes.at() < limit {
            match usual_entry(source, bytes.at(), processor) {
                Some((entry, next)) => {
                    index.entries.push(entry);
                    bytes = Bytes::starting_at(source, next);
                }
                None => is_last = index.read_entry(source, &mut bytes)?,
            }
        }
        index.end = bytes.at();
        Ok(index)
    }

    /// The clear version: reads one entry, and returns true where it was the last.
    fn read_entry<'a>(&mut self, source: &'a [u8], bytes: &mut Bytes<'a>) -> Result<bool, ParseError> {
        let start = bytes.at();
        let length = bytes.byte("a parameter")? as i8;
        if length == 0 {
            return Ok(true);
        }
        let id = bytes.byte("the group of a parameter")? as i8;
        let name_length = length.unsigned_abs();
        let name = bytes.take(name_length.into(), "the name of a parameter")?;
        let pointer_at = bytes.at();
        let pointer = self.processor.u16(bytes.array("the way to the next parameter")?);
        let content = if id < 0 { None } else { Some(read_content(bytes, name)?) };
        let is_last = pointer == 0;
        let end = if is_last { source.len() } else { pointer_at + usize::from(pointer) };
        let mut description_length = 0;
        if bytes.at() < end {
            // A description that would run into the next entry ends there.
            let stated = bytes.byte("the length of a description")?;
            description_length = end.saturating_sub(bytes.at()).min(stated.into()) as u8;
            bytes.take(description_length.into(), "a description")?;
        }
        self.entries.push(Entry { start, id, is_locked: length < 0, name_length, content, description_length });
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
        let is = |entry: &Entry, wanted: &str| {
            usize::from(entry.name_length) == wanted.len() && entry.name(source).eq_ignore_ascii_case(wanted.as_bytes())
        };
        let group = self.entries.iter().find(|entry| entry.id < 0 && is(entry, group))?.id.unsigned_abs();
        let is_own = |entry: &&Entry| entry.id >= 0 && entry.id.unsigned_abs() == group;
        let own = self.entries.iter().find(|entry| is_own(entry) && is(entry, name))?;
        match own.item(source, self.processor) {
            Item::Parameter(parameter) => Some(parameter),
            Item::Group(_) => None,
        }
    }
}

/// The fast version: returns a parameter with nothing odd about it that is not the last, and where the next begins.
#[inline]
fn usual_entry(source: &[u8], start: usize, processor: Processor) -> Option<(Entry, usize)> {
    let [length, id, rest @ ..] = source.get(start..)? else { return None };
    let (length, id) = (*length as i8, *id as i8);
    let name_length = length.unsigned_abs();
    let [low, high, number, dimension_count, rest @ ..] = rest.get(name_length.into()..)? else { return None };
    let pointer = usize::from(processor.u16([*low, *high]));
    let kind = ParameterType::of_number(*number)?;
    if length == 0 || id < 0 || pointer == 0 || *dimension_count > MOST_DIMENSIONS {
        return None;
    }
    // As many of these bytes are dimensions as there are; the others count as 1.
    let others = u64::MAX << (8 * u32::from(*dimension_count));
    let dimensions = (u64::from_le_bytes(*rest.first_chunk()?) & !others | EACH_1 & others).to_le_bytes();
    // In pairs, so that no product waits for all before it.
    let [a, b, c, d, e, f, g, _] = dimensions.map(u64::from);
    let value_bytes = usize::try_from((a * b) * (c * d) * ((e * f) * g)).ok()?.checked_mul(kind.width())?;
    let [stated, behind @ ..] = rest.get(usize::from(*dimension_count)..)?.get(value_bytes..)? else { return None };
    let end = start + 2 + usize::from(name_length) + pointer;
    let room = end.min(source.len()).checked_sub(source.len() - behind.len())?;
    if usize::from(*stated) > room {
        return None;
    }
    let content = Content { kind, dimension_count: *dimension_count, value_bytes };
    let (is_locked, description_length) = (length < 0, *stated);
    Some((Entry { start, id, is_locked, name_length, content: Some(content), description_length }, end))
}

/// Reads type, dimensions and values.
fn read_content(bytes: &mut Bytes<'_>, name: &[u8]) -> Result<Content, ParseError> {
    let at = bytes.at();
    let number = bytes.byte("the type of a parameter")?;
    let kind = ParameterType::of_number(number).ok_or_else(|| {
        let expected = format!("a type of parameter {}: -1, 1, 2 or 4", quoted(name));
        error_at(at, expected, number as i8)
    })?;
    let at = bytes.at();
    let dimension_count = bytes.byte("the number of dimensions of a parameter")?;
    if dimension_count > MOST_DIMENSIONS {
        return Err(error_at(at, format!("at most 7 dimensions of parameter {}", quoted(name)), dimension_count));
    }
    let dimensions = bytes.take(dimension_count.into(), "the dimensions of a parameter")?;
    // Seven dimensions of at most 255 and four bytes stay below 2^58.
    let product: u64 = dimensions.iter().map(|dimension| u64::from(*dimension)).product();
    let value_bytes = usize::try_from(product).unwrap_or(usize::MAX).saturating_mul(kind.width());
    let at = bytes.at();
    bytes.take(value_bytes, "").map_err(|error| {
        let expected = format!("{value_bytes} bytes of parameter {}", quoted(name));
        error_at(at, expected, error.found)
    })?;
    Ok(Content { kind, dimension_count, value_bytes })
}

/// Returns `length` bytes of a file; nothing where it ends before.
fn part(source: &[u8], start: usize, length: usize) -> &[u8] {
    source.get(start..start + length).unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::super::section::Section;
    use super::*;
    use proptest::prelude::*;

    fn section(processor: Processor) -> Vec<u8> {
        let mut section = Section::new(processor);
        for group in ["POINT", "ANALOG"] {
            section.group(group);
            section.texts("LABELS", &["LASI", "RASI", "a longer one"]);
            section.floats("OFFSETS", 3, &[1.0; 12]);
            section.integer("USED", 3);
            section.text("EMPTY", "");
        }
        section.finish()
    }

    /// What [`Index::parse`] says without the fast version.
    fn clear(source: &[u8]) -> Result<Index, ParseError> {
        let processor = processor(source, 0)?;
        let mut bytes = Bytes::starting_at(source, 0);
        let [_, _, block_count, _] = bytes.array(HEAD)?;
        let mut index = Index { entries: Vec::new(), processor, start: 0, end: 0, block_count: block_count.into() };
        let mut is_last = false;
        while !is_last && bytes.at() < source.len() {
            is_last = index.read_entry(source, &mut bytes)?;
        }
        index.end = bytes.at();
        Ok(index)
    }

    #[test]
    fn most_parameters_are_usual() {
        let source = section(Processor::Intel);
        let index = Index::parse(&source, 0, source.len()).unwrap();
        let is_usual = |entry: &&Entry| usual_entry(&source, entry.start, Processor::Intel).is_some();
        assert_eq!((index.entries.len(), index.entries.iter().filter(is_usual).count()), (10, 8));
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(2_000))]

        #[test]
        fn the_fast_version_says_what_the_clear_one_does(
            is_mips in any::<bool>(),
            changes in proptest::collection::vec((4..220_usize, any::<u8>()), 0..4),
            length in 0..600_usize,
        ) {
            let mut source = section(if is_mips { Processor::Mips } else { Processor::Intel });
            for (at, byte) in changes {
                source[at] = byte;
            }
            source.truncate(length.max(4));
            prop_assert_eq!(Index::parse(&source, 0, source.len()), clear(&source));
        }
    }
}
