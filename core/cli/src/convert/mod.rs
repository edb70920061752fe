//! `motion-theater convert`: files and folders into another format.

mod plan;

use std::ops::ControlFlow;
use std::path::Path;
use std::sync::atomic::AtomicBool;
use std::time::SystemTime;

use motion_theater_core::loaded::{Pairing, SkeletonFile};
use plan::{plan, Job};

use crate::arguments::ConvertOptions;
use crate::console::Console;
use crate::load::{load, named_skeleton};
use crate::write::converted;
use crate::{in_order, Failures, Outcome};

/// What came of one file.
enum Verdict {
    Converted(String),
    Skipped(String),
    Failed(String),
}

/// Runs the command.
pub fn run(options: &ConvertOptions, console: &Console, stop: &AtomicBool) -> Outcome {
    let jobs = plan(options)?;
    let skeleton = named_skeleton(options.skeleton.as_deref())?;
    let (mut converted, mut skipped, mut failed) = (0, 0, 0);
    let work = |job: &Result<Job, String>| match job {
        Ok(job) => convert(job, options, skeleton.as_ref()).unwrap_or_else(Verdict::Failed),
        Err(text) => Verdict::Failed(text.clone()),
    };
    in_order::for_each(&jobs, options.workers.jobs, stop, work, |verdict| {
        // Who does not read the verdicts may want the files all the same.
        match verdict {
            Verdict::Converted(text) => {
                converted += 1;
                console.say(&text);
            }
            Verdict::Skipped(text) => {
                skipped += 1;
                console.say(&text);
            }
            Verdict::Failed(text) => {
                failed += 1;
                console.warn(&text);
            }
        }
        ControlFlow::Continue(())
    });
    if jobs.len() > 1 {
        let left = jobs.len() - converted - skipped - failed;
        let left = if left > 0 { format!(", {left} not begun") } else { String::new() };
        console.say(&format!("{converted} converted, {skipped} skipped, {failed} failed{left}"));
    }
    Ok(Failures(failed > 0))
}

fn convert(job: &Job, options: &ConvertOptions, skeleton: Option<&SkeletonFile>) -> Result<Verdict, String> {
    let Job { input, output, format } = job;
    let inputs = [Some(input.as_path()), options.skeleton.as_deref()];
    if !options.force && is_up_to_date(output, inputs.into_iter().flatten()) {
        let text = format!("{}: skipped, {} is newer (--force writes it anew)", input.display(), output.display());
        return Ok(Verdict::Skipped(text));
    }
    let loaded = load(input, skeleton)?;
    let files = converted(&loaded, *format, options.rate, output)?;
    let read = [Some(input.as_path()), loaded.pairing.as_ref().and_then(Pairing::path)];
    if let Some(path) = files.paths().find(|path| read.into_iter().flatten().any(|input| is_same(path, input))) {
        return Err(format!("{}: not written, for {} is read for it", input.display(), path.display()));
    }
    files.store()?;
    Ok(Verdict::Converted(files.verdict(input)))
}

/// Whether an output is there and not older than what it is made from. Outputs are never there in part.
fn is_up_to_date<'a>(output: &Path, mut inputs: impl Iterator<Item = &'a Path>) -> bool {
    let changed = |path: &Path| -> Option<SystemTime> { path.metadata().ok()?.modified().ok() };
    let Some(written) = changed(output) else { return false };
    inputs.all(|input| changed(input).is_some_and(|input| input <= written) && !is_same(input, output))
}

fn is_same(a: &Path, b: &Path) -> bool {
    a == b || a.canonicalize().is_ok_and(|a| b.canonicalize().is_ok_and(|b| a == b))
}
