//! `motion-theater info`: what is in files.

use std::ops::ControlFlow;
use std::path::{Path, PathBuf};
use std::sync::atomic::AtomicBool;

use motion_theater_core::infer::tallness;
use motion_theater_core::loaded::{Loaded, Pairing};
use motion_theater_core::markers::Event;
use motion_theater_core::upright::axis_name;
use serde::Serialize;

use crate::arguments::InfoOptions;
use crate::console::Console;
use crate::folder::{look, Found};
use crate::load::{load, named_skeleton};
use crate::{in_order, Failures, Outcome};

/// What is in one file; the fields of the JSON object. What a file does not have, or could not be read, is null.
#[derive(Debug, Default, Serialize)]
struct Info {
    path: String,
    format: Option<&'static str>,
    frames: Option<usize>,
    first_frame: Option<i64>,
    rate_hz: Option<f64>,
    /// How long all frames last: `frames / rate_hz`.
    duration_s: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    joints: Option<Vec<String>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    markers: Option<Vec<String>>,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    analog: Vec<String>,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    events: Vec<Happening>,
    unit_m: Option<f64>,
    up: Option<&'static str>,
    height_m: Option<f64>,
    skeleton: Option<String>,
    notices: Vec<String>,
    error: Option<String>,
}

/// Something that happened at a moment.
#[derive(Debug, Serialize)]
struct Happening {
    label: String,
    context: String,
    time_s: f64,
}

impl Happening {
    fn of(event: &Event) -> Self {
        Self { label: event.label.clone(), context: event.context.clone(), time_s: event.time_s }
    }
}

/// Runs the command.
pub fn run(options: &InfoOptions, console: &Console, stop: &AtomicBool) -> Outcome {
    let named = named_skeleton(options.skeleton.as_deref())?;
    let mut failures = Failures::default();
    let mut files: Vec<Result<PathBuf, (PathBuf, String)>> = Vec::new();
    for path in &options.files {
        match look(path, None) {
            Ok(Found::File(path)) => files.push(Ok(path)),
            Ok(Found::Folder(found)) if found.is_empty() => {
                files.push(Err((path.clone(), format!("{}: no motion file is in it", path.display()))));
            }
            Ok(Found::Folder(found)) => files.extend(found.into_iter().map(|(path, _)| Ok(path))),
            Err(text) => files.push(Err((path.clone(), text))),
        }
    }
    let work = |file: &Result<PathBuf, (PathBuf, String)>| match file {
        Ok(path) => match load(path, named.as_ref()) {
            Ok(loaded) => Info::of(loaded),
            Err(text) => Info::failed(path, text),
        },
        Err((path, text)) => Info::failed(path, text.clone()),
    };
    in_order::for_each(&files, options.workers.jobs, stop, work, |info| {
        failures.0 |= info.error.is_some();
        let is_read = if options.json {
            console.say(&serde_json::to_string(&info).unwrap_or_default())
        } else if let Some(text) = &info.error {
            console.warn(text);
            true
        } else {
            console.say(&info.to_string())
        };
        if is_read {
            ControlFlow::Continue(())
        } else {
            ControlFlow::Break(())
        }
    });
    Ok(failures)
}

impl Info {
    fn of(loaded: Loaded) -> Self {
        let skeleton = loaded.skeleton.as_ref();
        let (frames, rate_hz) = (loaded.frame_count(), loaded.rate_hz());
        let markers = loaded.clip.markers();
        Self {
            path: loaded.path.display().to_string(),
            format: Some(loaded.clip.format.extension()),
            frames: Some(frames),
            first_frame: (frames > 0).then(|| loaded.clip.first_frame()),
            rate_hz,
            duration_s: rate_hz.map(|rate| frames as f64 / rate),
            joints: markers.is_none().then(|| loaded.names()),
            markers: markers.map(|markers| markers.names.clone()),
            analog: markers.map_or_else(Vec::new, |markers| {
                markers.analog.channels.iter().map(|channel| channel.name.clone()).collect()
            }),
            events: markers.map_or_else(Vec::new, |markers| markers.events.iter().map(Happening::of).collect()),
            unit_m: skeleton.map(|skeleton| skeleton.unit.metres).or(markers.map(|markers| markers.unit.metres)),
            up: skeleton.map(|skeleton| skeleton.up).or(markers.map(|markers| markers.up.axis)).map(axis_name),
            height_m: skeleton.map(|skeleton| tallness(skeleton) * skeleton.unit.metres),
            skeleton: loaded.pairing.as_ref().and_then(Pairing::path).map(|path| path.display().to_string()),
            notices: loaded.notices.into_iter().chain(loaded.clip.facing_notice()).collect(),
            error: None,
        }
    }

    fn failed(path: &Path, error: String) -> Self {
        Self { path: path.display().to_string(), error: Some(error), ..Self::default() }
    }
}

impl std::fmt::Display for Info {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{}: {}", self.path, self.format.unwrap_or_default().to_uppercase())?;
        if let (Some(frames), Some(rate), Some(duration)) = (self.frames, self.rate_hz, self.duration_s) {
            write!(f, ", {frames} frames at {} Hz, {duration:.2} s", short(rate))?;
        }
        for (what, names) in [("joints", &self.joints), ("markers", &self.markers)] {
            if let Some(names) = names {
                write!(f, ", {} {what}", names.len())?;
            }
        }
        for (what, count) in [("analog channels", self.analog.len()), ("events", self.events.len())] {
            if count > 0 {
                write!(f, ", {count} {what}")?;
            }
        }
        if let (Some(unit), Some(up)) = (self.unit_m, self.up) {
            write!(f, ", unit {} m, {up} up", short(unit))?;
        }
        self.notices.iter().try_for_each(|notice| write!(f, "\n  {notice}"))
    }
}

/// A number in a few digits.
fn short(value: f64) -> String {
    let text = format!("{value:.6}");
    text.trim_end_matches('0').trim_end_matches('.').to_owned()
}
