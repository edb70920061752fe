//! VAX F floating point, which DEC machines wrote: IEEE bits, nearly.
//!
//! Sign, eight bits of exponent and 23 bits of fraction stand as in IEEE single precision, but the two 16-bit words come
//! in the other order, the significand is 0.1f instead of 1.f and the exponent counts from 128: the same bits mean a
//! quarter of what IEEE makes of them. There is no infinity, no -0 and no subnormal number; an exponent of 0 is zero, or
//! with the sign set a "reserved operand", which stands for no number.

const EXPONENT: u32 = 0x7F80_0000;
const FRACTION: u32 = 0x007F_FFFF;
const HIDDEN: u32 = 0x0080_0000;
const SIGN: u32 = 0x8000_0000;
/// By how much the exponent fields of the two differ.
const EXPONENT_STEP: u32 = 2 << 23;
/// The lowest exponent field whose number is a normal one in IEEE too.
const FIRST_NORMAL: u32 = 3 << 23;

/// Returns the nearest `f32`: the same number, except that those below 2^-126 may lose their last two bits.
#[inline]
pub(super) fn to_f32(bytes: [u8; 4]) -> f32 {
    let bits = in_order(bytes);
    if bits & EXPONENT >= FIRST_NORMAL {
        f32::from_bits(bits - EXPONENT_STEP)
    } else {
        small(bits)
    }
}

/// Returns the four bytes of a number: zero for what is too small (below 2^-128), the largest number for what is too
/// large (from 2^127) or infinite, the reserved operand for what is none.
#[inline]
pub(super) fn of_f32(value: f32) -> [u8; 4] {
    let bits = value.to_bits();
    let (sign, magnitude) = (bits & SIGN, bits & !SIGN);
    let vax = if value.is_nan() {
        SIGN
    } else if magnitude >= HIDDEN {
        sign | magnitude.saturating_add(EXPONENT_STEP).min(EXPONENT | FRACTION)
    } else {
        of_subnormal(sign, magnitude)
    };
    let [a, b, c, d] = vax.to_le_bytes();
    [c, d, a, b]
}

fn in_order([a, b, c, d]: [u8; 4]) -> u32 {
    u32::from_le_bytes([c, d, a, b])
}

/// Exponent fields 0 (zero, or no number), 1 and 2 (subnormal in IEEE).
#[cold]
fn small(bits: u32) -> f32 {
    let exponent = (bits & EXPONENT) >> 23;
    match (exponent, bits & SIGN) {
        (0, 0) => 0.0,
        (0, _) => f32::NAN,
        (exponent, sign) => {
            // 24 bits at 2^-151 or 2^-150; the cast rounds to the nearest.
            let magnitude = f64::from((bits & FRACTION) | HIDDEN) * 2.0_f64.powi(exponent as i32 - 152);
            (if sign == 0 { magnitude } else { -magnitude }) as f32
        }
    }
}

/// A fraction of up to 23 bits at 2^-149: its highest bit becomes the hidden one.
#[cold]
fn of_subnormal(sign: u32, fraction: u32) -> u32 {
    match fraction.leading_zeros() {
        // From 2^-127.
        9 => sign | (2 << 23) | ((fraction << 1) & FRACTION),
        // From 2^-128.
        10 => sign | (1 << 23) | ((fraction << 2) & FRACTION),
        _ => 0,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// The definition, in `f64`, which holds every VAX F number.
    fn by_definition(bytes: [u8; 4]) -> f64 {
        let bits = in_order(bytes);
        let exponent = ((bits & EXPONENT) >> 23) as i32;
        let sign = if bits & SIGN == 0 { 1.0 } else { -1.0 };
        match exponent {
            0 if sign > 0.0 => 0.0,
            0 => f64::NAN,
            _ => sign * f64::from(bits & FRACTION | HIDDEN) / f64::from(HIDDEN << 1) * 2.0_f64.powi(exponent - 128),
        }
    }

    #[test]
    #[allow(clippy::approx_constant)] // the manual's example is pi to six digits, no more
    fn numbers_of_the_manual_are_read_and_written() {
        let table: [([u8; 4], f32); 6] = [
            ([0x00, 0x00, 0x00, 0x00], 0.0),
            ([0x80, 0x40, 0x00, 0x00], 1.0),
            ([0x80, 0xC0, 0x00, 0x00], -1.0),
            ([0x60, 0x41, 0x00, 0x00], 3.5),
            ([0x49, 0x41, 0xD0, 0x0F], 3.141_59),
            ([0xF0, 0x7D, 0xC2, 0xBD], 1e37),
        ];
        for (bytes, value) in table {
            assert_eq!(of_f32(value), bytes, "{value}");
            assert_eq!(to_f32(bytes).to_bits(), value.to_bits(), "{value}");
        }
        assert!(to_f32([0x00, 0x80, 0, 0]).is_nan());
        assert_eq!(to_f32([0x7F, 0x00, 1, 2]), 0.0);
        assert_eq!(of_f32(f32::NAN), [0x00, 0x80, 0, 0]);
        assert_eq!(of_f32(f32::NEG_INFINITY), [0xFF, 0xFF, 0xFF, 0xFF]);
        assert_eq!(of_f32(-0.0), [0; 4]);
        assert_eq!(of_f32(f32::from_bits(1)), [0; 4]);
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(20_000))]

        #[test]
        fn every_vax_number_is_read_as_defined(bytes in any::<[u8; 4]>()) {
            let (found, expected) = (to_f32(bytes), by_definition(bytes) as f32);
            prop_assert!(found.to_bits() == expected.to_bits() || found.is_nan() && expected.is_nan());
        }

        #[test]
        fn small_vax_numbers_are_read_as_defined(fraction in any::<u32>(), exponent in 0_u32..5, sign in any::<bool>()) {
            let bits = (fraction & FRACTION) | (exponent << 23) | (u32::from(sign) << 31);
            let [a, b, c, d] = bits.to_le_bytes();
            let (found, expected) = (to_f32([c, d, a, b]), by_definition([c, d, a, b]) as f32);
            prop_assert!(found.to_bits() == expected.to_bits() || found.is_nan() && expected.is_nan());
        }

        #[test]
        fn what_is_written_reads_back_to_the_last_bit(bits in any::<u32>()) {
            let value = f32::from_bits(bits);
            let magnitude = f64::from(value).abs();
            prop_assume!(magnitude < 2.0_f64.powi(127) && magnitude >= 2.0_f64.powi(-128));
            prop_assert_eq!(to_f32(of_f32(value)).to_bits(), bits);
        }

        #[test]
        fn vax_numbers_survive_a_way_through_ieee(bytes in any::<[u8; 4]>()) {
            prop_assume!(in_order(bytes) & EXPONENT >= FIRST_NORMAL);
            prop_assert_eq!(of_f32(to_f32(bytes)), bytes);
        }
    }
}
