//! Sines and cosines of many angles at once.
//!
//! The C library takes one angle at a time, and they are most of what turning a file's angles into rotations costs. Here
//! nothing branches on an angle, so that the compiler works on several of them side by side: each is brought to within an
//! eighth of a turn of 0, where the Taylor series are short.

use std::f64::consts::{FRAC_2_PI, FRAC_PI_2};

/// A quarter turn in two parts: whole numbers of up to 20 bits times the first are exact, and the second, with what
/// `FRAC_PI_2` itself lacks, goes on where that ends.
const QUARTER_HIGH: f64 = f64::from_bits(FRAC_PI_2.to_bits() & !0xF_FFFF);
const QUARTER_LOW: f64 = (FRAC_PI_2 - QUARTER_HIGH) + 6.123_233_995_736_766e-17;

/// Beyond so many radians the whole number of quarter turns has more bits.
const MOST: f64 = 1e6;

/// Added to a number far below it, this leaves the nearest whole one in the lowest bits.
const ROUNDING: f64 = 1.5 * (1_u64 << 52) as f64;

/// From the third power of the angle on, up to the last one that can change a result within an eighth of a turn.
const SINE_TERMS: [f64; 8] = taylor(3.0);

/// From the second power on.
const COSINE_TERMS: [f64; 8] = taylor(2.0);

/// Returns -1/n!, 1/(n + 2)!, -1/(n + 4)! and so on for `first`, which is 2 or 3.
const fn taylor(first: f64) -> [f64; 8] {
    let mut terms = [0.0; 8];
    let (mut term, mut power, mut index) = (-1.0 / (first * (first - 1.0)), first, 0);
    while index < terms.len() {
        terms[index] = term;
        term /= -(power + 1.0) * (power + 2.0);
        power += 2.0;
        index += 1;
    }
    terms
}

/// Returns sines and cosines of angles in radians, each to within 4e-16.
#[inline(always)]
pub(super) fn sines_and_cosines<const N: usize>(angles: &[f64; N]) -> ([f64; N], [f64; N]) {
    let (mut sines, mut cosines) = ([0.0; N], [0.0; N]);
    // One loop over all of them: an angle that is too large leads the way out afterwards.
    let mut are_usual = true;
    for ((angle, sine), cosine) in angles.iter().zip(&mut sines).zip(&mut cosines) {
        are_usual &= angle.abs() <= MOST;
        (*sine, *cosine) = near_zero(*angle);
    }
    if !are_usual {
        for ((angle, sine), cosine) in angles.iter().zip(&mut sines).zip(&mut cosines) {
            (*sine, *cosine) = angle.sin_cos();
        }
    }
    (sines, cosines)
}

/// Returns sine and cosine of up to [`MOST`] radians.
#[inline(always)]
fn near_zero(angle: f64) -> (f64, f64) {
    let rounded = angle * FRAC_2_PI + ROUNDING;
    let quarters = rounded - ROUNDING;
    let rest = (angle - quarters * QUARTER_HIGH) - quarters * QUARTER_LOW;
    let square = rest * rest;
    let (mut sine, mut cosine) = (0.0, 0.0);
    for index in (0..SINE_TERMS.len()).rev() {
        sine = sine * square + SINE_TERMS[index];
        cosine = cosine * square + COSINE_TERMS[index];
    }
    let (sine, cosine) = (rest + rest * (sine * square), 1.0 + cosine * square);
    // After an odd number of quarter turns they change places; signs change after two quarters and after one.
    let quarters = rounded.to_bits();
    let (sine, cosine, swap) = (sine.to_bits(), cosine.to_bits(), (quarters & 1).wrapping_neg());
    let sign = |quarters: u64| (quarters & 2) << 62;
    let with_sine = (sine & !swap | cosine & swap) ^ sign(quarters);
    let with_cosine = (cosine & !swap | sine & swap) ^ sign(quarters.wrapping_add(1));
    (f64::from_bits(with_sine), f64::from_bits(with_cosine))
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    const ACCURACY: f64 = 4e-16;

    fn assert_as_in_the_c_library(angle: f64) {
        let ([sine], [cosine]) = sines_and_cosines(&[angle]);
        assert!((sine - angle.sin()).abs() <= ACCURACY, "sine of {angle}: {sine}, {}", angle.sin());
        assert!((cosine - angle.cos()).abs() <= ACCURACY, "cosine of {angle}: {cosine}, {}", angle.cos());
    }

    #[test]
    fn quarter_turns_and_their_borders_are_right() {
        for eighths in -80_000..80_000 {
            let angle = f64::from(eighths) * FRAC_PI_2 / 2.0;
            for angle in [angle.next_down(), angle, angle.next_up()] {
                assert_as_in_the_c_library(angle);
            }
        }
    }

    #[test]
    fn nothing_is_lost_of_small_angles() {
        for angle in [0.0, 1e-300, -1e-17, 1e-8, 0.001, -0.01] {
            let ([sine], [cosine]) = sines_and_cosines(&[angle]);
            assert!((sine - angle.sin()).abs() <= f64::EPSILON * angle.abs(), "{angle}: {sine}");
            assert_eq!(cosine, angle.cos(), "{angle}");
        }
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(20_000))]

        #[test]
        fn angles_of_any_size_are_as_in_the_c_library(
            turned in -10.0..10.0_f64, far in -2e6..2e6_f64, beyond in proptest::num::f64::NORMAL,
        ) {
            assert_as_in_the_c_library(turned);
            assert_as_in_the_c_library(far);
            assert_as_in_the_c_library(beyond);
            let (sines, _) = sines_and_cosines(&[turned, beyond]);
            prop_assert!((sines[0] - turned.sin()).abs() <= ACCURACY);
        }
    }
}
