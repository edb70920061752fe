//! What is searched for: `subject:07 walk rate>=100 -tag:broken "left hand"`.
//!
//! ```text
//! query = { term }                                       every term must be met
//! term  = ["-"] ( word | phrase | field operator value ) a minus asks for what the term does not give
//! ```
//!
//! A query is a list of [`Term`]s. [`Library::search`](crate::Library::search) answers it from the database; `docs/library.md`, "Searching",
//! is the language for those who type it. Three rules hold everywhere:
//!
//! - A clip that does not say what is asked for does not meet the term, whatever the comparison.
//! - A minus gives exactly the clips that the term without it does not give, so also those that do not say.
//! - Neither case nor accents matter.

mod dates;
mod error;
mod fields;
mod id_set;
mod numbers;
mod parse;
mod search;
mod sets;
mod sort;
mod split;
mod sql;
mod used;
mod whole;

#[cfg(test)]
mod plain;
#[cfg(test)]
mod tests;

pub use error::QueryError;
pub use fields::{Field, FlagField, NumberField, TextField, WholeField};
pub use numbers::Bounds;
pub use sort::{Order, Sort};
pub use whole::WholeValue;

/// What a clip must be.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Query {
    /// A clip meets all of them.
    pub terms: Vec<Term>,
}

/// One demand.
#[derive(Debug, Clone, PartialEq)]
pub struct Term {
    /// Whether it asks for all clips that do not meet the condition.
    pub is_negated: bool,
    /// What is asked of a clip.
    pub condition: Condition,
}

/// What is asked of a clip.
#[derive(Debug, Clone, PartialEq)]
pub enum Condition {
    /// Words stand next to each other in one text.
    Words {
        /// Which text; any of them without this.
        field: Option<TextField>,
        /// The words, with whatever stands between them.
        text: String,
        /// Whether the last word is a whole one; else it begins one.
        is_phrase: bool,
    },
    /// A text is a certain one.
    Whole {
        /// Which text.
        field: WholeField,
        /// What it must be.
        value: WholeValue,
    },
    /// A number lies within bounds.
    Number {
        /// Which number.
        field: NumberField,
        /// In the unit of its column.
        bounds: Bounds<f64>,
    },
    /// The day of the recording lies within bounds.
    Date {
        /// Texts that stand before and behind ISO dates, byte by byte.
        bounds: Bounds<String>,
    },
    /// Something is so, or known not to be so.
    Flag {
        /// What.
        field: FlagField,
        /// Whether it is so.
        value: bool,
    },
    /// The user has used it.
    Used {
        /// Not longer ago than so many seconds; at any time without this.
        within_s: Option<i64>,
    },
    /// The file is of a kind.
    Format {
        /// Its usual extension, in small letters.
        extension: &'static str,
    },
    /// Nothing is known of a field that some clips lack.
    Unknown(Field),
}
