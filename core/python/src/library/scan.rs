//! `motion_theater.Scan` and `ScanProgress`.

use std::path::PathBuf;
use std::sync::Arc;
use std::time::Duration;

use motion_theater_library::scan::{Options, Previews, Progress, Scan};
use motion_theater_library::{Library, LibraryError};
use pyo3::prelude::*;

/// Never waits longer than this without asking Python whether Ctrl+C was pressed.
const SIGNAL_CHECK: Duration = Duration::from_millis(100);

/// A scan that runs in the background.
#[pyclass(name = "Scan", module = "motion_theater", frozen)]
pub struct PyScan(Scan);

/// How far a scan is.
#[pyclass(name = "ScanProgress", module = "motion_theater", frozen, get_all)]
pub struct PyScanProgress {
    phase: &'static str,
    done: u64,
    total: u64,
    current: String,
    unchanged: u64,
    new: u64,
    changed: u64,
    moved: u64,
    missing: u64,
    broken: u64,
    previews_done: u64,
    previews_total: u64,
    is_finished: bool,
    error: Option<String>,
}

/// Begins a scan.
pub fn start(
    library: &Arc<Library>,
    folders: Option<Vec<PathBuf>>,
    with_previews: bool,
    jobs: Option<usize>,
) -> Result<PyScan, LibraryError> {
    let previews = with_previews.then(|| library.previews()).transpose()?;
    let previews = previews.map(|cache| Arc::clone(cache) as Arc<dyn Previews>);
    Scan::start(library, &Options { folders, previews, jobs }).map(PyScan)
}

#[pymethods]
impl PyScan {
    fn progress(&self) -> PyScanProgress {
        self.0.progress().into()
    }

    fn cancel(&self) {
        self.0.cancel();
    }

    #[pyo3(signature = (timeout_s=None))]
    fn wait(&self, py: Python<'_>, timeout_s: Option<f64>) -> PyResult<bool> {
        // What is no number of seconds, or a very large one, is for ever.
        let mut left = timeout_s.map(|seconds| Duration::try_from_secs_f64(seconds.max(0.0)).unwrap_or(Duration::MAX));
        loop {
            let slice = left.map_or(SIGNAL_CHECK, |left| left.min(SIGNAL_CHECK));
            if py.detach(|| self.0.wait(Some(slice))) {
                return Ok(true);
            }
            py.check_signals()?;
            left = left.map(|left| left.saturating_sub(slice));
            if left.is_some_and(|left| left.is_zero()) {
                return Ok(false);
            }
        }
    }
}

impl From<Progress> for PyScanProgress {
    fn from(progress: Progress) -> Self {
        Self {
            phase: progress.phase.name(),
            done: progress.done,
            total: progress.total,
            current: progress.current,
            unchanged: progress.unchanged,
            new: progress.new,
            changed: progress.changed,
            moved: progress.moved,
            missing: progress.missing,
            broken: progress.broken,
            previews_done: progress.previews_done,
            previews_total: progress.previews_total,
            is_finished: progress.is_finished,
            error: progress.error,
        }
    }
}
