//! The Python module `motion_theater`: converts, releases the interpreter, calls the core, converts back.
//!
//! Its documentation is the stub file `motion_theater.pyi`.

// PyO3 hands extracted arguments over by value.
#![allow(clippy::needless_pass_by_value)]

use pyo3::prelude::*;

mod arrays;
mod clip;
mod command_line;
mod entries;
mod errors;
mod evaluation;
mod filters;
mod inference;
mod library;
mod markers;
mod motion;
mod pairing;
mod recipe;
mod rig;
mod skeleton;
mod writing;

/// Motion capture: read it, combine it, filter it.
#[pymodule]
fn motion_theater(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add("__version__", env!("CARGO_PKG_VERSION"))?;
    errors::add_to(module)?;
    library::add_to(module)?;
    module.add_class::<skeleton::PySkeleton>()?;
    module.add_class::<motion::PyMotion>()?;
    module.add_class::<markers::PyMarkers>()?;
    module.add_class::<markers::PyEvent>()?;
    module.add_class::<markers::PyAnalogChannel>()?;
    module.add_class::<clip::PyClip>()?;
    module.add_class::<rig::PyRig>()?;
    module.add_class::<rig::PyBaseChannel>()?;
    module.add_class::<entries::PyTrack>()?;
    module.add_class::<entries::PyFilter>()?;
    module.add_class::<evaluation::PyResultChannel>()?;
    module.add_class::<evaluation::PyNotice>()?;
    module.add_class::<evaluation::PyEvaluation>()?;
    module.add_function(wrap_pyfunction!(command_line::main, module)?)?;
    module.add_function(wrap_pyfunction!(clip::read, module)?)?;
    module.add_function(wrap_pyfunction!(clip::read_bytes, module)?)?;
    module.add_function(wrap_pyfunction!(clip::format_of, module)?)?;
    pairing::add_to(module)?;
    module.add_class::<inference::PyAnswer>()?;
    module.add_class::<inference::PyInference>()?;
    module.add_function(wrap_pyfunction!(inference::infer, module)?)?;
    module.add_function(wrap_pyfunction!(writing::to_bvh, module)?)?;
    module.add_function(wrap_pyfunction!(writing::to_acclaim, module)?)?;
    module.add_function(wrap_pyfunction!(filters::filter_values, module)?)?;
    module.add_function(wrap_pyfunction!(filters::filter_rotations, module)?)?;
    module.add_function(wrap_pyfunction!(evaluation::evaluate, module)?)?;
    module.add_function(wrap_pyfunction!(recipe::parse_recipe, module)?)?;
    module.add_function(wrap_pyfunction!(recipe::format_recipe, module)?)?;
    module.add_function(wrap_pyfunction!(evaluation::digest, module)?)
}
