//! From what was typed to its terms: `-subject:"Anna Smith"` is a minus, a field, an operator and a quoted value.

use super::error::QueryError;

/// How a field and its value stand to each other.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Operator {
    Is,
    Below,
    AtMost,
    Above,
    AtLeast,
}

/// Operators as typed, the longer ones first.
const OPERATORS: [(&str, Operator); 6] = [
    (">=", Operator::AtLeast),
    ("<=", Operator::AtMost),
    (">", Operator::Above),
    ("<", Operator::Below),
    (":", Operator::Is),
    ("=", Operator::Is),
];

/// One term of a query, taken apart but not yet understood.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Piece<'a> {
    /// The whole term as typed, for messages.
    pub term: &'a str,
    pub is_negated: bool,
    /// What stands before the operator.
    pub field: Option<(&'a str, Operator)>,
    /// The word or value; without its quotes.
    pub value: String,
    pub is_quoted: bool,
}

/// Takes a query apart. Terms stand between white space; a quoted value may hold white space, and `""` for one quote.
pub(super) fn split(text: &str) -> Result<Vec<Piece<'_>>, QueryError> {
    let mut pieces = Vec::new();
    let mut rest = text.trim_start_matches(is_space);
    while !rest.is_empty() {
        let (piece, after) = next_piece(rest)?;
        pieces.push(piece);
        rest = after.trim_start_matches(is_space);
    }
    Ok(pieces)
}

fn is_space(character: char) -> bool {
    character.is_whitespace() || character.is_control()
}

fn next_piece(text: &str) -> Result<(Piece<'_>, &str), QueryError> {
    let positive = text.strip_prefix('-');
    let body = positive.unwrap_or(text);
    let field = field_of(body);
    let value = field.map_or(body, |(_, _, value)| value);
    let (value, is_quoted, after) = match value.strip_prefix('"') {
        None => {
            let (value, after) = value.split_at(value.find(is_space).unwrap_or(value.len()));
            (value.to_owned(), false, after)
        }
        Some(quoted) => {
            let (value, after) = unquote(quoted).ok_or_else(|| QueryError::new(text, "a closing quote"))?;
            if after.chars().next().is_some_and(|next| !is_space(next)) {
                return Err(QueryError::new(text, "a space after the closing quote"));
            }
            (value, true, after)
        }
    };
    let term = &text[..text.len() - after.len()];
    let field = field.map(|(name, operator, _)| (name, operator));
    Ok((Piece { term, is_negated: positive.is_some(), field, value, is_quoted }, after))
}

/// Returns the name before an operator, the operator, and what follows; a name is a letter and then letters, digits
/// and underscores.
fn field_of(body: &str) -> Option<(&str, Operator, &str)> {
    if !body.starts_with(char::is_alphabetic) {
        return None;
    }
    let (name, rest) = body.split_at(body.find(|c: char| !(c.is_alphanumeric() || c == '_'))?);
    let (operator, value) = OPERATORS.iter().find_map(|(text, op)| Some((*op, rest.strip_prefix(text)?)))?;
    Some((name, operator, value))
}

/// Returns what stands before the closing quote, and what follows it.
fn unquote(quoted: &str) -> Option<(String, &str)> {
    let mut value = String::new();
    let mut rest = quoted;
    loop {
        let (before, after) = rest.split_once('"')?;
        value.push_str(before);
        match after.strip_prefix('"') {
            Some(more) => {
                value.push('"');
                rest = more;
            }
            None => return Some((value, after)),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// What a query falls into: `-field operator [value]`, one after the other; quoted values in quotes.
    fn split_into(text: &str) -> String {
        let shown = |piece: Piece<'_>| {
            let minus = if piece.is_negated { "-" } else { "" };
            let field = piece.field.map(|(name, operator)| format!("{name} {operator:?} ")).unwrap_or_default();
            let value = if piece.is_quoted { format!("{:?}", piece.value) } else { piece.value };
            format!("{minus}{field}[{value}]")
        };
        split(text).map_or_else(|error| error.to_string(), |pieces| pieces.into_iter().map(shown).collect())
    }

    #[test]
    fn terms_stand_between_white_space() {
        assert_eq!(split_into("  walk\tfast\u{0}-jump\u{3000}"), "[walk][fast]-[jump]");
        assert_eq!(split_into(""), "");
        assert_eq!(split_into("well-made 01_02 10:30"), "[well-made][01_02][10:30]");
    }

    #[test]
    fn a_field_is_a_name_with_an_operator() {
        assert_eq!(split_into("subject:07 rate>=100"), "subject Is [07]rate AtLeast [100]");
        assert_eq!(split_into("-a<1 a<=1 a>1 a=1"), "-a Below [1]a AtMost [1]a Above [1]a Is [1]");
        assert_eq!(split_into("a: b"), "a Is [][b]");
        assert_eq!(split_into(r"folder:C:\clips"), r"folder Is [C:\clips]");
    }

    #[test]
    fn quotes_hold_white_space_and_are_doubled_inside() {
        assert_eq!(split_into(r#""left hand" -"a""b" group:"x y""#), r#"["left hand"]-["a\"b"]group Is ["x y"]"#);
        assert_eq!(split_into(r#"6"tall ""#), "`\"`: expected a closing quote");
        assert_eq!(split_into(r#""left hand"s"#), "`\"left hand\"s`: expected a space after the closing quote");
        assert_eq!(split_into(r#""""#), r#"[""]"#);
    }
}
