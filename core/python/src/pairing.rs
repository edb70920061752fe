//! Which skeleton belongs to a motion: `skeletons_for`, `default_skeleton`.

use std::io::Read;
use std::path::PathBuf;
use std::sync::Arc;

use motion_theater_core::formats::amc::skeleton_hint;
use motion_theater_core::pairing::{
    default_skeleton as core_default, skeletons_for as core_skeletons_for, Candidate, Known, DEFAULT_SKELETON_ASF,
    DEFAULT_SKELETON_NOTICE,
};
use pyo3::prelude::*;

use crate::errors;
use crate::skeleton::PySkeleton;

/// As much of a motion file as may stand before its first frame.
const HEAD_BYTES: u64 = 1 << 16;

/// A skeleton file that may belong to a motion, and why.
#[pyclass(name = "SkeletonCandidate", module = "motion_theater", frozen, get_all)]
pub struct PySkeletonCandidate {
    path: String,
    reason: String,
}

#[pymethods]
impl PySkeletonCandidate {
    fn __repr__(&self) -> String {
        format!("<SkeletonCandidate '{}': {}>", self.path, self.reason)
    }
}

impl From<Candidate> for PySkeletonCandidate {
    fn from(candidate: Candidate) -> Self {
        Self { path: candidate.path.display().to_string(), reason: candidate.reason.to_string() }
    }
}

/// The skeleton files that may belong to a motion file, best first.
#[pyfunction]
#[pyo3(signature = (path, *, chosen=Vec::new(), others=Vec::new()), text_signature = "(path, *, chosen=(), others=())")]
pub fn skeletons_for(
    py: Python<'_>,
    path: PathBuf,
    chosen: Vec<PathBuf>,
    others: Vec<PathBuf>,
) -> PyResult<Vec<PySkeletonCandidate>> {
    let found = py.detach(|| {
        let mut head = Vec::new();
        std::fs::File::open(&path)?.take(HEAD_BYTES).read_to_end(&mut head)?;
        let known = Known { chosen: &chosen, others: &others };
        Ok::<_, std::io::Error>(core_skeletons_for(&path, skeleton_hint(&head).as_deref(), known))
    });
    Ok(found.map_err(|error| errors::io(&path, &error))?.into_iter().map(PySkeletonCandidate::from).collect())
}

/// The skeleton that stands in where a motion's own is not to be found.
#[pyfunction]
pub fn default_skeleton() -> PySkeleton {
    PySkeleton(Arc::new(core_default().clone()))
}

/// Adds what this file has to the module.
pub fn add_to(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add("DEFAULT_SKELETON_ASF", DEFAULT_SKELETON_ASF)?;
    module.add("DEFAULT_SKELETON_NOTICE", DEFAULT_SKELETON_NOTICE)?;
    module.add_class::<PySkeletonCandidate>()?;
    module.add_function(wrap_pyfunction!(skeletons_for, module)?)?;
    module.add_function(wrap_pyfunction!(default_skeleton, module)?)
}
