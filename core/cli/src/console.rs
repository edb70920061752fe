//! Where text goes. A reader that has gone away (`motion-theater info ... | head`) is no error.

use std::io::Write;
use std::sync::{Mutex, PoisonError};

/// The two streams of a program.
pub struct Console {
    out: Mutex<Stream>,
    err: Mutex<Stream>,
}

struct Stream {
    writer: Box<dyn Write + Send>,
    is_open: bool,
}

impl Console {
    /// Takes what stands for standard output and standard error.
    pub fn new(out: impl Write + Send + 'static, err: impl Write + Send + 'static) -> Self {
        let stream = |writer| Mutex::new(Stream { writer, is_open: true });
        Self { out: stream(Box::new(out)), err: stream(Box::new(err)) }
    }

    /// Writes a line of output; false where nobody reads any more.
    pub(crate) fn say(&self, text: &str) -> bool {
        write(&self.out, text)
    }

    /// Writes a line to the error stream.
    pub(crate) fn warn(&self, text: &str) {
        write(&self.err, text);
    }
}

fn write(stream: &Mutex<Stream>, text: &str) -> bool {
    // A stream has no state that a panic elsewhere could leave half-changed.
    let mut stream = stream.lock().unwrap_or_else(PoisonError::into_inner);
    if stream.is_open {
        let written = writeln!(stream.writer, "{text}").and_then(|()| stream.writer.flush());
        stream.is_open = written.is_ok();
    }
    stream.is_open
}
