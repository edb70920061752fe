//! What stands between `HIERARCHY` and `MOTION`.

use super::name::read_name;
use super::tokens::Tokens;
use super::{Channel, EndSite, Joint, CHANNEL_WORDS};
use crate::error::ParseError;
use crate::text::Word;

/// Reads all joints. What comes next is `MOTION` or the end of the file.
pub(super) fn read(tokens: &mut Tokens<'_>) -> Result<Vec<Joint>, ParseError> {
    tokens.keyword("HIERARCHY")?;
    let mut joints = Vec::new();
    loop {
        let expected = if joints.is_empty() { "`ROOT`" } else { "`ROOT`, `MOTION` or the end of the file" };
        match tokens.peek() {
            None if !joints.is_empty() => return Ok(joints),
            Some(word) if word.is("MOTION") && !joints.is_empty() => return Ok(joints),
            None => return Err(tokens.ended(expected)),
            Some(word) if !word.is("ROOT") => return Err(word.unexpected(expected)),
            Some(_) => {
                tokens.next();
                read_tree(tokens, &mut joints)?;
            }
        }
    }
}

/// A joint whose closing brace is still to come.
struct Open {
    joint: usize,
    has_offset: bool,
    has_channels: bool,
}

/// Reads a root and everything in it. The joints that are open are a list: a file may nest them as deep as it likes.
fn read_tree(tokens: &mut Tokens<'_>, joints: &mut Vec<Joint>) -> Result<(), ParseError> {
    let mut open = vec![open_joint(tokens, joints, None)?];
    while let Some(current) = open.last_mut() {
        let Some(joint) = joints.get_mut(current.joint) else { return Ok(()) };
        let of_joint = || format!("in joint `{}`", joint.name);
        let what = "`OFFSET`, `CHANNELS`, `JOINT`, `End Site` or `}`";
        let Some(word) = tokens.next() else { return Err(tokens.ended(format_args!("{what} {}", of_joint()))) };
        if word.is("OFFSET") && !current.has_offset {
            joint.offset = read_offset(tokens, &joint.name)?;
            current.has_offset = true;
        } else if word.is("CHANNELS") && !current.has_channels {
            joint.channels = read_channels(tokens)?;
            current.has_channels = true;
        } else if word.is("JOINT") {
            let parent = current.joint;
            open.push(open_joint(tokens, joints, Some(parent))?);
        } else if word.is("End") {
            let end_site = read_end_site(tokens)?;
            joint.end_sites.push(end_site);
        } else if word.is("}") && current.has_offset {
            open.pop();
        } else if word.is("}") {
            return Err(word.unexpected(format_args!("`OFFSET` {}", of_joint())));
        } else if word.is("OFFSET") || word.is("CHANNELS") {
            return Err(
                word.problem(format_args!("one `{}` {}", word.text().to_ascii_uppercase(), of_joint()), "a second one")
            );
        } else {
            return Err(word.unexpected(format_args!("{what} {}", of_joint())));
        }
    }
    Ok(())
}

/// Reads `[NAME] "{"`.
fn open_joint(tokens: &mut Tokens<'_>, joints: &mut Vec<Joint>, parent: Option<usize>) -> Result<Open, ParseError> {
    let joint = joints.len();
    joints.push(Joint { name: read_name(tokens), parent, ..Joint::default() });
    tokens.keyword("{")?;
    Ok(Open { joint, has_offset: false, has_channels: false })
}

/// Reads `[Site] [NAME] "{" OFFSET N N N "}"`.
fn read_end_site(tokens: &mut Tokens<'_>) -> Result<EndSite, ParseError> {
    if tokens.peek().is_some_and(|word| word.is("Site")) {
        tokens.next();
    }
    let name = read_name(tokens);
    tokens.keyword("{")?;
    tokens.keyword("OFFSET")?;
    let offset = read_offset(tokens, "End Site")?;
    tokens.keyword("}")?;
    Ok(EndSite { name, offset })
}

fn read_offset(tokens: &mut Tokens<'_>, joint: &str) -> Result<[f64; 3], ParseError> {
    let mut component = || tokens.number(format_args!("a number for `OFFSET` of `{joint}`"));
    Ok([component()?, component()?, component()?])
}

/// Reads `COUNT { CHANNEL }`. The count is a claim: the list grows only while channels really follow.
fn read_channels(tokens: &mut Tokens<'_>) -> Result<Vec<Channel>, ParseError> {
    let what = "the number of channels";
    let word = tokens.expect(what)?;
    let count: u64 = word.text().parse().map_err(|_| word.unexpected(what))?;
    let mut channels = Vec::with_capacity(count.min(CHANNEL_WORDS.len() as u64) as usize);
    for _ in 0..count {
        let word = tokens.expect("a channel such as `Xrotation`")?;
        channels.push(channel(&word).ok_or_else(|| word.unexpected("a channel such as `Xrotation`"))?);
    }
    match tokens.peek().filter(|word| channel(word).is_some()) {
        Some(word) => Err(word.unexpected(format_args!("{count} channels, as the line says, and no more"))),
        None => Ok(channels),
    }
}

fn channel(word: &Word<'_>) -> Option<Channel> {
    CHANNEL_WORDS.iter().find(|(known, _)| word.is(known)).map(|(_, channel)| *channel)
}
