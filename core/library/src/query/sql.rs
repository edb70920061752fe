//! What a term is in the words of `SQLite`.

use std::fmt::Write as _;
use std::ops::Bound;

use rusqlite::types::Value;

use super::{Bounds, Condition, Field, FlagField, NumberField, Query, Term, TextField};
use crate::catalogue::now;

/// A condition on the columns of `clip`, with its values.
#[derive(Debug, Default, PartialEq)]
pub(super) struct Where {
    sql: String,
    pub values: Vec<Value>,
}

impl Where {
    /// Collects the terms that the columns of a clip answer.
    pub fn of(query: &Query) -> Self {
        let mut all = Self::default();
        for term in &query.terms {
            let Some(condition) = all.condition(&term.condition) else { continue };
            let joint = if all.sql.is_empty() { "" } else { " AND " };
            // Of what is not known, SQL says neither yes nor no: here that is no.
            let truth = if term.is_negated { "NOT TRUE" } else { "TRUE" };
            let _ = write!(all.sql, "{joint}({condition}) IS {truth}");
        }
        all
    }

    /// Returns whether every clip meets it.
    pub fn is_empty(&self) -> bool {
        self.sql.is_empty()
    }

    /// Returns the clause of a statement, with its keyword.
    pub fn clause(&self) -> String {
        if self.is_empty() {
            String::new()
        } else {
            format!("WHERE {}", self.sql)
        }
    }

    fn condition(&mut self, condition: &Condition) -> Option<String> {
        Some(match condition {
            Condition::Number { field, bounds } => {
                self.between(column(Field::Number(*field))?, bounds, |value| (*value).into())
            }
            Condition::Date { bounds } => self.between(column(Field::Date)?, bounds, |text| text.clone().into()),
            Condition::Flag { field, value } => self.compare(column(Field::Flag(*field))?, "=", (*value).into()),
            Condition::Used { within_s: None } => format!("{} IS NOT NULL", column(Field::Used)?),
            Condition::Used { within_s: Some(seconds) } => {
                self.compare(column(Field::Used)?, ">=", now().saturating_sub(*seconds).into())
            }
            Condition::Format { extension } => {
                self.compare(column(Field::Format)?, "=", (*extension).to_owned().into())
            }
            Condition::Unknown(field) => format!("{} IS NULL", column(*field)?),
            Condition::Words { .. } | Condition::Whole { .. } => return None,
        })
    }

    fn between<T>(&mut self, column: &str, bounds: &Bounds<T>, to_value: impl Fn(&T) -> Value) -> String {
        let mut side = |bound: &Bound<T>, open: &str, closed: &str| match bound {
            Bound::Included(end) => Some(self.compare(column, closed, to_value(end))),
            Bound::Excluded(end) => Some(self.compare(column, open, to_value(end))),
            Bound::Unbounded => None,
        };
        let sides = [side(&bounds.0, ">", ">="), side(&bounds.1, "<", "<=")];
        sides.into_iter().flatten().collect::<Vec<_>>().join(" AND ")
    }

    fn compare(&mut self, column: &str, operator: &str, value: Value) -> String {
        self.values.push(value);
        format!("{column} {operator} ?")
    }
}

/// Returns the column of `clip` that holds a number, a date, a flag or a format. `None` for what is a set of clips.
fn column(field: Field) -> Option<&'static str> {
    Some(match field {
        Field::Number(NumberField::Rate) => "rate_hz",
        Field::Number(NumberField::Duration) => "duration_s",
        Field::Number(NumberField::Frames) => "frames",
        Field::Number(NumberField::Height) => "height_m",
        Field::Number(NumberField::Rating) => "rating",
        Field::Number(NumberField::Size) => "size",
        Field::Number(NumberField::Joints) => "joints",
        Field::Number(NumberField::Markers) => "markers",
        Field::Date => "recorded_on",
        Field::Used => "used_at",
        Field::Format => "format",
        Field::Flag(FlagField::Cleaned) => "cleaned",
        Field::Flag(FlagField::Missing) => "is_missing",
        Field::Flag(FlagField::Favourite) => "is_favourite",
        Field::Flag(FlagField::Broken) | Field::Text(_) | Field::Whole(_) => return None,
    })
}

/// Returns words as the full-text index is asked for them, joined by `AND` or `OR`; `None` where there are none.
pub(super) fn words<'a>(terms: impl Iterator<Item = &'a Term>, joint: &str) -> Option<String> {
    let words: Vec<_> = terms.filter_map(word).collect();
    (!words.is_empty()).then(|| words.join(joint))
}

fn word(term: &Term) -> Option<String> {
    let Condition::Words { field, text, is_phrase } = &term.condition else { return None };
    let scope = match field {
        Some(TextField::Name) => "name : ",
        Some(TextField::Folder) => "folder : ",
        Some(TextField::Description) => "description : ",
        None => "",
    };
    let ending = if *is_phrase { "" } else { " *" };
    Some(format!("{scope}\"{}\"{ending}", text.replace('"', " ")))
}
