//! `motion_theater.Motion`.

use std::collections::HashMap;
use std::sync::Arc;

use glam::{DQuat, DVec3};
use motion_theater_core::pose::pose;
use motion_theater_core::rest_axes::RestAxes;
use motion_theater_core::stack::Source;
use motion_theater_core::{Bone, BoneMotion, Dof, EulerOrder, Motion, Skeleton};
use numpy::{PyArray2, PyReadonlyArray2};
use pyo3::exceptions::{PyIndexError, PyValueError};
use pyo3::prelude::*;

use crate::arrays::{one_per_bone, quaternions, read_quaternions, read_vectors, rows, vectors};
use crate::errors;
use crate::skeleton::PySkeleton;

type Array<'py> = Bound<'py, PyArray2<f64>>;

/// Channels over frames, for the bones of one skeleton or of one host armature.
#[pyclass(name = "Motion", module = "motion_theater", frozen)]
pub struct PyMotion {
    pub source: Arc<Source>,
    pub names: Vec<String>,
    /// The skeleton that the motion was read for.
    pub skeleton: Arc<Skeleton>,
}

impl PyMotion {
    /// Takes a motion of a skeleton's own bones.
    pub fn new(motion: motion_theater_core::Motion, skeleton: Arc<Skeleton>) -> Self {
        let names = skeleton.bones.iter().map(|bone| bone.name.clone()).collect();
        Self { source: Arc::new(Source::new(motion)), names, skeleton }
    }

    fn bone(&self, bone: usize) -> PyResult<&BoneMotion> {
        let bones = &self.source.motion().bones;
        bones.get(bone).ok_or_else(|| PyIndexError::new_err(format!("bone {bone} of {}", bones.len())))
    }
}

/// Rotations smaller than this (radians) about an axis that a bone does not turn about are rounding.
const ROUNDING_RAD: f64 = 1e-5;

/// Returns one bone's samples in the file's axes, with angles about its own axes: unwrapped, and exactly zero about
/// axes that are not among its degrees of freedom.
fn samples(bone: &Bone, rotations: Vec<DQuat>, translations: Vec<DVec3>) -> BoneMotion {
    let mut near = [0.0; 3];
    let angles = rotations.iter().map(|rotation| {
        near = bone.order.angles_near(bone.axes.conjugate() * *rotation * bone.axes, near);
        near
    });
    let mut angles: Vec<[f64; 3]> = angles.collect();
    for axis in (0..3).filter(|axis| !bone.dofs.contains(&Dof::Rotate(*axis))) {
        if angles.iter().all(|angles| angles[axis].abs() < ROUNDING_RAD) {
            for angles in &mut angles {
                angles[axis] = 0.0;
            }
        }
    }
    let mut last = DQuat::IDENTITY;
    let rotations = rotations.into_iter().map(|rotation| {
        last = if rotation.dot(last) < 0.0 { -rotation } else { rotation };
        last
    });
    BoneMotion { rotations: rotations.collect(), angles, translations, stretches: Vec::new() }
}

#[pymethods]
impl PyMotion {
    #[new]
    #[pyo3(signature = (skeleton, *, frames, rotations, translations, first_frame=1, rate_hz=None))]
    fn from_arrays(
        skeleton: &PySkeleton,
        frames: usize,
        rotations: Vec<Option<PyReadonlyArray2<'_, f64>>>,
        translations: Vec<Option<PyReadonlyArray2<'_, f64>>>,
        first_frame: i64,
        rate_hz: Option<f64>,
    ) -> PyResult<Self> {
        let count = skeleton.0.bones.len();
        one_per_bone("rotations", rotations.len(), count)?;
        one_per_bone("translations", translations.len(), count)?;
        let mut bones = Vec::with_capacity(count);
        for ((bone, rotations), translations) in skeleton.0.bones.iter().zip(rotations).zip(translations) {
            let turned = rotations.map(|rows| read_quaternions("rotations", &rows)).transpose()?.unwrap_or_default();
            let moved = translations.map(|rows| read_vectors("translations", &rows)).transpose()?.unwrap_or_default();
            if [turned.len(), moved.len()].into_iter().any(|rows| rows != 0 && rows != frames) {
                let text = format!("{}: expected {frames} frames, found {}", bone.name, turned.len().max(moved.len()));
                return Err(PyValueError::new_err(text));
            }
            bones.push(samples(bone, turned.into_iter().map(DQuat::normalize).collect(), moved));
        }
        let motion = Motion { bones, first_frame, frame_count: frames, rate_hz };
        Ok(Self::new(motion, Arc::clone(&skeleton.0)))
    }

    #[getter]
    fn names(&self) -> Vec<String> {
        self.names.clone()
    }

    #[getter]
    fn first_frame(&self) -> i64 {
        self.source.motion().first_frame
    }

    #[getter]
    fn frames(&self) -> usize {
        self.source.motion().frame_count
    }

    #[getter]
    fn rate_hz(&self) -> Option<f64> {
        self.source.motion().rate_hz
    }

    fn has_rotation(&self, bone: usize) -> PyResult<bool> {
        Ok(!self.bone(bone)?.rotations.is_empty())
    }

    fn has_translation(&self, bone: usize) -> PyResult<bool> {
        Ok(!self.bone(bone)?.translations.is_empty())
    }

    fn rotations<'py>(&self, py: Python<'py>, bone: usize) -> PyResult<Array<'py>> {
        Ok(quaternions(py, &self.bone(bone)?.rotations))
    }

    fn angles<'py>(&self, py: Python<'py>, bone: usize) -> PyResult<Array<'py>> {
        Ok(rows(py, self.bone(bone)?.angles.clone()))
    }

    fn translations<'py>(&self, py: Python<'py>, bone: usize) -> PyResult<Array<'py>> {
        Ok(vectors(py, &self.bone(bone)?.translations))
    }

    fn pose<'py>(&self, py: Python<'py>, skeleton: &PySkeleton, frame: f64) -> (Array<'py>, Array<'py>, Array<'py>) {
        let pose = pose(&skeleton.0, self.source.motion(), frame);
        (vectors(py, &pose.heads), vectors(py, &pose.tails), quaternions(py, &pose.rotations))
    }

    fn resampled(&self, py: Python<'_>, rate_hz: f64) -> PyResult<Self> {
        let motion =
            py.detach(|| self.source.motion().resampled(rate_hz)).map_err(|error| errors::parameter(&error))?;
        Ok(Self {
            source: Arc::new(Source::new(motion)),
            names: self.names.clone(),
            skeleton: Arc::clone(&self.skeleton),
        })
    }

    #[pyo3(signature = (names, axes, scale, *, orders=None))]
    fn in_rest_axes(
        &self,
        py: Python<'_>,
        names: Vec<Option<String>>,
        axes: PyReadonlyArray2<'_, f64>,
        scale: f64,
        orders: Option<Vec<Option<String>>>,
    ) -> PyResult<Self> {
        let axes = read_quaternions("axes", &axes)?;
        one_per_bone("axes", axes.len(), names.len())?;
        let orders = orders.unwrap_or_else(|| vec![None; names.len()]);
        one_per_bone("orders", orders.len(), names.len())?;
        let own: HashMap<&str, usize> =
            self.names.iter().enumerate().map(|(index, name)| (name.as_str(), index)).collect();
        let host: Vec<RestAxes> = (names.iter().zip(axes).zip(orders))
            .map(|((name, axes), order)| {
                let order = order.map(|order| order.parse::<EulerOrder>()).transpose();
                let bone = name.as_deref().and_then(|name| own.get(name).copied());
                Ok(RestAxes { bone, axes, order: order.map_err(|error| errors::parameter(&error))? })
            })
            .collect::<PyResult<_>>()?;
        let motion = py.detach(|| self.source.motion().in_rest_axes(&self.skeleton, &host, scale));
        let names = names.into_iter().map(Option::unwrap_or_default).collect();
        Ok(Self { source: Arc::new(Source::new(motion)), names, skeleton: Arc::clone(&self.skeleton) })
    }

    fn __repr__(&self) -> String {
        let motion = self.source.motion();
        format!("<Motion: {} bones, {} frames>", motion.bones.len(), motion.frame_count)
    }
}
