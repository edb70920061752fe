//! What a file is about, without reading every number in it.
//!
//! A folder of motion capture is thousands of files of hundreds of thousands of numbers; what is asked of each first is how
//! many frames there are, of which bones, how large and how it stands. A few of its frames say that. The others are only
//! looked over: whether they have as many lines and words in all, and no byte where no number has it. Whatever is unusual
//! about a file is left to its reader, so that both say the same; but damage that keeps the shape of a number (a digit for
//! another, two points in one word), or takes a word from one line and gives it to the next, only the reader sees.

use crate::formats::amc::Amc;
use crate::formats::bvh::Bvh;
use crate::formats::csm::Csm;
use crate::formats::trc::Trc;
use crate::read::{Clip, Format};
use std::path::Path;

/// How much of a file is looked at to tell what it is.
const HEAD_BYTES: usize = 4096;

/// A file by some of its frames.
#[derive(Debug, Clone, PartialEq)]
pub struct Skim {
    /// What the file says, with some of its frames alone and no motion made of them; everything else, notices too, is as in
    /// the whole clip.
    pub clip: Clip,
    /// How many frames the file has.
    pub frame_count: usize,
}

/// Looks over a file. `name` gives its extension.
///
/// `None` where the file is no usual one, or of a format that is read as fast: then
/// [`read_bytes`](crate::read::read_bytes) is to be asked.
pub fn skim(source: &[u8], name: &Path) -> Option<Skim> {
    let (clip, frame_count) = match Format::of(source.get(..HEAD_BYTES).unwrap_or(source), name)? {
        Format::Amc => {
            let (amc, count) = Amc::skim(source)?;
            (Clip::of_amc(amc, None), count)
        }
        Format::Bvh => {
            let (bvh, count) = Bvh::skim(source)?;
            (Clip::of_skimmed_bvh(bvh), count)
        }
        Format::Csm => {
            let (csm, markers, count) = Csm::skim(source)?;
            (Clip::of_csm(csm, markers), count)
        }
        Format::Trc => {
            let (trc, markers, count) = Trc::skim(source)?;
            (Clip::of_trc(trc, markers), count)
        }
        Format::Asf | Format::C3d => return None,
    };
    Some(Skim { clip, frame_count })
}
