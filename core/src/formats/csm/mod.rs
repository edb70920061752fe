//! CSM (`.csm`): markers of Character Studio as text, in millimetres, Z up.
//!
//! ```text
//! csm     = { section }
//! section = "$" NAME [ value ] { line }
//! $order  = { NAME }
//! $points = { NUMBER { X Y Z | "DROPOUT" } }
//! ```
//! Names of sections are recognised in either case; their value stands on the same line or the next ones. `$order` and
//! `$points` must be there, `$firstframe`, `$lastframe` and `$rate` are understood, all other sections are kept as
//! text. A frame is a line, or as many lines as the first one takes; a marker that drops out has one word instead of
//! three numbers.

mod markers;
mod read;
mod skim;
mod write;

use crate::error::ParseError;

/// What a CSM file says, in its own units and order.
#[derive(Debug, Clone, Default)]
pub struct Csm {
    /// Sections of text in file order: `Actor`, `Comments`, `Filename`, `Date`, `Time` and any others.
    pub texts: Vec<(String, String)>,
    /// `$firstframe`.
    pub first_frame: Option<i64>,
    /// `$lastframe`.
    pub last_frame: Option<i64>,
    /// `$rate`: frames per second; more than 0.
    pub rate_hz: Option<f64>,
    /// `$order`: the names of the markers.
    pub order: Vec<String>,
    /// The number of each frame.
    pub frame_numbers: Vec<i64>,
    /// Frame by frame x, y and z of every marker, as in the file; not numbers where it drops out.
    pub values: Vec<f64>,
}

impl Csm {
    /// Reads what a file says.
    ///
    /// # Errors
    /// Where the bytes are something else, `$order` or `$points` is missing, a number is damaged, or a frame has too few
    /// or too many values.
    pub fn parse(source: &[u8]) -> Result<Self, ParseError> {
        read::parse(source)
    }

    /// Returns what is odd in the file and what was done about it, a sentence each.
    pub fn notices(&self) -> Vec<String> {
        let mut notices = Vec::new();
        if self.rate_hz.is_none() {
            notices.push("The file does not say how many frames there are per second".to_owned());
        }
        let (first, count) = (self.frame_numbers.first(), self.frame_numbers.len());
        let stated = self.first_frame.zip(self.last_frame);
        if let Some((stated_first, stated_last)) = stated {
            let last = self.frame_numbers.last();
            if first.is_some_and(|first| *first != stated_first) || last.is_some_and(|last| *last != stated_last) {
                notices.push(format!(
                    "The file speaks of frames {stated_first} to {stated_last}, but holds {count} from {} to {}: \
                     those are taken",
                    first.unwrap_or(&stated_first),
                    last.unwrap_or(&stated_last)
                ));
            }
        }
        let uneven = self.frame_numbers.windows(2).find_map(|pair| match pair {
            [before, after] if before.checked_add(1) != Some(*after) => Some((*before, *after)),
            _ => None,
        });
        if let Some((before, after)) = uneven {
            notices.push(format!(
                "Frame numbers do not ascend by one (after {before} comes {after}): the {count} frames are taken one after \
                 the other"
            ));
        }
        if count == 0 {
            notices.push("The file holds no frame".to_owned());
        }
        notices
    }
}

/// Dropouts are equal to each other, though numbers that are none are not.
impl PartialEq for Csm {
    fn eq(&self, other: &Self) -> bool {
        let same = |(a, b): (&f64, &f64)| a == b || a.is_nan() && b.is_nan();
        self.texts == other.texts
            && (self.first_frame, self.last_frame, self.rate_hz) == (other.first_frame, other.last_frame, other.rate_hz)
            && (&self.order, &self.frame_numbers) == (&other.order, &other.frame_numbers)
            && self.values.len() == other.values.len()
            && self.values.iter().zip(&other.values).all(same)
    }
}
