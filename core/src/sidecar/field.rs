//! The fields of a sidecar, and the many ways in which people write their labels.

/// One of the eleven lines.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Field {
    /// When the clip was recorded.
    Date,
    /// The session, or another group of clips that belong together.
    Group,
    /// Who was recorded.
    Subject,
    /// How long the clip is, in seconds.
    Duration,
    /// Frames per second.
    FrameRate,
    /// Whether the capture was cleaned: see [`cleaned`](super::cleaned).
    Cleaned,
    /// When the sidecar was changed the last time.
    LastChange,
    /// Who changed it.
    ModifiedBy,
    /// The usable pieces of the clip: see [`segments`](super::segments).
    UsableSegments,
    /// The skeleton's file.
    AsfFile,
    /// What else is to be said.
    Comment,
}

impl Field {
    /// Every field in the order of the lines.
    pub const ALL: [Self; 11] = [
        Self::Date,
        Self::Group,
        Self::Subject,
        Self::Duration,
        Self::FrameRate,
        Self::Cleaned,
        Self::LastChange,
        Self::ModifiedBy,
        Self::UsableSegments,
        Self::AsfFile,
        Self::Comment,
    ];

    /// Returns the label that we write: of one word, of three words for the last change, of two for the three after it.
    pub fn label(self) -> &'static str {
        match self {
            Self::Date => "Date",
            Self::Group => "Group",
            Self::Subject => "Subject",
            Self::Duration => "Duration",
            Self::FrameRate => "Framerate",
            Self::Cleaned => "Cleaned",
            Self::LastChange => "Last changed on",
            Self::ModifiedBy => "Modified by",
            Self::UsableSegments => "Usable segments",
            Self::AsfFile => "ASF file",
            Self::Comment => "Comment",
        }
    }

    /// Returns the field's name in programs: `last_change`.
    pub fn name(self) -> &'static str {
        match self {
            Self::Date => "date",
            Self::Group => "group",
            Self::Subject => "subject",
            Self::Duration => "duration",
            Self::FrameRate => "frame_rate",
            Self::Cleaned => "cleaned",
            Self::LastChange => "last_change",
            Self::ModifiedBy => "modified_by",
            Self::UsableSegments => "usable_segments",
            Self::AsfFile => "asf_file",
            Self::Comment => "comment",
        }
    }

    /// Returns the field of a name.
    pub fn of_name(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|field| field.name() == name)
    }

    /// Returns the field that a label means: ours, or one that people write instead, in any case and with any blanks,
    /// hyphens or underscores; English or German.
    pub fn of_label(label: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|field| field.distance(label).is_some())
    }

    /// Returns how far a label is from the field's own: 0 for that itself; `None` where it does not mean the field.
    pub(super) fn distance(self, label: &str) -> Option<usize> {
        let letters: String = label.chars().filter(|letter| letter.is_alphanumeric()).collect();
        let letters = letters.to_lowercase();
        self.spellings().iter().position(|spelling| *spelling == letters)
    }

    /// The labels in lower case, letters alone; the clearest first.
    fn spellings(self) -> &'static [&'static str] {
        match self {
            Self::Date => {
                &["date", "datum", "recordedon", "daterecorded", "recordingdate", "aufnahmedatum", "recorded"]
            }
            Self::Group => &["group", "gruppe", "sessiongroup", "session", "sitzung"],
            Self::Subject => &["subject", "subjekt", "actor", "akteur", "performer", "darsteller", "proband", "person"],
            Self::Duration => &["duration", "dauer", "length", "länge"],
            Self::FrameRate => &[
                "framerate",
                "bildrate",
                "framerateinhz",
                "framespersecond",
                "bilderprosekunde",
                "samplerate",
                "fps",
                "rate",
            ],
            Self::Cleaned => &["cleaned", "bereinigt", "cleanedup", "gereinigt", "gesäubert", "clean"],
            Self::LastChange => &[
                "lastchangedon",
                "dateoflastchange",
                "datelastchange",
                "datelastchanged",
                "datelastmodified",
                "datumderletztenänderung",
                "datumletzteänderung",
                "letzteänderungam",
                "letzteänderung",
                "zuletztgeändertam",
                "zuletztgeändert",
                "geändertam",
                "lastchange",
                "lastchanged",
                "lastchangedate",
                "lastmodified",
                "lastmodifiedon",
                "modifiedon",
            ],
            Self::ModifiedBy => &[
                "modifiedby",
                "geändertvon",
                "bearbeitetvon",
                "changedby",
                "editedby",
                "lastmodifiedby",
                "lastchangedby",
                "bearbeiter",
            ],
            Self::UsableSegments => &[
                "usablesegments",
                "brauchbaresegmente",
                "verwendbaresegmente",
                "brauchbareabschnitte",
                "verwendbareabschnitte",
                "nutzbaresegmente",
                "nutzbareabschnitte",
                "usableparts",
                "usablepieces",
                "segments",
                "segmente",
            ],
            Self::AsfFile => &["asffile", "asfdatei", "skeletonfile", "skelettdatei", "asf", "skeleton", "skelett"],
            Self::Comment => &[
                "comment",
                "kommentar",
                "comments",
                "kommentare",
                "bemerkung",
                "bemerkungen",
                "remark",
                "remarks",
                "description",
                "note",
                "notes",
            ],
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_label_and_name_means_its_field_and_no_spelling_means_two() {
        for field in Field::ALL {
            assert_eq!(Field::of_label(field.label()), Some(field));
            assert_eq!(Field::of_name(field.name()), Some(field));
            for spelling in field.spellings() {
                assert_eq!(Field::of_label(spelling), Some(field), "{spelling}");
            }
        }
    }

    #[test]
    fn labels_have_as_many_words_as_those_of_the_first_viewer() {
        let words = Field::ALL.map(|field| field.label().split(' ').count());
        assert_eq!(words, [1, 1, 1, 1, 1, 1, 3, 2, 2, 2, 1]);
    }

    #[test]
    fn labels_that_people_write_are_understood() {
        for (label, field) in [
            ("DATE", Some(Field::Date)),
            (" Frame rate ", Some(Field::FrameRate)),
            ("date of last change", Some(Field::LastChange)),
            ("Geändert von", Some(Field::ModifiedBy)),
            ("usable_segments", Some(Field::UsableSegments)),
            ("ASF-File", Some(Field::AsfFile)),
            ("Weather", None),
            ("", None),
        ] {
            assert_eq!(Field::of_label(label), field, "{label}");
        }
    }
}
