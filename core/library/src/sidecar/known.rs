//! What a clip itself tells for its sidecar.

use std::path::{Component, Path, PathBuf};
use std::time::{SystemTime, UNIX_EPOCH};

use motion_theater_core::loaded::{Loaded, Pairing};
use motion_theater_core::sidecar::{Field, Sidecar};

use crate::catalogue::Field as Column;
use crate::facts::said;

const SECONDS_A_DAY: u64 = 24 * 60 * 60;

/// Returns a new sidecar with the values that the clip tells; what it does not tell stays empty.
pub(super) fn sidecar_of(loaded: &Loaded) -> Sidecar {
    let mut sidecar = Sidecar::default();
    let rate = loaded.rate_hz();
    let duration = rate.map(|rate| loaded.frame_count() as f64 / rate);
    let says = said::by(&loaded.clip, &loaded.path);
    let said = |column: Column| says.iter().find(|(known, _)| *known == column).map(|(_, value)| value.clone());
    // Most files state no day: that of their last change (UTC) is the best that there is.
    let changed = || Some(day_of(loaded.path.metadata().ok()?.modified().ok()?));
    let values = [
        (Field::Date, said(Column::RecordedOn).or_else(changed)),
        (Field::Subject, said(Column::Subject)),
        (Field::Duration, duration.map(short)),
        (Field::FrameRate, rate.map(short)),
        (Field::AsfFile, skeleton(loaded)),
    ];
    for (field, value) in values {
        // A name with a line break in it is no value.
        let _ = value.map(|value| sidecar.set(field, &value));
    }
    sidecar
}

/// Returns the skeleton's file as seen from the clip's folder, where it lies near.
fn skeleton(loaded: &Loaded) -> Option<String> {
    let path = loaded.pairing.as_ref().and_then(Pairing::path)?;
    let (folder, of_skeleton) = (loaded.path.parent()?, path.parent()?);
    let is_same = |a: &Path, b: &Path| match (a.canonicalize(), b.canonicalize()) {
        (Ok(a), Ok(b)) => a == b,
        _ => a == b,
    };
    let here = |folder: &Path| if folder.as_os_str().is_empty() { PathBuf::from(".") } else { folder.to_owned() };
    let (folder, of_skeleton) = (here(folder), here(of_skeleton));
    let name = path.file_name()?.to_string_lossy().into_owned();
    if is_same(&folder, &of_skeleton) {
        Some(name)
    } else if is_same(&folder.join(Component::ParentDir), &of_skeleton) {
        Some(format!("../{name}"))
    } else {
        Some(path.display().to_string())
    }
}

/// Returns a number in a few digits: `2.633`, `120`.
fn short(value: f64) -> String {
    let text = format!("{value:.3}");
    text.trim_end_matches('0').trim_end_matches('.').to_owned()
}

/// Returns today (UTC), as an ISO date.
pub fn today() -> String {
    day_of(SystemTime::now())
}

/// Returns the day of a moment in UTC, as an ISO date.
fn day_of(moment: SystemTime) -> String {
    let days = moment.duration_since(UNIX_EPOCH).map_or(0, |since| since.as_secs() / SECONDS_A_DAY);
    let (year, month, day) = civil(days as i64);
    format!("{year:04}-{month:02}-{day:02}")
}

/// Returns year, month and day of a number of days since 1970-01-01. Years are counted from March on, so that the day that
/// a leap year has more is its last.
fn civil(days: i64) -> (i64, i64, i64) {
    const DAYS_IN_400_YEARS: i64 = 146_097;
    const DAYS_BEFORE_1970: i64 = 719_468;
    let days = days + DAYS_BEFORE_1970;
    let era = days.div_euclid(DAYS_IN_400_YEARS);
    let day_of_era = days.rem_euclid(DAYS_IN_400_YEARS);
    let year_of_era = (day_of_era - day_of_era / 1460 + day_of_era / 36_524 - day_of_era / 146_096) / 365;
    let day_of_year = day_of_era - (365 * year_of_era + year_of_era / 4 - year_of_era / 100);
    let month_from_march = (5 * day_of_year + 2) / 153;
    let day = day_of_year - (153 * month_from_march + 2) / 5 + 1;
    let month = if month_from_march < 10 { month_from_march + 3 } else { month_from_march - 9 };
    (400 * era + year_of_era + i64::from(month <= 2), month, day)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn days_are_those_of_the_calendar() {
        for (days, wanted) in [
            (0, (1970, 1, 1)),
            (11_016, (2000, 2, 29)),
            (11_017, (2000, 3, 1)),
            (20_088, (2024, 12, 31)),
            (-1, (1969, 12, 31)),
        ] {
            assert_eq!(civil(days), wanted);
        }
    }
}
