//! TRC (`.trc`): markers as a table of text, the plain format of most laboratories.
//!
//! ```text
//! trc  = "PathFileType" TAB N TAB "(X/Y/Z)" TAB NAME
//!        KEY { TAB KEY }                     DataRate CameraRate NumFrames NumMarkers Units ...
//!        VALUE { TAB VALUE }
//!        "Frame#" TAB "Time" { TAB NAME TAB TAB }
//!        TAB { TAB "X1" TAB "Y1" TAB "Z1" }
//!        { NUMBER TAB TIME { TAB X TAB Y TAB Z } }
//! ```
//! A gap is three empty cells (or `NaN`); a place of which only a coordinate or two are there is none either. Real files have a blank line after the head or not, blanks or tabs at the ends
//! of lines, no last line end, counts in the head that are wrong, rows that end where no more markers are seen, and
//! columns without a name: unlabelled markers. Those are kept as markers without a name.

mod markers;
mod read;
mod skim;
mod write;

use crate::error::ParseError;
use crate::rate::RATES_HZ;

/// What a TRC file says, in its own units and order.
#[derive(Debug, Clone, Default)]
pub struct Trc {
    /// The cells of the first line.
    pub path_file_type: Vec<String>,
    /// The keys of the second line with the values of the third.
    pub header: Vec<(String, String)>,
    /// The names of the markers; empty for columns without one.
    pub names: Vec<String>,
    /// The number of each frame.
    pub frame_numbers: Vec<i64>,
    /// The time of each frame in seconds, as in the file.
    pub times: Vec<f64>,
    /// Frame by frame x, y and z of every marker, as in the file; not numbers in a gap.
    pub values: Vec<f64>,
    /// How many places had a coordinate or two and became gaps.
    broken_places: usize,
}

impl Trc {
    /// Reads what a file says.
    ///
    /// # Errors
    /// Where the bytes are something else, the head is not complete, a number is damaged, or a row ends within a marker.
    pub fn parse(source: &[u8]) -> Result<Self, ParseError> {
        read::parse(source)
    }

    /// Returns the value of a key of the head; letters match in either case.
    pub fn value(&self, key: &str) -> Option<&str> {
        let found = self.header.iter().find(|(known, _)| known.eq_ignore_ascii_case(key));
        found.map(|(_, value)| value.as_str()).filter(|value| !value.is_empty())
    }

    /// Returns the frames per second.
    pub fn rate_hz(&self) -> Option<f64> {
        let rate = self.value("DataRate").and_then(|value| crate::number::read(value.as_bytes()));
        let by_times = || match self.times.as_slice() {
            [first, .., last] if last > first => Some((self.times.len() - 1) as f64 / (last - first)),
            _ => None,
        };
        let is_rate = |rate: &f64| RATES_HZ.contains(rate);
        rate.filter(is_rate).or_else(|| by_times().filter(is_rate))
    }

    /// Returns what is odd in the file and what was done about it, a sentence each.
    pub fn notices(&self) -> Vec<String> {
        let mut notices = Vec::new();
        let found = [("NumFrames", self.frame_numbers.len(), "frames"), ("NumMarkers", self.names.len(), "markers")];
        for (key, count, what) in found {
            let stated = self.value(key).and_then(|value| value.parse::<usize>().ok());
            if let Some(stated) = stated.filter(|stated| *stated != count) {
                notices.push(format!("The head speaks of {stated} {what}, the table has {count}: those are taken"));
            }
        }
        let unnamed = self.names.iter().filter(|name| name.is_empty()).count();
        if unnamed > 0 {
            notices.push(format!("{unnamed} of {} markers have no name", self.names.len()));
        }
        if self.broken_places > 0 {
            notices.push(format!("Places without all three coordinates are taken as gaps: {}", self.broken_places));
        }
        let uneven = self.frame_numbers.windows(2).find_map(|pair| match pair {
            [before, after] if before.checked_add(1) != Some(*after) => Some((*before, *after)),
            _ => None,
        });
        if let Some((before, after)) = uneven {
            notices.push(format!(
                "Frame numbers do not ascend by one (after {before} comes {after}): the frames are taken one after the other"
            ));
        }
        notices
    }
}

/// Gaps are equal to each other, though numbers that are none are not.
impl PartialEq for Trc {
    fn eq(&self, other: &Self) -> bool {
        let same = |(a, b): (&f64, &f64)| a == b || a.is_nan() && b.is_nan();
        (&self.path_file_type, &self.header, &self.names) == (&other.path_file_type, &other.header, &other.names)
            && (&self.frame_numbers, &self.times) == (&other.frame_numbers, &other.times)
            && self.values.len() == other.values.len()
            && self.values.iter().zip(&other.values).all(same)
    }
}
