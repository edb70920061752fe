//! [`Csm`] -> bytes.

use super::read::DROPOUT;
use super::Csm;
use crate::number;
use std::io::Write;

/// About how many bytes a value takes in text: room is made for that many.
const TYPICAL_VALUE_BYTES: usize = 12;

impl Csm {
    /// Returns the file anew: reading it gives an equal `Csm`.
    pub fn to_bytes(&self) -> Vec<u8> {
        let mut out = Vec::with_capacity(TYPICAL_VALUE_BYTES * self.values.len());
        for (name, value) in &self.texts {
            // On one line with the name, for a value may begin with a dollar sign.
            line(&mut out, format_args!("${name} {value}"));
        }
        for (name, number) in [("FirstFrame", self.first_frame), ("LastFrame", self.last_frame)] {
            if let Some(number) = number {
                line(&mut out, format_args!("${name} {number}"));
            }
        }
        if let Some(rate) = self.rate_hz {
            line(&mut out, format_args!("$Rate {rate}"));
        }
        line(&mut out, format_args!("\n$Order\n{}\n\n$Points", self.order.join(" ")));
        let mut points = self.values.as_chunks::<3>().0.iter();
        for frame in &self.frame_numbers {
            let written = write!(out, "{frame}");
            debug_assert!(written.is_ok(), "a vector takes every byte");
            for point in points.by_ref().take(self.order.len()) {
                out.extend_from_slice(b"  ");
                write_point(point, &mut out);
            }
            out.push(b'\n');
        }
        out
    }
}

fn write_point(point: &[f64; 3], out: &mut Vec<u8>) {
    if point.iter().any(|x| x.is_nan()) {
        out.extend_from_slice(DROPOUT.as_bytes());
        return;
    }
    for (index, x) in point.iter().enumerate() {
        if index > 0 {
            out.push(b' ');
        }
        number::write(*x, out);
    }
}

fn line(out: &mut Vec<u8>, text: std::fmt::Arguments<'_>) {
    let written = writeln!(out, "{text}");
    debug_assert!(written.is_ok(), "a vector takes every byte");
}
