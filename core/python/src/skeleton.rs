//! `motion_theater.Skeleton`.

use std::sync::Arc;

use glam::DVec3;
use motion_theater_core::formats::asf::dof_word;
use motion_theater_core::Skeleton;
use numpy::PyArray2;
use pyo3::prelude::*;

use crate::arrays::{quaternions, vectors};

/// Names, hierarchy and rest pose, in the file's own axes and units. Parents come before children.
#[pyclass(name = "Skeleton", module = "motion_theater", frozen)]
pub struct PySkeleton(pub Arc<Skeleton>);

#[pymethods]
impl PySkeleton {
    #[getter]
    fn name(&self) -> &str {
        &self.0.name
    }

    #[getter]
    fn names(&self) -> Vec<String> {
        self.0.bones.iter().map(|bone| bone.name.clone()).collect()
    }

    #[getter]
    fn parents(&self) -> Vec<i64> {
        self.0.bones.iter().map(|bone| bone.parent.map_or(-1, |parent| parent as i64)).collect()
    }

    #[getter]
    fn heads<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray2<f64>> {
        vectors(py, &self.0.rest_heads())
    }

    #[getter]
    fn tails<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray2<f64>> {
        let tails: Vec<DVec3> =
            self.0.rest_heads().into_iter().zip(&self.0.bones).map(|(head, bone)| head + bone.tail).collect();
        vectors(py, &tails)
    }

    #[getter]
    fn axes<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray2<f64>> {
        let axes: Vec<_> = self.0.bones.iter().map(|bone| bone.axes).collect();
        quaternions(py, &axes)
    }

    #[getter]
    fn orders(&self) -> Vec<&'static str> {
        self.0.bones.iter().map(|bone| bone.order.name()).collect()
    }

    #[getter]
    fn dofs(&self) -> Vec<Vec<&'static str>> {
        self.0.bones.iter().map(|bone| bone.dofs.iter().map(|&dof| dof_word(dof)).collect()).collect()
    }

    #[getter]
    fn limits(&self) -> Vec<Vec<(f64, f64)>> {
        self.0.bones.iter().map(|bone| bone.limits.clone()).collect()
    }

    #[getter]
    fn up(&self) -> (f64, f64, f64) {
        self.0.up.into()
    }

    #[getter]
    fn unit_m(&self) -> f64 {
        self.0.unit.metres
    }

    #[getter]
    fn unit_reason(&self) -> &str {
        &self.0.unit.reason
    }

    #[getter]
    fn unit_is_certain(&self) -> bool {
        self.0.unit.is_certain
    }

    #[getter]
    fn height(&self) -> f64 {
        self.0.height()
    }

    fn __repr__(&self) -> String {
        format!("<Skeleton '{}': {} bones>", self.0.name, self.0.bones.len())
    }
}
