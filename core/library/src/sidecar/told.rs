//! What a sidecar tells the catalogue.

use motion_theater_core::sidecar::{cleaned, day, Field, Segment, Sidecar};

/// Returns what a sidecar says of its clip, by the names of the catalogue's columns: `subject`, `recorded_on` (an ISO date),
/// `session_group`, `description`, `cleaned` (`1` or `0`). What is empty, or means nothing there, is left out: the sidecar
/// keeps it.
pub fn told(sidecar: &Sidecar) -> Vec<(&'static str, String)> {
    let text = |field| sidecar.get(field).filter(|value| !value.is_empty()).map(str::to_owned);
    let is_cleaned = text(Field::Cleaned).and_then(|word| cleaned(&word).ok().flatten());
    let all = [
        ("subject", text(Field::Subject)),
        ("recorded_on", text(Field::Date).and_then(|date| day(&date))),
        ("session_group", text(Field::Group)),
        ("description", text(Field::Comment)),
        ("cleaned", is_cleaned.map(|yes| String::from(if yes { "1" } else { "0" }))),
    ];
    all.into_iter().filter_map(|(name, value)| Some((name, value?))).collect()
}

/// Returns usable segments as a sidecar has them: `20-180, 200-316 (walks on)`.
pub fn segments_text(segments: &[Segment]) -> String {
    let one = |segment: &Segment| {
        // What separates two segments cannot be part of one.
        let note = segment.note.replace([',', ';', '\n', '\r'], " ");
        let note = if note.trim().is_empty() { String::new() } else { format!(" ({})", note.trim()) };
        // Between numbers below zero, a hyphen would be hard to read.
        let between = if segment.first_frame < 0 { " to " } else { "-" };
        format!("{}{between}{}{note}", segment.first_frame, segment.last_frame)
    };
    segments.iter().map(one).collect::<Vec<_>>().join(", ")
}
