//! `motion_theater.Preview`: how a clip looks.

use motion_theater_library::preview::{Frames, Strip};
use numpy::ndarray::{Array3, Array4, ShapeError};
use numpy::{IntoPyArray, PyArray3, PyArray4};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

/// A moving strip of a clip.
#[pyclass(name = "Preview", module = "motion_theater", frozen, get_all)]
pub struct PyPreview {
    frames: Py<PyArray4<u8>>,
    rate_hz: f64,
    still_frame: i64,
}

impl PyPreview {
    pub fn new(py: Python<'_>, strip: Strip) -> PyResult<Self> {
        let Frames { count, width, height, rgba } = strip.frames;
        let frames = Array4::from_shape_vec((count, height, width, 4), rgba).map_err(shape_error)?;
        let frames = frames.into_pyarray(py).unbind();
        Ok(Self { frames, rate_hz: strip.rate_hz, still_frame: strip.still_frame })
    }
}

#[pymethods]
impl PyPreview {
    fn __repr__(&self) -> String {
        format!("<Preview: {} frames per second>", self.rate_hz)
    }
}

/// Returns a single picture.
pub fn picture(py: Python<'_>, still: Frames) -> PyResult<Bound<'_, PyArray3<u8>>> {
    let shape = (still.height, still.width, 4);
    Ok(Array3::from_shape_vec(shape, still.rgba).map_err(shape_error)?.into_pyarray(py))
}

fn shape_error(error: ShapeError) -> PyErr {
    PyValueError::new_err(error.to_string())
}
