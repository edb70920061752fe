//! Clips of the right words and whole texts.
//!
//! Words are for the full-text index; texts that are compared as a whole are looked through value by value. Each term gives
//! a set of clips.

use rusqlite::types::Value;
use rusqlite::{params_from_iter, Connection, Row};

use super::id_set::IdSet;
use super::sql::words;
use super::{Condition, Field, FlagField, Query, Term, WholeField, WholeValue};

/// What the terms give that no column in `clip_facts` answers.
#[derive(Default)]
pub(super) struct Sets {
    wanted: Vec<IdSet>,
    unwanted: Vec<IdSet>,
}

const BROKEN: &str = "SELECT id FROM clip WHERE error IS NOT NULL";
const DESCRIBED: &str = "SELECT id FROM clip WHERE description > ''";

/// Returns the statement for the clips of which a text is known.
fn all_with(field: WholeField) -> &'static str {
    match field {
        WholeField::Subject => "SELECT id FROM clip WHERE subject > ''",
        WholeField::Group => "SELECT id FROM clip WHERE session_group > ''",
        WholeField::Tag => "SELECT clip_id FROM clip_tag",
        WholeField::Skeleton => "SELECT id FROM clip WHERE skeleton_fingerprint > '' OR skeleton_path > ''",
    }
}

impl Sets {
    /// Collects what the terms give.
    pub fn of(db: &Connection, query: &Query) -> rusqlite::Result<Self> {
        let mut sets = Self::default();
        if let Some(words) = words(query.terms.iter().filter(|term| !term.is_negated), " AND ") {
            sets.wanted.push(clips_with(db, &words)?);
        }
        if let Some(words) = words(query.terms.iter().filter(|term| term.is_negated), " OR ") {
            sets.unwanted.push(clips_with(db, &words)?);
        }
        for Term { is_negated, condition } in &query.terms {
            let (set, is_wanted) = match condition {
                Condition::Whole { field, value } => (clips_of(db, *field, value)?, true),
                Condition::Flag { field: FlagField::Broken, value } => (ids(db, BROKEN, vec![])?, *value),
                Condition::Unknown(Field::Text(_)) => (ids(db, DESCRIBED, vec![])?, false),
                Condition::Unknown(Field::Whole(field)) => (ids(db, all_with(*field), vec![])?, false),
                _ => continue,
            };
            let sets = if is_wanted == *is_negated { &mut sets.unwanted } else { &mut sets.wanted };
            sets.push(set);
        }
        Ok(sets)
    }

    /// Leaves only those that are in one more set.
    pub fn keep(&mut self, set: IdSet) {
        self.wanted.push(set);
    }

    /// Returns whether a clip is among them.
    pub fn hold(&self, id: i64) -> bool {
        self.wanted.iter().all(|set| set.contains(id)) && !self.unwanted.iter().any(|set| set.contains(id))
    }
}

/// Returns the clips that words are in, which are written as the full-text index is asked.
pub(super) fn clips_with(db: &Connection, words: &str) -> rusqlite::Result<IdSet> {
    ids(db, "SELECT rowid FROM clip_text WHERE clip_text MATCH ?", vec![words.to_owned().into()])
}

/// Returns the clips of which one text as a whole is what was asked for.
fn clips_of(db: &Connection, field: WholeField, value: &WholeValue) -> rusqlite::Result<IdSet> {
    match field {
        WholeField::Subject => {
            runs(db, "SELECT id, subject, NULL FROM clip WHERE subject > '' ORDER BY subject", |text, _| {
                text.is_some_and(|text| value.is_met_by(text))
            })
        }
        WholeField::Group => runs(
            db,
            "SELECT id, session_group, NULL FROM clip WHERE session_group > '' ORDER BY session_group",
            |text, _| text.is_some_and(|text| value.is_met_by(text)),
        ),
        WholeField::Skeleton => runs(
            db,
            "SELECT id, skeleton_fingerprint, skeleton_path FROM clip ORDER BY skeleton_fingerprint, skeleton_path",
            |fingerprint, path| value.is_met_by_skeleton(fingerprint, path),
        ),
        WholeField::Tag => clips_with_tag(db, value),
    }
}

/// Returns the ids of rows with two texts that are met. Equal rows stand side by side and are asked about once.
fn runs(db: &Connection, sql: &str, is_met: impl Fn(Option<&str>, Option<&str>) -> bool) -> rusqlite::Result<IdSet> {
    let mut set = IdSet::default();
    let mut last: (Option<String>, Option<String>) = (None, None);
    let mut is_last_met = false;
    each(db, sql, vec![], |row| {
        let texts = (row.get_ref(1)?.as_str_or_null()?, row.get_ref(2)?.as_str_or_null()?);
        if texts != (last.0.as_deref(), last.1.as_deref()) {
            is_last_met = is_met(texts.0, texts.1);
            last = (texts.0.map(str::to_owned), texts.1.map(str::to_owned));
        }
        if is_last_met {
            set.insert(row.get(0)?);
        }
        Ok(())
    })?;
    Ok(set)
}

fn clips_with_tag(db: &Connection, value: &WholeValue) -> rusqlite::Result<IdSet> {
    let mut tags: Vec<i64> = Vec::new();
    each(db, "SELECT id, name FROM tag", vec![], |row| {
        if value.is_met_by(row.get_ref(1)?.as_str()?) {
            tags.push(row.get(0)?);
        }
        Ok(())
    })?;
    let mut set = IdSet::default();
    for tag in tags {
        each(db, "SELECT clip_id FROM clip_tag WHERE tag_id = ?", vec![tag.into()], |row| {
            set.insert(row.get(0)?);
            Ok(())
        })?;
    }
    Ok(set)
}

/// Returns the ids that a statement gives.
pub(super) fn ids(db: &Connection, sql: &str, values: Vec<Value>) -> rusqlite::Result<IdSet> {
    let mut set = IdSet::default();
    each(db, sql, values, |row| {
        set.insert(row.get(0)?);
        Ok(())
    })?;
    Ok(set)
}

/// Goes through the rows of a statement.
pub(super) fn each(
    db: &Connection,
    sql: &str,
    values: Vec<Value>,
    mut task: impl FnMut(&Row<'_>) -> rusqlite::Result<()>,
) -> rusqlite::Result<()> {
    let mut statement = db.prepare_cached(sql)?;
    let mut rows = statement.query(params_from_iter(values))?;
    while let Some(row) = rows.next()? {
        task(row)?;
    }
    Ok(())
}
