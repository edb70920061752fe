//! From a query to the clips that it gives.
//!
//! What numbers, dates and flags say is a condition for `SQLite`, which is met while it goes through the clips in the
//! order of their names, in an index that holds all that is asked for. Clips that are not in the sets of all other terms
//! are left out on the way. No text is ever sorted.

use rusqlite::Connection;

use super::sets::{clips_with, each, ids, Sets};
use super::sort::{compare, Key};
use super::sql::{words, Where};
use super::{Condition, Order, Query, Sort, Term};
use crate::catalogue::Library;
use crate::error::LibraryError;

impl Library {
    /// Returns the numbers of the clips that a query gives, in order.
    ///
    /// # Errors
    /// Where the library cannot be read.
    pub fn search(&self, query: &Query, order: Order) -> Result<Vec<i64>, LibraryError> {
        self.read(|db| {
            // All parts of the answer see the library at one moment.
            let moment = db.unchecked_transaction()?;
            Ok(search(&moment, query, order)?)
        })
    }
}

fn search(db: &Connection, query: &Query, order: Order) -> rusqlite::Result<Vec<i64>> {
    let sets = Sets::of(db, query)?;
    let condition = Where::of(query);
    match order.sort {
        Sort::Path => by_path(db, sets, condition, order.is_descending),
        Sort::Name => by_name(db, &sets, condition, order.is_descending),
        Sort::Relevance => {
            let found = by_name(db, &sets, condition, false)?;
            by_relevance(db, query, order.is_descending, found)
        }
        sort => by_key(db, &sets, condition, key_column(sort), order.is_descending),
    }
}

fn by_name(db: &Connection, sets: &Sets, condition: Where, is_descending: bool) -> rusqlite::Result<Vec<i64>> {
    let direction = if is_descending { "DESC" } else { "ASC" };
    let order = format!("ORDER BY name COLLATE NOCASE {direction}, id {direction}");
    let mut found = Vec::new();
    each(db, &format!("SELECT id FROM clip {} {order}", condition.clause()), condition.values, |row| {
        found.extend(Some(row.get(0)?).filter(|id| sets.hold(*id)));
        Ok(())
    })?;
    Ok(found)
}

/// The index of the paths holds nothing else, so what the condition gives is one more set.
fn by_path(db: &Connection, mut sets: Sets, condition: Where, is_descending: bool) -> rusqlite::Result<Vec<i64>> {
    if !condition.is_empty() {
        sets.keep(ids(db, &format!("SELECT id FROM clip {}", condition.clause()), condition.values)?);
    }
    let direction = if is_descending { "DESC" } else { "ASC" };
    let mut found = Vec::new();
    each(db, &format!("SELECT id FROM clip ORDER BY path {direction}"), vec![], |row| {
        found.extend(Some(row.get(0)?).filter(|id| sets.hold(*id)));
        Ok(())
    })?;
    Ok(found)
}

fn by_key(
    db: &Connection,
    sets: &Sets,
    condition: Where,
    column: &str,
    is_descending: bool,
) -> rusqlite::Result<Vec<i64>> {
    let sql = format!("SELECT id, {column} FROM clip {} ORDER BY name COLLATE NOCASE, id", condition.clause());
    let mut found: Vec<(Option<Key>, i64)> = Vec::new();
    each(db, &sql, condition.values, |row| {
        let id = row.get(0)?;
        if sets.hold(id) {
            found.push((Key::of(row.get_ref(1)?), id));
        }
        Ok(())
    })?;
    found.sort_by(|(a, _), (b, _)| compare(a.as_ref(), b.as_ref(), is_descending));
    Ok(found.into_iter().map(|(_, id)| id).collect())
}

fn key_column(sort: Sort) -> &'static str {
    match sort {
        Sort::Name | Sort::Relevance => "name",
        Sort::Path => "path",
        Sort::Date => "recorded_on",
        Sort::Modified => "modified_ns",
        Sort::Duration => "duration_s",
        Sort::Rate => "rate_hz",
        Sort::Frames => "frames",
        Sort::Size => "size",
        Sort::Rating => "rating",
        Sort::Used => "used_at",
    }
}

/// Orders clips that are in the order of their names by where the words without a field stand.
fn by_relevance(
    db: &Connection,
    query: &Query,
    is_descending: bool,
    mut found: Vec<i64>,
) -> rusqlite::Result<Vec<i64>> {
    let is_free = |term: &&Term| !term.is_negated && matches!(term.condition, Condition::Words { field: None, .. });
    if let Some(words) = words(query.terms.iter().filter(is_free), " AND ") {
        let in_name = clips_with(db, &format!("name : ({words})"))?;
        let but_folder = clips_with(db, &format!("- folder : ({words})"))?;
        let rank = |id: i64| if in_name.contains(id) { 0 } else { 2 - i8::from(but_folder.contains(id)) };
        found.sort_by_key(|id| if is_descending { -rank(*id) } else { rank(*id) });
    }
    Ok(found)
}
