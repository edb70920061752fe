//! What the library knows of a clip, written to the sidecar beside it.

use std::path::PathBuf;

use motion_theater_core::sidecar::{cleaned, day, segments, Field, Segment, Sidecar, ValueError};

use super::{segments_text, SidecarFile};
use crate::catalogue::ClipRow;
use crate::error::LibraryError;
use crate::Library;

impl Library {
    /// Writes what is in force of a clip to its sidecar, which is made where there is none: subject, date, group, comment,
    /// cleaned, usable segments. A value that means the same already stays as it is written, and so does what the library
    /// does not know. `today` (an ISO date) and `who` say who changed it. Returns where the sidecar is.
    ///
    /// # Errors
    /// Where the clip is not there or the sidecar cannot be saved; it is what it was then.
    pub fn write_sidecar(&self, clip: i64, today: &str, who: &str) -> Result<PathBuf, LibraryError> {
        let rows = self.clips(&[clip])?;
        let row = rows.first().ok_or_else(|| LibraryError::Asked(format!("the library has no clip {clip}")))?;
        let mut file = SidecarFile::beside(&row.path)?;
        take_over(&mut file.sidecar, row).map_err(super::SidecarError::from)?;
        file.stamp(today, who)?;
        file.save()?;
        Ok(file.path().to_owned())
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
