//! Scanning folders: what is there, what is new, changed, moved or gone.
//!
//! A walk lists the files and compares them with the library; unchanged ones are not opened. Workers read the others, each
//! once, hash them and tell what is in them. One writer puts that into the database, many files in a transaction and each
//! transaction short, so that others can read and write in between. A scan that is killed leaves a library with some of
//! the files; the next one reads the rest.

mod drawing;
mod plan;
mod progress;
mod reading;
pub(crate) mod sidecars;
mod skeletons;
mod walk;
mod writer;

pub use drawing::Previews;
pub use progress::{Phase, Progress};

use std::panic::{catch_unwind, AssertUnwindSafe};
use std::path::PathBuf;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::mpsc::{sync_channel, Receiver, TryRecvError};
use std::sync::Arc;
use std::time::{Duration, Instant};

use plan::Plan;
use progress::{count, State};
use reading::{Reader, Reading};
use writer::Root;

use crate::catalogue::{as_a_whole, now, paths, Library};
use crate::error::LibraryError;
use crate::index_file;

/// About so many files are written in one transaction at most, ...
const BATCH_FILES: usize = 512;

/// ... and so long the writer waits for more: at first hardly, so that something is to be seen soon, then longer, for every
/// transaction writes much of the indexes anew.
const BATCH_TIMES: std::ops::RangeInclusive<Duration> = Duration::from_millis(10)..=Duration::from_millis(160);

/// So many files that were read may wait for the writer.
const MOST_WAITING: usize = 1024;

/// What a scan is to do.
#[derive(Clone, Default)]
pub struct Options {
    /// Folders of the library, or folders within them; `None` for all of the library's.
    pub folders: Option<Vec<PathBuf>>,
    /// What makes previews once the files are read, which means to read every number of each; `None` for no previews.
    pub previews: Option<Arc<dyn Previews>>,
    /// How many files are read at a time; `None` for one per core.
    pub jobs: Option<usize>,
}

/// A scan that runs in the background.
#[derive(Debug)]
pub struct Scan {
    state: Arc<State>,
}

impl Scan {
    /// Begins a scan, and returns at once.
    ///
    /// # Errors
    /// Where a folder is not in the library, or no thread can be made.
    pub fn start(library: &Arc<Library>, options: &Options) -> Result<Self, LibraryError> {
        let folders = chosen(library, options.folders.as_deref())?;
        let state = Arc::new(State::new());
        let (library, shared, options) = (Arc::clone(library), Arc::clone(&state), options.clone());
        let run = move || {
            // Whatever happens, nobody waits in vain.
            let ended = catch_unwind(AssertUnwindSafe(|| run(&library, &folders, &options, &shared)));
            shared.finish(match ended {
                Ok(ended) => ended.err().map(|error| error.to_string()),
                Err(_) => Some("a mistake in the program ended the scan".to_owned()),
            });
        };
        let thread = std::thread::Builder::new().name("library-scan".to_owned()).spawn(run);
        thread.map_err(|source| LibraryError::Asked(format!("no scan can begin: {source}")))?;
        Ok(Self { state })
    }

    /// Returns how far it is.
    pub fn progress(&self) -> Progress {
        self.state.progress()
    }

    /// Stops the scan as soon as the files that are being read are done. What was read stays in the library.
    pub fn cancel(&self) {
        self.state.is_cancelled.store(true, Ordering::Relaxed);
    }

    /// Waits for the end, at most so long, and returns whether it has come.
    pub fn wait(&self, longest: Option<Duration>) -> bool {
        self.state.wait(longest)
    }
}

/// Returns the folders to walk over: none twice, though one may lie within another.
fn chosen(library: &Library, wanted: Option<&[PathBuf]>) -> Result<Vec<PathBuf>, LibraryError> {
    let known: Vec<PathBuf> = library.folders()?.into_iter().map(|folder| folder.path).collect();
    let mut chosen = Vec::new();
    match wanted {
        None => chosen.clone_from(&known),
        Some(wanted) => {
            for folder in wanted {
                let path = paths::plain(folder).unwrap_or_else(|_| folder.clone());
                if !known.iter().any(|known| path.starts_with(known)) {
                    return Err(LibraryError::Asked(format!("{}: not in the library", path.display())));
                }
                chosen.push(path);
            }
        }
    }
    chosen.sort();
    chosen.dedup_by(|folder, before| folder.starts_with(before));
    Ok(chosen)
}

fn run(library: &Library, folders: &[PathBuf], options: &Options, state: &State) -> Result<(), LibraryError> {
    let started_at = now();
    let mut plan = library.read(|db| plan::make(db, folders, state))?;
    if state.is_cancelled() {
        return Ok(());
    }
    library.write(|db| writer::mark(db, &plan, state))?;
    state.enter(Phase::Reading);
    let jobs = options.jobs.unwrap_or_else(|| std::thread::available_parallelism().map_or(1, usize::from));
    read_all(library, &plan, jobs, state)?;
    sidecars::take_in(library, folders, &plan.sidecars, state)?;
    if state.is_cancelled() {
        return Ok(());
    }
    index_file::apply_all(library, std::mem::take(&mut plan.lists))?;
    library.write(|db| {
        for folder in folders {
            let text = paths::to_text(folder);
            let (from, to) = paths::below(&text);
            let within = "UPDATE folder SET scanned_at = ? WHERE path = ? OR path >= ? AND path < ?";
            db.execute(within, rusqlite::params![started_at, text, from, to])?;
        }
        Ok(())
    })?;
    let Some(previews) = &options.previews else { return Ok(()) };
    state.enter(Phase::Drawing);
    drawing::draw_all(library, folders, previews.as_ref(), jobs, state)
}

/// Reads files with several workers, and writes what they find.
fn read_all(library: &Library, plan: &Plan, jobs: usize, state: &State) -> Result<(), LibraryError> {
    let jobs = jobs.clamp(1, plan.to_read.len().max(1));
    let reader = Reader::new(&plan.skeletons);
    let next = AtomicUsize::new(0);
    let (sender, receiver) = sync_channel(MOST_WAITING);
    let work = |sender: std::sync::mpsc::SyncSender<Reading>| {
        let mut buffer = Arc::default();
        while !state.is_cancelled() {
            let Some(found) = plan.to_read.get(next.fetch_add(1, Ordering::Relaxed)) else { break };
            state.take_up(&found.path);
            let reading = reader.read(found.clone(), &mut buffer);
            count(&state.done);
            // The writer has failed, and says why.
            if sender.send(reading).is_err() {
                break;
            }
        }
    };
    std::thread::scope(|scope| {
        for _ in 0..jobs {
            let (sender, work) = (sender.clone(), &work);
            scope.spawn(move || work(sender));
        }
        drop(sender);
        let written = write_all(library, &receiver, plan, state);
        // Workers that have something to hand over must not wait for a writer that has failed.
        drop(receiver);
        written
    })
}

/// Writes files as they come in, until there are no more.
fn write_all(library: &Library, receiver: &Receiver<Reading>, plan: &Plan, state: &State) -> Result<(), LibraryError> {
    library.without_triggers(|connection| {
        let mut longest = *BATCH_TIMES.start();
        while let Ok(first) = receiver.recv() {
            let batch = batch(first, receiver, longest);
            longest = (2 * longest).min(*BATCH_TIMES.end());
            as_a_whole(connection, |db| {
                // Folders may come and go while a scan runs.
                let mut roots = db.prepare_cached("SELECT id, path FROM folder")?;
                let root = |row: &rusqlite::Row<'_>| {
                    Ok(Root { id: row.get(0)?, path: paths::to_path(&row.get::<_, String>(1)?) })
                };
                let roots = roots.query_map((), root)?.collect::<Result<Vec<_>, _>>()?;
                writer::write_all(db, &roots, plan, &batch, state)
            })?;
        }
        Ok(())
    })
}

/// Collects files until they are enough, there are no more, or so much time has passed.
fn batch(first: Reading, receiver: &Receiver<Reading>, longest: Duration) -> Vec<Reading> {
    let begun = Instant::now();
    let mut batch = vec![first];
    while batch.len() < BATCH_FILES && begun.elapsed() < longest {
        // Meanwhile the workers need not wake anyone for every file.
        std::thread::sleep(*BATCH_TIMES.start());
        loop {
            match receiver.try_recv() {
                Ok(reading) => batch.push(reading),
                Err(TryRecvError::Empty) => break,
                Err(TryRecvError::Disconnected) => return batch,
            }
        }
    }
    batch
}
