//! Days, months and years: `2004-05-17`, `2004-05`, `2004`.

use std::fmt::Write as _;
use std::ops::Bound;

use super::numbers::Bounds;
use super::split::Operator;

/// Stands behind everything that may follow in a date: `2004~` is after all of 2004 and before 2005.
const AFTER_ALL: char = '~';

/// Returns between which texts an ISO date lies, compared byte by byte; `None` where the text is no date, or no range
/// `2004..2006` after `:`. A month or a year stands for all of its days: `date>2004` begins with 2005.
pub(super) fn bounds(operator: Operator, text: &str) -> Option<Bounds<String>> {
    let end_of = |date: String| date + AFTER_ALL.encode_utf8(&mut [0; 4]);
    if let (Operator::Is, Some((from, to))) = (operator, text.split_once("..")) {
        let end = |text: &str| if text.is_empty() { Some(None) } else { date(text).map(Some) };
        let (from, to) = (end(from)?, end(to)?.map(end_of));
        if from.is_none() && to.is_none() || from.as_ref().zip(to.as_ref()).is_some_and(|(from, to)| from > to) {
            return None;
        }
        return Some((from.map_or(Bound::Unbounded, Bound::Included), to.map_or(Bound::Unbounded, Bound::Excluded)));
    }
    let date = date(text)?;
    Some(match operator {
        Operator::Is => (Bound::Included(date.clone()), Bound::Excluded(end_of(date))),
        Operator::Below => (Bound::Unbounded, Bound::Excluded(date)),
        Operator::AtMost => (Bound::Unbounded, Bound::Excluded(end_of(date))),
        Operator::Above => (Bound::Included(end_of(date)), Bound::Unbounded),
        Operator::AtLeast => (Bound::Included(date), Bound::Unbounded),
    })
}

/// Returns the text as an ISO date: `2004-5-7` is `2004-05-07`.
fn date(text: &str) -> Option<String> {
    let mut parts = text.split('-');
    let year = parts.next().filter(|year| year.len() == 4).and_then(digits)?;
    let mut date = format!("{year:04}");
    let mut last = [12, 31].into_iter();
    for part in parts {
        let number = digits(part).filter(|number| *number > 0)?;
        if number > last.next()? || part.len() > 2 {
            return None;
        }
        let _ = write!(date, "-{number:02}");
    }
    Some(date)
}

fn digits(text: &str) -> Option<u32> {
    text.bytes().all(|byte| byte.is_ascii_digit()).then(|| text.parse().ok()).flatten()
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::ops::RangeBounds;

    fn meets(operator: Operator, text: &str, date: &str) -> bool {
        bounds(operator, text).unwrap_or_else(|| panic!("`{text}` is a date")).contains(&date.to_owned())
    }

    #[test]
    fn a_month_or_a_year_stands_for_all_of_its_days() {
        for (date, [is, below, at_most, above, at_least]) in [
            ("2004-04-30", [false, true, true, false, false]),
            ("2004-05-01", [true, false, true, false, true]),
            ("2004-05-31", [true, false, true, false, true]),
            ("2004-06-01", [false, false, false, true, true]),
        ] {
            assert_eq!(meets(Operator::Is, "2004-05", date), is, "{date}");
            assert_eq!(meets(Operator::Below, "2004-05", date), below, "{date}");
            assert_eq!(meets(Operator::AtMost, "2004-5", date), at_most, "{date}");
            assert_eq!(meets(Operator::Above, "2004-05", date), above, "{date}");
            assert_eq!(meets(Operator::AtLeast, "2004-05", date), at_least, "{date}");
        }
    }

    #[test]
    fn a_range_holds_both_of_its_ends() {
        assert!(meets(Operator::Is, "2004..2005-02", "2004-01-01"));
        assert!(meets(Operator::Is, "2004..2005-02", "2005-02-28"));
        assert!(!meets(Operator::Is, "2004..2005-02", "2005-03-01"));
        assert!(meets(Operator::Is, "2004-05..2004", "2004-12-24"));
        assert!(meets(Operator::Is, "..2005", "1998-01-01"));
    }

    #[test]
    fn what_is_no_date_is_refused() {
        for text in [
            "",
            "..",
            "2005..2004",
            "04",
            "2004-13",
            "2004-00",
            "2004-02-32",
            "2004-1-1-1",
            "17.5.2004",
            "2004-",
            "٢٠٠٤",
        ] {
            assert_eq!(bounds(Operator::Is, text), None, "{text}");
        }
    }
}
