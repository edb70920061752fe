//! `motion-theater library`: the catalogue of clips that the add-on uses, from the command line.

mod arguments;
mod export;
mod scan;
mod search;
mod show;
mod sidecar;
mod tag;

pub use arguments::LibraryOptions;

use std::path::PathBuf;
use std::sync::atomic::AtomicBool;
use std::sync::Arc;

use arguments::LibraryCommand;
use motion_theater_library::{Library, LibraryError};

use crate::console::Console;
use crate::{Outcome, Refusal, WrongUse};

/// Where the library is, unless `--library` says it.
const VARIABLE: &str = "MOTION_THEATER_LIBRARY";

/// Runs the command.
pub fn run(options: &LibraryOptions, console: &Console, stop: &AtomicBool) -> Outcome {
    let library = Arc::new(Library::open(&path(options)?).map_err(failed)?);
    match &options.command {
        LibraryCommand::Scan(options) => scan::run(&library, options, console, stop),
        LibraryCommand::Search(options) => search::run(&library, options, console),
        LibraryCommand::Show(options) => show::run(&library, options, console),
        LibraryCommand::Tag(options) => tag::run(&library, options, console),
        LibraryCommand::Sidecar(options) => sidecar::run(&library, options, console),
        LibraryCommand::Export(options) => export::run(&library, options, console),
    }
}

fn path(options: &LibraryOptions) -> Result<PathBuf, WrongUse> {
    let named = options.library.clone();
    let path = named.or_else(|| std::env::var_os(VARIABLE).filter(|path| !path.is_empty()).map(PathBuf::from));
    path.ok_or_else(|| WrongUse(format!("which library? Name its file with --library, or in the variable {VARIABLE}")))
}

/// What ends a command, on one line.
#[allow(clippy::needless_pass_by_value)] // It is what `map_err` hands over.
fn failed(error: LibraryError) -> Refusal {
    Refusal::Failed(error.to_string().replace(['\n', '\r'], " "))
}

/// Returns the number of a clip that was named by its path or its number.
fn find(library: &Library, name: &str) -> Result<Option<i64>, LibraryError> {
    let path = std::path::absolute(name).unwrap_or_else(|_| PathBuf::from(name));
    match (library.find(&path)?, name.parse()) {
        (Some(id), _) => Ok(Some(id)),
        (None, Ok(number)) => Ok(library.clips(&[number])?.first().map(|clip| clip.id)),
        (None, Err(_)) => Ok(None),
    }
}

/// Returns what is said of a clip that the library does not have.
fn unknown(name: &str) -> String {
    format!("{name}: not in the library")
}
