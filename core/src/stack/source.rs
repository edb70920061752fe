//! A clip as the entries of a stack share it.

use std::sync::{Arc, Mutex, PoisonError};

use crate::motion::{BoneMotion, Motion};
use crate::sample::{lowpass_angles, lowpass_rotations, lowpass_vectors};

/// A motion in a rig's rest axes, with its low-passed form kept between evaluations.
#[derive(Debug, Default)]
pub struct Source {
    motion: Arc<Motion>,
    lowpassed: Mutex<Option<(f64, Arc<Motion>)>>,
}

impl Source {
    /// Takes a motion whose bones are the rig's (see [`Motion::in_rest_axes`]).
    pub fn new(motion: Motion) -> Self {
        Self { motion: Arc::new(motion), lowpassed: Mutex::new(None) }
    }

    /// Returns the motion as it is.
    pub fn motion(&self) -> &Arc<Motion> {
        &self.motion
    }

    /// Returns the motion without what would alias when only every `ratio`-th frame is taken; itself up to 1.
    pub fn for_ratio(&self, ratio: f64) -> Arc<Motion> {
        if ratio <= 1.0 {
            return Arc::clone(&self.motion);
        }
        // The cache is a plain value that is replaced whole: a panic elsewhere cannot leave it half-written.
        let mut kept = self.lowpassed.lock().unwrap_or_else(PoisonError::into_inner);
        match kept.as_ref() {
            Some((for_ratio, motion)) if *for_ratio == ratio => Arc::clone(motion),
            _ => {
                let bones = self.motion.bones.iter().map(|bone| lowpass(bone, ratio)).collect();
                let motion = Arc::new(Motion {
                    bones,
                    first_frame: self.motion.first_frame,
                    frame_count: self.motion.frame_count,
                    rate_hz: self.motion.rate_hz,
                });
                *kept = Some((ratio, Arc::clone(&motion)));
                motion
            }
        }
    }
}

fn lowpass(bone: &BoneMotion, ratio: f64) -> BoneMotion {
    BoneMotion {
        rotations: lowpass_rotations(&bone.rotations, ratio),
        angles: lowpass_angles(&bone.angles, ratio),
        translations: lowpass_vectors(&bone.translations, ratio),
        stretches: bone.stretches.clone(),
    }
}
