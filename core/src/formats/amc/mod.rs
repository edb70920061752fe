//! Acclaim motions (`.amc`).
//!
//! ```text
//! amc    = { keyword } frame { frame }
//! keyword = :FULLY-SPECIFIED | :DEGREES | :RADIANS | :SAMPLES-PER-SECOND N | :FORCE-ALL-JOINTS-BE-3DOF | :OTHER ...
//! frame  = NUMBER { NAME { VALUE } }          the number and each bone on a line of its own
//! ```
//! Keywords are recognised in either case and come in any order. The bones of the first frame are the file's bones;
//! every frame lists the same ones with as many values each, in any order. A bone that is missing in a frame, or is
//! there twice, is an error: no reader could know its pose. Frame numbers that do not ascend by one are kept, and a
//! notice says so. A file that was cut off is an error unless it was cut between two frames (or within the very last
//! number): what is left is then a shorter motion, and nothing in the format can tell.

mod build;
mod frame;
mod frames;
mod header;
mod motion;
mod read;
mod skim;
#[cfg(test)]
mod tests;
mod write;

pub use build::with_dofs_for;
pub use header::skeleton_hint;

use super::AngleUnit;
use crate::error::ParseError;

/// What an AMC file says, in its own units and order.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Amc {
    /// What stands before the first frame.
    pub header: AmcHeader,
    /// The bones of each frame, in the order of the first.
    pub bones: Vec<AmcBone>,
    /// The number of the first frame.
    pub first_frame: i64,
    /// How many frames there are.
    pub frame_count: usize,
    /// The number of each frame where they do not ascend by one; otherwise empty.
    pub frame_numbers: Vec<i64>,
    /// Frame by frame the values of all bones, as they are in the file.
    pub values: Vec<f64>,
}

/// What stands before the first frame.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct AmcHeader {
    /// The skeleton's file as the comment `#!OML:ASF` names it; files get renamed, so it is only a hint.
    pub skeleton_hint: Option<String>,
    /// `:FULLY-SPECIFIED`.
    pub is_fully_specified: bool,
    /// `:FORCE-ALL-JOINTS-BE-3DOF`: three values for every bone, whatever its degrees of freedom.
    pub is_forced_to_3dof: bool,
    /// `:DEGREES` or `:RADIANS`.
    pub angle: Option<AngleUnit>,
    /// `:SAMPLES-PER-SECOND`; more than 0.
    pub rate_hz: Option<f64>,
    /// Other keyword lines, as they are.
    pub others: Vec<String>,
}

/// One bone of the frames.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct AmcBone {
    /// The bone's name: one word.
    pub name: String,
    /// How many values it has in a frame.
    pub width: usize,
}

impl Amc {
    /// Reads what a file says.
    ///
    /// # Errors
    /// Where the bytes are something else, a number is missing or damaged, or a frame does not list the bones of the
    /// first.
    pub fn parse(source: &[u8]) -> Result<Self, ParseError> {
        read::parse(source)
    }

    /// Returns the unit of the file's angles; degrees where it does not say.
    pub fn angle_unit(&self) -> AngleUnit {
        self.header.angle.unwrap_or(AngleUnit::Degrees)
    }

    /// Returns how many values a frame has.
    pub fn width(&self) -> usize {
        self.bones.iter().map(|bone| bone.width).sum()
    }

    /// Returns what is odd in the file and what was done about it, a sentence each.
    pub fn notices(&self) -> Vec<String> {
        let mut notices = Vec::new();
        if self.header.angle.is_none() {
            notices.push("The file does not say whether angles are degrees or radians: degrees assumed".to_owned());
        }
        let uneven = self.frame_numbers.windows(2).find_map(|pair| match pair {
            [before, after] if before.checked_add(1) != Some(*after) => Some((*before, *after)),
            _ => None,
        });
        if let Some((before, after)) = uneven {
            notices.push(format!(
                "Frame numbers do not ascend by one (after {before} comes {after}): \
                 the {} frames are taken one after the other from {}",
                self.frame_count, self.first_frame
            ));
        }
        notices
    }
}
