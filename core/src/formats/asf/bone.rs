//! One bone of `:bonedata`.

use super::read::{next_of_section, read_dofs, read_order, read_vector, Once};
use super::AsfBone;
use crate::error::ParseError;
use crate::number;
use crate::skeleton::Limit;
use crate::text::{Lines, Word, Words};

/// Reads `begin { field } end`, where `first` is the line of `begin`.
pub(super) fn read_bone(lines: &mut Lines<'_>, mut first: Words<'_>) -> Result<AsfBone, ParseError> {
    let begin = first.expect("`begin`")?;
    if !begin.is("begin") {
        return Err(begin.unexpected("`begin`, a section or the end of the file"));
    }
    first.finish()?;
    let mut bone = AsfBone::default();
    let mut seen = Once::default();
    loop {
        let Some(mut words) = next_of_section(lines) else {
            return Err(match lines.peek_words().and_then(|mut words| words.next()) {
                Some(section) => section.unexpected(format_args!("`end` of {}", called(&bone))),
                None => lines.ended(format_args!("`end` of {}", called(&bone))),
            });
        };
        let raw = words.rest();
        let keyword = words.expect("a field")?;
        if keyword.is("end") {
            words.finish()?;
            for field in ["name", "direction", "length"] {
                if !seen.has(field) {
                    return Err(keyword.unexpected(format_args!("`{field}` of {}", called(&bone))));
                }
            }
            return Ok(bone);
        }
        if read_field(&mut bone, &keyword, &mut words, lines)? {
            seen.check(&keyword)?;
            words.finish()?;
        } else if continues_limits(&keyword) {
            return Err(keyword.unexpected(format_args!("a field of {}", called(&bone))));
        } else {
            bone.others.push(raw);
        }
    }
}

/// Reads one field; returns false where the keyword is not known.
fn read_field(
    bone: &mut AsfBone,
    keyword: &Word<'_>,
    words: &mut Words<'_>,
    lines: &mut Lines<'_>,
) -> Result<bool, ParseError> {
    let of_bone = called(bone);
    let number_for = |field: &str| format!("a number for `{field}` of {of_bone}");
    match keyword.text().to_ascii_lowercase().as_str() {
        "id" => {
            let word = words.expect("a whole number for `id`")?;
            let id = word.text().parse().map_err(|_| word.unexpected("a whole number for `id`"))?;
            bone.id = Some(id);
        }
        "name" => bone.name = words.expect("the name of the bone")?.text(),
        "direction" => bone.direction = read_vector(words, number_for("direction"))?,
        "length" => bone.length = words.number(number_for("length"))?,
        "axis" => {
            bone.axis = read_vector(words, number_for("axis"))?;
            if let Some(order) = words.next() {
                bone.axis_order = read_order(&order)?;
            }
        }
        "dof" => bone.dofs = read_dofs(words)?,
        "limits" => bone.limits = read_limits(words, lines, &of_bone)?,
        "bodymass" => bone.body_mass = Some(words.number(number_for("bodymass"))?),
        "cofmass" => {
            let numbers = words.map(|word| word.number(number_for("cofmass")));
            bone.centre_of_mass = numbers.collect::<Result<_, _>>()?;
        }
        "begin" => return Err(keyword.unexpected(format_args!("`end` of {of_bone}"))),
        _ => return Ok(false),
    }
    Ok(true)
}

fn called(bone: &AsfBone) -> String {
    if bone.name.is_empty() {
        "the bone".to_owned()
    } else {
        format!("bone `{}`", bone.name)
    }
}

/// Reads pairs of numbers, on this line and on those that follow and begin with a bracket or a number.
fn read_limits(words: &mut Words<'_>, lines: &mut Lines<'_>, of_bone: &str) -> Result<Vec<Limit>, ParseError> {
    let mut limits = Vec::new();
    let mut open: Option<f64> = None;
    let mut line: Vec<_> = words.split_at_brackets().collect();
    loop {
        for word in line {
            let bound = number::read_or_infinity(word.bytes);
            let bound = bound.ok_or_else(|| word.unexpected(format_args!("a number for `limits` of {of_bone}")))?;
            match open.take() {
                Some(low) => limits.push((low, bound)),
                None => open = Some(bound),
            }
        }
        let starts_with_limit = |line: &Words<'_>| line.clone().next().is_some_and(|word| continues_limits(&word));
        let Some(mut next) = lines.peek_words().filter(starts_with_limit) else { break };
        lines.next_words();
        line = next.split_at_brackets().collect();
    }
    match (open, lines.peek_words().and_then(|mut words| words.next())) {
        (None, _) => Ok(limits),
        (Some(_), Some(word)) => Err(word.unexpected(format_args!("the upper limit of {of_bone}"))),
        (Some(_), None) => Err(lines.ended(format_args!("the upper limit of {of_bone}"))),
    }
}

/// Whether a line with this first word goes on with the limits of the line before.
fn continues_limits(first: &Word<'_>) -> bool {
    first.bytes.starts_with(b"(") || number::read_or_infinity(first.bytes).is_some()
}
