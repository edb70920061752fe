//! `motion_theater.evaluate` and what it returns.

use motion_theater_core::stack;
use numpy::{PyArray1, PyArray2, PyArrayMethods, PyReadonlyArrayDyn};
use pyo3::prelude::*;
use xxhash_rust::xxh3::Xxh3;

use crate::arrays::row_first;
use crate::entries::AnyEntry;
use crate::errors;
use crate::rig::{PyBaseChannel, PyRig};

/// What one channel of one bone became.
#[pyclass(name = "ResultChannel", module = "motion_theater", frozen, get_all)]
pub struct PyResultChannel {
    bone: usize,
    channel: &'static str,
    start: f64,
    end: f64,
    coordinates: Py<PyArray2<f32>>,
    interpolation: Option<Py<PyArray1<i32>>>,
}

/// A sentence about one entry.
#[pyclass(name = "Notice", module = "motion_theater", frozen, get_all)]
pub struct PyNotice {
    entry: usize,
    text: String,
}

/// What a stack comes to.
#[pyclass(name = "Evaluation", module = "motion_theater", frozen, get_all)]
pub struct PyEvaluation {
    channels: Vec<Py<PyResultChannel>>,
    notices: Vec<Py<PyNotice>>,
    start: f64,
    end: f64,
}

/// Base motion + entries, in order, -> the resulting motion per channel, with what the user should know.
#[pyfunction]
pub fn evaluate(
    py: Python<'_>,
    rig: &PyRig,
    base: Vec<PyRef<'_, PyBaseChannel>>,
    entries: Vec<AnyEntry<'_>>,
) -> PyResult<PyEvaluation> {
    let base: Vec<stack::BaseChannel> = base.iter().map(|channel| channel.0.clone()).collect();
    let entries: Vec<stack::Entry> = entries.iter().map(AnyEntry::entry).collect();
    let evaluation =
        py.detach(|| stack::evaluate(&rig.0, &base, &entries)).map_err(|error| errors::parameter(&error))?;
    let (start, end) = evaluation.range.unwrap_or((0.0, 0.0));
    let channels = evaluation.channels.into_iter().map(|channel| to_python(py, channel)).collect::<PyResult<_>>()?;
    let notices = evaluation.notices.into_iter();
    let notices = notices.map(|notice| Py::new(py, PyNotice { entry: notice.entry, text: notice.text }));
    Ok(PyEvaluation { channels, notices: notices.collect::<PyResult<_>>()?, start, end })
}

fn to_python(py: Python<'_>, channel: stack::ResultChannel) -> PyResult<Py<PyResultChannel>> {
    let shape = [channel.channel.components(), 2 * channel.key_count];
    let coordinates = PyArray1::from_vec(py, channel.coordinates).reshape(shape)?;
    Py::new(
        py,
        PyResultChannel {
            bone: channel.bone,
            channel: channel.channel.name(),
            start: channel.start,
            end: channel.end,
            coordinates: coordinates.unbind(),
            interpolation: channel.interpolation.map(|codes| PyArray1::from_vec(py, codes).unbind()),
        },
    )
}

/// A short hash of float32 arrays, to notice curves that were edited by hand.
#[pyfunction]
pub fn digest(arrays: Vec<PyReadonlyArrayDyn<'_, f32>>) -> PyResult<String> {
    let mut hash = Xxh3::new();
    for array in &arrays {
        let values = row_first("arrays", array)?;
        hash.update(&(values.len() as u64).to_le_bytes());
        hash.update(bytemuck::cast_slice(values));
    }
    Ok(format!("{:016x}", hash.digest()))
}
