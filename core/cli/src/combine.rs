//! `motion-theater combine`: a stack file, evaluated on its skeleton.

use std::path::Path;
use std::sync::Arc;

use motion_theater_core::error::words;
use motion_theater_core::loaded::{Loaded, SkeletonFile};
use motion_theater_core::recipe::{EntryKind, Recipe, RecipeEntry};
use motion_theater_core::stack::{evaluate_on, on_skeleton, Entry, Source, ASSUMED_RATE_HZ};
use motion_theater_core::{Motion, Skeleton};

use crate::arguments::CombineOptions;
use crate::console::Console;
use crate::load::{load, load_skeleton, moving, skeleton, warning};
use crate::write::{of_motion, output_format};
use crate::{report, Outcome};

/// Runs the command.
pub fn run(options: &CombineOptions, console: &Console) -> Outcome {
    let format = output_format(&options.output)?;
    let combined = combine(&options.stack).and_then(|combined| {
        let Combined { first, skeleton, motion, notices } = combined;
        let files = of_motion(&first, &skeleton, &motion, format, &options.output)?;
        files.store()?;
        let (count, last) = (motion.frame_count, motion.last_frame());
        let verdict = files.verdict(&options.stack);
        console.say(&format!("{verdict}: {count} frames, {} to {last}", motion.first_frame));
        for notice in notices {
            console.say(&format!("  {notice}"));
        }
        Ok(())
    });
    Ok(report(console, combined))
}

/// What a stack comes to.
struct Combined {
    /// The file of the first track.
    first: Loaded,
    skeleton: Skeleton,
    motion: Motion,
    notices: Vec<String>,
}

fn combine(path: &Path) -> Result<Combined, String> {
    let wrong = |text: String| format!("{}: {text}", path.display());
    let bytes = std::fs::read(path).map_err(|error| wrong(words(&error)))?;
    let text =
        String::from_utf8(bytes).map_err(|_| wrong("a stack file is UTF-8 text, and this is none".to_owned()))?;
    let recipe = Recipe::parse(&text, path).map_err(|error| error.to_string())?;
    let folder = path.parent().unwrap_or(Path::new(""));
    let named = Some(&recipe.skeleton).filter(|name| !name.is_empty());
    let named = named.map(|name| load_skeleton(&folder.join(name))).transpose()?;

    let entries: Vec<&RecipeEntry> = recipe.entries.iter().filter(|entry| entry.enabled).collect();
    let mut tracks = Vec::with_capacity(entries.len());
    for entry in &entries {
        tracks.push(match entry.kind {
            EntryKind::Track => Some(load_track(entry, folder, named.as_ref())?),
            EntryKind::Filter => None,
        });
    }
    let Some(first) = tracks.iter().flatten().next() else { return Err(wrong("the stack has no track".to_owned())) };
    let skeleton = named.map_or_else(|| skeleton(first).cloned(), |named| Ok(named.skeleton))?;
    let own_rate = entries.iter().zip(&tracks).find_map(|(entry, track)| rate_of(entry, track.as_ref()?));
    let rate_hz = Some(recipe.rate_hz).filter(|rate| *rate != 0.0).or(own_rate);

    let names: Vec<&str> = skeleton.bones.iter().map(|bone| bone.name.as_str()).collect();
    let evaluated: Vec<Entry> = (entries.iter().zip(&tracks))
        .map(|(entry, track)| {
            let source = track.as_ref().map(|track| source(track, &skeleton)).transpose()?;
            entry.to_entry(&names, source).map_err(|error| wrong(error.to_string()))
        })
        .collect::<Result<_, String>>()?;
    let (mut motion, notices) = evaluate_on(&skeleton, rate_hz.unwrap_or(ASSUMED_RATE_HZ), &evaluated)
        .map_err(|error| wrong(error.to_string()))?;
    if motion.frame_count == 0 {
        return Err(wrong("the result has no frames: no track has data for the bones".to_owned()));
    }
    // Where nobody said a rate, nobody is told one.
    motion.rate_hz = rate_hz;
    let label = |entry: usize| entries.get(entry).map(|entry| entry.label()).unwrap_or_default();
    let warnings =
        tracks.iter().enumerate().filter_map(|(entry, track)| Some((entry, warning(track.as_ref()?)?.into())));
    let notices = warnings.chain(notices.into_iter().map(|notice| (notice.entry, notice.text)));
    let notices = notices.map(|(entry, text): (usize, String)| format!("{}: {text}", label(entry))).collect();
    let first = tracks.into_iter().flatten().next().ok_or_else(|| wrong("the stack has no track".to_owned()))?;
    Ok(Combined { first, skeleton, motion, notices })
}

/// Reads the file of a track. The skeleton of an AMC is the track's own, that of the stack where it fits, or the one beside
/// the file.
fn load_track(entry: &RecipeEntry, folder: &Path, stack: Option<&SkeletonFile>) -> Result<Loaded, String> {
    if entry.source.is_empty() {
        return Err(format!("{}: there is no source", entry.label()));
    }
    let path = folder.join(&entry.source);
    if !entry.skeleton.is_empty() {
        let own = load_skeleton(&folder.join(&entry.skeleton))?;
        return load(&path, Some(&own));
    }
    match stack {
        Some(stack) => load(&path, Some(stack)).or_else(|_| load(&path, None)),
        None => load(&path, None),
    }
}

fn rate_of(entry: &RecipeEntry, track: &Loaded) -> Option<f64> {
    Some(entry.rate_hz).filter(|rate| *rate != 0.0).or(track.clip.rate_hz())
}

fn source(track: &Loaded, skeleton: &Skeleton) -> Result<Arc<Source>, String> {
    let (own, motion) = moving(track)?;
    Ok(Arc::new(Source::new(on_skeleton(skeleton, own, motion))))
}
