//! What the library of clips gives: figures, previews.

mod figure;

use pyo3::prelude::*;

/// Adds the classes and functions to the module.
pub fn add_to(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add_class::<figure::PyFigure>()?;
    module.add_function(wrap_pyfunction!(figure::load_figure, module)?)
}
