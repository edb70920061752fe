//! What a file of markers loses in another format, or at another rate.

use motion_theater_core::formats::c3d::C3d;
use motion_theater_core::markers::{Markers, PointKind};
use motion_theater_core::read::{Clip, Format};

/// The groups of parameters whose meaning goes over: they say what markers, analog signals and events are.
const CARRIED_GROUPS: [&str; 4] = ["POINT", "ANALOG", "TRIAL", "EVENT"];

/// Returns what a file had that is not in what is written of it, a few words each.
pub fn left_out(clip: &Clip, written: &Markers, format: Format) -> Vec<String> {
    let Some(markers) = clip.markers() else { return Vec::new() };
    let is_c3d = format == Format::C3d;
    let others = markers.kinds.iter().filter(|kind| **kind != PointKind::Position).count();
    let channels = markers.analog.channels.len();
    let has_channels = is_c3d && written.analog.channels.len() == channels;
    let counts = [
        (others, is_c3d, ["point that is no position", "points that are no positions"]),
        (markers.events.len(), is_c3d, ["event", "events"]),
        (channels, has_channels, ["analog channel", "analog channels"]),
    ];
    let counts = counts.into_iter().filter(|(count, is_kept, _)| *count > 0 && !is_kept);
    let mut lost: Vec<String> =
        counts.map(|(count, _, [one, many])| format!("{count} {}", if count == 1 { one } else { many })).collect();
    if has_quality(markers) && !(is_c3d && has_quality(written)) {
        lost.push("residuals".to_owned());
    }
    let groups = clip.c3d.as_ref().map(groups_of_its_own).unwrap_or_default();
    if !groups.is_empty() {
        lost.push(format!("parameters of {}", groups.join(", ")));
    }
    lost
}

/// Whether any residual was measured, or any camera named.
fn has_quality(markers: &Markers) -> bool {
    markers.quality.residuals().iter().any(|residual| *residual > 0.0)
        || markers.quality.cameras().iter().any(|cameras| *cameras > 0)
}

fn groups_of_its_own(c3d: &C3d) -> Vec<String> {
    let names = c3d.groups().map(|group| String::from_utf8_lossy(group.name).into_owned());
    names.filter(|name| !CARRIED_GROUPS.iter().any(|known| known.eq_ignore_ascii_case(name))).collect()
}
