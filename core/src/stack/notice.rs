//! What a user should know about an entry, in words.

use super::entry::{Prepared, PreparedTrack, ASSUMED_RATE_HZ};
use super::rig::Rig;
use crate::combine::{Border, Borders, Depth};

/// How many names a sentence lists before it counts.
const NAMES_LISTED: usize = 4;

/// A sentence about one entry.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Notice {
    /// Index of the entry.
    pub entry: usize,
    /// The sentence, without a full stop.
    pub text: String,
}

/// What happened to one bone.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Event {
    NoData,
    Laid,
    RootAligned,
    Filtered,
    DepthReduced { border: f64, asked: u32, depth: Depth },
}

impl Event {
    /// Returns the borders at which the blend could not reach as far as asked.
    pub fn of_borders(borders: Borders, asked: Option<u32>) -> Vec<Self> {
        let Some(asked) = asked else { return Vec::new() };
        let reduced = |border: Border| {
            let depth = border.depth?;
            let full = i64::from(asked);
            (depth.before < full || depth.after < full).then_some(Self::DepthReduced {
                border: border.frame,
                asked,
                depth,
            })
        };
        [borders.start, borders.end].into_iter().flatten().filter_map(reduced).collect()
    }
}

/// Turns what happened to single bones into sentences about entries.
///
/// `events` has one list per bone: which entry, and what.
pub(super) fn collect(rig: &Rig, entries: &[Prepared<'_>], events: &[Vec<(usize, Event)>]) -> Vec<Notice> {
    let mut notices = Vec::new();
    for (number, entry) in entries.iter().enumerate() {
        let events: Vec<(usize, Event)> = (events.iter().enumerate())
            .flat_map(|(bone, events)| events.iter().map(move |&(entry, event)| (entry, bone, event)))
            .filter(|&(entry, ..)| entry == number)
            .map(|(_, bone, event)| (bone, event))
            .collect();
        let texts = match entry {
            Prepared::Track(track) => of_track(rig, track, &events),
            Prepared::Filter(_) if events.is_empty() => {
                vec!["There is nothing to filter: the bones have no keys".into()]
            }
            Prepared::Filter(_) => Vec::new(),
        };
        notices.extend(texts.into_iter().map(|text| Notice { entry: number, text }));
    }
    notices
}

fn of_track(rig: &Rig, track: &PreparedTrack<'_>, events: &[(usize, Event)]) -> Vec<String> {
    let mut texts = Vec::new();
    if track.rate_is_assumed {
        texts.push(format!("The clip does not say its rate: {ASSUMED_RATE_HZ} Hz assumed"));
    }
    if track.samples_too_close {
        texts.push("Samples lie too close for keys of their own: keys stand on whole frames".into());
    }
    if track.track.preserve.is_some() {
        if track.track.blend_depth.is_some() {
            texts.push("Blending is off because the old position and rotation are preserved".into());
        }
        if !events.iter().any(|(_, event)| *event == Event::RootAligned) {
            texts.push("Preserving has no effect: the track does not move the root".into());
        }
    }
    texts.extend(depth_notices(rig, events));
    let without: Vec<&str> = named(rig, events, |event| event == Event::NoData);
    if track.track.bones.is_some() && !events.iter().any(|(_, event)| *event == Event::Laid) {
        texts.push(format!("The clip has no data for {}", list(&without)));
    }
    texts
}

/// One sentence per border and depth, with the bones where it is not the same for all.
fn depth_notices(rig: &Rig, events: &[(usize, Event)]) -> Vec<String> {
    let mut seen: Vec<Event> = Vec::new();
    for &(_, event) in events {
        if matches!(event, Event::DepthReduced { .. }) && !seen.contains(&event) {
            seen.push(event);
        }
    }
    let sentence = |event: &Event| {
        let Event::DepthReduced { border, asked, depth } = *event else { return None };
        let short = [(depth.before, "before"), (depth.after, "after")].into_iter();
        let short = short.filter(|&(reach, _)| reach < i64::from(asked));
        let reach: Vec<_> = short.map(|(reach, side)| format!("{} {side}", reach.max(0))).collect();
        let text = format!("Blend depth {asked} reduced to {} frame {border}", reach.join(" and "));
        // One sentence per border speaks for itself; several say whom they mean.
        let bones = || list(&named(rig, events, |other| other == *event));
        Some(if seen.len() > 2 { format!("{text} for {}", bones()) } else { text })
    };
    seen.iter().filter_map(sentence).collect()
}

fn named<'a>(rig: &'a Rig, events: &[(usize, Event)], is_meant: impl Fn(Event) -> bool) -> Vec<&'a str> {
    events.iter().filter(|(_, event)| is_meant(*event)).map(|&(bone, _)| rig.bones[bone].name.as_str()).collect()
}

fn list(names: &[&str]) -> String {
    match names.len().checked_sub(NAMES_LISTED) {
        Some(more) if more > 0 => format!("{} and {more} more", names[..NAMES_LISTED].join(", ")),
        _ => names.join(", "),
    }
}
