//! `motion_theater.Clip`, `read` and `read_bytes`.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use motion_theater_core::formats::c3d::ParameterType;
use motion_theater_core::read::{read_bytes as read_from_bytes, read_path, Clip, Format};
use motion_theater_core::{ParameterError, ReadError, Skeleton};
use pyo3::prelude::*;
use pyo3::sync::PyOnceLock;
use pyo3::types::{PyBytes, PyDict};

use crate::errors;
use crate::markers::{encoding, PyMarkers};
use crate::motion::PyMotion;
use crate::skeleton::PySkeleton;

/// What one file holds.
#[pyclass(name = "Clip", module = "motion_theater", frozen)]
pub struct PyClip {
    path: String,
    names: Vec<String>,
    clip: Clip,
    skeleton: Option<Py<PySkeleton>>,
    motion: Option<Py<PyMotion>>,
    markers: PyOnceLock<Py<PyMarkers>>,
}

/// Read any supported file. Raises `ParseError`, `MisfitError` or `OSError`.
#[pyfunction]
#[pyo3(signature = (path, *, skeleton=None))]
pub fn read(py: Python<'_>, path: PathBuf, skeleton: Option<&PySkeleton>) -> PyResult<PyClip> {
    PyClip::new(py, &path, skeleton, |skeleton| read_path(&path, skeleton))
}

/// Read a file that is already in memory; `name` stands for its path in messages and gives its extension.
#[pyfunction]
#[pyo3(signature = (data, *, name, skeleton=None))]
pub fn read_bytes(py: Python<'_>, data: &[u8], name: PathBuf, skeleton: Option<&PySkeleton>) -> PyResult<PyClip> {
    PyClip::new(py, &name, skeleton, |skeleton| read_from_bytes(data, &name, skeleton))
}

/// The format of a file by how it begins, or else by its extension.
#[pyfunction]
pub fn format_of(path: PathBuf) -> PyResult<Option<&'static str>> {
    let format = Format::of_path(&path).map_err(|error| errors::io(&path, &error))?;
    Ok(format.map(Format::extension))
}

impl PyClip {
    fn new(
        py: Python<'_>,
        path: &Path,
        skeleton: Option<&PySkeleton>,
        read: impl Fn(Option<&Skeleton>) -> Result<Clip, ReadError> + Send + Sync,
    ) -> PyResult<Self> {
        let given = skeleton.map(|skeleton| Arc::clone(&skeleton.0));
        let mut clip = py.detach(|| read(given.as_deref())).map_err(errors::read)?;
        // Markers are named when they are first asked for.
        let names = if clip.has_markers() { Vec::new() } else { clip.names() };
        let own = clip.skeleton.take().map(Arc::new);
        let motion = match (clip.motion.take(), own.as_ref().or(given.as_ref())) {
            (Some(motion), Some(skeleton)) => Some(Py::new(py, PyMotion::new(motion, Arc::clone(skeleton)))?),
            _ => None,
        };
        let skeleton = own.map(|skeleton| Py::new(py, PySkeleton(skeleton))).transpose()?;
        Ok(Self { path: path.display().to_string(), names, clip, skeleton, motion, markers: PyOnceLock::new() })
    }
}

#[pymethods]
impl PyClip {
    #[getter]
    fn path(&self) -> &str {
        &self.path
    }

    #[getter]
    fn format(&self) -> &'static str {
        self.clip.format.extension()
    }

    #[getter]
    fn notices(&self, py: Python<'_>) -> Vec<String> {
        py.detach(|| self.clip.notices().iter().cloned().chain(self.clip.facing_notice()).collect())
    }

    #[getter]
    fn names(&self, py: Python<'_>) -> Vec<String> {
        let of_markers = py.detach(|| self.clip.markers()).map(|markers| markers.names.clone());
        of_markers.unwrap_or_else(|| self.names.clone())
    }

    #[getter]
    fn frames(&self) -> usize {
        self.clip.frame_count()
    }

    #[getter]
    fn first_frame(&self) -> i64 {
        self.clip.first_frame()
    }

    #[getter]
    fn rate_hz(&self) -> Option<f64> {
        self.clip.rate_hz()
    }

    #[getter]
    fn skeleton(&self, py: Python<'_>) -> Option<Py<PySkeleton>> {
        self.skeleton.as_ref().map(|skeleton| skeleton.clone_ref(py))
    }

    #[getter]
    fn motion(&self, py: Python<'_>) -> Option<Py<PyMotion>> {
        self.motion.as_ref().map(|motion| motion.clone_ref(py))
    }

    #[getter]
    fn markers(&self, py: Python<'_>) -> PyResult<Option<Py<PyMarkers>>> {
        let Some(markers) = py.detach(|| self.clip.markers()) else { return Ok(None) };
        let made = self.markers.get_or_try_init(py, || Py::new(py, PyMarkers(Arc::clone(markers))))?;
        Ok(Some(made.clone_ref(py)))
    }

    #[getter]
    fn parameters<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let parameters = PyDict::new(py);
        let Some(c3d) = &self.clip.c3d else { return Ok(parameters) };
        for parameter in c3d.parameters() {
            let group = c3d.groups().find(|group| group.id == parameter.group);
            let group = group.map_or_else(|| parameter.group.to_string(), |group| text(group.name));
            let key = format!("{group}:{}", text(parameter.name));
            if parameters.contains(&key)? {
                continue;
            }
            if parameter.kind == ParameterType::Text {
                parameters.set_item(key, parameter.texts())?;
            } else {
                parameters.set_item(key, parameter.numbers())?;
            }
        }
        Ok(parameters)
    }

    #[getter]
    fn skeleton_hint(&self) -> Option<&str> {
        self.clip.amc.as_ref()?.header.skeleton_hint.as_deref()
    }

    fn bind(&self, py: Python<'_>, skeleton: &PySkeleton) -> PyResult<PyMotion> {
        let given = Arc::clone(&skeleton.0);
        let (motion, _) = py.detach(|| self.clip.bind(&given)).map_err(|error| errors::misfit(&self.path, error))?;
        Ok(PyMotion::new(motion, given))
    }

    #[pyo3(signature = (*, processor=None, storage=None))]
    fn to_bytes<'py>(
        &self,
        py: Python<'py>,
        processor: Option<&str>,
        storage: Option<&str>,
    ) -> PyResult<Bound<'py, PyBytes>> {
        let bytes = match (&self.clip.c3d, processor, storage) {
            (_, None, None) => py.detach(|| self.clip.to_bytes()),
            (Some(c3d), processor, storage) => {
                let encoding = encoding(processor.unwrap_or("INTEL"), storage.unwrap_or("FLOAT"))?;
                py.detach(|| c3d.encoded(encoding)).map_err(|error| errors::parameter(&error))?
            }
            (None, ..) => {
                let why = "only a C3D has a processor and a storage".to_owned();
                return Err(errors::parameter(&ParameterError(why)));
            }
        };
        Ok(PyBytes::new(py, &bytes))
    }

    fn skeleton_to_bytes<'py>(&self, py: Python<'py>) -> Bound<'py, PyBytes> {
        PyBytes::new(py, &self.clip.skeleton_to_bytes())
    }

    fn __repr__(&self, py: Python<'_>) -> String {
        let what = if self.clip.has_markers() { "markers" } else { "bones" };
        format!("<Clip '{}': {} {what}, {} frames>", self.path, self.names(py).len(), self.frames())
    }
}

/// Names in a C3D are ASCII, nearly always.
fn text(bytes: &[u8]) -> String {
    String::from_utf8_lossy(bytes).into_owned()
}
