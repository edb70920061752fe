//! `motion-theater filter`: one file, filtered.

use std::sync::Arc;

use motion_theater_core::combine::{KeySpacing, Span};
use motion_theater_core::filter::{Depth, FilterKind};
use motion_theater_core::sample::Sampling;
use motion_theater_core::stack::{evaluate_on, on_skeleton, Entry, FilterEntry, Source, Track, ASSUMED_RATE_HZ};
use motion_theater_core::value::{Blend, FilterChannels};
use motion_theater_core::{Motion, Skeleton};

use crate::arguments::FilterOptions;
use crate::console::Console;
use crate::load::{Loaded, SkeletonFile};
use crate::write::{moving, output_format};
use crate::{report, Outcome, WrongUse};

/// Runs the command.
pub fn run(options: &FilterOptions, console: &Console) -> Outcome {
    let format = output_format(&options.output)?;
    let depth = Depth::try_from(options.depth).map_err(|error| WrongUse(error.to_string()))?;
    let given = SkeletonFile::read_if_any(options.skeleton.as_deref())?;
    let done = Loaded::read(&options.input, given.as_ref()).and_then(|loaded| {
        let (skeleton, motion) = loaded.moving()?;
        let bones = options.bones.as_deref().map(|names| indices(&loaded, skeleton, names)).transpose()?;
        let filtered = filtered(skeleton, motion, options.kind.into(), depth, bones)
            .map_err(|error| format!("{}: {error}", loaded.path.display()))?;
        let files = moving(&loaded, skeleton, &filtered, format, &options.output)?;
        files.store()?;
        let written: Vec<_> = files.paths().map(|path| path.display().to_string()).collect();
        console.say(&format!("{} -> {}", options.input.display(), written.join(", ")));
        Ok(())
    });
    Ok(report(console, done))
}

fn indices(loaded: &Loaded, skeleton: &Skeleton, names: &[String]) -> Result<Vec<usize>, String> {
    let index = |name: &String| {
        let known = || skeleton.bones.iter().map(|bone| bone.name.as_str()).collect::<Vec<_>>().join(", ");
        let found = skeleton.index_of(name.trim());
        found.ok_or_else(|| format!("{}: there is no bone `{name}`: the bones are {}", loaded.path.display(), known()))
    };
    names.iter().map(index).collect()
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
