//! The Python module `motion_theater`: converts, releases the interpreter, calls the core, converts back.

use pyo3::prelude::*;

#[pymodule]
fn motion_theater(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add("__version__", env!("CARGO_PKG_VERSION"))
}
