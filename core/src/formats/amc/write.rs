//! [`Amc`] -> bytes.

use super::Amc;
use crate::formats::AngleUnit;
use crate::number;
use std::io::Write;

/// About how many bytes a value takes in text: room is made for that many.
const TYPICAL_VALUE_BYTES: usize = 10;

impl Amc {
    /// Returns the file anew: reading it gives an equal `Amc`.
    pub fn to_bytes(&self) -> Vec<u8> {
        let mut out = Vec::with_capacity(TYPICAL_VALUE_BYTES * self.values.len());
        self.write_header(&mut out);
        let mut values = self.values.iter();
        for frame in 0..self.frame_count {
            line(&mut out, format_args!("{}", self.frame_number(frame)));
            for bone in &self.bones {
                out.extend_from_slice(bone.name.as_bytes());
                for value in values.by_ref().take(bone.width) {
                    out.push(b' ');
                    number::write(*value, &mut out);
                }
                out.push(b'\n');
            }
        }
        out
    }

    /// Returns the file's number of a frame that is counted from 0.
    pub fn frame_number(&self, frame: usize) -> i64 {
        let even = || self.first_frame.saturating_add_unsigned(frame as u64);
        self.frame_numbers.get(frame).copied().unwrap_or_else(even)
    }

    fn write_header(&self, out: &mut Vec<u8>) {
        let header = &self.header;
        if let Some(hint) = &header.skeleton_hint {
            line(out, format_args!("#!OML:ASF {hint}"));
        }
        if header.is_fully_specified {
            line(out, format_args!(":FULLY-SPECIFIED"));
        }
        if header.is_forced_to_3dof {
            line(out, format_args!(":FORCE-ALL-JOINTS-BE-3DOF"));
        }
        match header.angle {
            Some(AngleUnit::Degrees) => line(out, format_args!(":DEGREES")),
            Some(AngleUnit::Radians) => line(out, format_args!(":RADIANS")),
            None => {}
        }
        if let Some(rate) = header.rate_hz {
            line(out, format_args!(":SAMPLES-PER-SECOND {rate}"));
        }
        for other in &header.others {
            line(out, format_args!("{other}"));
        }
    }
}

fn line(out: &mut Vec<u8>, text: std::fmt::Arguments<'_>) {
    let written = writeln!(out, "{text}");
    debug_assert!(written.is_ok(), "a vector takes every byte");
}
