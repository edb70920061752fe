//! Filters on bare arrays.

use glam::DQuat;
use motion_theater_core::filter::{self, Depth, FilterKind};
use motion_theater_core::ParameterError;
use numpy::ndarray::Array3;
use numpy::{
    IntoPyArray, PyArray2, PyArray3, PyArrayMethods, PyReadonlyArray2, PyReadonlyArray3, PyUntypedArrayMethods,
};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

use crate::arrays::row_first;
use crate::errors;

/// Reads a filter's kind by name.
pub fn kind(name: &str) -> PyResult<FilterKind> {
    match name {
        "MEDIAN" => Ok(FilterKind::Median),
        "AVERAGE" => Ok(FilterKind::Average),
        "WEIGHTED" => Ok(FilterKind::Weighted),
        other => {
            Err(errors::parameter(&ParameterError(format!("expected MEDIAN, AVERAGE or WEIGHTED, found `{other}`"))))
        }
    }
}

/// Checks a filter's depth.
pub fn depth(depth: usize) -> PyResult<Depth> {
    Depth::try_from(depth).map_err(|error| errors::parameter(&error))
}

/// Filter (channels, frames) along the last axis. Near the ends the window shrinks so that it stays centred.
#[pyfunction]
#[pyo3(name = "filter_values", signature = (values, *, kind, depth))]
pub fn filter_values<'py>(
    py: Python<'py>,
    values: PyReadonlyArray2<'py, f64>,
    kind: &str,
    depth: usize,
) -> PyResult<Bound<'py, PyArray2<f64>>> {
    let (kind, depth) = (self::kind(kind)?, self::depth(depth)?);
    let frames = values.shape()[1];
    // numpy's own memory: it asks the system for large pages, which a vector of Rust does not.
    let filtered = PyArray2::zeros(py, [values.shape()[0], frames], false);
    {
        let mut out = filtered.try_readwrite()?;
        let (values, out) = (row_first("values", &values)?, out.as_slice_mut()?);
        py.detach(|| filter::filter_channels(values, frames, out, kind, depth));
    }
    Ok(filtered)
}

/// Filter (bones, frames, 4) quaternions as rotations.
#[pyfunction]
#[pyo3(name = "filter_rotations", signature = (values, *, kind, depth))]
pub fn filter_rotations<'py>(
    py: Python<'py>,
    values: PyReadonlyArray3<'py, f64>,
    kind: &str,
    depth: usize,
) -> PyResult<Bound<'py, PyArray3<f64>>> {
    let (kind, depth) = (self::kind(kind)?, self::depth(depth)?);
    let shape = (values.shape()[0], values.shape()[1], values.shape()[2]);
    if shape.2 != 4 {
        return Err(PyValueError::new_err(format!("expected quaternions of 4 components, found {}", shape.2)));
    }
    let values = row_first("values", &values)?;
    let filtered = py.detach(|| {
        let mut filtered = Vec::with_capacity(values.len());
        for bone in values.chunks_exact((shape.1 * 4).max(1)) {
            let rotations: Vec<DQuat> =
                bone.as_chunks::<4>().0.iter().map(|&[w, x, y, z]| DQuat::from_xyzw(x, y, z, w)).collect();
            let mut smooth = vec![DQuat::IDENTITY; rotations.len()];
            filter::filter_rotations(&rotations, &mut smooth, kind, depth);
            filtered.extend(smooth.iter().flat_map(|value| [value.w, value.x, value.y, value.z]));
        }
        filtered
    });
    let filtered = Array3::from_shape_vec(shape, filtered);
    Ok(filtered.map_err(|error| PyValueError::new_err(error.to_string()))?.into_pyarray(py))
}
