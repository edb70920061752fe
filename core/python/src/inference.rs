//! `motion_theater.infer` and what it returns.

use motion_theater_core::infer::{infer as infer_core, Inference};
use pyo3::prelude::*;

use crate::motion::PyMotion;
use crate::skeleton::PySkeleton;

/// What a skeleton does not say of itself.
#[pyclass(name = "Inference", module = "motion_theater", frozen)]
pub struct PyInference(Inference);

/// Work out unit, up axis, facing and rate of a skeleton, better with a motion of it.
#[pyfunction]
#[pyo3(signature = (skeleton, motion=None))]
pub fn infer(py: Python<'_>, skeleton: &PySkeleton, motion: Option<&PyMotion>) -> PyInference {
    PyInference(py.detach(|| infer_core(&skeleton.0, motion.map(|motion| &**motion.source.motion()))))
}

#[pymethods]
impl PyInference {
    #[getter]
    fn unit_m(&self) -> f64 {
        self.0.unit_m.value
    }

    #[getter]
    fn unit_reason(&self) -> &str {
        &self.0.unit_m.reason
    }

    #[getter]
    fn unit_is_certain(&self) -> bool {
        self.0.unit_m.is_certain
    }

    #[getter]
    fn up(&self) -> (f64, f64, f64) {
        self.0.up.value.into()
    }

    #[getter]
    fn up_reason(&self) -> &str {
        &self.0.up.reason
    }

    #[getter]
    fn up_is_certain(&self) -> bool {
        self.0.up.is_certain
    }

    #[getter]
    fn facing(&self) -> (f64, f64, f64) {
        self.0.facing.value.into()
    }

    #[getter]
    fn facing_reason(&self) -> &str {
        &self.0.facing.reason
    }

    #[getter]
    fn facing_is_certain(&self) -> bool {
        self.0.facing.is_certain
    }

    #[getter]
    fn rate_hz(&self) -> Option<f64> {
        self.0.rate_hz.value
    }

    #[getter]
    fn rate_reason(&self) -> &str {
        &self.0.rate_hz.reason
    }

    #[getter]
    fn rate_is_certain(&self) -> bool {
        self.0.rate_hz.is_certain
    }
}
