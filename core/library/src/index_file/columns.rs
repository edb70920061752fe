//! Which column of a list says what.

use std::collections::BTreeMap;

use csv::StringRecord;

/// What a column may say.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Column {
    /// The clip's file: a name with or without its extension, or a path.
    File,
    /// Who was recorded; with the trial, also which clip.
    Subject,
    /// The number of the clip among those of its subject.
    Trial,
    /// What happens.
    Description,
    /// When it was recorded.
    Date,
    /// The session, or another group.
    Group,
    /// Whether the capture was cleaned.
    Cleaned,
}

/// Every column, its name in a mapping, and what people write over it: small letters and digits of it alone.
const COLUMNS: [(Column, &str, &[&str]); 7] = [
    (Column::File, "file", &["file", "filename", "name", "clip", "clipname", "motionfile", "path"]),
    (Column::Subject, "subject", &["subject", "subjectid", "subjectno", "subjectnumber", "actor", "performer"]),
    (
        Column::Trial,
        "trial",
        &["trial", "trialid", "trialno", "trialnumber", "motion", "motionno", "motionnumber", "take"],
    ),
    (
        Column::Description,
        "description",
        &["description", "motiondescription", "trialdescription", "comment", "comments", "note", "notes", "action"],
    ),
    (Column::Date, "date", &["date", "day", "recorded", "recordedon", "capturedate"]),
    (Column::Group, "group", &["group", "session", "category", "type"]),
    (Column::Cleaned, "cleaned", &["cleaned", "clean"]),
];

/// Which column of a row says what.
pub(super) type Places = BTreeMap<Column, usize>;

/// Returns what the columns say by what stands over them; `None` where that is no header of a list of clips.
pub(super) fn guess(header: &StringRecord) -> Option<Places> {
    let mut places = Places::new();
    for (index, title) in header.iter().enumerate() {
        let title: String = title.chars().filter(|c| c.is_alphanumeric()).flat_map(char::to_lowercase).collect();
        if let Some((column, ..)) = COLUMNS.iter().find(|(.., titles)| titles.contains(&title.as_str())) {
            places.entry(*column).or_insert(index);
        }
    }
    is_enough(&places).then_some(places)
}

/// Returns the places of columns that are named, `file` or `description` and what stands over each.
///
/// # Errors
/// In words: a column or a title that there is not, or too few of them.
pub(super) fn named(header: &StringRecord, titles: &BTreeMap<String, String>) -> Result<Places, String> {
    let mut places = Places::new();
    for (name, title) in titles {
        let Some((column, ..)) = COLUMNS.iter().find(|(_, known, _)| known == name) else {
            let known = COLUMNS.map(|(_, known, _)| known).join(", ");
            return Err(format!("expected one of the columns {known}, found `{name}`"));
        };
        let Some(index) = header.iter().position(|known| known.trim().eq_ignore_ascii_case(title.trim())) else {
            let known: Vec<_> = header.iter().map(str::trim).collect();
            return Err(format!("no column is called `{title}`: there are {}", known.join(", ")));
        };
        places.insert(*column, index);
    }
    if is_enough(&places) {
        return Ok(places);
    }
    Err("expected a column `file`, or `subject` and `trial`, and one that says something of the clip".to_owned())
}

/// Whether columns say which clip is meant, and something of it.
fn is_enough(places: &Places) -> bool {
    let has = |column| places.contains_key(&column);
    let by_number = has(Column::Subject) && has(Column::Trial);
    let says = [Column::Description, Column::Date, Column::Group, Column::Cleaned].into_iter().any(has);
    by_number && says || has(Column::File) && (says || has(Column::Subject))
}
