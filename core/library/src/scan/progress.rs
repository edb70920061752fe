//! How far a scan is: counters that many threads raise and others look at.

use std::sync::atomic::{AtomicBool, AtomicU64, AtomicU8, Ordering};
use std::sync::{Condvar, Mutex, PoisonError};
use std::time::{Duration, Instant};

/// What a scan is doing.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Phase {
    /// It looks through the folders for files that are new or changed.
    Looking,
    /// It reads them.
    Reading,
    /// It draws previews.
    Drawing,
    /// It has ended.
    Done,
}

impl Phase {
    /// Returns the name of the phase in capitals: `LOOKING`.
    pub fn name(self) -> &'static str {
        match self {
            Self::Looking => "LOOKING",
            Self::Reading => "READING",
            Self::Drawing => "DRAWING",
            Self::Done => "DONE",
        }
    }
}

/// How far a scan is.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Progress {
    /// What it is doing.
    pub phase: Phase,
    /// How many files it has read, ...
    pub done: u64,
    /// ... of how many that are new or changed; it grows while the scan is looking.
    pub total: u64,
    /// The path of the file that was taken up last.
    pub current: String,
    /// How many clips are as they were: these are not opened.
    pub unchanged: u64,
    /// How many clips are new.
    pub new: u64,
    /// How many clips have other contents than before.
    pub changed: u64,
    /// How many clips were found again in another place, or under another name.
    pub moved: u64,
    /// How many clips are gone that were there at the last scan.
    pub missing: u64,
    /// How many of the files that were read are damaged.
    pub broken: u64,
    /// How many previews it has drawn, ...
    pub previews_done: u64,
    /// ... of how many.
    pub previews_total: u64,
    /// Whether the scan has ended: it is through, was cancelled, or has failed.
    pub is_finished: bool,
    /// Why it could not go on; `None` where nothing was wrong.
    pub error: Option<String>,
}

/// The counters of a running scan.
#[derive(Debug)]
pub(super) struct State {
    phase: AtomicU8,
    pub(super) done: AtomicU64,
    pub(super) total: AtomicU64,
    pub(super) unchanged: AtomicU64,
    pub(super) new: AtomicU64,
    pub(super) changed: AtomicU64,
    pub(super) moved: AtomicU64,
    pub(super) missing: AtomicU64,
    pub(super) broken: AtomicU64,
    pub(super) previews_done: AtomicU64,
    pub(super) previews_total: AtomicU64,
    pub(super) is_cancelled: AtomicBool,
    current: Mutex<String>,
    end: Mutex<End>,
    ended: Condvar,
}

/// Whether the scan has ended, and why it could not go on.
#[derive(Debug, Clone, Default)]
struct End {
    has_come: bool,
    error: Option<String>,
}

const PHASES: [Phase; 4] = [Phase::Looking, Phase::Reading, Phase::Drawing, Phase::Done];

impl State {
    pub(super) fn new() -> Self {
        let zero = || AtomicU64::new(0);
        Self {
            phase: AtomicU8::new(0),
            done: zero(),
            total: zero(),
            unchanged: zero(),
            new: zero(),
            changed: zero(),
            moved: zero(),
            missing: zero(),
            broken: zero(),
            previews_done: zero(),
            previews_total: zero(),
            is_cancelled: AtomicBool::new(false),
            current: Mutex::new(String::new()),
            end: Mutex::new(End::default()),
            ended: Condvar::new(),
        }
    }

    pub(super) fn is_cancelled(&self) -> bool {
        self.is_cancelled.load(Ordering::Relaxed)
    }

    pub(super) fn enter(&self, phase: Phase) {
        self.phase.store(phase as u8, Ordering::Relaxed);
    }

    pub(super) fn take_up(&self, path: &std::path::Path) {
        let mut current = self.current.lock().unwrap_or_else(PoisonError::into_inner);
        current.clear();
        current.push_str(&path.to_string_lossy());
    }

    /// Ends the scan; an error says why it could not go on.
    pub(super) fn finish(&self, error: Option<String>) {
        self.enter(Phase::Done);
        *self.end.lock().unwrap_or_else(PoisonError::into_inner) = End { has_come: true, error };
        self.ended.notify_all();
    }

    /// Waits for the end, and returns whether it has come.
    pub(super) fn wait(&self, longest: Option<Duration>) -> bool {
        let mut end = self.end.lock().unwrap_or_else(PoisonError::into_inner);
        let deadline = longest.and_then(|longest| Instant::now().checked_add(longest));
        while !end.has_come {
            let Some(deadline) = deadline else {
                end = self.ended.wait(end).unwrap_or_else(PoisonError::into_inner);
                continue;
            };
            let left = deadline.saturating_duration_since(Instant::now());
            if left.is_zero() {
                return false;
            }
            end = self.ended.wait_timeout(end, left).unwrap_or_else(PoisonError::into_inner).0;
        }
        true
    }

    pub(super) fn progress(&self) -> Progress {
        let count = |counter: &AtomicU64| counter.load(Ordering::Relaxed);
        let end = self.end.lock().unwrap_or_else(PoisonError::into_inner).clone();
        let phase = PHASES.get(usize::from(self.phase.load(Ordering::Relaxed))).copied();
        Progress {
            phase: phase.unwrap_or(Phase::Done),
            done: count(&self.done),
            total: count(&self.total),
            current: self.current.lock().unwrap_or_else(PoisonError::into_inner).clone(),
            unchanged: count(&self.unchanged),
            new: count(&self.new),
            changed: count(&self.changed),
            moved: count(&self.moved),
            missing: count(&self.missing),
            broken: count(&self.broken),
            previews_done: count(&self.previews_done),
            previews_total: count(&self.previews_total),
            is_finished: end.has_come,
            error: end.error,
        }
    }
}

/// Counts one more.
pub(super) fn count(counter: &AtomicU64) {
    counter.fetch_add(1, Ordering::Relaxed);
}
