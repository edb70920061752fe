//! In which way a C3D file writes its numbers.

use super::vax;

/// The machine that a file was written for: how its numbers lie in bytes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Processor {
    /// Little-endian, IEEE.
    Intel,
    /// Little-endian, VAX F.
    Dec,
    /// Big-endian, IEEE (SGI).
    Mips,
}

/// How points and analog samples are stored.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub enum Storage {
    /// 16-bit integers, to be scaled.
    Integer,
    /// 32-bit floating point; points are not scaled.
    #[default]
    Float,
}

/// How a file is written.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Encoding {
    /// How numbers lie in bytes, everywhere in the file.
    pub processor: Processor,
    /// How points and analog samples are stored.
    pub storage: Storage,
}

/// The file's numbers for processors.
const PROCESSORS: [(u8, Processor); 3] = [(84, Processor::Intel), (85, Processor::Dec), (86, Processor::Mips)];

impl Processor {
    pub(super) fn of_number(number: u8) -> Option<Self> {
        PROCESSORS.iter().find(|(known, _)| *known == number).map(|(_, processor)| *processor)
    }

    pub(super) fn number(self) -> u8 {
        PROCESSORS.iter().find(|(_, known)| *known == self).map_or(0, |(number, _)| *number)
    }

    #[inline]
    pub(super) fn i16(self, bytes: [u8; 2]) -> i16 {
        match self {
            Self::Intel | Self::Dec => i16::from_le_bytes(bytes),
            Self::Mips => i16::from_be_bytes(bytes),
        }
    }

    #[inline]
    pub(super) fn u16(self, bytes: [u8; 2]) -> u16 {
        self.i16(bytes) as u16
    }

    #[inline]
    pub(super) fn f32(self, bytes: [u8; 4]) -> f32 {
        match self {
            Self::Intel => f32::from_le_bytes(bytes),
            Self::Dec => vax::to_f32(bytes),
            Self::Mips => f32::from_be_bytes(bytes),
        }
    }

    #[inline]
    pub(super) fn i16_bytes(self, value: i16) -> [u8; 2] {
        match self {
            Self::Intel | Self::Dec => value.to_le_bytes(),
            Self::Mips => value.to_be_bytes(),
        }
    }

    #[inline]
    pub(super) fn u16_bytes(self, value: u16) -> [u8; 2] {
        self.i16_bytes(value as i16)
    }

    #[inline]
    pub(super) fn f32_bytes(self, value: f32) -> [u8; 4] {
        match self {
            Self::Intel => value.to_le_bytes(),
            Self::Dec => vax::of_f32(value),
            Self::Mips => value.to_be_bytes(),
        }
    }
}

impl Storage {
    /// Returns the bytes of a value.
    #[inline]
    pub fn width(self) -> usize {
        match self {
            Self::Integer => 2,
            Self::Float => 4,
        }
    }
}
