//! Numbers as people type them, with units: `1:30`, `200kb`, `120fps`.

use std::ops::Bound;

use super::fields::NumberField;
use super::split::Operator;

/// Two ends of what a number may be, in the unit of its column: hertz, seconds, metres, bytes.
pub type Bounds<T> = (Bound<T>, Bound<T>);

/// How far the rate of a file may lie from the one that is asked for: a file that says 0.008333 s a frame plays at
/// 120.0048 Hz, and nobody calls that anything but 120. Half as far as 29.97 is from 30.
const RATE_TOLERANCE: f64 = 0.0005;

/// A number, and how far what it stands for reaches to either side.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Number {
    value: f64,
    /// Half of the last digit that is written, in the same unit.
    half_digit: f64,
}

impl NumberField {
    /// What stands behind the number, and how much one of it is.
    fn units(self) -> &'static [(&'static str, f64)] {
        match self {
            Self::Rate => &[("", 1.0), ("hz", 1.0), ("fps", 1.0)],
            Self::Duration => &[("", 1.0), ("s", 1.0), ("ms", 0.001), ("min", 60.0), ("m", 60.0), ("h", 3600.0)],
            Self::Height => &[("", 1.0), ("m", 1.0), ("cm", 0.01), ("mm", 0.001), ("ft", 0.3048), ("in", 0.0254)],
            Self::Size => &[("", 1.0), ("b", 1.0), ("kb", 1e3), ("mb", 1e6), ("gb", 1e9)],
            Self::Frames | Self::Rating | Self::Joints | Self::Markers => &[("", 1.0)],
        }
    }

    /// What a value of the field is, in words.
    pub(super) fn expected(self) -> &'static str {
        match self {
            Self::Rate => "a number of frames per second",
            Self::Duration => "a time in seconds, or with a unit as 90s, 1.5min, 1:30",
            Self::Frames => "a number of frames",
            Self::Height => "a length in metres, or with a unit as 180cm, 6ft",
            Self::Rating => "a number of stars, 0 to 5",
            Self::Size => "a number of bytes, or with a unit as 200kb, 1.5mb, 1gb",
            Self::Joints => "a number of joints",
            Self::Markers => "a number of markers",
        }
    }
}

/// Returns what a value may be; `None` where the text is no number, or no range `2..10` after `:`.
///
/// A single number stands for all that it would be the short form of: `duration:10` for 9.5 to 10.5, `height:1.80` for
/// 1.795 to 1.805. Comparisons and ranges take it as it is. Rates have their own tolerance in every case.
pub(super) fn bounds(field: NumberField, operator: Operator, text: &str) -> Option<Bounds<f64>> {
    let tolerance = if field == NumberField::Rate { RATE_TOLERANCE } else { 0.0 };
    let low = |number: Number| number.value * (1.0 - tolerance);
    let high = |number: Number| number.value * (1.0 + tolerance);
    if let (Operator::Is, Some((from, to))) = (operator, text.split_once("..")) {
        let end = |text: &str| if text.is_empty() { Some(None) } else { number(field, text).map(Some) };
        let (from, to) = (end(from)?, end(to)?);
        if from.is_none() && to.is_none() || from.zip(to).is_some_and(|(from, to)| from.value > to.value) {
            return None;
        }
        let from = from.map_or(Bound::Unbounded, |number| Bound::Included(low(number)));
        return Some((from, to.map_or(Bound::Unbounded, |number| Bound::Included(high(number)))));
    }
    let number = number(field, text)?;
    Some(match operator {
        Operator::Is if tolerance > 0.0 => (Bound::Included(low(number)), Bound::Included(high(number))),
        Operator::Is => {
            (Bound::Included(number.value - number.half_digit), Bound::Excluded(number.value + number.half_digit))
        }
        Operator::Below => (Bound::Unbounded, Bound::Excluded(low(number))),
        Operator::AtMost => (Bound::Unbounded, Bound::Included(high(number))),
        Operator::Above => (Bound::Excluded(high(number)), Bound::Unbounded),
        Operator::AtLeast => (Bound::Included(low(number)), Bound::Unbounded),
    })
}

fn number(field: NumberField, text: &str) -> Option<Number> {
    if field == NumberField::Duration && text.contains(':') {
        return clock(text);
    }
    let digits = text.trim_end_matches(|c: char| c.is_ascii_alphabetic());
    let unit = &text[digits.len()..];
    let (_, factor) = field.units().iter().find(|(name, _)| name.eq_ignore_ascii_case(unit))?;
    let number = decimal(digits)?;
    Some(Number { value: number.value * factor, half_digit: number.half_digit * factor })
}

/// `1:30` or `1:02:03.5`, in seconds; what follows a colon is below 60.
fn clock(text: &str) -> Option<Number> {
    let mut total = Number { value: 0.0, half_digit: 0.0 };
    for (index, part) in text.split(':').enumerate() {
        let part = decimal(part)?;
        if index > 2 || index > 0 && part.value >= 60.0 || total.half_digit < 0.5 && index > 0 {
            return None;
        }
        total = Number { value: total.value * 60.0 + part.value, half_digit: part.half_digit };
    }
    Some(total)
}

/// Digits with at most one point, and nothing else: no sign, no exponent, no `inf`.
fn decimal(text: &str) -> Option<Number> {
    let (whole, fraction) = text.split_once('.').unwrap_or((text, ""));
    let is_written = whole.len() + fraction.len() > 0;
    if !is_written || ![whole, fraction].iter().all(|part| part.bytes().all(|byte| byte.is_ascii_digit())) {
        return None;
    }
    let value: f64 = text.parse().ok().filter(|value: &f64| value.is_finite())?;
    Some(Number { value, half_digit: 0.5 * 0.1_f64.powi(fraction.len() as i32) })
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::ops::RangeBounds;

    fn meets(field: NumberField, operator: Operator, text: &str, value: f64) -> bool {
        bounds(field, operator, text).unwrap_or_else(|| panic!("`{text}` is a number")).contains(&value)
    }

    #[test]
    fn units_are_those_of_the_field() {
        let at_least = |field, text| bounds(field, Operator::AtLeast, text).map(|(low, _)| low);
        for (text, seconds) in [("90s", 90.0), ("1:30", 90.0), ("1.5MIN", 90.0), ("1:02:03.5", 3723.5), ("2h", 7200.0)]
        {
            assert_eq!(at_least(NumberField::Duration, text), Some(Bound::Included(seconds)), "{text}");
        }
        assert_eq!(at_least(NumberField::Size, "1.5kb"), Some(Bound::Included(1500.0)));
        assert_eq!(at_least(NumberField::Height, ".5m"), Some(Bound::Included(0.5)));
        for text in ["", "1:75", "1:2:3:4", "1.5:30", "1,5", "-1", "1e3", "inf", "1kb", ":", "1:", "4 s", "."] {
            assert_eq!(at_least(NumberField::Duration, text), None, "{text}");
        }
    }

    #[test]
    fn a_number_stands_for_what_it_is_the_short_form_of() {
        for (value, is_met) in [(9.49, false), (9.5, true), (10.49, true), (10.5, false)] {
            assert_eq!(meets(NumberField::Duration, Operator::Is, "10", value), is_met, "{value}");
        }
        assert!(!meets(NumberField::Duration, Operator::Is, "10.0", 10.2));
        assert!(meets(NumberField::Frames, Operator::Is, "500", 500.0));
        assert!(!meets(NumberField::Frames, Operator::Is, "500", 501.0));
    }

    #[test]
    fn comparisons_and_ranges_take_a_number_as_it_is() {
        assert!(meets(NumberField::Duration, Operator::Above, "1", 1.2));
        assert!(!meets(NumberField::Duration, Operator::Above, "1", 1.0));
        assert!(!meets(NumberField::Duration, Operator::Is, "2..10", 10.1));
        assert!(meets(NumberField::Duration, Operator::Is, "1:00..2:00", 120.0));
        assert!(meets(NumberField::Duration, Operator::Is, "..10", 0.0));
        for text in ["10..2", "..", "1..2..3"] {
            assert_eq!(bounds(NumberField::Duration, Operator::Is, text), None, "{text}");
        }
    }

    #[test]
    fn rounded_frame_times_do_not_change_a_rate() {
        for (operator, text, rate, is_met) in [
            (Operator::Is, "120", 1.0 / 0.008_333, true),
            (Operator::AtMost, "120", 1.0 / 0.008_333, true),
            (Operator::Above, "120", 1.0 / 0.008_333, false),
            (Operator::AtLeast, "60", 59.9988, true),
            (Operator::Below, "60", 59.9988, false),
            (Operator::Is, "30", 29.97, false),
            (Operator::Is, "24..30fps", 30.0003, true),
        ] {
            assert_eq!(meets(NumberField::Rate, operator, text, rate), is_met, "{operator:?} {text} {rate}");
        }
    }
}
