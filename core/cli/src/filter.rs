//! `motion-theater filter`: one file, filtered.

use std::sync::Arc;

use motion_theater_core::combine::{KeySpacing, Span};
use motion_theater_core::filter::{Depth, FilterKind};
use motion_theater_core::loaded::Loaded;
use motion_theater_core::read::Format;
use motion_theater_core::sample::Sampling;
use motion_theater_core::stack::{evaluate_on, on_skeleton, Entry, FilterEntry, Source, Track, ASSUMED_RATE_HZ};
use motion_theater_core::value::{Blend, FilterChannels};
use motion_theater_core::{Markers, Motion, Skeleton};

use crate::arguments::FilterOptions;
use crate::console::Console;
use crate::load::{load, moving, named_skeleton};
use crate::write::{of_markers, of_motion, output_format, Files};
use crate::{report, Outcome, WrongUse};

/// Runs the command.
pub fn run(options: &FilterOptions, console: &Console) -> Outcome {
    let format = output_format(&options.output)?;
    let depth = Depth::try_from(options.depth).map_err(|error| WrongUse(error.to_string()))?;
    let given = named_skeleton(options.skeleton.as_deref())?;
    let done = load(&options.input, given.as_ref()).and_then(|loaded| {
        let files = filter(&loaded, options, depth, format)?;
        files.store()?;
        console.say(&files.verdict(&options.input));
        Ok(())
    });
    Ok(report(console, done))
}

fn filter(loaded: &Loaded, options: &FilterOptions, depth: Depth, format: Format) -> Result<Files, String> {
    let kind = options.kind.into();
    if let Some(markers) = loaded.clip.markers() {
        let chosen = chosen(loaded, "marker", markers.names.iter().map(String::as_str), options)?;
        let mut filtered = Markers::clone(markers);
        filtered.filter(&chosen.unwrap_or_else(|| (0..markers.count()).collect()), kind, depth);
        return of_markers(loaded, &filtered, format, &options.output);
    }
    let (skeleton, motion) = moving(loaded)?;
    let chosen = chosen(loaded, "bone", skeleton.bones.iter().map(|bone| bone.name.as_str()), options)?;
    let filtered = filtered(skeleton, motion, kind, depth, chosen)
        .map_err(|error| format!("{}: {error}", loaded.path.display()))?;
    Ok(of_motion(loaded, skeleton, &filtered, format, &options.output)?.warning_of(loaded))
}

/// Returns which bones or markers are meant; `None` for all.
fn chosen<'a>(
    loaded: &Loaded,
    what: &str,
    known: impl Iterator<Item = &'a str>,
    options: &FilterOptions,
) -> Result<Option<Vec<usize>>, String> {
    let known: Vec<&str> = known.collect();
    let index = |name: &String| {
        let wrong = || format!("{}: there is no {what} `{name}`: they are {}", loaded.path.display(), known.join(", "));
        known.iter().position(|known| *known == name.trim()).ok_or_else(wrong)
    };
    options.bones.as_ref().map(|names| names.iter().map(index).collect()).transpose()
}

/// The file as a track of its own rate, and the filter over it: bones that are not meant keep every value.
fn filtered(
    skeleton: &Skeleton,
    motion: &Motion,
    kind: FilterKind,
    depth: Depth,
    bones: Option<Vec<usize>>,
) -> Result<Motion, motion_theater_core::ParameterError> {
    let track = Track {
        source: Arc::new(Source::new(on_skeleton(skeleton, skeleton, motion))),
        label: "the file".to_owned(),
        bones: None,
        cut: Span::default(),
        scale: Span::default(),
        blend_depth: None,
        preserve: None,
        discard: false,
        blend: Blend::default(),
        sampling: Sampling::default(),
        spacing: KeySpacing::default(),
        rate_hz: None,
    };
    let filter = FilterEntry { label: "the filter".to_owned(), bones, kind, depth, channels: FilterChannels::Rotation };
    let rate_hz = motion.rate_hz.unwrap_or(ASSUMED_RATE_HZ);
    let (mut filtered, _) = evaluate_on(skeleton, rate_hz, &[Entry::Track(track), Entry::Filter(filter)])?;
    filtered.rate_hz = motion.rate_hz;
    Ok(filtered)
}
