//! [`Bvh`] -> bytes, and a [`Skeleton`] with its [`Motion`] -> [`Bvh`].

use super::name::name_for_file;
use super::{Bvh, Channel, Joint};
use crate::number;

/// About how many bytes a value takes in text: room is made for that many.
const TYPICAL_VALUE_BYTES: usize = 10;

/// Lines are not indented further than this: a chain of a million joints would be nothing but tabs.
const DEEPEST_INDENT: usize = 32;

impl Bvh {
    /// Returns the file anew: reading it gives equal joints and an equal motion. How many frames it says it has is how many
    /// it holds.
    pub fn to_bytes(&self) -> Vec<u8> {
        let value_count = self.motion.as_ref().map_or(0, |motion| motion.values.len());
        let mut out = Writer(Vec::with_capacity(TYPICAL_VALUE_BYTES * value_count));
        out.line(0, &["HIERARCHY"]);
        self.write_joints(&mut out);
        if let Some(motion) = &self.motion {
            out.line(0, &["MOTION"]);
            out.line(0, &["Frames:", &motion.frame_count.to_string()]);
            if let Some(time) = motion.frame_time_s {
                out.numbers(0, "Frame Time:", &[time]);
            }
            let width = self.width().max(1);
            motion.values.chunks_exact(width).for_each(|row| out.row(row));
        }
        out.0
    }

    fn write_joints(&self, out: &mut Writer) {
        let mut open: Vec<usize> = Vec::new();
        for (index, joint) in self.joints.iter().enumerate() {
            while open.last().copied() != joint.parent && !open.is_empty() {
                open.pop();
                out.line(open.len(), &["}"]);
            }
            joint.write(open.len(), out);
            open.push(index);
        }
        for depth in (0..open.len()).rev() {
            out.line(depth, &["}"]);
        }
    }
}

impl Joint {
    fn write(&self, depth: usize, out: &mut Writer) {
        let keyword = if depth == 0 { "ROOT" } else { "JOINT" };
        out.line(depth, &[keyword, &name_for_file(&self.name)]);
        out.line(depth, &["{"]);
        out.numbers(depth + 1, "OFFSET", &self.offset);
        let count = self.channels.len().to_string();
        let words = self.channels.iter().map(|channel: &Channel| channel.word());
        out.line(depth + 1, &["CHANNELS", &count].into_iter().chain(words).collect::<Vec<_>>());
        for end_site in &self.end_sites {
            out.line(depth + 1, &["End Site", &name_for_file(&end_site.name)]);
            out.line(depth + 1, &["{"]);
            out.numbers(depth + 2, "OFFSET", &end_site.offset);
            out.line(depth + 1, &["}"]);
        }
    }
}

/// The file as far as it is written.
struct Writer(Vec<u8>);

impl Writer {
    /// Writes words that are not empty as one line.
    fn line(&mut self, depth: usize, words: &[&str]) {
        self.indent(depth);
        let words = words.iter().filter(|word| !word.is_empty());
        self.0.extend_from_slice(words.copied().collect::<Vec<_>>().join(" ").as_bytes());
        self.0.push(b'\n');
    }

    /// Writes a keyword and numbers as one line.
    fn numbers(&mut self, depth: usize, keyword: &str, values: &[f64]) {
        self.indent(depth);
        self.0.extend_from_slice(keyword.as_bytes());
        self.0.push(b' ');
        self.row(values);
    }

    fn row(&mut self, values: &[f64]) {
        for (index, value) in values.iter().enumerate() {
            if index > 0 {
                self.0.push(b' ');
            }
            number::write(*value, &mut self.0);
        }
        self.0.push(b'\n');
    }

    fn indent(&mut self, depth: usize) {
        self.0.extend(std::iter::repeat_n(b'\t', depth.min(DEEPEST_INDENT)));
    }
}
