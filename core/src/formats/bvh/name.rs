//! Names: read by the line, made unique for the [`Skeleton`](crate::Skeleton), and made fit for a line again.

use super::tokens::{is_space, Tokens};
use crate::text::{decode, skip_blanks};
use std::collections::{HashMap, HashSet};

/// What a joint without a name is called in a skeleton.
const NAMELESS: &str = "joint";

/// Takes the name that the rest of the line holds, possibly empty.
///
/// `JOINT Left Arm {` and `JOINT Left Arm{` name the joint `Left Arm`. Other braces are part of the name.
pub(super) fn read_name(tokens: &mut Tokens<'_>) -> String {
    let rest = tokens.rest();
    let start = rest.len() - skip_blanks(rest).len();
    let ends = |at: &usize| matches!(rest.get(*at), Some(b'\n' | b'\r')) || is_lone_brace(rest, *at, start);
    let end = (start..rest.len()).find(ends).unwrap_or(rest.len());
    let mut name = trim(rest.get(..end).unwrap_or_default());
    let mut behind = tokens.clone();
    behind.advance(end);
    if name.ends_with(b"{") && behind.peek().is_none_or(|word| word.bytes != b"{") {
        name = without_last(name);
        // `a {{`: what is left would open the joint too.
        while name.len().checked_sub(1).is_some_and(|last| is_lone_brace(name, last, 0)) {
            name = without_last(name);
        }
    } else {
        *tokens = behind;
        return decode(name);
    }
    let brace = rest.get(..end).and_then(|line| line.iter().rposition(|byte| *byte == b'{'));
    tokens.advance(brace.unwrap_or(end));
    decode(name)
}

/// Returns whether a brace stands there that is a word by itself, or where the name would begin.
fn is_lone_brace(text: &[u8], at: usize, start: usize) -> bool {
    let is_free = |byte: Option<&u8>| byte.is_none_or(|byte| is_space(*byte));
    let before = at.checked_sub(1).and_then(|before| text.get(before));
    text.get(at) == Some(&b'{') && is_free(before) && (at == start || is_free(text.get(at + 1)))
}

/// Whether each has a name of its own.
pub(super) fn are_unique<'a>(mut names: impl Iterator<Item = &'a str>) -> bool {
    let mut seen = HashSet::with_capacity(names.size_hint().0);
    names.all(|name| !name.is_empty() && seen.insert(name))
}

/// Returns a name of its own for each, and which were changed. `.001` and so on sets the later ones apart.
pub(super) fn unique_names<'a>(names: impl Iterator<Item = &'a str> + Clone) -> (Vec<String>, Vec<String>) {
    if are_unique(names.clone()) {
        return (names.map(str::to_owned).collect(), Vec::new());
    }
    let taken: HashSet<&str> = names.clone().collect();
    let mut seen: HashSet<&str> = HashSet::with_capacity(taken.len());
    let mut counts: HashMap<&str, usize> = HashMap::new();
    let (mut unique, mut changed) = (Vec::new(), Vec::new());
    for name in names {
        if !name.is_empty() && seen.insert(name) {
            unique.push(name.to_owned());
            continue;
        }
        let base = if name.is_empty() { NAMELESS } else { name };
        let count = counts.entry(base).or_default();
        let own = loop {
            *count += 1;
            let own = format!("{base}.{count:03}");
            if !taken.contains(own.as_str()) {
                break own;
            }
        };
        changed.push(own.clone());
        unique.push(own);
    }
    (unique, changed)
}

/// Returns a name as a line of a file can hold it: no line ends, no outer blanks, no brace that would open the joint.
pub(super) fn name_for_file(name: &str) -> String {
    let line: Vec<u8> = name.bytes().map(|byte| if matches!(byte, b'\n' | b'\r') { b' ' } else { byte }).collect();
    let line = trim(&line);
    let fit = |at| if is_lone_brace(line, at, 0) { b'(' } else { line[at] };
    decode(&(0..line.len()).map(fit).collect::<Vec<_>>())
}

fn without_last(name: &[u8]) -> &[u8] {
    trim(name.split_last().map_or(name, |(_, rest)| rest))
}

fn trim(line: &[u8]) -> &[u8] {
    let start = line.iter().take_while(|byte| is_space(**byte)).count();
    let end = line.iter().rposition(|byte| !is_space(*byte)).map_or(start, |last| last + 1);
    line.get(start..end).unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_name_is_the_rest_of_its_line_up_to_the_brace() {
        for (line, name) in [
            (" Left Arm ", "Left Arm"),
            ("\tmixamorig:Hips", "mixamorig:Hips"),
            (" Left Arm { OFFSET", "Left Arm"),
            ("Left Arm{", "Left Arm"),
            ("a{\n{", "a{"),
            ("a{b} (c) [d] #e", "a{b} (c) [d] #e"),
            ("\n{", ""),
            ("{", ""),
            (" {a}", ""),
            (" ROOT a {{\nOFFSET", "ROOT a"),
            (" \u{fc}\n", "\u{fc}"),
        ] {
            assert_eq!(read_name(&mut Tokens::new(line.as_bytes())), name, "{line:?}");
        }
        assert_eq!(read_name(&mut Tokens::new(b"H\xFCfte")), "H\u{fc}fte");
    }

    #[test]
    fn what_is_read_as_a_name_is_written_as_it_is() {
        const LETTERS: [u8; 4] = *b"a{ \n";
        for number in 0..4_usize.pow(8) {
            let line: Vec<u8> = (0..8).map(|place| LETTERS[number >> (2 * place) & 3]).collect();
            let name = read_name(&mut Tokens::new(&line));
            assert_eq!(name_for_file(&name), name, "{:?}", decode(&line));
        }
    }

    #[test]
    fn later_joints_of_one_name_get_a_number_that_is_free() {
        let (unique, changed) = unique_names(["a", "a", "a.001", "", "a", ""].into_iter());
        assert_eq!(unique, ["a", "a.002", "a.001", "joint.001", "a.003", "joint.002"]);
        assert_eq!(changed, ["a.002", "joint.001", "a.003", "joint.002"]);
    }

    #[test]
    fn any_name_fits_into_a_line() {
        for name in ["a\nb", " a ", "a {", "{", "{{", "{b c}", "a{", "\t", "}"] {
            let written = name_for_file(name);
            assert_eq!(read_name(&mut Tokens::new(format!("{written}\n{{").as_bytes())), written, "{name:?}");
        }
    }
}
