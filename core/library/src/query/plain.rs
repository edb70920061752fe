//! The clear version of a search: every clip is looked at, and what a term means is said in plain words.
//!
//! Only the division of texts into words comes from `SQLite`, from a table of its own.

use std::cell::RefCell;
use std::cmp::Ordering;
use std::collections::HashMap;
use std::ops::RangeBounds;

use rusqlite::Connection;

use super::{Condition, Field, FlagField, NumberField, Order, Query, Sort, TextField, WholeField};
use crate::catalogue::now;

/// A clip as a query sees it.
#[derive(Debug, Clone, Default)]
pub struct PlainClip {
    pub id: i64,
    pub name: String,
    pub folder: String,
    pub path: String,
    pub subject: Option<String>,
    pub description: Option<String>,
    pub group: Option<String>,
    pub tags: Vec<String>,
    pub skeleton_fingerprint: Option<String>,
    pub skeleton_path: Option<String>,
    pub format: String,
    pub rate_hz: Option<f64>,
    pub duration_s: Option<f64>,
    pub height_m: Option<f64>,
    pub frames: Option<i64>,
    pub joints: Option<i64>,
    pub markers: Option<i64>,
    pub size: i64,
    pub modified_ns: i64,
    pub used_at: Option<i64>,
    pub rating: i64,
    pub recorded_on: Option<String>,
    pub cleaned: Option<bool>,
    pub is_missing: bool,
    pub is_favourite: bool,
    pub error: Option<String>,
}

/// Returns the ids of the clips that a query gives, in order.
pub fn search(clips: &[PlainClip], query: &Query, order: Order) -> Vec<i64> {
    let words = Words::new();
    let meets = |clip: &PlainClip, condition: &Condition| is_met(clip, condition, &words);
    let mut found: Vec<&PlainClip> = clips
        .iter()
        .filter(|clip| query.terms.iter().all(|term| meets(clip, &term.condition) != term.is_negated))
        .collect();
    let by_name =
        |a: &&PlainClip, b: &&PlainClip| (a.name.to_ascii_lowercase(), a.id).cmp(&(b.name.to_ascii_lowercase(), b.id));
    let rank = |clip: &PlainClip| relevance(clip, query, &words);
    let turned = |ordering: Ordering| if order.is_descending { ordering.reverse() } else { ordering };
    found.sort_by(by_name);
    found.sort_by(|a, b| match order.sort {
        Sort::Name => turned(by_name(a, b)),
        Sort::Path => turned(a.path.cmp(&b.path)),
        Sort::Modified => turned(a.modified_ns.cmp(&b.modified_ns)),
        Sort::Size => turned(a.size.cmp(&b.size)),
        Sort::Rating => turned(a.rating.cmp(&b.rating)),
        Sort::Relevance => turned(rank(a).cmp(&rank(b))),
        Sort::Date => unknown_last(a.recorded_on.as_ref(), b.recorded_on.as_ref(), turned),
        Sort::Duration => unknown_last(a.duration_s.as_ref(), b.duration_s.as_ref(), turned),
        Sort::Rate => unknown_last(a.rate_hz.as_ref(), b.rate_hz.as_ref(), turned),
        Sort::Frames => unknown_last(a.frames.as_ref(), b.frames.as_ref(), turned),
        Sort::Used => unknown_last(a.used_at.as_ref(), b.used_at.as_ref(), turned),
    });
    found.iter().map(|clip| clip.id).collect()
}

fn unknown_last<T: PartialOrd>(a: Option<&T>, b: Option<&T>, turned: impl Fn(Ordering) -> Ordering) -> Ordering {
    match (a, b) {
        (Some(a), Some(b)) => turned(a.partial_cmp(b).expect("numbers that can be compared")),
        (None, Some(_)) => Ordering::Greater,
        (Some(_), None) => Ordering::Less,
        (None, None) => Ordering::Equal,
    }
}

/// 0 where each word is in the name, 1 where each is in some text but the folder, else 2.
fn relevance(clip: &PlainClip, query: &Query, words: &Words) -> u8 {
    let is_free = |condition: &Condition| matches!(condition, Condition::Words { field: None, .. });
    let terms: Vec<_> = query.terms.iter().filter(|term| !term.is_negated && is_free(&term.condition)).collect();
    let all_meet = |clip: &PlainClip| terms.iter().all(|term| is_met(clip, &term.condition, words));
    let in_name = PlainClip { name: clip.name.clone(), ..PlainClip::default() };
    let without_folder = PlainClip { folder: String::new(), ..clip.clone() };
    if all_meet(&in_name) {
        0
    } else {
        2 - u8::from(all_meet(&without_folder))
    }
}

fn is_met(clip: &PlainClip, condition: &Condition, words: &Words) -> bool {
    match condition {
        Condition::Words { field, text, is_phrase } => {
            let asked = words.of(text);
            texts(clip, *field).iter().any(|text| holds(&words.of(text), &asked, *is_phrase))
        }
        Condition::Whole { field: WholeField::Skeleton, value } => {
            value.is_met_by_skeleton(clip.skeleton_fingerprint.as_deref(), clip.skeleton_path.as_deref())
        }
        Condition::Whole { field: WholeField::Tag, value } => clip.tags.iter().any(|tag| value.is_met_by(tag)),
        Condition::Whole { field: WholeField::Subject, value } => {
            clip.subject.as_ref().is_some_and(|subject| value.is_met_by(subject))
        }
        Condition::Whole { field: WholeField::Group, value } => {
            clip.group.as_ref().is_some_and(|group| value.is_met_by(group))
        }
        Condition::Number { field, bounds } => number(clip, *field).is_some_and(|number| bounds.contains(&number)),
        Condition::Date { bounds } => clip.recorded_on.as_ref().is_some_and(|date| bounds.contains(date)),
        Condition::Flag { field, value } => flag(clip, *field) == Some(*value),
        Condition::Used { within_s } => {
            clip.used_at.is_some_and(|at| within_s.is_none_or(|seconds| now() - at <= seconds))
        }
        Condition::Format { extension } => clip.format == *extension,
        Condition::Unknown(field) => is_unknown(clip, *field),
    }
}

/// Whether words stand next to each other, the last perhaps only begun.
fn holds(text: &[String], asked: &[String], is_phrase: bool) -> bool {
    let Some((last, before)) = asked.split_last() else { return false };
    text.windows(asked.len()).any(|window| {
        let end = &window[before.len()];
        window[..before.len()] == *before && if is_phrase { end == last } else { end.starts_with(last.as_str()) }
    })
}

fn texts(clip: &PlainClip, field: Option<TextField>) -> Vec<&str> {
    match field {
        Some(TextField::Name) => vec![&clip.name],
        Some(TextField::Folder) => vec![&clip.folder],
        Some(TextField::Description) => clip.description.iter().map(String::as_str).collect(),
        None => {
            let known = [&clip.subject, &clip.description, &clip.group].into_iter().flatten().chain(&clip.tags);
            [&clip.name, &clip.folder].into_iter().chain(known).map(String::as_str).collect()
        }
    }
}

fn number(clip: &PlainClip, field: NumberField) -> Option<f64> {
    match field {
        NumberField::Rate => clip.rate_hz,
        NumberField::Duration => clip.duration_s,
        NumberField::Height => clip.height_m,
        NumberField::Frames => clip.frames.map(|frames| frames as f64),
        NumberField::Joints => clip.joints.map(|joints| joints as f64),
        NumberField::Markers => clip.markers.map(|markers| markers as f64),
        NumberField::Rating => Some(clip.rating as f64),
        NumberField::Size => Some(clip.size as f64),
    }
}

fn flag(clip: &PlainClip, field: FlagField) -> Option<bool> {
    match field {
        FlagField::Cleaned => clip.cleaned,
        FlagField::Missing => Some(clip.is_missing),
        FlagField::Broken => Some(clip.error.is_some()),
        FlagField::Favourite => Some(clip.is_favourite),
    }
}

fn is_unknown(clip: &PlainClip, field: Field) -> bool {
    let is_blank = |text: &Option<String>| text.as_deref().unwrap_or_default().is_empty();
    match field {
        Field::Whole(WholeField::Subject) => is_blank(&clip.subject),
        Field::Whole(WholeField::Group) => is_blank(&clip.group),
        Field::Whole(WholeField::Tag) => clip.tags.is_empty(),
        Field::Whole(WholeField::Skeleton) => is_blank(&clip.skeleton_fingerprint) && is_blank(&clip.skeleton_path),
        Field::Text(_) => is_blank(&clip.description),
        Field::Number(field) => number(clip, field).is_none(),
        Field::Date => clip.recorded_on.is_none(),
        Field::Used => clip.used_at.is_none(),
        Field::Flag(field) => flag(clip, field).is_none(),
        Field::Format => false,
    }
}

/// Divides texts into words as the full-text index does, by asking one that holds nothing but that text.
struct Words {
    db: Connection,
    known: RefCell<HashMap<String, Vec<String>>>,
}

impl Words {
    fn new() -> Self {
        let db = Connection::open_in_memory().expect("a database in memory");
        db.execute_batch(
            "CREATE VIRTUAL TABLE said USING fts5 (text, tokenize = 'unicode61 remove_diacritics 2');
             CREATE VIRTUAL TABLE word USING fts5vocab (said, instance);",
        )
        .expect("a table of words");
        Self { db, known: RefCell::default() }
    }

    fn of(&self, text: &str) -> Vec<String> {
        let words = || {
            self.db.execute("INSERT INTO said (rowid, text) VALUES (1, ?)", [text])?;
            let mut rows = self.db.prepare_cached("SELECT term FROM word ORDER BY offset")?;
            let words = rows.query_map((), |row| row.get(0))?.collect::<rusqlite::Result<Vec<String>>>();
            self.db.execute("DELETE FROM said", ())?;
            words
        };
        self.known.borrow_mut().entry(text.to_owned()).or_insert_with(|| words().expect("words of a text")).clone()
    }
}
