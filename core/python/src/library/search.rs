//! What to search for, and in which order to list it.

use motion_theater_core::ParameterError;
use motion_theater_library::query::{Order, Query, Sort};
use pyo3::prelude::*;

use crate::errors;

/// Understands a query and an order.
pub fn understand(query: &str, sort: &str, is_descending: bool) -> PyResult<(Query, Order)> {
    let wrong = |text: String| errors::parameter(&ParameterError(text));
    let query = Query::parse(query).map_err(|error| wrong(error.to_string()))?;
    let sort = Sort::named(sort).ok_or_else(|| wrong(format!("`{sort}`: expected one of {}", Sort::list())))?;
    Ok((query, Order { sort, is_descending }))
}
