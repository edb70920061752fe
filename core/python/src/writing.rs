//! `motion_theater.to_bvh` and `to_acclaim`: a skeleton and a motion of it as the bytes of files.

use std::sync::Arc;

use motion_theater_core::formats::amc::{with_dofs_for, Amc};
use motion_theater_core::formats::asf::Asf;
use motion_theater_core::formats::bvh::Bvh;
use motion_theater_core::formats::AngleUnit;
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::PyBytes;

use crate::motion::PyMotion;
use crate::skeleton::PySkeleton;

fn check(skeleton: &PySkeleton, motion: &PyMotion) -> PyResult<()> {
    if Arc::ptr_eq(&skeleton.0, &motion.skeleton) || skeleton.0.bones.len() == motion.names.len() {
        Ok(())
    } else {
        Err(PyValueError::new_err("the motion has other bones than the skeleton"))
    }
}

/// A BVH file.
#[pyfunction]
pub fn to_bvh<'py>(py: Python<'py>, skeleton: &PySkeleton, motion: &PyMotion) -> PyResult<Bound<'py, PyBytes>> {
    check(skeleton, motion)?;
    let bytes = py.detach(|| {
        let motion = motion.source.motion();
        Bvh::from_motion(&with_dofs_for(&skeleton.0, motion), motion).to_bytes()
    });
    Ok(PyBytes::new(py, &bytes))
}

/// An ASF and an AMC file that belong together.
#[pyfunction]
pub fn to_acclaim<'py>(
    py: Python<'py>,
    skeleton: &PySkeleton,
    motion: &PyMotion,
) -> PyResult<(Bound<'py, PyBytes>, Bound<'py, PyBytes>)> {
    check(skeleton, motion)?;
    let (asf, amc) = py.detach(|| {
        let motion = motion.source.motion();
        let needed = with_dofs_for(&skeleton.0, motion);
        let amc = Amc::from_motion(&needed, motion, AngleUnit::Degrees).to_bytes();
        (Asf::from_skeleton(&needed).to_bytes(), amc)
    });
    Ok((PyBytes::new(py, &asf), PyBytes::new(py, &amc)))
}
