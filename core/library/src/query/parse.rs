//! From the pieces of a query to what they ask for.

use motion_theater_core::read::Format;

use super::error::QueryError;
use super::fields::{Field, FlagField, NumberField};
use super::split::{split, Operator, Piece};
use super::{dates, numbers, used, Condition, Query, Term, WholeValue};

/// More is no search but an accident, and `SQLite` has limits of its own.
const TERM_LIMIT: usize = 100;
/// In characters; see [`TERM_LIMIT`].
const LENGTH_LIMIT: usize = 10_000;
/// Stands between two tags in the full-text index, as a word of its own. Nobody may ask for it.
const BETWEEN_TAGS: char = '\u{E000}';

impl Query {
    /// Reads a query; one without terms is met by every clip.
    ///
    /// # Errors
    /// Where a term means nothing: the error names it and says what would be right.
    ///
    /// ```
    /// use motion_theater_library::query::Query;
    ///
    /// assert_eq!(Query::parse("subject:07 walk -rate<100")?.terms.len(), 3);
    /// let error = Query::parse("walk rate>=fast").unwrap_err();
    /// assert_eq!(
    ///     error.to_string(),
    ///     "`rate>=fast`: expected a number of frames per second, such as rate>=100"
    /// );
    /// # Ok::<(), motion_theater_library::query::QueryError>(())
    /// ```
    pub fn parse(text: &str) -> Result<Self, QueryError> {
        if text.chars().count() > LENGTH_LIMIT {
            return Err(QueryError::new(text, format!("at most {LENGTH_LIMIT} characters")));
        }
        let pieces = split(text)?;
        if pieces.len() > TERM_LIMIT {
            return Err(QueryError::new(text, format!("at most {TERM_LIMIT} words and terms")));
        }
        pieces.iter().map(term).collect::<Result<_, _>>().map(|terms| Self { terms })
    }
}

fn term(piece: &Piece<'_>) -> Result<Term, QueryError> {
    let condition = match piece.field {
        None => words(piece, None)?,
        Some((name, operator)) => {
            let field = Field::named(name).ok_or_else(|| unknown_field(piece))?;
            if is_none(piece, operator) && field.may_be_unknown() {
                Condition::Unknown(field)
            } else {
                condition(piece, field, operator)?
            }
        }
    };
    Ok(Term { is_negated: piece.is_negated, condition })
}

/// Whether a value asks for clips that lack the field; in quotes it is a word like any other.
fn is_none(piece: &Piece<'_>, operator: Operator) -> bool {
    let is_word = ["none", "unknown"].iter().any(|word| piece.value.eq_ignore_ascii_case(word));
    operator == Operator::Is && is_word && !piece.is_quoted
}

fn condition(piece: &Piece<'_>, field: Field, operator: Operator) -> Result<Condition, QueryError> {
    let value = piece.value.as_str();
    let wrong = |expected: &str| QueryError::new(piece.term, format!("{expected}, such as {}", field.example()));
    let is_comparable = matches!(field, Field::Number(_) | Field::Date);
    if operator != Operator::Is && !is_comparable {
        return Err(wrong("a colon, for this cannot be greater or less"));
    }
    match field {
        Field::Text(text) => words(piece, Some(text)),
        Field::Whole(_) if value.trim().is_empty() => Err(wrong("a value behind the colon")),
        Field::Whole(field) => Ok(Condition::Whole { field, value: WholeValue::new(value, piece.is_quoted) }),
        Field::Number(number) => {
            let bounds = numbers::bounds(number, operator, value).ok_or_else(|| wrong(&number_words(number, value)))?;
            Ok(Condition::Number { field: number, bounds })
        }
        Field::Date => {
            let expected = "a year, month or day as 2004, 2004-05, 2004-05-17, or a range of them, earlier end first";
            let bounds = dates::bounds(operator, value).ok_or_else(|| wrong(expected))?;
            Ok(Condition::Date { bounds })
        }
        Field::Flag(flag) => {
            let value = yes_or_no(value)
                .ok_or_else(|| wrong(if flag == FlagField::Cleaned { "yes, no or unknown" } else { "yes or no" }))?;
            Ok(Condition::Flag { field: flag, value })
        }
        Field::Used => used::condition(value).ok_or_else(|| wrong("yes, no or a time until now as 12h, 7d, 2w")),
        Field::Format => {
            let format = Format::from_extension(value.trim_start_matches('.'));
            let extension = format.map(Format::extension);
            extension
                .map(|extension| Condition::Format { extension })
                .ok_or_else(|| wrong(&format!("one of {}", Format::list())))
        }
    }
}

fn number_words(field: NumberField, value: &str) -> String {
    let expected = field.expected();
    if value.contains("..") {
        format!("{expected}, as a range with its smaller end first")
    } else {
        expected.to_owned()
    }
}

fn words(piece: &Piece<'_>, field: Option<super::TextField>) -> Result<Condition, QueryError> {
    if piece.value.chars().any(char::is_alphanumeric) {
        let text = piece.value.replace(BETWEEN_TAGS, " ");
        return Ok(Condition::Words { field, text, is_phrase: piece.is_quoted });
    }
    let is_comparison = piece.value.starts_with([':', '=', '<', '>']);
    Err(QueryError::new(
        piece.term,
        match field {
            Some(field) => format!("a word behind the colon, such as {}", Field::Text(field).example()),
            None if is_comparison => "a field right before it, without blanks, such as rate>=100".to_owned(),
            None if piece.is_negated => "a word or a term right behind the minus, such as -walk".to_owned(),
            None => "at least one letter or digit".to_owned(),
        },
    ))
}

fn unknown_field(piece: &Piece<'_>) -> QueryError {
    let fields = Field::list();
    QueryError::new(piece.term, format!("one of the fields {fields}; or quotes, to search for the text itself"))
}

fn yes_or_no(text: &str) -> Option<bool> {
    let is_any = |words: &[&str]| words.iter().any(|word| word.eq_ignore_ascii_case(text));
    match () {
        () if is_any(&["yes", "y"]) => Some(true),
        () if is_any(&["no", "n"]) => Some(false),
        () => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn error(query: &str) -> String {
        Query::parse(query).map_or_else(|error| error.to_string(), |query| format!("understood: {query:?}"))
    }

    #[test]
    fn an_error_names_the_term_and_what_would_be_right() {
        for (query, message) in [
            ("walk subject:", "`subject:`: expected a value behind the colon, such as subject:07"),
            ("rate >= 100", "`>=`: expected a field right before it, without blanks, such as rate>=100"),
            ("name:?", "`name:?`: expected a word behind the colon, such as name:walk"),
            ("-", "`-`: expected a word or a term right behind the minus, such as -walk"),
            ("walk !", "`!`: expected at least one letter or digit"),
            ("-subject>7", "`-subject>7`: expected a colon, for this cannot be greater or less, such as subject:07"),
            ("cleaned:maybe", "`cleaned:maybe`: expected yes, no or unknown, such as cleaned:yes"),
            ("missing:none", "`missing:none`: expected yes or no, such as missing:yes"),
            ("used:lately", "`used:lately`: expected yes, no or a time until now as 12h, 7d, 2w, such as used:7d"),
            (
                "duration:10..2",
                "`duration:10..2`: expected a time in seconds, or with a unit as 90s, 1.5min, 1:30, as a range with its \
                 smaller end first, such as duration<10",
            ),
            (
                "date:17.5.2004",
                "`date:17.5.2004`: expected a year, month or day as 2004, 2004-05, 2004-05-17, or a range of them, \
                 earlier end first, such as date:2004-05",
            ),
        ] {
            assert_eq!(error(query), message);
        }
        assert!(error("colour:red").starts_with("`colour:red`: expected one of the fields subject, format, tag,"));
        assert!(error("format:fbx").starts_with("`format:fbx`: expected one of asf, amc, bvh"));
    }

    #[test]
    fn a_query_without_bounds_is_refused() {
        assert!(error(&"a ".repeat(101)).ends_with("…`: expected at most 100 words and terms"));
        assert!(error(&"a".repeat(10_001)).ends_with("…`: expected at most 10000 characters"));
    }

    #[test]
    fn none_is_a_word_in_quotes_and_where_nothing_can_lack() {
        let condition = |query: &str| Query::parse(query).map(|query| query.terms[0].condition.clone());
        assert_eq!(condition("Rate:None"), Ok(Condition::Unknown(Field::Number(NumberField::Rate))));
        assert_eq!(condition("cleaned:unknown"), Ok(Condition::Unknown(Field::Flag(FlagField::Cleaned))));
        assert!(matches!(condition("subject:\"none\""), Ok(Condition::Whole { .. })));
        assert!(matches!(condition("name:none"), Ok(Condition::Words { .. })));
        assert!(error("rating:none").contains("a number of stars"));
    }

    proptest! {
        #[test]
        fn no_text_makes_it_panic(text in r#"(\PC|[\s\x00-\x1f":<>=.*-]|rate|date|size|duration|subject|[0-9]){0,40}"#) {
            if let Err(error) = Query::parse(&text) {
                prop_assert!(error.to_string().contains("expected"));
            }
        }
    }
}
