//! Decimal numbers in text: read in one pass, exactly, and written so that they read back exactly.
//!
//! Reading is most of the work on a motion file, so the common number (up to eight digits on either side of the point)
//! is read eight bytes at a time and made without a loop. A mantissa below 2^53 and a power of ten up to 10^22 are both
//! exact as `f64`, so one multiplication or division rounds once and gives the nearest `f64` (Clinger, 1990).
//! Everything else is left to the standard library, which is exact for all input.

/// The powers of ten that `f64` holds exactly.
const POWERS: [f64; 23] = [
    1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20,
    1e21, 1e22,
];

/// Above this, whole numbers are no longer all exact as `f64`.
const EXACT_MANTISSA: u64 = 1 << 53;

/// Nineteen digits always fit into `u64`.
const MANTISSA_DIGITS: usize = 19;

/// Reads the longest number at the start of `text`: its value and how many bytes it takes.
///
/// `[+-] (digits [. [digits]] | . digits) [(e|E) [+-] digits]`, rounded to the nearest `f64`, as [`str::parse`] does it;
/// infinite where the number is too large for `f64`. What follows the number is the caller's business.
///
/// ```
/// use motion_theater_core::number::read_prefix;
///
/// assert_eq!(read_prefix(b"-12.5e-015 7"), Some((-12.5e-15, 10)));
/// assert_eq!(read_prefix(b"lfoot"), None);
/// ```
#[inline]
pub fn read_prefix(text: &[u8]) -> Option<(f64, usize)> {
    read_short(text).or_else(|| read_any(text))
}

/// Reads the whole of `text` as a number, as [`read_prefix`] does.
pub fn read(text: &[u8]) -> Option<f64> {
    let (value, length) = read_prefix(text)?;
    (length == text.len()).then_some(value)
}

/// Reads the whole of `text` as a number or one of the spellings of infinity that C libraries print.
pub fn read_or_infinity(text: &[u8]) -> Option<f64> {
    let (sign, magnitude) = match text {
        [b'-', rest @ ..] => (-1.0, rest),
        [b'+', rest @ ..] => (1.0, rest),
        _ => (1.0, text),
    };
    let spellings: [&[u8]; 3] = [b"inf", b"infinity", b"1.#inf"];
    if spellings.iter().any(|spelling| magnitude.eq_ignore_ascii_case(spelling)) {
        return Some(sign * f64::INFINITY);
    }
    read(text)
}

/// Appends `value` in the fewest digits that read back as the same `f64`.
pub fn write(value: f64, out: &mut Vec<u8>) {
    use std::io::Write;
    let magnitude = value.abs();
    let is_short = magnitude == 0.0 || magnitude.is_infinite() || (1e-5..1e16).contains(&magnitude);
    let written = if is_short { write!(out, "{value}") } else { write!(out, "{value:e}") };
    debug_assert!(written.is_ok(), "a vector takes every byte");
}

/// The fast version: up to eight digits with perhaps a point among them (not first), then perhaps an exponent.
///
/// Where the number ends is found before what it is, and nothing branches on how long it is: the processor can work on
/// several numbers at once.
#[allow(clippy::inline_always)] // Passing the result through memory costs a quarter of the time.
#[inline(always)]
fn read_short(text: &[u8]) -> Option<(f64, usize)> {
    let negative = *text.first()? == b'-';
    let text = text.get(usize::from(negative)..)?;
    let others = others_among(u128::from_le_bytes(*text.first_chunk()?));
    let whole_digits = (others.trailing_zeros() / 8) as usize;
    if !(1..8).contains(&whole_digits) {
        return None;
    }
    let mut digits = u64::from_le_bytes(*text.first_chunk()?);
    let (mut end, mut digit_count, mut fraction_digits) = (whole_digits, whole_digits, 0);
    if text.get(whole_digits) == Some(&b'.') {
        end = ((others & (others - 1)).trailing_zeros() / 8) as usize;
        digit_count = end - 1;
        fraction_digits = digit_count - whole_digits;
        // What stands behind the point moves into its place.
        let whole = (1 << (8 * whole_digits)) - 1;
        let behind = u64::from_le_bytes(*text.get(1..)?.first_chunk()?);
        digits = (digits & whole) | (behind & !whole);
    }
    if digit_count > 8 {
        return None;
    }
    let mut value = digits_value(digits, digit_count) as f64;
    if text.get(end).is_some_and(|byte| byte | 0x20 == b'e') {
        (value, end) = with_exponent(value, fraction_digits, text, end)?;
    } else {
        value /= POWERS[fraction_digits];
    }
    // A sign is as good as random: it is set without a branch.
    Some((f64::from_bits(value.to_bits() | u64::from(negative) << 63), end + usize::from(negative)))
}

/// Applies the exponent at byte `end`: returns the value and where the number ends.
#[inline(never)]
fn with_exponent(digits: f64, fraction_digits: usize, text: &[u8], end: usize) -> Option<(f64, usize)> {
    let (exponent, length) = read_exponent(text.get(end..)?);
    let value = times_ten_to(digits, exponent.saturating_sub(fraction_digits as i64))?;
    Some((value, end + length))
}

/// Returns the highest bit of the first byte that is no digit, and of some bytes behind it: of every one that is no
/// digit, and maybe of a digit right behind a byte above 0x89.
#[inline]
fn others_among(word: u128) -> u128 {
    const EACH: u128 = u128::MAX / 0xFF;
    // Digits become 0..=9; in every other byte the sum or the byte itself has its highest bit set.
    let digits = word ^ (0x30 * EACH);
    (digits.wrapping_add(0x76 * EACH) | digits) & (0x80 * EACH)
}

/// Returns the value of the first `count` bytes, which are one to eight digits.
#[inline]
fn digits_value(bytes: u64, count: usize) -> u64 {
    // The digits move to the high end; the zeros that follow them in are leading zeros.
    let run = (bytes ^ 0x3030_3030_3030_3030) << (64 - 8 * count);
    // Pairs, then fours, then all eight.
    let pairs = run.wrapping_mul(10).wrapping_add(run >> 8);
    let even = (pairs & 0x0000_00FF_0000_00FF).wrapping_mul(100 + (1_000_000 << 32));
    let odd = ((pairs >> 16) & 0x0000_00FF_0000_00FF).wrapping_mul(1 + (10_000 << 32));
    even.wrapping_add(odd) >> 32
}

/// The clear version: reads any number, digit by digit.
#[cold]
fn read_any(text: &[u8]) -> Option<(f64, usize)> {
    let negative = text.first() == Some(&b'-');
    let mut at = usize::from(negative || text.first() == Some(&b'+'));
    let mut mantissa = Mantissa::default();
    let whole_digits = mantissa.take_digits(text.get(at..)?);
    at += whole_digits;
    let mut fraction_digits = 0;
    if text.get(at) == Some(&b'.') {
        fraction_digits = mantissa.take_digits(text.get(at + 1..)?);
        at += 1 + fraction_digits;
    }
    if whole_digits + fraction_digits == 0 {
        return None;
    }
    let (exponent, exponent_length) = read_exponent(text.get(at..)?);
    at += exponent_length;
    let power = exponent.saturating_sub(i64::try_from(fraction_digits).ok()?);
    let value = match mantissa.times_ten_to(power) {
        Some(value) if negative => -value,
        Some(value) => value,
        None => std::str::from_utf8(text.get(..at)?).ok()?.parse().ok()?,
    };
    Some((value, at))
}

/// Reads `(e|E) [+-] digits` at the start of `text`; zero and no bytes where it is not a whole exponent.
fn read_exponent(text: &[u8]) -> (i64, usize) {
    let [b'e' | b'E', after @ ..] = text else { return (0, 0) };
    let sign_length = usize::from(matches!(after.first(), Some(b'-' | b'+')));
    let digits = after.iter().skip(sign_length).take_while(|byte| byte.is_ascii_digit());
    let (value, count) = digits.fold((0_i64, 0), |(value, count), byte| {
        (value.saturating_mul(10).saturating_add(i64::from(byte - b'0')), count + 1)
    });
    match (count, after.first()) {
        (0, _) => (0, 0),
        (_, Some(b'-')) => (-value, 1 + sign_length + count),
        _ => (value, 1 + sign_length + count),
    }
}

/// The digits of a number as they come in.
#[derive(Default)]
struct Mantissa {
    value: u64,
    significant_digits: usize,
}

impl Mantissa {
    /// Takes the digits at the start of `text` and returns how many there are.
    fn take_digits(&mut self, text: &[u8]) -> usize {
        let mut count = 0;
        for byte in text.iter().take_while(|byte| byte.is_ascii_digit()) {
            self.value = self.value.wrapping_mul(10).wrapping_add(u64::from(byte - b'0'));
            self.significant_digits += usize::from(self.significant_digits > 0 || *byte != b'0');
            count += 1;
        }
        count
    }

    /// Returns the value times a power of ten if that can be computed exactly.
    fn times_ten_to(&self, power: i64) -> Option<f64> {
        if self.significant_digits > MANTISSA_DIGITS || self.value > EXACT_MANTISSA {
            return None;
        }
        times_ten_to(self.value as f64, power)
    }
}

/// Returns an exact value times a power of ten if one exact operation gives it.
#[inline]
fn times_ten_to(value: f64, power: i64) -> Option<f64> {
    let factor = *POWERS.get(usize::try_from(power.unsigned_abs()).ok()?)?;
    Some(if power < 0 { value / factor } else { value * factor })
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// Reads `text` with and without bytes behind it: the fast path needs some.
    fn read_both_ways(text: &str) -> Option<f64> {
        let alone = read(text.as_bytes());
        let padded = read_prefix(format!("{text} and more text").as_bytes());
        match (alone, padded) {
            (Some(value), Some((same, length))) => {
                assert_eq!(value.to_bits(), same.to_bits(), "{text}");
                assert_eq!(length, text.len(), "{text}");
            }
            (None, Some((_, length))) => assert_ne!(length, text.len(), "{text}"),
            (alone, None) => assert_eq!(alone, None, "{text}"),
        }
        alone
    }

    fn assert_as_std(text: &str) {
        let expected: f64 = text.parse().unwrap_or_else(|_| panic!("{text} is no number"));
        let found = read_both_ways(text).unwrap_or_else(|| panic!("{text} was not read"));
        assert_eq!(found.to_bits(), expected.to_bits(), "{text}");
    }

    #[test]
    fn spellings_found_in_files_are_read() {
        let spellings = "0 -0 +0 7 +7 -7 .5 5. -.5 +5. 1e5 1E5 1e+5 1e-5 3.64024e-015 -6.75868e-015 007 0.0030495 \
            12345678 123456789 0.12345678 0.123456789 1.1920928955078125e-07 9007199254740993 9007199254740992 \
            18446744073709551616 0.1e22 1e22 1e23 1e-22 1e-23 1e308 1e309 -1e400 4.9e-324 2e-324 1e-400 \
            1e99999999999999999999 0e99999999999999999999 0.000000000000000000000000001 \
            100000000000000000000000000000 2.2250738585072011e-308";
        spellings.split_whitespace().for_each(assert_as_std);
    }

    #[test]
    fn what_is_no_number_is_refused() {
        for text in
            ["", "-", "+", ".", "-.", "e5", "1e", "1e+", "1,5", "1.2.3", "--1", "+-1", "inf", "nan", "0x10", "1d5"]
        {
            assert_eq!(read_both_ways(text), None, "{text}");
        }
    }

    #[test]
    fn infinity_is_read_where_a_format_allows_it() {
        for text in ["inf", "+inf", "INF", "Infinity", "1.#INF"] {
            assert_eq!(read_or_infinity(text.as_bytes()), Some(f64::INFINITY), "{text}");
        }
        assert_eq!(read_or_infinity(b"-inf"), Some(f64::NEG_INFINITY));
        assert_eq!(read_or_infinity(b"-12.5"), Some(-12.5));
        assert_eq!(read_or_infinity(b"nan"), None);
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(20_000))]

        #[test]
        fn decimals_are_read_as_std_reads_them(text in r"[+-]?([0-9]{1,22}(\.[0-9]{0,22})?|\.[0-9]{1,22})([eE][+-]?[0-9]{1,3})?") {
            assert_as_std(&text);
        }

        #[test]
        fn short_decimals_are_read_as_std_reads_them(text in r"-?[0-9]{1,9}\.[0-9]{0,9}") {
            assert_as_std(&text);
        }

        #[test]
        fn a_prefix_is_read_exactly_when_std_reads_it(text in r"[-+0-9.eE ]{0,12}") {
            if let Some((value, length)) = read_prefix(text.as_bytes()) {
                prop_assert_eq!(text[..length].parse::<f64>().map(f64::to_bits), Ok(value.to_bits()));
            }
            prop_assert_eq!(read(text.as_bytes()).map(f64::to_bits), text.parse::<f64>().ok().map(f64::to_bits));
        }

        #[test]
        fn written_numbers_read_back_bit_for_bit(bits in any::<u64>()) {
            let value = f64::from_bits(bits);
            prop_assume!(!value.is_nan());
            let mut text = Vec::new();
            write(value, &mut text);
            prop_assert_eq!(read_or_infinity(&text).map(f64::to_bits), Some(bits));
        }
    }
}
