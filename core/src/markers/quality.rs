//! How well markers were seen.

use crate::formats::c3d::Frames;

/// The quality of every sample, where the format has one: which cameras saw the marker, and how far their rays pass each
/// other.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Quality(Option<Frames>);

impl Quality {
    /// Takes what a C3D says.
    pub(crate) fn recorded(frames: Frames) -> Self {
        Self(Some(frames))
    }

    /// Returns the word of a sample as C3D stores it, cameras in its upper and the residual in its lower byte; negative in
    /// a gap, 0 where nothing is known.
    pub(crate) fn word(&self, marker: usize, frame: usize) -> i16 {
        self.0.as_ref().map_or(0, |frames| frames.word(marker, frame))
    }

    /// Returns what the residual in a word is multiplied by to be a length in file units.
    pub(crate) fn scale(&self) -> f32 {
        self.0.as_ref().map_or(0.0, Frames::scale)
    }

    /// Returns the residual of every sample in file units, marker after marker: 0 where it was not measured, -1 in a gap;
    /// nothing where the format has none.
    pub fn residuals(&self) -> Vec<f32> {
        let scale = self.scale();
        let residual = |word: i16| if word < 0 { -1.0 } else { f32::from(word & 0xFF) * scale };
        self.words().into_iter().map(residual).collect()
    }

    /// Returns for every sample, marker after marker, which of the first seven cameras saw it, a bit each; nothing where
    /// the format does not say.
    pub fn cameras(&self) -> Vec<u8> {
        self.words().into_iter().map(|word| if word < 0 { 0 } else { (word >> 8) as u8 }).collect()
    }

    fn words(&self) -> Vec<i16> {
        self.0.as_ref().map(Frames::words).unwrap_or_default()
    }
}
