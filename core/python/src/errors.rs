//! The exceptions of the module, and how errors of the core become them.

use std::path::Path;

use motion_theater_core::error::words;
use motion_theater_core::loaded::LoadError;
use motion_theater_core::{MisfitError, ParameterError, ParseError, Position, ReadError};
use motion_theater_library::sidecar::SidecarError;
use motion_theater_library::LibraryError;
use pyo3::exceptions::{PyException, PyOSError, PyValueError};
use pyo3::prelude::*;
use pyo3::sync::PyOnceLock;
use pyo3::types::{PyDict, PyTuple, PyType};

struct Types {
    root: Py<PyType>,
    parse: Py<PyType>,
    misfit: Py<PyType>,
    parameter: Py<PyType>,
    library: Py<PyType>,
}

static TYPES: PyOnceLock<Types> = PyOnceLock::new();

fn types(py: Python<'_>) -> PyResult<&Types> {
    TYPES.get_or_try_init(py, || {
        let exception = py.get_type::<PyException>();
        let root =
            new_type(&[&exception], "MotionTheaterError", "The root of every error of this module but OSError.")?;
        let bases = [&root, &py.get_type::<PyValueError>()];
        let new = |name, doc| Ok::<_, PyErr>(new_type(&bases, name, doc)?.unbind());
        Ok(Types {
            parse: new("ParseError", "A file is wrong; the text says where and why.")?,
            misfit: new("MisfitError", "A motion and a skeleton do not belong together.")?,
            parameter: new("ParameterError", "What was asked for makes no sense.")?,
            library: new_type(&[&root], "LibraryError", "A library cannot be opened, read or written.")?.unbind(),
            root: root.unbind(),
        })
    })
}

/// Makes an exception class; the way that `PyO3` offers knows only one base.
fn new_type<'py>(bases: &[&Bound<'py, PyType>], name: &str, doc: &str) -> PyResult<Bound<'py, PyType>> {
    let py = bases[0].py();
    let namespace = PyDict::new(py);
    namespace.set_item("__module__", "motion_theater")?;
    namespace.set_item("__doc__", doc)?;
    let class = py.get_type::<PyType>().call1((name, PyTuple::new(py, bases)?, namespace))?;
    Ok(class.cast_into::<PyType>()?)
}

/// Adds the exceptions to the module.
pub fn add_to(module: &Bound<'_, PyModule>) -> PyResult<()> {
    let py = module.py();
    let types = types(py)?;
    for (name, class) in [
        ("MotionTheaterError", &types.root),
        ("ParseError", &types.parse),
        ("MisfitError", &types.misfit),
        ("ParameterError", &types.parameter),
        ("LibraryError", &types.library),
    ] {
        module.add(name, class.bind(py))?;
    }
    Ok(())
}

/// Makes an exception of one of our types with attributes.
fn raise(
    py: Python<'_>,
    class: impl FnOnce(&Types) -> &Py<PyType>,
    message: String,
    fill: impl FnOnce(&Bound<'_, PyAny>) -> PyResult<()>,
) -> PyErr {
    let make = || {
        let error = class(types(py)?).bind(py).call1((message,))?;
        fill(&error)?;
        Ok(PyErr::from_value(error))
    };
    make().unwrap_or_else(|failure| failure)
}

/// A number or combination that makes no sense.
pub fn parameter(error: &ParameterError) -> PyErr {
    Python::attach(|py| raise(py, |types| &types.parameter, error.to_string(), |_| Ok(())))
}

/// What can go wrong with a library.
pub fn library(error: LibraryError) -> PyErr {
    match error {
        LibraryError::Io { path, source } => io(&path, &source),
        LibraryError::Sidecar(error) => sidecar(error),
        LibraryError::Asked(reason) => parameter(&ParameterError(reason)),
        other => Python::attach(|py| raise(py, |types| &types.library, other.to_string(), |_| Ok(()))),
    }
}

/// Why a sidecar could not be opened, edited or saved.
pub fn sidecar(error: SidecarError) -> PyErr {
    let text = error.to_string();
    match error {
        SidecarError::NotRead { path, source } => io(&path, &source),
        SidecarError::NotSaved { path, source } => {
            // Python puts the path behind what the system says.
            let reason = format!("not saved, and left as it was: {}", words(&source));
            match source.raw_os_error() {
                Some(code) => PyOSError::new_err((code, reason, path)),
                None => PyOSError::new_err(text),
            }
        }
        SidecarError::Clip(error) => load(error),
        SidecarError::Value(error) => parameter(&ParameterError(error.to_string())),
        _ => Python::attach(|py| raise(py, |types| &types.library, text, |_| Ok(()))),
    }
}

/// A motion and a skeleton that do not belong together; `path` is the motion's file.
pub fn misfit(path: &str, error: MisfitError) -> PyErr {
    Python::attach(|py| {
        let message = format!("{path}: {error}");
        raise(py, |types| &types.misfit, message, |value| value.setattr("bones", error.bones))
    })
}

/// A file that is wrong.
pub fn parse(path: &str, error: &ParseError) -> PyErr {
    Python::attach(|py| {
        let message = format!("{path}, {error}");
        raise(
            py,
            |types| &types.parse,
            message,
            |value| {
                let (line, column, byte) = match error.position {
                    Position::Text { line, column } => (Some(line), Some(column), None),
                    Position::Byte(offset) => (None, None, Some(offset)),
                };
                value.setattr("path", path)?;
                value.setattr("line", line)?;
                value.setattr("column", column)?;
                value.setattr("byte", byte)?;
                value.setattr("expected", &error.expected)?;
                value.setattr("found", &error.found)
            },
        )
    })
}

/// What the disk said, as the exception that Python itself would raise.
pub fn io(path: &Path, error: &std::io::Error) -> PyErr {
    match error.raw_os_error() {
        Some(code) => PyOSError::new_err((code, words(error), path.to_path_buf())),
        None => PyOSError::new_err(format!("{}: {error}", path.display())),
    }
}

/// Everything that reading can end in.
pub fn read(error: ReadError) -> PyErr {
    match error {
        ReadError::Io { path, source } => io(&path, &source),
        ReadError::Parse { path, error } => parse(&path.display().to_string(), &error),
        ReadError::Misfit { path, error } => misfit(&path.display().to_string(), error),
        other => PyValueError::new_err(other.to_string()),
    }
}

/// Everything that reading a file with its skeleton can end in.
pub fn load(error: LoadError) -> PyErr {
    match error {
        LoadError::Read(error) => read(error),
        LoadError::Misfit { motion, error, .. } => misfit(&motion.display().to_string(), error),
        other => Python::attach(|py| {
            let fill = |value: &Bound<'_, PyAny>| value.setattr("bones", Vec::<String>::new());
            raise(py, |types| &types.misfit, other.to_string(), fill)
        }),
    }
}
