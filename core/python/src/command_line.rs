//! `motion_theater.main`: the program `motion-theater`, as Python starts it.

use std::ffi::OsString;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{channel, RecvTimeoutError};
use std::thread;
use std::time::Duration;

use motion_theater_cli::{run, Console, FAILURE};
use pyo3::prelude::*;

/// How often Python is asked whether Ctrl+C was pressed.
const SIGNAL_CHECK: Duration = Duration::from_millis(50);

/// What shells expect of a program that was interrupted.
const INTERRUPTED: u8 = 130;

/// The program `motion-theater`: takes `sys.argv`, prints, returns the exit code.
///
/// The work is done beside Python's main thread, which alone hears of Ctrl+C: then no further file is begun, those that
/// are being written are finished, and a second Ctrl+C ends the process at once.
#[pyfunction]
pub fn main(py: Python<'_>) -> PyResult<u8> {
    let given: Vec<OsString> = py.import("sys")?.getattr("argv")?.extract()?;
    let arguments = [OsString::from("motion-theater")].into_iter().chain(given.into_iter().skip(1));
    py.detach(|| supervised(arguments))
}

fn supervised(arguments: impl Iterator<Item = OsString> + Send) -> PyResult<u8> {
    let console = Console::new(std::io::stdout(), std::io::stderr());
    let stop = AtomicBool::new(false);
    let mut is_interrupted = false;
    thread::scope(|scope| {
        let (sender, receiver) = channel();
        let (console, stop) = (&console, &stop);
        // Nobody listens any more only where the main thread failed, and that error is told.
        scope.spawn(move || sender.send(run(arguments, console, stop)));
        loop {
            match receiver.recv_timeout(SIGNAL_CHECK) {
                Ok(_) if is_interrupted => return Ok(INTERRUPTED),
                Ok(code) => return Ok(code),
                Err(RecvTimeoutError::Disconnected) => return Ok(FAILURE),
                Err(RecvTimeoutError::Timeout) if is_interrupted => {}
                Err(RecvTimeoutError::Timeout) => {
                    is_interrupted = Python::attach(interrupted)?;
                    stop.store(is_interrupted, Ordering::Relaxed);
                }
            }
        }
    })
}

/// Returns whether Ctrl+C was pressed, and lets the next one end the process.
fn interrupted(py: Python<'_>) -> PyResult<bool> {
    if py.check_signals().is_ok() {
        return Ok(false);
    }
    let signal = py.import("signal")?;
    signal.call_method1("signal", (signal.getattr("SIGINT")?, signal.getattr("SIG_DFL")?))?;
    Ok(true)
}
