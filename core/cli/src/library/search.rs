//! `motion-theater library search`.

use std::fmt::Write as _;

use motion_theater_library::catalogue::ClipRow;
use motion_theater_library::query::{Order, Query};
use motion_theater_library::Library;

use super::arguments::SearchOptions;
use super::failed;
use crate::console::Console;
use crate::{Failures, Outcome, WrongUse};

/// So many clips are in memory at a time.
const PAGE: usize = 512;

/// Runs the command.
pub fn run(library: &Library, options: &SearchOptions, console: &Console) -> Outcome {
    let query = Query::parse(&options.query.join(" ")).map_err(|error| WrongUse(error.to_string()))?;
    let order = Order { sort: options.sort, is_descending: options.descending };
    let mut found = library.search(&query, order).map_err(failed)?;
    found.truncate(options.limit.unwrap_or(usize::MAX));
    for page in found.chunks(PAGE) {
        for clip in library.clips(page).map_err(failed)? {
            let line = if options.json { serde_json::to_string(&clip).unwrap_or_default() } else { line(&clip) };
            if !console.say(&line) {
                return Ok(Failures(false));
            }
        }
    }
    Ok(Failures(false))
}

/// A clip on one line: its path, and what is most told of it.
fn line(clip: &ClipRow) -> String {
    let mut line = format!("{}: {}", clip.path.display(), clip.format.to_uppercase());
    if let (Some(frames), Some(seconds)) = (clip.frames, clip.duration_s) {
        let _ = write!(line, ", {frames} frames, {seconds:.2} s");
    }
    for text in [&clip.description, &clip.error].into_iter().flatten() {
        let _ = write!(line, ", {}", text.replace(['\n', '\r'], " "));
    }
    if clip.is_missing {
        line += ", missing";
    }
    line
}
