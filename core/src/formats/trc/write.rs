//! [`Trc`] -> bytes.

use super::Trc;
use crate::number;
use std::io::Write;

/// About how many bytes a value takes in text: room is made for that many.
const TYPICAL_VALUE_BYTES: usize = 12;

impl Trc {
    /// Returns the file anew: reading it gives an equal `Trc`.
    pub fn to_bytes(&self) -> Vec<u8> {
        let mut out = Vec::with_capacity(TYPICAL_VALUE_BYTES * self.values.len());
        line(&mut out, &self.path_file_type);
        line(&mut out, self.header.iter().map(|(key, _)| key));
        line(&mut out, self.header.iter().map(|(_, value)| value));
        let names = self.names.iter().flat_map(|name| [name.as_str(), "", ""]);
        line(&mut out, ["Frame#", "Time"].into_iter().chain(names));
        let axes = (1..=self.names.len()).flat_map(|number| ["X", "Y", "Z"].map(|axis| format!("{axis}{number}")));
        line(&mut out, [String::new(), String::new()].into_iter().chain(axes));
        out.push(b'\n');
        let mut values = self.values.iter();
        for (number, time) in self.frame_numbers.iter().zip(&self.times) {
            let written = write!(out, "{number}\t");
            debug_assert!(written.is_ok(), "a vector takes every byte");
            number::write(*time, &mut out);
            for value in values.by_ref().take(3 * self.names.len()) {
                out.push(b'\t');
                if !value.is_nan() {
                    number::write(*value, &mut out);
                }
            }
            out.push(b'\n');
        }
        out
    }
}

fn line<T: AsRef<str>>(out: &mut Vec<u8>, cells: impl IntoIterator<Item = T>) {
    for (index, cell) in cells.into_iter().enumerate() {
        if index > 0 {
            out.push(b'\t');
        }
        out.extend_from_slice(cell.as_ref().as_bytes());
    }
    out.push(b'\n');
}
