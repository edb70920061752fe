//! Tags: words that the user puts on clips.

use rusqlite::{params, Transaction};

use super::Library;
use crate::error::LibraryError;

/// No tag is longer, in characters.
const LONGEST: usize = 100;

impl Library {
    /// Puts tags on clips and takes others off. Tags are the same in either case; the first spelling stays.
    ///
    /// # Errors
    /// Where a tag is empty or very long, a clip is not there, or the library cannot be written.
    pub fn tag(&self, clips: &[i64], add: &[String], remove: &[String]) -> Result<(), LibraryError> {
        let add = add.iter().map(|tag| checked(tag)).collect::<Result<Vec<_>, _>>()?;
        self.write(|db| {
            for tag in add {
                db.execute("INSERT INTO tag (name) VALUES (?) ON CONFLICT DO NOTHING", [tag])?;
                let mut put = db.prepare_cached(
                    "INSERT INTO clip_tag (clip_id, tag_id) SELECT ?, id FROM tag WHERE name = ? ON CONFLICT DO NOTHING",
                )?;
                for clip in clips {
                    super::check_clip(db, *clip)?;
                    put.execute(params![clip, tag])?;
                }
            }
            for tag in remove {
                let mut take = db.prepare_cached(
                    "DELETE FROM clip_tag WHERE clip_id = ? AND tag_id = (SELECT id FROM tag WHERE name = ?)",
                )?;
                for clip in clips {
                    take.execute(params![clip, tag.trim()])?;
                }
            }
            remove_unused(db)
        })
    }
}

/// A tag without blanks around it.
fn checked(tag: &str) -> Result<&str, LibraryError> {
    let tag = tag.trim();
    if tag.is_empty() || tag.chars().count() > LONGEST || tag.contains(char::is_control) {
        return Err(LibraryError::Asked(format!("a tag is a word or a few, up to {LONGEST} letters: `{tag}` is none")));
    }
    Ok(tag)
}

/// Removes the tags that are on no clip any more.
pub(super) fn remove_unused(db: &Transaction<'_>) -> Result<(), LibraryError> {
    db.execute("DELETE FROM tag WHERE id NOT IN (SELECT tag_id FROM clip_tag)", ())?;
    Ok(())
}
