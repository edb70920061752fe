//! What is wrong with a query, in words for the person who typed it.

/// A term that means nothing, and what would be right.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("`{term}`: expected {expected}")]
pub struct QueryError {
    /// The term as typed; its beginning, where it is long.
    pub term: String,
    /// What would be right in its place, in words: "a number of frames per second, such as rate>=100".
    pub expected: String,
}

/// How many characters of a term stand in a message.
const TERM_LIMIT: usize = 60;

impl QueryError {
    pub(super) fn new(term: &str, expected: impl Into<String>) -> Self {
        let mut shown: String = term.chars().take(TERM_LIMIT).collect();
        if shown.len() < term.len() {
            shown.push('…');
        }
        Self { term: shown, expected: expected.into() }
    }
}
