//! What stands before the first frame.

use super::AmcHeader;
use crate::error::ParseError;
use crate::formats::AngleUnit;
use crate::rate::RATES_HZ;
use crate::text::{decode, Lines, Words};

/// The comment in which Vicon's programs name the skeleton.
const HINT: &[u8] = b"#!OML:ASF";

/// Reads up to the first line that is neither keyword nor comment.
pub(super) fn read_header(lines: &mut Lines<'_>) -> Result<AmcHeader, ParseError> {
    let mut header = AmcHeader::default();
    loop {
        let mut ahead = lines.clone();
        let Some(mut words) = ahead.next_line() else { return Ok(header) };
        let raw = words.raw().trim_ascii();
        if header.skeleton_hint.is_none() {
            header.skeleton_hint = hint(raw);
        }
        let text = words.rest();
        match words.next() {
            Some(keyword) if keyword.bytes.starts_with(b":") => {
                match keyword.text().to_ascii_uppercase().trim_end_matches(':') {
                    ":FULLY-SPECIFIED" => header.is_fully_specified = true,
                    ":FORCE-ALL-JOINTS-BE-3DOF" => header.is_forced_to_3dof = true,
                    ":DEGREES" => set_once(&mut header.angle, AngleUnit::Degrees, &keyword)?,
                    ":RADIANS" => set_once(&mut header.angle, AngleUnit::Radians, &keyword)?,
                    ":SAMPLES-PER-SECOND" => set_once(&mut header.rate_hz, read_rate(&mut words)?, &keyword)?,
                    _ => header.others.push(text),
                }
            }
            Some(_) => return Ok(header),
            None => {}
        }
        *lines = ahead;
    }
}

/// Returns the skeleton's file as the beginning of a motion file names it; files get renamed, so it is only a hint.
pub fn skeleton_hint(head: &[u8]) -> Option<String> {
    read_header(&mut Lines::new(head)).ok()?.skeleton_hint
}

fn hint(line: &[u8]) -> Option<String> {
    let (start, rest) = line.split_at_checked(HINT.len())?;
    let path = rest.trim_ascii();
    (start.eq_ignore_ascii_case(HINT) && !path.is_empty()).then(|| decode(path))
}

/// A keyword may come again as long as it says the same.
fn set_once<T: PartialEq>(field: &mut Option<T>, value: T, keyword: &crate::text::Word<'_>) -> Result<(), ParseError> {
    match field {
        Some(known) if *known != value => Err(keyword.unexpected("nothing that contradicts an earlier line")),
        _ => {
            *field = Some(value);
            Ok(())
        }
    }
}

fn read_rate(words: &mut Words<'_>) -> Result<f64, ParseError> {
    let what = "a number of samples per second";
    let word = words.expect(what)?;
    let rate = word.number(what)?;
    if RATES_HZ.contains(&rate) {
        Ok(rate)
    } else {
        Err(word.unexpected(format_args!("{what} from {} to {}", RATES_HZ.start(), RATES_HZ.end())))
    }
}
