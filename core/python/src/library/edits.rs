//! What a dictionary says of clips.

use motion_theater_core::ParameterError;
use motion_theater_library::catalogue::{Edit, Field};
use pyo3::prelude::*;
use pyo3::types::{PyBool, PyDict};

use crate::errors;

/// Reads `field: value`; `None` takes the user's own value back.
pub fn read(fields: &Bound<'_, PyDict>) -> PyResult<Vec<Edit>> {
    fields.iter().map(|(name, value)| edit(&name.extract::<String>()?, &value)).collect()
}

fn edit(name: &str, value: &Bound<'_, PyAny>) -> PyResult<Edit> {
    match name {
        "rating" if value.is_none() => Ok(Edit::Rating(0)),
        "rating" => Ok(Edit::Rating(value.extract()?)),
        "is_favourite" => Ok(Edit::Favourite(value.extract()?)),
        _ => {
            let field = Field::of_name(name).ok_or_else(|| unknown(name))?;
            let text = match value.cast::<PyBool>() {
                Ok(truth) => Some(i32::from(truth.is_true()).to_string()),
                Err(_) => value.extract::<Option<String>>()?,
            };
            Ok(Edit::Field(field, text))
        }
    }
}

fn unknown(name: &str) -> PyErr {
    let known = Field::ALL.map(Field::name).join(", ");
    errors::parameter(&ParameterError(format!("expected {known}, rating or is_favourite, found `{name}`")))
}
