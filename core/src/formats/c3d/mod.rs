//! C3D (`.c3d`): markers and analog signals of a motion laboratory, in binary.
//!
//! A file is a header of 512 bytes, a parameter section (see [`parameters`]) and the data: frame after frame the points
//! (x, y, z and a word for the quality), then the analog samples of that frame. All integers, or all floating point, in
//! the byte order of one of three processors.
//!
//! Real files contradict themselves: header against parameters, both against the size of the file. [`layout`] decides,
//! and says why. A [`C3d`] keeps the bytes of its file and an index into them, so that nothing is lost and reading costs
//! little more than looking at every number once; [`C3d::markers`] makes plain data of it.

mod compose;
mod encode;
mod encoding;
mod events;
mod frames;
mod header;
mod index;
mod layout;
mod markers;
mod parameters;
mod section;
#[cfg(test)]
mod tests;
mod turn;
mod vax;

pub use encoding::{Encoding, Processor, Storage};
pub use frames::Frames;
pub use header::{Header, HeaderEvent};
pub use layout::Layout;
pub use parameters::{Group, Parameter, ParameterType};

use crate::bytes::error_at;
use crate::error::ParseError;
use crate::formats::kind::{recognise, Kind};
use header::{BLOCK_BYTES, KEY};
use index::Index;
use std::sync::Arc;

/// Where the parameter section is where the file does not say.
const USUAL_PARAMETER_BLOCK: u8 = 2;

/// What a C3D file says, in its own units and order.
#[derive(Debug, Clone, PartialEq)]
pub struct C3d {
    frames: Frames,
    header: Header,
    index: Index,
    notices: Vec<String>,
}

impl C3d {
    /// Reads what a file says; its bytes are kept, or a share in them.
    ///
    /// # Errors
    /// Where the bytes are something else, or end or are damaged before the data begin. Data that end early are read as
    /// far as they go, and a notice says so.
    pub fn parse(bytes: impl Into<Arc<Vec<u8>>>) -> Result<Self, ParseError> {
        let bytes = bytes.into();
        let start = parameter_start(&bytes)?;
        let block = bytes.first_chunk::<BLOCK_BYTES>();
        let block = block.ok_or_else(|| error_at(bytes.len(), "a header of 512 bytes", "the end of the file"))?;
        let processor = index::processor(&bytes, start)?;
        let header = Header::read(block, processor);
        let data_start = usize::from(header.data_block).saturating_sub(1) * BLOCK_BYTES;
        let limit = if data_start > start { data_start } else { bytes.len() };
        let index = Index::parse(&bytes, start, limit)?;
        let (layout, notices) = layout::decide(&bytes, &header, &index);
        Ok(Self { frames: Frames { bytes, layout, processor }, header, index, notices })
    }

    /// Returns the header.
    pub fn header(&self) -> &Header {
        &self.header
    }

    /// Returns what lies where in the data, after header, parameters and the size of the file were compared.
    pub fn layout(&self) -> &Layout {
        &self.frames.layout
    }

    /// Returns how the file is written.
    pub fn encoding(&self) -> Encoding {
        Encoding { processor: self.index.processor(), storage: self.frames.layout.storage }
    }

    /// Returns the groups in file order.
    pub fn groups(&self) -> impl Iterator<Item = Group<'_>> {
        self.index.groups(self.bytes())
    }

    /// Returns the parameters in file order.
    pub fn parameters(&self) -> impl Iterator<Item = Parameter<'_>> {
        self.index.parameters(self.bytes())
    }

    /// Returns a parameter by its group and name; letters match in either case, the first one counts.
    pub fn parameter(&self, group: &str, name: &str) -> Option<Parameter<'_>> {
        self.index.find(self.bytes(), group, name)
    }

    /// Returns the bytes of the declared frames.
    pub fn data(&self) -> &[u8] {
        self.frames.data()
    }

    fn bytes(&self) -> &[u8] {
        &self.frames.bytes
    }

    /// Returns the file as it was read.
    pub fn to_bytes(&self) -> Vec<u8> {
        self.bytes().to_vec()
    }

    /// Returns what is odd in the file and what was done about it, a sentence each.
    pub fn notices(&self) -> Vec<String> {
        self.notices.clone()
    }

    /// Returns the texts of a parameter and of those that go on where it is full: `LABELS`, `LABELS2`, `LABELS3` ...
    fn texts(&self, group: &str, name: &str) -> Vec<String> {
        self.series(group, name).flat_map(|parameter| parameter.texts()).collect()
    }

    /// Returns the numbers of a parameter and of those that go on where it is full.
    fn numbers(&self, group: &str, name: &str) -> Vec<f64> {
        self.series(group, name).flat_map(|parameter| parameter.numbers()).collect()
    }

    fn series<'a>(&'a self, group: &'a str, name: &'a str) -> impl Iterator<Item = Parameter<'a>> {
        // More than there can be points or channels is damage.
        const MOST: usize = u16::MAX as usize / u8::MAX as usize + 1;
        let more = (2..=MOST).map_while(move |number| self.parameter(group, &format!("{name}{number}")));
        let first = self.parameter(group, name);
        let is_full = first.and_then(|first| first.dimensions.last().copied()) == Some(u8::MAX);
        first.into_iter().chain(more.take(if is_full { usize::MAX } else { 0 }))
    }
}

/// Returns where the parameter section begins.
fn parameter_start(bytes: &[u8]) -> Result<usize, ParseError> {
    let key = match bytes {
        [] => return Err(error_at(0, Kind::C3d, "an empty file")),
        [block, key, ..] => Some((*block, *key)),
        [_] => None,
    };
    let Some((block, KEY)) = key else {
        let found = match recognise(bytes) {
            Some(kind) if kind != Kind::C3d => kind.to_string(),
            _ => key.map_or("the end of the file".to_owned(), |(_, key)| format!("{key:#04x} in its second byte")),
        };
        return Err(error_at(1, format_args!("{}, with {KEY:#04x} in its second byte", Kind::C3d), found));
    };
    let block = if block == 0 { USUAL_PARAMETER_BLOCK } else { block };
    let start = (usize::from(block) - 1) * BLOCK_BYTES;
    // Others have that byte too, pictures (PNG) among them.
    if let Some(kind @ Kind::Foreign(_)) = recognise(bytes) {
        let is_processor = bytes.get(start + 3).is_some_and(|number| Processor::of_number(*number).is_some());
        if !is_processor {
            return Err(error_at(0, Kind::C3d, kind));
        }
    }
    Ok(start)
}
