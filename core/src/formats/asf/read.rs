//! Bytes -> [`Asf`]: the sections.

use super::hierarchy::{check_hierarchy, read_hierarchy};
use super::{bone::read_bone, Asf, OtherSection, Root, Units, DOF_WORDS, ORDER_WORDS};
use crate::error::ParseError;
use crate::formats::kind::{self, Kind};
use crate::formats::AngleUnit;
use crate::skeleton::{Dof, EulerOrder};
use crate::text::{decode, Lines, Word, Words};
use std::fmt::Display;

/// A unit of length beyond these is damage.
pub(super) const BEARABLE_LENGTH_UNITS: std::ops::RangeInclusive<f64> = 1e-9..=1e9;

pub(super) fn parse(source: &[u8]) -> Result<Asf, ParseError> {
    kind::check(source, Kind::Asf)?;
    let mut lines = Lines::new(source);
    let mut asf = Asf::default();
    let mut seen = Once::default();
    let mut bone_positions = Vec::new();
    let mut family_positions = Vec::new();
    while let Some(mut words) = lines.next_words() {
        let section = words.expect("a section")?;
        if !section.bytes.starts_with(b":") {
            return Err(section.unexpected("a section such as `:bonedata`"));
        }
        let keyword = section.text().to_ascii_lowercase();
        match keyword.as_str() {
            ":version" | ":name" | ":units" | ":documentation" | ":root" | ":bonedata" | ":hierarchy" => {
                seen.check(&section)?;
            }
            _ => {}
        }
        match keyword.as_str() {
            ":version" => asf.version = Some(words.rest()),
            ":name" => asf.name = Some(words.rest()),
            ":documentation" => asf.documentation = Some(read_documentation(&mut lines, &words)),
            ":units" => asf.units = read_units(&mut lines, words)?,
            ":root" => asf.root = read_root(&mut lines, words)?,
            ":bonedata" => {
                words.finish()?;
                while let Some(begin) = next_of_section(&mut lines) {
                    bone_positions.push(begin.at());
                    asf.bones.push(read_bone(&mut lines, begin)?);
                }
            }
            ":hierarchy" => {
                words.finish()?;
                (asf.hierarchy, family_positions) = read_hierarchy(&mut lines)?;
            }
            _ => asf.others.push(OtherSection {
                name: section.text(),
                value: words.rest(),
                lines: raw_lines(&mut lines),
            }),
        }
    }
    for section in [":bonedata", ":hierarchy"] {
        if !seen.has(section) {
            return Err(lines.ended(format_args!("the section `{section}`")));
        }
    }
    check_hierarchy(source, &asf, &bone_positions, &family_positions)?;
    Ok(asf)
}

/// Returns the next line with words, unless a section begins there.
pub(super) fn next_of_section<'a>(lines: &mut Lines<'a>) -> Option<Words<'a>> {
    let starts_section = |mut words: Words<'_>| words.next().is_some_and(|word| word.bytes.starts_with(b":"));
    if starts_section(lines.peek_words()?) {
        return None;
    }
    lines.next_words()
}

/// Keywords that may come once, and have come.
#[derive(Default)]
pub(super) struct Once(Vec<String>);

impl Once {
    /// Notes a keyword; refuses it the second time.
    pub(super) fn check(&mut self, word: &Word<'_>) -> Result<(), ParseError> {
        let keyword = word.text().to_ascii_lowercase();
        if self.has(&keyword) {
            return Err(word.problem(format_args!("`{keyword}` only once"), "it again"));
        }
        self.0.push(keyword);
        Ok(())
    }

    /// Returns whether the keyword, in lower case, has come.
    pub(super) fn has(&self, keyword: &str) -> bool {
        self.0.iter().any(|seen| seen == keyword)
    }
}

fn read_units<'a>(lines: &mut Lines<'a>, first: Words<'a>) -> Result<Units, ParseError> {
    let mut units = Units::default();
    let mut seen = Once::default();
    for_each_line(lines, first, |mut words| {
        let raw = words.rest();
        let keyword = words.expect("a unit")?;
        if keyword.is("mass") {
            units.mass = Some(words.number("a number for the unit `mass`")?);
        } else if keyword.is("length") {
            let word = words.expect("a number for the unit `length`")?;
            let length = word.number("a number for the unit `length`")?;
            if !BEARABLE_LENGTH_UNITS.contains(&length) {
                return Err(word.unexpected("a number from 1e-9 to 1e9 for the unit `length`"));
            }
            units.length = Some(length);
        } else if keyword.is("angle") {
            let word = words.expect("`deg` or `rad`")?;
            let is_one_of = |spellings: [&str; 4]| spellings.iter().any(|spelling| word.is(spelling));
            units.angle = Some(match () {
                () if is_one_of(["deg", "degs", "degree", "degrees"]) => AngleUnit::Degrees,
                () if is_one_of(["rad", "rads", "radian", "radians"]) => AngleUnit::Radians,
                () => return Err(word.unexpected("`deg` or `rad`")),
            });
        } else {
            units.others.push(raw);
            return Ok(());
        }
        seen.check(&keyword)?;
        words.finish()
    })?;
    Ok(units)
}

fn read_root<'a>(lines: &mut Lines<'a>, first: Words<'a>) -> Result<Root, ParseError> {
    let mut root = Root::default();
    let mut seen = Once::default();
    for_each_line(lines, first, |mut words| {
        let raw = words.rest();
        let keyword = words.expect("a field of the root")?;
        if keyword.is("order") {
            root.order = read_dofs(&mut words)?;
        } else if keyword.is("axis") {
            let word = words.expect("an order such as XYZ for `axis` of the root")?;
            root.axis = read_order(&word)?;
        } else if keyword.is("position") {
            root.position = read_vector(&mut words, "a number for `position` of the root")?;
        } else if keyword.is("orientation") {
            root.orientation = read_vector(&mut words, "a number for `orientation` of the root")?;
        } else {
            root.others.push(raw);
            return Ok(());
        }
        seen.check(&keyword)?;
        words.finish()
    })?;
    Ok(root)
}

/// Calls `read` with what stands behind a section's name, if anything, and with each line up to the next section.
fn for_each_line<'a>(
    lines: &mut Lines<'a>,
    first: Words<'a>,
    mut read: impl FnMut(Words<'a>) -> Result<(), ParseError>,
) -> Result<(), ParseError> {
    if let Some(word) = first.clone().next() {
        if word.bytes.starts_with(b":") {
            return Err(word.unexpected("a field, for each section begins on a line of its own"));
        }
        read(first)?;
    }
    while let Some(words) = next_of_section(lines) {
        read(words)?;
    }
    Ok(())
}

/// Takes the lines as they are, up to the next section; what stands behind the section's name is the first.
fn read_documentation(lines: &mut Lines<'_>, first: &Words<'_>) -> Vec<String> {
    let inline = decode(first.raw()).trim().to_owned();
    let mut documentation = if inline.is_empty() { Vec::new() } else { vec![inline] };
    documentation.extend(raw_lines(lines));
    documentation
}

/// Takes the lines as they are, up to the next that begins with a colon.
fn raw_lines(lines: &mut Lines<'_>) -> Vec<String> {
    let mut taken = Vec::new();
    loop {
        let mut ahead = lines.clone();
        match ahead.next_line() {
            Some(line) if !line.raw().trim_ascii_start().starts_with(b":") => taken.push(decode(line.raw())),
            _ => return taken,
        }
        *lines = ahead;
    }
}

pub(super) fn read_vector(words: &mut Words<'_>, what: impl Display) -> Result<[f64; 3], ParseError> {
    Ok([words.number(&what)?, words.number(&what)?, words.number(&what)?])
}

pub(super) fn read_order(word: &Word<'_>) -> Result<EulerOrder, ParseError> {
    let known = ORDER_WORDS.iter().find(|(spelling, _)| word.is(spelling));
    known.map(|(_, order)| *order).ok_or_else(|| word.unexpected("an order such as XYZ"))
}

/// Reads degrees of freedom up to the end of the line.
pub(super) fn read_dofs(words: &mut Words<'_>) -> Result<Vec<Dof>, ParseError> {
    let mut dofs = Vec::new();
    for word in words {
        let known = DOF_WORDS.iter().find(|(spelling, _)| word.is(spelling));
        let (_, dof) = known.ok_or_else(|| word.unexpected("one of tx ty tz rx ry rz l"))?;
        if dofs.contains(dof) {
            return Err(word.problem("each degree of freedom only once", format_args!("`{}` again", word.text())));
        }
        dofs.push(*dof);
    }
    Ok(dofs)
}
