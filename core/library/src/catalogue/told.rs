//! What people say of clips, in layers: the file, an index of its folder, its sidecar, the user.
//!
//! Every source keeps what it says in the table `told`. In force is what the most trusted one says, and that is copied into
//! the clip's own columns, where it is searched. A scan never overwrites what the user wrote, and where the user takes
//! that back, what was below it shows again.

use rusqlite::{params, Connection};

use crate::error::LibraryError;

/// Who says something of a clip; later ones are trusted more.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Source {
    /// The clip's file, or its name.
    File,
    /// A list of the folder's clips.
    Index,
    /// The clip's sidecar (`.i3d`).
    Sidecar,
    /// The user, in the library.
    User,
}

impl Source {
    /// Every source, the least trusted first.
    pub const ALL: [Self; 4] = [Self::File, Self::Index, Self::Sidecar, Self::User];

    /// Returns the source's name in the database: `SIDECAR`.
    pub fn name(self) -> &'static str {
        match self {
            Self::File => "FILE",
            Self::Index => "INDEX",
            Self::Sidecar => "SIDECAR",
            Self::User => "USER",
        }
    }
}

/// What can be said of a clip.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Field {
    /// Who was recorded.
    Subject,
    /// When: a year, a month or a day (`2004`, `2004-05`, `2004-05-31`).
    RecordedOn,
    /// What happens.
    Description,
    /// The session, or another group of clips that belong together.
    SessionGroup,
    /// Whether the capture was cleaned: `1` or `0`.
    Cleaned,
}

impl Field {
    /// Every field.
    pub const ALL: [Self; 5] = [Self::Subject, Self::RecordedOn, Self::Description, Self::SessionGroup, Self::Cleaned];

    /// Returns the field's name, which is that of the column too: `recorded_on`.
    pub fn name(self) -> &'static str {
        match self {
            Self::Subject => "subject",
            Self::RecordedOn => "recorded_on",
            Self::Description => "description",
            Self::SessionGroup => "session_group",
            Self::Cleaned => "cleaned",
        }
    }

    /// Returns the field of a name.
    pub fn of_name(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|field| field.name() == name)
    }

    /// Returns a value as the field keeps it; nothing where it is empty.
    ///
    /// # Errors
    /// Where the field cannot hold it: the reason in words.
    pub fn checked(self, value: &str) -> Result<Option<String>, LibraryError> {
        let value = value.trim();
        let wrong = |wanted: &str| Err(LibraryError::Asked(format!("{wanted}, not `{value}`")));
        match self {
            _ if value.is_empty() => Ok(None),
            Self::RecordedOn if !is_date(value) => {
                wrong("the day of the recording is a year, a month or a day such as 2004, 2004-05 or 2004-05-31")
            }
            Self::Cleaned if !matches!(value, "0" | "1") => wrong("cleaned is 1 for yes or 0 for no"),
            _ => Ok(Some(value.to_owned())),
        }
    }
}

/// Whether a text is an ISO date, or the first part of one.
fn is_date(text: &str) -> bool {
    let mut parts = text.split('-');
    let mut number = |digits: usize| {
        let part = parts.next()?;
        (part.len() == digits && part.bytes().all(|byte| byte.is_ascii_digit())).then(|| part.parse::<u32>().ok())?
    };
    let (year, month, day) = (number(4), number(2), number(2));
    let count = text.split('-').count();
    let days = match (month, year) {
        (Some(2), Some(year)) if year % 4 == 0 && (year % 100 != 0 || year % 400 == 0) => 29,
        (Some(2), _) => 28,
        (Some(4 | 6 | 9 | 11), _) => 30,
        _ => 31,
    };
    year.is_some()
        && count <= 3
        && (count < 2 || month.is_some_and(|month| (1..=12).contains(&month)))
        && (count < 3 || day.is_some_and(|day| (1..=days).contains(&day)))
}

/// Keeps what a source says of a clip's fields; `None` takes it back. Fields that are not listed stay. [`put_in_force`]
/// must follow.
pub(crate) fn tell(
    db: &Connection,
    clip: i64,
    source: Source,
    says: &[(Field, Option<String>)],
) -> Result<(), LibraryError> {
    for (field, value) in says {
        match value {
            Some(value) => db
                .prepare_cached(
                    "INSERT INTO told (clip_id, source, field, value) VALUES (?, ?, ?, ?)
                     ON CONFLICT DO UPDATE SET value = excluded.value",
                )?
                .execute(params![clip, source.name(), field.name(), value])?,
            None => db
                .prepare_cached("DELETE FROM told WHERE clip_id = ? AND source = ? AND field = ?")?
                .execute(params![clip, source.name(), field.name()])?,
        };
    }
    Ok(())
}

/// Copies what the most trusted sources say into the clip's own columns.
pub(crate) fn put_in_force(db: &Connection, clip: i64) -> Result<(), LibraryError> {
    let mut update = db.prepare_cached(
        "WITH best AS (
             SELECT field, value, max(CASE source WHEN 'USER' THEN 3 WHEN 'SIDECAR' THEN 2 WHEN 'INDEX' THEN 1 ELSE 0 END)
             FROM told WHERE clip_id = ?1 GROUP BY field
         )
         UPDATE clip SET
             subject = (SELECT value FROM best WHERE field = 'subject'),
             recorded_on = (SELECT value FROM best WHERE field = 'recorded_on'),
             description = (SELECT value FROM best WHERE field = 'description'),
             session_group = (SELECT value FROM best WHERE field = 'session_group'),
             cleaned = CAST((SELECT value FROM best WHERE field = 'cleaned') AS INTEGER)
         WHERE id = ?1",
    )?;
    update.execute([clip])?;
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn dates_are_years_months_or_days_that_exist() {
        for good in ["2004", "2004-05", "2004-02-29", "1999-12-31", "2000-02-29"] {
            assert_eq!(Field::RecordedOn.checked(good).unwrap().as_deref(), Some(good));
        }
        for bad in [
            "04",
            "2004-5",
            "2004-13",
            "2003-02-29",
            "1900-02-29",
            "2004-04-31",
            "31.5.2004",
            "2004-05-",
            "2004-05-06-07",
        ] {
            let message = Field::RecordedOn.checked(bad).expect_err(bad).to_string();
            assert!(message.starts_with("the day of the recording is a year, a month or a day"), "{message}");
        }
    }

    #[test]
    fn an_empty_value_is_none() {
        for field in Field::ALL {
            assert_eq!(field.checked("  ").unwrap(), None);
            assert_eq!(Field::of_name(field.name()), Some(field));
        }
    }
}
