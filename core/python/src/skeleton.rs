//! `motion_theater.Skeleton`.

use std::sync::Arc;

use glam::{DQuat, DVec3};
use motion_theater_core::formats::asf::dof_word;
use motion_theater_core::{Bone, Dof, EulerOrder, LengthUnit, Skeleton};
use numpy::{PyArray2, PyReadonlyArray2};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

use crate::arrays::{one_per_bone, quaternions, read_quaternions, read_vectors, vectors};
use crate::errors;

/// Returns the degree of freedom that a word stands for.
fn dof(word: &str) -> PyResult<Dof> {
    let all = (0..3).flat_map(|axis| [Dof::Translate(axis), Dof::Rotate(axis)]).chain([Dof::Length]);
    all.into_iter()
        .find(|dof| dof_word(*dof) == word)
        .ok_or_else(|| PyValueError::new_err(format!("dofs: `{word}` is none of tx, ty, tz, rx, ry, rz, l")))
}

/// Names, hierarchy and rest pose, in the file's own axes and units. Parents come before children.
#[pyclass(name = "Skeleton", module = "motion_theater", frozen)]
pub struct PySkeleton(pub Arc<Skeleton>);

#[pymethods]
impl PySkeleton {
    #[new]
    #[pyo3(signature = (names, *, parents, heads, tails, axes=None, orders=None, dofs=None, up=(0.0, 1.0, 0.0), unit_m=0.01, name=String::new()))]
    #[allow(clippy::too_many_arguments)] // keyword-only in Python, each named at the call
    fn new(
        names: Vec<String>,
        parents: Vec<i64>,
        heads: PyReadonlyArray2<'_, f64>,
        tails: PyReadonlyArray2<'_, f64>,
        axes: Option<PyReadonlyArray2<'_, f64>>,
        orders: Option<Vec<String>>,
        dofs: Option<Vec<Vec<String>>>,
        up: (f64, f64, f64),
        unit_m: f64,
        name: String,
    ) -> PyResult<Self> {
        let count = names.len();
        let (heads, tails) = (read_vectors("heads", &heads)?, read_vectors("tails", &tails)?);
        let axes = axes.map(|axes| read_quaternions("axes", &axes)).transpose()?;
        let axes = axes.unwrap_or_else(|| vec![DQuat::IDENTITY; count]);
        let orders = orders.unwrap_or_else(|| vec!["XYZ".into(); count]);
        let dofs = dofs.unwrap_or_else(|| vec![Vec::new(); count]);
        for (what, found) in [
            ("parents", parents.len()),
            ("heads", heads.len()),
            ("tails", tails.len()),
            ("axes", axes.len()),
            ("orders", orders.len()),
            ("dofs", dofs.len()),
        ] {
            one_per_bone(what, found, count)?;
        }
        let mut bones = Vec::with_capacity(count);
        for (index, name) in names.into_iter().enumerate() {
            let parent = usize::try_from(parents[index]).ok();
            if parent.is_some_and(|parent| parent >= index) {
                return Err(PyValueError::new_err(format!("parents: `{name}` comes before its parent")));
            }
            let order: Result<EulerOrder, _> = orders[index].parse();
            bones.push(Bone {
                name,
                parent,
                offset: heads[index] - parent.map_or(DVec3::ZERO, |parent| heads[parent]),
                tail: tails[index] - heads[index],
                axes: axes[index].normalize(),
                order: order.map_err(|error| errors::parameter(&error))?,
                dofs: dofs[index].iter().map(|word| dof(word)).collect::<PyResult<_>>()?,
                limits: Vec::new(),
            });
        }
        let unit = LengthUnit { metres: unit_m, reason: "as given".to_owned(), is_certain: true };
        Ok(Self(Arc::new(Skeleton { name, bones, up: up.into(), unit })))
    }

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
