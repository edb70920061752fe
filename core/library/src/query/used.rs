//! When a clip was last used: `yes`, `no`, or within a time that ends now, as `12h`, `7d`, `2w`.

use super::{Condition, Field};

/// How many seconds each unit has.
const UNITS: [(&str, i64); 3] = [("h", 60 * 60), ("d", 24 * 60 * 60), ("w", 7 * 24 * 60 * 60)];

/// Returns what a value asks for; `None` where it means nothing.
pub(super) fn condition(text: &str) -> Option<Condition> {
    let is = |word: &str| text.eq_ignore_ascii_case(word);
    if is("yes") || is("y") {
        return Some(Condition::Used { within_s: None });
    }
    if is("no") || is("n") {
        return Some(Condition::Unknown(Field::Used));
    }
    let digits = text.trim_end_matches(|c: char| c.is_ascii_alphabetic());
    let (_, seconds) = UNITS.iter().find(|(unit, _)| unit.eq_ignore_ascii_case(&text[digits.len()..]))?;
    let is_written = !digits.is_empty() && digits.bytes().all(|byte| byte.is_ascii_digit());
    let count = digits.parse::<i64>().ok().filter(|_| is_written)?;
    Some(Condition::Used { within_s: Some(count.checked_mul(*seconds)?) })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_time_is_a_whole_number_with_a_unit() {
        for (text, seconds) in [("1h", 3600), ("7d", 604_800), ("2W", 1_209_600), ("0d", 0)] {
            assert_eq!(condition(text), Some(Condition::Used { within_s: Some(seconds) }), "{text}");
        }
        assert_eq!(condition("Yes"), Some(Condition::Used { within_s: None }));
        assert_eq!(condition("no"), Some(Condition::Unknown(Field::Used)));
        for text in
            ["", "d", "7", "7 d", "1.5d", "-1d", "+1d", "7m", "today", "99999999999999999d", "9999999999999999w"]
        {
            assert_eq!(condition(text), None, "{text}");
        }
    }
}
