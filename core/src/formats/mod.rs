//! One file or folder per format, named after it.
//!
//! Each goes in three steps: bytes -> what the file says ([`asf::Asf`], [`bvh::Bvh`], [`c3d::C3d`]: its own units, order and
//! names) -> our [`Skeleton`](crate::Skeleton) and [`Motion`](crate::Motion), or [`Markers`](crate::Markers). Writers go the
//! same way back.

pub mod amc;
pub mod asf;
pub mod bvh;
pub mod c3d;
pub mod csm;
mod fields;
pub(crate) mod kind;
pub mod trc;

/// The unit in which an Acclaim file gives angles.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum AngleUnit {
    /// 360 for a full turn.
    Degrees,
    /// Two pi for a full turn.
    Radians,
}

impl AngleUnit {
    /// Returns an angle in this unit as radians.
    #[inline]
    pub fn radians(self, angle: f64) -> f64 {
        match self {
            Self::Degrees => angle.to_radians(),
            Self::Radians => angle,
        }
    }

    /// Returns an angle in radians as this unit has it.
    #[inline]
    pub fn of_radians(self, radians: f64) -> f64 {
        match self {
            Self::Degrees => radians.to_degrees(),
            Self::Radians => radians,
        }
    }
}
