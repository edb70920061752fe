//! `motion-theater library scan`.

use std::path::PathBuf;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::Arc;
use std::time::Duration;

use motion_theater_library::query::{Order, Query};
use motion_theater_library::scan::{Options, Previews, Progress, Scan};
use motion_theater_library::{Library, LibraryError};
use serde_json::json;

use super::arguments::ScanOptions;
use super::failed;
use crate::console::Console;
use crate::{Failures, Outcome, Refusal};

/// How often Ctrl+C is looked for.
const GLANCE: Duration = Duration::from_millis(50);

/// Runs the command.
pub fn run(library: &Arc<Library>, options: &ScanOptions, console: &Console, stop: &AtomicBool) -> Outcome {
    let folders = add(library, &options.folders).map_err(failed)?;
    let jobs = options.workers.jobs.map(usize::from);
    let previews = (!options.no_previews).then(|| library.previews()).transpose().map_err(failed)?;
    let previews = previews.map(|cache| Arc::clone(cache) as Arc<dyn Previews>);
    let scan = Scan::start(library, &Options { folders, previews, jobs }).map_err(failed)?;
    while !scan.wait(Some(GLANCE)) {
        if stop.load(Ordering::Relaxed) {
            scan.cancel();
        }
    }
    let progress = scan.progress();
    if let Some(error) = progress.error {
        return Err(Refusal::Failed(error));
    }
    for line in broken(library).map_err(failed)? {
        console.warn(&line);
    }
    console.say(&if options.json { as_json(&progress).to_string() } else { as_text(&progress) });
    Ok(Failures(progress.broken > 0))
}

/// Adds folders that are not in the library yet, and returns them; `None` for all of the library's.
fn add(library: &Library, folders: &[PathBuf]) -> Result<Option<Vec<PathBuf>>, LibraryError> {
    let known = library.folders()?;
    let mut added = Vec::new();
    for folder in folders {
        let path = std::path::absolute(folder).unwrap_or_else(|_| folder.clone());
        let is_within = known.iter().any(|known| path.starts_with(&known.path));
        added.push(if is_within { path } else { library.add_folder(folder)? });
    }
    Ok((!folders.is_empty()).then_some(added))
}

/// Returns a line for each clip that cannot be read.
fn broken(library: &Library) -> Result<Vec<String>, LibraryError> {
    let query = Query::parse("broken:yes").map_err(|error| LibraryError::Asked(error.to_string()))?;
    let clips = library.clips(&library.search(&query, Order::default())?)?;
    let line = |path: &std::path::Path, error: &str| format!("{}: {error}", path.display()).replace(['\n', '\r'], " ");
    Ok(clips.iter().filter_map(|clip| Some(line(&clip.path, clip.error.as_deref()?))).collect())
}

fn as_text(progress: &Progress) -> String {
    let Progress { new, changed, moved, missing, unchanged, broken, .. } = progress;
    format!(
        "{new} new, {changed} changed, {moved} moved, {missing} missing, {unchanged} as they were; \
         {broken} of those that were read cannot be used"
    )
}

fn as_json(progress: &Progress) -> serde_json::Value {
    json!({
        "read": progress.done,
        "new": progress.new,
        "changed": progress.changed,
        "moved": progress.moved,
        "missing": progress.missing,
        "unchanged": progress.unchanged,
        "broken": progress.broken,
        "previews": progress.previews_done,
    })
}
