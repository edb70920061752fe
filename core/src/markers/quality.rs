//! How well markers were seen.

/// The quality of every sample, as C3D stores it: a word with the cameras in its upper and the residual in its lower byte.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Quality {
    /// One word per sample, marker after marker; negative in a gap. Empty where the format has nothing of the kind.
    pub words: Vec<i16>,
    /// What the lower byte is multiplied by to be a length in file units.
    pub scale: f32,
}

impl Quality {
    /// Returns the residual of every sample in file units, marker after marker: how far the rays of the cameras pass each
    /// other. 0 where it was not measured, -1 in a gap.
    pub fn residuals(&self) -> Vec<f32> {
        let residual = |word: &i16| if *word < 0 { -1.0 } else { f32::from(*word & 0xFF) * self.scale };
        self.words.iter().map(residual).collect()
    }

    /// Returns for every sample, marker after marker, which of the first seven cameras saw it, a bit each.
    pub fn cameras(&self) -> Vec<u8> {
        self.words.iter().map(|word| if *word < 0 { 0 } else { (*word >> 8) as u8 }).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_word_is_cameras_above_and_residual_below() {
        let quality = Quality { words: vec![0x0303, 0x7F00, 0, -1, i16::MIN], scale: 0.5 };
        assert_eq!(quality.residuals(), [1.5, 0.0, 0.0, -1.0, -1.0]);
        assert_eq!(quality.cameras(), [3, 127, 0, 0, 0]);
    }
}
