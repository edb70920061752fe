//! What a file says of itself in words: who, when, what.

use std::path::Path;

use motion_theater_core::formats::c3d::C3d;
use motion_theater_core::formats::csm::Csm;
use motion_theater_core::read::Clip;

use crate::catalogue::Field;

/// Returns what a file says, and else its name.
pub(crate) fn by(clip: &Clip, path: &Path) -> Vec<(Field, String)> {
    let of_csm = clip.csm.as_ref().map(by_csm).unwrap_or_default();
    let of_c3d = clip.c3d.as_ref().map(by_c3d).unwrap_or_default();
    let mut said: Vec<_> = of_csm.into_iter().chain(of_c3d).collect();
    if !said.iter().any(|(field, _)| *field == Field::Subject) {
        said.extend(subject_of_name(path).map(|subject| (Field::Subject, subject)));
    }
    // What a field cannot hold is not said.
    said.into_iter().filter_map(|(field, value)| Some((field, field.checked(&value).ok()??))).collect()
}

fn by_csm(csm: &Csm) -> Vec<(Field, String)> {
    let text = |name: &str| csm.texts.iter().find(|(known, _)| known.eq_ignore_ascii_case(name)).map(|(_, text)| text);
    let subject = text("Actor").map(|actor| (Field::Subject, actor.clone()));
    let date = text("Date").map(|date| (Field::RecordedOn, iso(date)));
    let comments = text("Comments").map(|comments| (Field::Description, comments.clone()));
    subject.into_iter().chain(date).chain(comments).collect()
}

fn by_c3d(c3d: &C3d) -> Vec<(Field, String)> {
    let texts = |group: &str, name: &str| c3d.parameter(group, name).map(|parameter| parameter.texts());
    let listed = |names: Vec<String>| names.into_iter().filter(|name| !name.is_empty()).collect::<Vec<_>>().join(", ");
    let subject = texts("SUBJECTS", "NAMES").map(listed).filter(|names| !names.is_empty());
    let subject = subject.or_else(|| texts("SUBJECT", "NAME").map(listed));
    let stated = texts("TRIAL", "CREATION_DATE").map(|texts| iso(&texts.concat())).filter(|date| !date.is_empty());
    let date = stated.or_else(|| {
        let numbers = c3d.parameter("TRIAL", "DATE")?.numbers();
        let [year, month, day] = numbers.first_chunk::<3>().copied()?;
        Some(format!("{year:04}-{month:02}-{day:02}"))
    });
    let subject = subject.map(|subject| (Field::Subject, subject));
    subject.into_iter().chain(date.map(|date| (Field::RecordedOn, date))).collect()
}

/// Returns the day of a text that begins with year, month and day in this order; anything else as it is.
///
/// Other orders mean one thing here and another there: they are not taken for dates.
fn iso(text: &str) -> String {
    let day = text.trim().get(..10).unwrap_or(text.trim());
    day.replace('/', "-")
}

/// Returns the subject of a name as the public data sets number them: `02` of `02_03.amc`.
fn subject_of_name(path: &Path) -> Option<String> {
    const MOST_DIGITS: usize = 3;
    let stem = path.file_stem()?.to_str()?;
    let (subject, rest) = stem.split_once('_')?;
    let is_number = |text: &str| (1..=MOST_DIGITS).contains(&text.len()) && text.bytes().all(|b| b.is_ascii_digit());
    let take = rest.split(['-', '_', '.', ' ']).next()?;
    (is_number(subject) && is_number(take)).then(|| subject.to_owned())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbered_takes_name_their_subject() {
        for (name, subject) in [
            ("02_03.amc", Some("02")),
            ("135_06-martialArts.amc", Some("135")),
            ("2004_05.bvh", None),
            ("walk_01.bvh", None),
            ("02.asf", None),
            ("02_walk.amc", None),
        ] {
            assert_eq!(subject_of_name(Path::new(name)).as_deref(), subject, "{name}");
        }
    }

    #[test]
    fn only_dates_that_begin_with_the_year_are_understood() {
        for (text, date) in [
            ("2008/07/17", Some("2008-07-17")),
            ("2023-02-01 20:53:18", Some("2023-02-01")),
            ("23/07/2003", None),
            ("", None),
        ] {
            assert_eq!(Field::RecordedOn.checked(&iso(text)).ok().flatten().as_deref(), date, "{text}");
        }
    }
}
