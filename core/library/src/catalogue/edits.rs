//! What the user changes in the library.

use rusqlite::params;

use super::told::{put_in_force, tell, Field, Source};
use super::{check_clip, now, Library};
use crate::error::LibraryError;

/// The most stars.
const BEST_RATING: u8 = 5;

/// One thing that the user says of a clip.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Edit {
    /// A field's value; `None` takes the user's own back, and what was below it shows again.
    Field(Field, Option<String>),
    /// From 1 to 5 stars; 0 for none.
    Rating(u8),
    /// Whether it is among the favourites.
    Favourite(bool),
}

impl Library {
    /// Writes the same edits to several clips: all of them, or none where something is wrong.
    ///
    /// # Errors
    /// Where a value makes no sense, a clip is not there, or the library cannot be written.
    pub fn edit(&self, clips: &[i64], edits: &[Edit]) -> Result<(), LibraryError> {
        let mut says = Vec::new();
        for edit in edits {
            match edit {
                Edit::Field(field, value) => {
                    says.push((*field, value.as_deref().map(|value| field.checked(value)).transpose()?.flatten()));
                }
                Edit::Rating(stars) if *stars > BEST_RATING => {
                    return Err(LibraryError::Asked(format!("a rating is 0 to {BEST_RATING}, not {stars}")));
                }
                Edit::Rating(_) | Edit::Favourite(_) => {}
            }
        }
        self.write(|db| {
            for clip in clips {
                check_clip(db, *clip)?;
                for edit in edits {
                    match edit {
                        Edit::Rating(stars) => {
                            db.execute("UPDATE clip SET rating = ? WHERE id = ?", params![stars, clip])?
                        }
                        Edit::Favourite(is_one) => {
                            db.execute("UPDATE clip SET is_favourite = ? WHERE id = ?", params![is_one, clip])?
                        }
                        Edit::Field(..) => 0,
                    };
                }
                if !says.is_empty() {
                    tell(db, *clip, Source::User, &says)?;
                    put_in_force(db, *clip)?;
                }
            }
            Ok(())
        })
    }

    /// Replaces the usable pieces of a clip: first and last frame of each, in the file's own numbers.
    ///
    /// # Errors
    /// Where a piece ends before it begins, the clip is not there, or the library cannot be written.
    pub fn set_segments(&self, clip: i64, segments: &[(i64, i64)]) -> Result<(), LibraryError> {
        if let Some((first, last)) = segments.iter().find(|(first, last)| last < first) {
            return Err(LibraryError::Asked(format!("a piece from frame {first} to {last} ends before it begins")));
        }
        self.write(|db| {
            check_clip(db, clip)?;
            db.execute("DELETE FROM segment WHERE clip_id = ?", [clip])?;
            let mut insert = db.prepare_cached(
                "INSERT INTO segment (clip_id, first_frame, last_frame) VALUES (?, ?, ?) ON CONFLICT DO NOTHING",
            )?;
            for (first, last) in segments {
                insert.execute([clip, *first, *last])?;
            }
            Ok(())
        })
    }

    /// Notes that a clip was used just now.
    ///
    /// # Errors
    /// Where the clip is not there, or the library cannot be written.
    pub fn mark_used(&self, clip: i64) -> Result<(), LibraryError> {
        self.write(|db| {
            check_clip(db, clip)?;
            db.execute("UPDATE clip SET used_at = ? WHERE id = ?", [now(), clip])?;
            Ok(())
        })
    }

    /// Returns the values of a field (`tag`, `subject`, `format` or `group`) that clips have, each with how many have it.
    ///
    /// # Errors
    /// Where the field has another name, or the library cannot be read.
    pub fn values(&self, field: &str) -> Result<Vec<(String, u32)>, LibraryError> {
        let sql = match field {
            "tag" => {
                "SELECT name, count(*) FROM tag JOIN clip_tag ON tag_id = tag.id GROUP BY tag.id ORDER BY name COLLATE NOCASE"
            }
            "subject" => "SELECT subject, count(*) FROM clip WHERE subject IS NOT NULL GROUP BY 1 ORDER BY 1",
            "format" => "SELECT format, count(*) FROM clip GROUP BY 1 ORDER BY 1",
            "group" => "SELECT session_group, count(*) FROM clip WHERE session_group IS NOT NULL GROUP BY 1 ORDER BY 1",
            other => {
                return Err(LibraryError::Asked(format!("expected tag, subject, format or group, found `{other}`")));
            }
        };
        self.read(|db| {
            let mut rows = db.prepare_cached(sql)?;
            let values = rows.query_map((), |row| Ok((row.get(0)?, row.get(1)?)))?.collect::<Result<_, _>>()?;
            Ok(values)
        })
    }
}
