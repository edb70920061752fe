//! What values mean.

use super::ValueError;

/// A usable piece of a clip.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Segment {
    /// Its first frame, by the file's own numbers.
    pub first_frame: i64,
    /// Its last frame, not before the first.
    pub last_frame: i64,
    /// What is said of it, possibly nothing.
    pub note: String,
}

/// Returns what *Cleaned* says: yes, no, or nothing where it is empty.
///
/// # Errors
/// Where the word is none of J, Ja, Y, Yes, N, Nein, No, in any case.
pub fn cleaned(value: &str) -> Result<Option<bool>, ValueError> {
    match value.trim().to_lowercase().as_str() {
        "" => Ok(None),
        "j" | "ja" | "y" | "yes" => Ok(Some(true)),
        "n" | "nein" | "no" => Ok(Some(false)),
        _ => Err(ValueError::Cleaned(value.trim().to_owned())),
    }
}

/// Returns the pieces of *Usable segments*: `20-180, 200-316 (walks on)`, separated by commas or semicolons. What is no
/// piece is left out here; the text keeps it.
pub fn segments(value: &str) -> Vec<Segment> {
    value.split([',', ';']).filter_map(segment).collect()
}

fn segment(text: &str) -> Option<Segment> {
    let (first, rest) = number(text)?;
    let rest = rest.trim_start();
    let rest = ["-", "–", "..", "to ", "bis "].iter().find_map(|between| rest.strip_prefix(between))?;
    let (last, rest) = number(rest)?;
    // `1-2-3` is something else.
    let is_whole = rest.is_empty() || rest.starts_with([' ', '(', '\t']);
    let note = rest.trim().trim_start_matches('(').trim_end_matches(')').trim().to_owned();
    (is_whole && first <= last).then_some(Segment { first_frame: first, last_frame: last, note })
}

/// Returns a frame number, which may be below zero, and the text behind it.
fn number(text: &str) -> Option<(i64, &str)> {
    let text = text.trim_start();
    let sign = usize::from(text.starts_with('-'));
    let digits = text.bytes().skip(sign).take_while(u8::is_ascii_digit).count();
    let (number, rest) = text.split_at(sign + digits);
    Some((number.parse().ok()?, rest))
}

/// Returns the day that a text means, as an ISO date: `2004-05-31` of `31.5.2004`, `2004/05/31` or `2004-05-31 10:30`.
/// `None` for what is no day, or a different one in different countries (`5/6/2004`).
pub fn day(value: &str) -> Option<String> {
    let date = value.split([' ', 'T', ',']).find(|word| !word.is_empty())?;
    let separator = date.chars().find(|letter| ['-', '.', '/'].contains(letter))?;
    let parts: Option<Vec<(u32, usize)>> = date.split(separator).map(digits).collect();
    let [(a, a_digits), (b, _), (c, c_digits)] = parts?.try_into().ok()?;
    let (year, month, day) = match (a_digits, c_digits, separator) {
        (4, ..) => (a, b, c),
        (_, 4, '/') if a > 12 => (c, b, a),
        (_, 4, '/') if b > 12 => (c, a, b),
        (_, 4, '.' | '-') => (c, b, a),
        _ => return None,
    };
    (1..=days(year, month)).contains(&day).then(|| format!("{year:04}-{month:02}-{day:02}"))
}

/// Returns a number and of how many digits it is made.
fn digits(text: &str) -> Option<(u32, usize)> {
    let is_number = text.bytes().all(|byte| byte.is_ascii_digit());
    is_number.then(|| text.parse().ok()).flatten().map(|number| (number, text.len()))
}

/// Returns how many days a month has; none where there is no such month.
fn days(year: u32, month: u32) -> u32 {
    let is_leap = year.is_multiple_of(4) && (!year.is_multiple_of(100) || year.is_multiple_of(400));
    match month {
        2 if is_leap => 29,
        2 => 28,
        4 | 6 | 9 | 11 => 30,
        1..=12 => 31,
        _ => 0,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cleaned_is_empty_or_one_of_seven_words_in_any_case() {
        for (words, said) in
            [(&["", "  "][..], None), (&["J", "ja", "Y", "YES"], Some(true)), (&["n", "Nein", "NO"], Some(false))]
        {
            for word in words {
                assert_eq!(cleaned(word), Ok(said), "{word}");
            }
        }
        for word in ["maybe", "1", "true", "oui", "yess"] {
            let text = cleaned(word).unwrap_err().to_string();
            assert_eq!(text, format!("Cleaned is empty or one of J, Ja, Y, Yes, N, Nein, No, not “{word}”"));
        }
    }

    #[test]
    fn segments_are_pairs_of_frames() {
        let piece = |first, last, note: &str| Segment { first_frame: first, last_frame: last, note: note.to_owned() };
        assert_eq!(segments("20-180, 200-316 (walks on)"), [piece(20, 180, ""), piece(200, 316, "walks on")]);
        assert_eq!(segments("1..5; 7 - 9;10 to 12"), [piece(1, 5, ""), piece(7, 9, ""), piece(10, 12, "")]);
        for none in ["", "all", "9-3", "5", "1-2-3", "1.5-2", "99999999999999999999-1"] {
            assert_eq!(segments(none), [], "{none}");
        }
    }

    #[test]
    fn a_day_is_understood_where_it_means_one_day_everywhere() {
        for (text, wanted) in [
            ("2004-05-31", Some("2004-05-31")),
            ("2004/5/3 10:30", Some("2004-05-03")),
            ("31.5.2004", Some("2004-05-31")),
            ("31/05/2004", Some("2004-05-31")),
            ("05/31/2004", Some("2004-05-31")),
            ("5/6/2004", None),
            ("31.5.04", None),
            ("2003-02-29", None),
            ("2004-13-01", None),
            ("yesterday", None),
            ("", None),
        ] {
            assert_eq!(day(text).as_deref(), wanted, "{text}");
        }
    }
}
