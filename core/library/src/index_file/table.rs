//! From the bytes of a list to its rows.

use std::borrow::Cow;
use std::collections::BTreeMap;

use csv::{ReaderBuilder, StringRecord};
use motion_theater_core::read::Format;
use motion_theater_core::sidecar::{cleaned, day};

use super::columns::{guess, named, Column, Places};
use super::names::{numbers, stem};
use crate::catalogue::Field;

/// So far down a header is looked for: lists begin with a title, or with thanks.
const HEADER_LINES: usize = 20;

/// What a list says of a clip.
#[derive(Debug, Clone, PartialEq)]
pub struct Row {
    /// The clip's file as the list names it; else the subject and trial say which it is.
    pub file: Option<String>,
    /// Numbers of the subject and of the trial.
    pub numbers: Option<(u32, u32)>,
    /// What it says.
    pub says: Vec<(Field, String)>,
}

/// Reads a list: CSV with commas, semicolons or tabs, UTF-8 or Latin-1. `titles` says what stands over the columns;
/// without it that is guessed, and a list without a header has the clip first and then its description.
///
/// # Errors
/// In words: where no column says which clip is meant, or what of it.
pub fn read(bytes: &[u8], titles: Option<&BTreeMap<String, String>>) -> Result<Vec<Row>, String> {
    let text = decoded(bytes);
    let records = records(&text);
    let none = StringRecord::new();
    if let Some(titles) = titles {
        let places = named(records.first().unwrap_or(&none), titles)?;
        return Ok(records.iter().skip(1).filter_map(|record| row(record, &places)).collect());
    }
    let mut header = records.iter().take(HEADER_LINES).enumerate();
    if let Some((index, places)) = header.find_map(|(index, record)| Some((index, guess(record)?))) {
        return Ok(records.iter().skip(index + 1).filter_map(|record| row(record, &places)).collect());
    }
    let rows: Vec<Row> = records.iter().filter_map(plain_row).collect();
    if rows.is_empty() {
        return Err("expected a header with a column for the file, or for subject and trial, and one for the \
                    description; or rows of a clip and its description"
            .to_owned());
    }
    Ok(rows)
}

fn decoded(bytes: &[u8]) -> Cow<'_, str> {
    let bytes = bytes.strip_prefix(b"\xEF\xBB\xBF").unwrap_or(bytes);
    match std::str::from_utf8(bytes) {
        Ok(text) => Cow::Borrowed(text),
        Err(_) => Cow::Owned(bytes.iter().map(|byte| char::from(*byte)).collect()),
    }
}

/// Takes a list apart at the separator that most of its lines hold.
fn records(text: &str) -> Vec<StringRecord> {
    let lines = |separator: u8| text.lines().filter(|line| line.bytes().any(|byte| byte == separator)).count();
    // Of equally many, the last: commas stand in descriptions too.
    let separator = [b',', b';', b'\t'].into_iter().max_by_key(|separator| lines(*separator)).unwrap_or(b',');
    let mut reader =
        ReaderBuilder::new().has_headers(false).flexible(true).delimiter(separator).from_reader(text.as_bytes());
    reader.records().map_while(Result::ok).collect()
}

fn row(record: &StringRecord, places: &Places) -> Option<Row> {
    let cell = |column: Column| places.get(&column).and_then(|index| record.get(*index)).map(str::trim);
    let filled = |column: Column| cell(column).filter(|text| !text.is_empty());
    let number = |column: Column| filled(column).and_then(|text| text.parse().ok());
    let file = filled(Column::File).map(str::to_owned);
    let by_trial = number(Column::Subject).zip(number(Column::Trial));
    let numbers = file.as_deref().map_or(by_trial, |file| numbers(stem(file)));
    if file.is_none() && numbers.is_none() {
        return None;
    }
    // The clip's own name says the same, and with its zeros.
    let is_of_name = |text: &&str| numbers.is_some_and(|(subject, _)| text.parse() == Ok(subject));
    let subject = filled(Column::Subject).filter(|text| !is_of_name(text));
    let is_cleaned = filled(Column::Cleaned).and_then(|word| cleaned(word).ok().flatten());
    let says = [
        (Field::Subject, subject.map(str::to_owned)),
        (Field::RecordedOn, filled(Column::Date).map(|date| day(date).unwrap_or_else(|| date.to_owned()))),
        (Field::Description, filled(Column::Description).map(str::to_owned)),
        (Field::SessionGroup, filled(Column::Group).map(str::to_owned)),
        (Field::Cleaned, is_cleaned.map(|yes| i32::from(yes).to_string())),
    ];
    let known = |(field, text): (Field, Option<String>)| Some((field, field.checked(&text?).ok()??));
    Some(Row { file, numbers, says: says.into_iter().filter_map(known).collect() })
}

/// A row without a header: `02_01<tab>walk`, or the same with blanks alone.
fn plain_row(record: &StringRecord) -> Option<Row> {
    let cells: Vec<&str> = record.iter().map(str::trim).filter(|cell| !cell.is_empty()).collect();
    let (file, description) = match cells.as_slice() {
        [] => return None,
        [line] => line.split_once(char::is_whitespace)?,
        [file, rest @ ..] => (*file, *rest.first()?),
    };
    let extension = file.rsplit_once('.').map_or("", |(_, extension)| extension);
    let numbers = numbers(stem(file));
    if numbers.is_none() && Format::from_extension(extension).is_none() {
        return None;
    }
    let description = Field::Description.checked(description).ok()??;
    Some(Row { file: Some(file.to_owned()), numbers, says: vec![(Field::Description, description)] })
}
