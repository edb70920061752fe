//! The program `motion-theater`: what is in motion capture files, other formats, poses, filters and stacks, from a
//! command line.
//!
//! [`run`] takes arguments and says how it went:
//!
//! | exit code | meaning |
//! |---|---|
//! | 0 | all good |
//! | 1 | some file failed, which its line on the error stream says |
//! | 2 | wrong use |
//!
//! Everything about motion is in the core; here arguments become calls and results become text.

mod arguments;
mod combine;
mod console;
mod convert;
mod filter;
mod folder;
mod in_order;
mod info;
mod joints_as_markers;
mod left_out;
mod library;
mod load;
mod points;
mod pose;
mod store;
mod write;

use std::ffi::OsString;
use std::sync::atomic::AtomicBool;

use clap::Parser;

use arguments::{Arguments, Command};
pub use console::Console;

/// All good.
pub const SUCCESS: u8 = 0;
/// Some file failed.
pub const FAILURE: u8 = 1;
/// The arguments make no sense.
pub const WRONG_USE: u8 = 2;

/// Arguments that make no sense together, and why.
#[derive(Debug)]
struct WrongUse(String);

/// Why a command ended before its first file.
#[derive(Debug)]
enum Refusal {
    WrongUse(WrongUse),
    /// A file that all others need cannot be read.
    Failed(String),
}

impl From<WrongUse> for Refusal {
    fn from(wrong: WrongUse) -> Self {
        Self::WrongUse(wrong)
    }
}

/// How a command ended.
type Outcome = Result<Failures, Refusal>;

/// Whether some file failed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
struct Failures(bool);

/// Runs the program; `arguments` begin with its name. Where `stop` becomes true, no further file is begun.
pub fn run(arguments: impl IntoIterator<Item = OsString>, console: &Console, stop: &AtomicBool) -> u8 {
    let arguments = match Arguments::try_parse_from(arguments) {
        Ok(arguments) => arguments,
        Err(message) => {
            let text = message.to_string();
            let text = text.trim_end();
            if message.use_stderr() {
                console.warn(text);
                return WRONG_USE;
            }
            console.say(text);
            return SUCCESS;
        }
    };
    let outcome = match &arguments.command {
        Command::Info(options) => info::run(options, console, stop),
        Command::Convert(options) => convert::run(options, console, stop),
        Command::Pose(options) => pose::run(options, console),
        Command::Filter(options) => filter::run(options, console),
        Command::Combine(options) => combine::run(options, console),
        Command::Library(options) => library::run(options, console, stop),
    };
    match outcome {
        Ok(Failures(false)) => SUCCESS,
        Ok(Failures(true)) => FAILURE,
        Err(Refusal::Failed(text)) => {
            console.warn(&text);
            FAILURE
        }
        Err(Refusal::WrongUse(WrongUse(text))) => {
            console.warn(&format!("error: {text}"));
            WRONG_USE
        }
    }
}

/// Reports what came of a single file: its error on one line.
fn report(console: &Console, result: Result<(), String>) -> Failures {
    match result {
        Ok(()) => Failures(false),
        Err(text) => {
            console.warn(&text);
            Failures(true)
        }
    }
}
