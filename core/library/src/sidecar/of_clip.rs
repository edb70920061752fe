//! The sidecar of a clip of the library: what is known of the clip goes there, and what is said there is taken in.

use std::path::PathBuf;

use motion_theater_core::sidecar::{cleaned, day, segments, Field, Segment, Sidecar, ValueError};

use super::{segments_text, SidecarFile};
use crate::catalogue::told::{put_in_force, tell};
use crate::catalogue::{ClipRow, Field as Column, Source};
use crate::error::LibraryError;
use crate::scan::sidecars;
use crate::Library;

impl Library {
    /// Opens the sidecar of a clip, or makes a new one with what the library knows of it and else the clip itself tells. A
    /// new one is on disk only once it is saved; [`Library::read_sidecar`] lets the library know of that.
    ///
    /// # Errors
    /// Where the clip is not there, or neither a sidecar nor the clip can be read.
    pub fn sidecar(&self, clip: i64) -> Result<SidecarFile, LibraryError> {
        let row = self.row(clip)?;
        let mut file = SidecarFile::beside(&row.path)?;
        if !file.is_on_disk() {
            take_over(&mut file.sidecar, &row).map_err(super::SidecarError::from)?;
        }
        Ok(file)
    }

    /// Writes what is in force of a clip to its sidecar, which is made where there is none: subject, date, group, comment,
    /// cleaned, usable segments. A value that means the same already stays as it is written, and so does what the library
    /// does not know. The lines of `emptied` lose their values instead: what the user took back is not to come in again.
    /// `today` (an ISO date) and `who` say who changed it. Returns where the sidecar is.
    ///
    /// # Errors
    /// Where the clip is not there or the sidecar cannot be saved; it is what it was then.
    pub fn write_sidecar(&self, clip: i64, emptied: &[Field], today: &str, who: &str) -> Result<PathBuf, LibraryError> {
        let row = self.row(clip)?;
        let mut file = SidecarFile::beside(&row.path)?;
        let is_new = !file.is_on_disk();
        let mut edit = || {
            if is_new && row.recorded_on.is_none() {
                // The day of the last change, with which a new one begins, is a guess that nobody gets to see here.
                file.sidecar.set(Field::Date, "")?;
            }
            take_over(&mut file.sidecar, &row)?;
            emptied.iter().try_for_each(|field| file.sidecar.set(*field, ""))
        };
        edit().map_err(super::SidecarError::from)?;
        file.stamp(today, who)?;
        file.save()?;
        self.read_sidecar(clip, &[])?;
        Ok(file.path().to_owned())
    }

    /// Takes in at once what the sidecar of a clip says, as the next scan would. What the user had said in the library of the
    /// lines in `edited` is taken back: there, the sidecar is the user's latest word.
    ///
    /// # Errors
    /// Where the clip is not there, or the library cannot be written.
    pub fn read_sidecar(&self, clip: i64, edited: &[Field]) -> Result<(), LibraryError> {
        let stale = sidecars::of_clip(&self.row(clip)?.path);
        self.write(|db| {
            let taken_back = edited.iter().filter_map(|line| column(*line)).map(|column| (column, None));
            tell(db, clip, Source::User, &taken_back.collect::<Vec<_>>())?;
            if edited.contains(&Field::UsableSegments) {
                db.execute("DELETE FROM segment WHERE clip_id = ?", [clip])?;
            }
            put_in_force(db, clip)?;
            sidecars::take_in_one(db, &stale)
        })
    }

    fn row(&self, clip: i64) -> Result<ClipRow, LibraryError> {
        let found = self.clips(&[clip])?.into_iter().next();
        found.ok_or_else(|| LibraryError::Asked(format!("the library has no clip {clip}")))
    }
}

/// Returns the column of the catalogue that a line tells.
fn column(line: Field) -> Option<Column> {
    match line {
        Field::Date => Some(Column::RecordedOn),
        Field::Group => Some(Column::SessionGroup),
        Field::Subject => Some(Column::Subject),
        Field::Cleaned => Some(Column::Cleaned),
        Field::Comment => Some(Column::Description),
        _ => None,
    }
}

fn take_over(sidecar: &mut Sidecar, row: &ClipRow) -> Result<(), ValueError> {
    for (field, value) in [
        (Field::Group, &row.session_group),
        (Field::Subject, &row.subject),
        // A sidecar has a line for it.
        (Field::Comment, &row.description.as_ref().map(|text| text.replace(['\n', '\r'], " "))),
    ] {
        if let Some(value) = value {
            sidecar.set(field, value)?;
        }
    }
    if let Some(date) =
        row.recorded_on.as_ref().filter(|date| day(current(sidecar, Field::Date)).as_ref() != Some(*date))
    {
        sidecar.set(Field::Date, date)?;
    }
    if row.cleaned.is_some() && cleaned(current(sidecar, Field::Cleaned)).ok().flatten() != row.cleaned {
        sidecar.set(Field::Cleaned, if row.cleaned == Some(true) { "Yes" } else { "No" })?;
    }
    let written = segments(current(sidecar, Field::UsableSegments));
    let is_same = |segment: &Segment, piece: &(i64, i64)| (segment.first_frame, segment.last_frame) == *piece;
    let agree = written.len() == row.segments.len() && written.iter().zip(&row.segments).all(|(a, b)| is_same(a, b));
    if !agree && !row.segments.is_empty() {
        let pieces = row.segments.iter().map(|&(first_frame, last_frame)| {
            let note = written.iter().find(|segment| is_same(segment, &(first_frame, last_frame)));
            Segment { first_frame, last_frame, note: note.map(|segment| segment.note.clone()).unwrap_or_default() }
        });
        sidecar.set(Field::UsableSegments, &segments_text(&pieces.collect::<Vec<_>>()))?;
    }
    Ok(())
}

fn current(sidecar: &Sidecar, field: Field) -> &str {
    sidecar.get(field).unwrap_or_default()
}
