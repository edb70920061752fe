//! `motion_theater.parse_recipe` and `format_recipe`: stack files as Python's own lists and dictionaries.

use std::path::PathBuf;

use motion_theater_core::recipe::Recipe;
use pyo3::prelude::*;

use crate::errors;

/// Read the text of a stack file, TOML or JSON; what it does not say is not in the result.
#[pyfunction]
#[pyo3(signature = (text, *, name))]
pub fn parse_recipe<'py>(py: Python<'py>, text: &str, name: PathBuf) -> PyResult<Bound<'py, PyAny>> {
    let recipe = Recipe::parse(text, &name).map_err(|error| errors::parameter(&error))?;
    py.import("json")?.call_method1("loads", (recipe.to_json(),))
}

/// Return a stack file as TOML. Raises `ParameterError` where it holds what a stack file cannot.
#[pyfunction]
pub fn format_recipe(recipe: &Bound<'_, PyAny>) -> PyResult<String> {
    let text: String = recipe.py().import("json")?.call_method1("dumps", (recipe,))?.extract()?;
    let recipe = Recipe::parse(&text, &PathBuf::from("the stack")).map_err(|error| errors::parameter(&error))?;
    Ok(recipe.to_toml())
}
