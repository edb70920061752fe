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
mod frame_values;
pub(crate) mod kind;
mod parts;
mod rows;
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

    /// Returns an angle in radians as this unit has it: degrees that were a number of up to 15 digits are that number
    /// again, and not the neighbour that two roundings may lead to.
    pub fn of_radians(self, radians: f64) -> f64 {
        if self == Self::Radians {
            return radians;
        }
        let degrees = radians.to_degrees();
        // Powers of ten up to this one are exact, and so is a number of 15 digits without a point.
        let decimals = 14.0 - degrees.abs().log10().floor();
        if !(0.0..=22.0).contains(&decimals) {
            return degrees;
        }
        let scale = 10_f64.powi(decimals as i32);
        let rounded = (degrees * scale).round() / scale;
        if rounded.to_radians() == radians {
            rounded
        } else {
            degrees
        }
    }
}

#[cfg(test)]
mod tests {
    use super::AngleUnit;

    #[test]
    fn degrees_of_a_file_come_back_as_they_were() {
        let angles = (0..2_000_000).step_by(37).map(|angle| f64::from(angle - 1_000_000) / 1e4);
        let tiny = [1e-7, 0.000_123_456, -3.788_43, 5.189_87, 359.999_999, 0.0, -720.5];
        for degrees in angles.chain(tiny) {
            let back = AngleUnit::Degrees.of_radians(AngleUnit::Degrees.radians(degrees));
            assert_eq!(back.to_bits(), degrees.to_bits(), "{degrees}");
        }
    }
}
