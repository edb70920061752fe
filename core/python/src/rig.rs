//! `motion_theater.Rig` and `motion_theater.BaseChannel`.

use glam::DQuat;
use motion_theater_core::stack::{BaseChannel, Channel, Mode, Rig, RigBone};
use motion_theater_core::value::EulerFrame;
use motion_theater_core::{EulerOrder, ParameterError};
use numpy::{PyReadonlyArray1, PyReadonlyArray2, PyUntypedArrayMethods};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

use crate::arrays::{one_per_bone, read_quaternions, read_vectors, row_first};
use crate::errors;

/// The armature a stack is evaluated for.
#[pyclass(name = "Rig", module = "motion_theater", frozen)]
pub struct PyRig(pub Rig);

fn order(name: &str) -> PyResult<EulerOrder> {
    name.parse().map_err(|error: ParameterError| errors::parameter(&error))
}

#[pymethods]
impl PyRig {
    #[new]
    #[pyo3(signature = (names, *, rest_rotations, rest_heads, parents, modes, up, rate_hz, file_axes=None, file_orders=None))]
    #[allow(clippy::too_many_arguments)] // keyword-only in Python, each named at the call
    fn new(
        names: Vec<String>,
        rest_rotations: PyReadonlyArray2<'_, f64>,
        rest_heads: PyReadonlyArray2<'_, f64>,
        parents: Vec<i64>,
        modes: Vec<String>,
        up: (f64, f64, f64),
        rate_hz: f64,
        file_axes: Option<PyReadonlyArray2<'_, f64>>,
        file_orders: Option<Vec<String>>,
    ) -> PyResult<Self> {
        let count = names.len();
        let rotations = read_quaternions("rest_rotations", &rest_rotations)?;
        let heads = read_vectors("rest_heads", &rest_heads)?;
        let axes = file_axes.map(|axes| read_quaternions("file_axes", &axes)).transpose()?;
        let axes = axes.unwrap_or_else(|| vec![DQuat::IDENTITY; count]);
        let orders = file_orders.unwrap_or_else(|| vec!["XYZ".into(); count]);
        for (name, found) in [
            ("rest_rotations", rotations.len()),
            ("rest_heads", heads.len()),
            ("parents", parents.len()),
            ("modes", modes.len()),
            ("file_axes", axes.len()),
            ("file_orders", orders.len()),
        ] {
            one_per_bone(name, found, count)?;
        }
        let bones = names.into_iter().enumerate().map(|(index, name)| {
            let mode = if modes[index] == "QUATERNION" { Mode::Quaternion } else { Mode::Euler(order(&modes[index])?) };
            Ok(RigBone {
                name,
                parent: usize::try_from(parents[index]).ok(),
                rest_rotation: rotations[index].normalize(),
                rest_head: heads[index],
                mode,
                angles: EulerFrame { axes: axes[index].normalize(), order: order(&orders[index])? },
            })
        });
        Ok(Self(Rig { bones: bones.collect::<PyResult<_>>()?, up: up.into(), rate_hz }))
    }
}

/// What one channel of one bone held before the first entry.
#[pyclass(name = "BaseChannel", module = "motion_theater", frozen)]
pub struct PyBaseChannel(pub BaseChannel);

#[pymethods]
impl PyBaseChannel {
    #[new]
    #[pyo3(signature = (bone, channel, frames, values, is_key=None))]
    fn new(
        bone: usize,
        channel: &str,
        frames: PyReadonlyArray1<'_, f64>,
        values: PyReadonlyArray2<'_, f64>,
        is_key: Option<PyReadonlyArray1<'_, bool>>,
    ) -> PyResult<Self> {
        let Some(channel) = Channel::from_name(channel) else {
            return Err(errors::parameter(&ParameterError(format!("there is no channel `{channel}`"))));
        };
        let frames = frames.as_slice()?.to_vec();
        if values.shape() != [frames.len(), channel.components()] {
            let expected = (frames.len(), channel.components());
            return Err(PyValueError::new_err(format!(
                "values: expected shape {expected:?}, found {:?}",
                values.shape()
            )));
        }
        if !frames.windows(2).all(|pair| pair[0] < pair[1]) {
            return Err(PyValueError::new_err("frames: expected ascending frames"));
        }
        let is_key = is_key.map(|flags| flags.as_slice().map(<[bool]>::to_vec)).transpose()?.unwrap_or_default();
        if !is_key.is_empty() && is_key.len() != frames.len() {
            return Err(PyValueError::new_err("is_key: expected one per frame"));
        }
        Ok(Self(BaseChannel { bone, channel, frames, values: row_first("values", &values)?.to_vec(), is_key }))
    }
}
