//! In which order clips are listed.

use std::cmp::Ordering;

use rusqlite::types::ValueRef;

/// What clips are ordered by. Those that are equal follow by name, and those of one name as they came into the library;
/// those of which it is not known stand at the end, in either direction.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Sort {
    /// The name of the file, in either case.
    #[default]
    Name,
    /// The path of the file.
    Path,
    /// The day of the recording.
    Date,
    /// When the file was last changed.
    Modified,
    /// How long it lasts.
    Duration,
    /// Frames per second.
    Rate,
    /// How many frames.
    Frames,
    /// Bytes of the file.
    Size,
    /// Stars.
    Rating,
    /// When the user last used it.
    Used,
    /// How telling the texts are in which the words of the query stand: the name, then everything but the folder, then
    /// the folder. Without words, the name.
    Relevance,
}

const SORTS: [(&str, Sort); 11] = [
    ("name", Sort::Name),
    ("path", Sort::Path),
    ("date", Sort::Date),
    ("modified", Sort::Modified),
    ("duration", Sort::Duration),
    ("rate", Sort::Rate),
    ("frames", Sort::Frames),
    ("size", Sort::Size),
    ("rating", Sort::Rating),
    ("used", Sort::Used),
    ("relevance", Sort::Relevance),
];

impl Sort {
    /// Returns the order of a name, in small letters.
    pub fn named(name: &str) -> Option<Self> {
        SORTS.iter().find(|(known, _)| *known == name).map(|(_, sort)| *sort)
    }

    /// Returns the names of all orders: "name, path, date".
    pub fn list() -> String {
        SORTS.map(|(name, _)| name).join(", ")
    }
}

/// An order and its direction.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Order {
    /// What clips are ordered by.
    pub sort: Sort,
    /// Whether the greatest comes first; of [`Sort::Relevance`], the least telling.
    pub is_descending: bool,
}

/// What one clip is ordered by. All those of a column are of one kind.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Key {
    Integer(i64),
    Real(f64),
    /// A date, which has ten letters at most: copied and compared without memory of its own.
    Text([u8; 16]),
}

impl Key {
    /// Returns the key of a value; `None` where it is not known.
    pub fn of(value: ValueRef<'_>) -> Option<Self> {
        match value {
            ValueRef::Null | ValueRef::Blob(_) => None,
            ValueRef::Integer(value) => Some(Self::Integer(value)),
            ValueRef::Real(value) => Some(Self::Real(value)),
            ValueRef::Text(text) => {
                let mut key = [0; 16];
                key.iter_mut().zip(text).for_each(|(place, byte)| *place = *byte);
                Some(Self::Text(key))
            }
        }
    }

    fn compare(&self, other: &Self) -> Ordering {
        match (self, other) {
            (Self::Integer(a), Self::Integer(b)) => a.cmp(b),
            (Self::Real(a), Self::Real(b)) => a.total_cmp(b),
            (Self::Text(a), Self::Text(b)) => a.cmp(b),
            _ => Ordering::Equal,
        }
    }
}

/// Compares two keys; what is not known is last.
pub(super) fn compare(a: Option<&Key>, b: Option<&Key>, is_descending: bool) -> Ordering {
    match (a, b) {
        (Some(a), Some(b)) if is_descending => b.compare(a),
        (Some(a), Some(b)) => a.compare(b),
        (a, b) => a.is_none().cmp(&b.is_none()),
    }
}
