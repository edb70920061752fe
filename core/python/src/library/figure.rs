//! `motion_theater.Figure` and `load_figure`.

use std::path::PathBuf;

use glam::Vec3;
use motion_theater_core::loaded::{Loaded, SkeletonFile};
use motion_theater_core::Skeleton;
use motion_theater_library::figure::{Actor, Figure};
use numpy::ndarray::{Array1, Array2, Array3};
use numpy::{IntoPyArray, PyArray1, PyArray2, PyArray3};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

use crate::errors;
use crate::skeleton::PySkeleton;

/// A clip as points and lines, ready to draw.
#[pyclass(name = "Figure", module = "motion_theater", frozen)]
pub struct PyFigure(Figure);

/// Reads a file as a figure.
#[pyfunction]
#[pyo3(signature = (path, *, skeleton=None, longest=None))]
pub fn load_figure(
    py: Python<'_>,
    path: PathBuf,
    skeleton: Option<&PySkeleton>,
    longest: Option<usize>,
) -> PyResult<PyFigure> {
    let named = skeleton.map(|skeleton| {
        let skeleton = Skeleton::clone(&skeleton.0);
        SkeletonFile { path: PathBuf::from(&skeleton.name), skeleton }
    });
    let figure = py.detach(|| {
        let loaded = Loaded::read(&path, named.as_ref())?;
        Ok(Figure::new(&Actor::of(&loaded)?, longest))
    });
    figure.map(PyFigure).map_err(errors::load)
}

#[pymethods]
impl PyFigure {
    #[getter]
    fn names(&self) -> Vec<String> {
        self.0.names.clone()
    }

    #[getter]
    fn points<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray3<f32>>> {
        let shape = (self.0.frame_count, self.0.names.len(), 3);
        let points = Array3::from_shape_vec(shape, numbers(&self.0.points)).map_err(shape_error)?;
        Ok(points.into_pyarray(py))
    }

    #[getter]
    fn lines<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<i32>>> {
        let ends = self.0.lines.iter().flatten().map(|point| *point as i32).collect();
        Ok(Array2::from_shape_vec((self.0.lines.len(), 2), ends).map_err(shape_error)?.into_pyarray(py))
    }

    #[getter]
    fn sides<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<i8>> {
        self.0.sides.iter().map(|side| side.number()).collect::<Array1<i8>>().into_pyarray(py)
    }

    #[getter]
    fn frames(&self) -> usize {
        self.0.frame_count
    }

    #[getter]
    fn step(&self) -> usize {
        self.0.frame_step
    }

    #[getter]
    fn first_frame(&self) -> i64 {
        self.0.first_frame
    }

    #[getter]
    fn rate_hz(&self) -> f64 {
        self.0.rate_hz
    }

    #[getter]
    fn bounds<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<f32>>> {
        rows(py, &self.0.bounds.unwrap_or_default())
    }

    #[getter]
    fn floor(&self) -> f32 {
        self.0.floor
    }

    fn segments<'py>(&self, py: Python<'py>, frame: f64) -> PyResult<Bound<'py, PyArray2<f32>>> {
        rows(py, self.0.segments(frame).as_flattened())
    }

    fn dots<'py>(&self, py: Python<'py>, frame: f64) -> PyResult<Bound<'py, PyArray2<f32>>> {
        rows(py, &self.0.dots(frame))
    }

    #[pyo3(signature = (*, left, middle, right))]
    fn colors<'py>(
        &self,
        py: Python<'py>,
        left: [f32; 4],
        middle: [f32; 4],
        right: [f32; 4],
    ) -> PyResult<Bound<'py, PyArray2<f32>>> {
        let colours: Vec<f32> = self.0.colours(left, middle, right).into_iter().flatten().flatten().collect();
        Ok(Array2::from_shape_vec((2 * self.0.lines.len(), 4), colours).map_err(shape_error)?.into_pyarray(py))
    }

    fn __repr__(&self) -> String {
        format!("<Figure: {} points, {} lines, {} frames>", self.0.names.len(), self.0.lines.len(), self.0.frame_count)
    }
}

fn numbers(points: &[Vec3]) -> Vec<f32> {
    points.iter().flat_map(Vec3::to_array).collect()
}

fn rows<'py>(py: Python<'py>, points: &[Vec3]) -> PyResult<Bound<'py, PyArray2<f32>>> {
    let rows = Array2::from_shape_vec((points.len(), 3), numbers(points)).map_err(shape_error)?;
    Ok(rows.into_pyarray(py))
}

fn shape_error(error: numpy::ndarray::ShapeError) -> PyErr {
    PyValueError::new_err(error.to_string())
}
