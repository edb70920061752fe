//! Writes a parameter section.

use super::encoding::Processor;
use super::header::{BLOCK_BYTES, KEY};
use super::parameters::{Group, Parameter, ParameterType};

/// The most values of a dimension.
const MOST: usize = u8::MAX as usize;

/// The most bytes of an entry: the way to the next is a 16-bit word.
const MOST_ENTRY_BYTES: usize = u16::MAX as usize;

/// A parameter section as it grows.
pub(super) struct Section {
    bytes: Vec<u8>,
    processor: Processor,
    group: u8,
}

impl Section {
    pub(super) fn new(processor: Processor) -> Self {
        Self { bytes: vec![1, KEY, 0, processor.number()], processor, group: 0 }
    }

    /// Writes a group; parameters that have no group of their own belong to the last one.
    pub(super) fn group(&mut self, name: &str) {
        self.group += 1;
        let group = Group { id: self.group, name: name.as_bytes(), is_locked: false, description: &[] };
        self.push_group(&group);
    }

    pub(super) fn push_group(&mut self, group: &Group<'_>) {
        self.entry((group.id as i8).wrapping_neg(), group.name, group.is_locked, group.description, &[]);
    }

    pub(super) fn push(&mut self, parameter: &Parameter<'_>) {
        let mut content = Vec::with_capacity(2 + parameter.dimensions.len() + parameter.bytes.len());
        content.push(parameter.kind.number());
        content.push(parameter.dimensions.len() as u8);
        content.extend_from_slice(parameter.dimensions);
        content.extend_from_slice(parameter.bytes);
        self.entry(parameter.group as i8, parameter.name, parameter.is_locked, parameter.description, &content);
    }

    fn add(&mut self, name: &str, kind: ParameterType, dimensions: &[u8], bytes: &[u8]) {
        self.push(&Parameter {
            group: self.group,
            name: name.as_bytes(),
            is_locked: false,
            kind,
            dimensions,
            bytes,
            description: &[],
            processor: self.processor,
        });
    }

    pub(super) fn integer(&mut self, name: &str, value: u16) {
        self.add(name, ParameterType::Integer, &[], &self.processor.u16_bytes(value));
    }

    pub(super) fn float(&mut self, name: &str, value: f32) {
        self.add(name, ParameterType::Float, &[], &self.processor.f32_bytes(value));
    }

    pub(super) fn text(&mut self, name: &str, text: &str) {
        let text = text.as_bytes().get(..MOST).unwrap_or(text.as_bytes());
        self.add(name, ParameterType::Text, &[text.len() as u8], text);
    }

    /// Writes a table of numbers in rows of `width`, in as many parameters as it needs.
    pub(super) fn integers(&mut self, name: &str, width: usize, values: &[u16]) {
        for (name, values) in series(name, values, width * MOST) {
            let bytes: Vec<u8> = values.iter().flat_map(|value| self.processor.u16_bytes(*value)).collect();
            self.add(&name, ParameterType::Integer, &dimensions(width, values.len()), &bytes);
        }
    }

    /// Writes a table of numbers in rows of `width`, in as many parameters as it needs.
    pub(super) fn floats(&mut self, name: &str, width: usize, values: &[f32]) {
        for (name, values) in series(name, values, width * MOST) {
            let bytes: Vec<u8> = values.iter().flat_map(|value| self.processor.f32_bytes(*value)).collect();
            self.add(&name, ParameterType::Float, &dimensions(width, values.len()), &bytes);
        }
    }

    /// Writes texts, filled up to the same length, in as many parameters as they need.
    pub(super) fn texts(&mut self, name: &str, texts: &[&str]) {
        // 255 texts of 255 bytes and their head would be just too long for an entry.
        let longest = texts.iter().map(|text| text.len()).max().unwrap_or(0).clamp(1, MOST_ENTRY_BYTES / MOST - 2);
        for (name, texts) in series(name, texts, MOST) {
            let padded = |text: &&str| {
                let text = text.bytes().chain(std::iter::repeat(b' ')).take(longest);
                text.collect::<Vec<u8>>()
            };
            let bytes: Vec<u8> = texts.iter().flat_map(padded).collect();
            self.add(&name, ParameterType::Text, &[longest as u8, texts.len() as u8], &bytes);
        }
    }

    fn entry(&mut self, id: i8, name: &[u8], is_locked: bool, description: &[u8], content: &[u8]) {
        let name = name.get(..127).unwrap_or(name);
        let description = description.get(..MOST).unwrap_or(description);
        let length = name.len() as i8;
        self.bytes.extend_from_slice(&[(if is_locked { -length } else { length }) as u8, id as u8]);
        self.bytes.extend_from_slice(name);
        let to_next = 2 + content.len() + 1 + description.len();
        self.bytes.extend_from_slice(&self.processor.u16_bytes(to_next as u16));
        self.bytes.extend_from_slice(content);
        self.bytes.push(description.len() as u8);
        self.bytes.extend_from_slice(description);
    }

    /// Ends the section with a block's end and states its number of blocks, as far as a byte can.
    pub(super) fn finish(mut self) -> Vec<u8> {
        self.bytes.extend_from_slice(&[0, 0]);
        self.bytes.resize(self.bytes.len().next_multiple_of(BLOCK_BYTES), 0);
        let block_count = (self.bytes.len() / BLOCK_BYTES).min(MOST);
        if let Some(place) = self.bytes.get_mut(2) {
            *place = block_count as u8;
        }
        self.bytes
    }
}

/// Splits what is too long for one parameter: `LABELS`, `LABELS2` ...; one empty part where there is nothing.
fn series<'a, T>(name: &str, values: &'a [T], most: usize) -> Vec<(String, &'a [T])> {
    if values.is_empty() {
        return vec![(name.to_owned(), values)];
    }
    let named = |(index, values)| {
        let name = if index == 0 { name.to_owned() } else { format!("{name}{}", index + 1) };
        (name, values)
    };
    values.chunks(most.max(1)).enumerate().map(named).collect()
}

fn dimensions(width: usize, count: usize) -> Vec<u8> {
    if width == 1 {
        vec![count as u8]
    } else {
        vec![width as u8, (count / width.max(1)) as u8]
    }
}
