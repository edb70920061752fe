//! `motion_theater.infer`: what a skeleton and its motion do not say of themselves.

use glam::DVec3;
use motion_theater_core::infer::{infer as infer_in_core, Answer};
use pyo3::prelude::*;

use crate::motion::PyMotion;
use crate::skeleton::PySkeleton;

/// A value that was worked out, with its reason.
#[pyclass(name = "Answer", module = "motion_theater", frozen, get_all)]
pub struct PyAnswer {
    value: Py<PyAny>,
    reason: String,
    is_certain: bool,
}

/// Everything that can be worked out of a skeleton and its motion.
#[pyclass(name = "Inference", module = "motion_theater", frozen, get_all)]
pub struct PyInference {
    unit_m: Py<PyAnswer>,
    up: Py<PyAnswer>,
    facing: Py<PyAnswer>,
    rate_hz: Py<PyAnswer>,
}

/// Works out unit, up axis, facing and rate of a skeleton and, where there is one, its motion in the file's axes.
#[pyfunction]
#[pyo3(signature = (skeleton, motion=None))]
pub fn infer(py: Python<'_>, skeleton: &PySkeleton, motion: Option<&PyMotion>) -> PyResult<PyInference> {
    let found = py.detach(|| infer_in_core(&skeleton.0, motion.map(|motion| &**motion.source.motion())));
    Ok(PyInference {
        unit_m: number(py, some(found.unit_m))?,
        up: direction(py, found.up)?,
        facing: direction(py, found.facing)?,
        rate_hz: number(py, found.rate_hz)?,
    })
}

fn some(answer: Answer<f64>) -> Answer<Option<f64>> {
    Answer { value: Some(answer.value), reason: answer.reason, is_certain: answer.is_certain }
}

pub fn direction(py: Python<'_>, answer: Answer<DVec3>) -> PyResult<Py<PyAnswer>> {
    let value = <(f64, f64, f64)>::from(answer.value).into_pyobject(py)?.into_any().unbind();
    Py::new(py, PyAnswer { value, reason: answer.reason, is_certain: answer.is_certain })
}

fn number(py: Python<'_>, answer: Answer<Option<f64>>) -> PyResult<Py<PyAnswer>> {
    let value = answer.value.into_pyobject(py)?.into_any().unbind();
    Py::new(py, PyAnswer { value, reason: answer.reason, is_certain: answer.is_certain })
}
