//! What can go wrong, in words for the person with the broken file.

use std::fmt;
use std::path::PathBuf;

/// Where in a file something stands.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Position {
    /// A line and a column of a text file, both counted from 1; the column counts bytes.
    Text {
        /// The line, from 1.
        line: usize,
        /// The column in bytes, from 1.
        column: usize,
    },
    /// A byte of a binary file, counted from 0.
    Byte(usize),
}

impl fmt::Display for Position {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Text { line, column } => write!(f, "line {line}, column {column}"),
            Self::Byte(offset) => write!(f, "byte {offset:#x}"),
        }
    }
}

/// Why a file could not be read, and where.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[error("{position}: expected {expected}, found {found}")]
pub struct ParseError {
    /// Where the reader stood.
    pub position: Position,
    /// What would have been right there, in words: "a number for `rx` of bone `lfemur`".
    pub expected: String,
    /// What stood there instead, in words: "`abc`", "the end of the file", "2 values".
    pub found: String,
}

/// A motion and a skeleton that do not belong together.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("the motion does not fit the skeleton: {}", .bones.join(", "))]
pub struct MisfitError {
    /// One item per bone that does not fit: its name, and why where that is not "unknown".
    pub bones: Vec<String>,
}

/// A number or a combination that was asked for and makes no sense, with the reason.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("{0}")]
pub struct ParameterError(pub String);

/// Returns what the system says of an error, without its number.
pub fn words(error: &std::io::Error) -> String {
    let text = error.to_string();
    text.split(" (os error").next().unwrap_or_default().to_owned()
}

/// Everything that reading a file from disk can end in.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum ReadError {
    /// The disk failed: no such file, no permission, a directory.
    #[error("{}: {}", path.display(), words(source))]
    Io {
        /// The file that was asked for.
        path: PathBuf,
        /// What the system said.
        source: std::io::Error,
    },
    /// The file is wrong.
    #[error("{}, {error}", path.display())]
    Parse {
        /// The file.
        path: PathBuf,
        /// Where and why.
        error: ParseError,
    },
    /// The motion and the skeleton do not belong together.
    #[error("{}: {error}", path.display())]
    Misfit {
        /// The motion's file.
        path: PathBuf,
        /// Which bones.
        error: MisfitError,
    },
}
