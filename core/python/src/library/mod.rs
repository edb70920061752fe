//! `motion_theater.Library`: each method converts, releases the interpreter and calls the library's crate once.

mod clip;
mod edits;
mod figure;
mod preview;
mod scan;
mod search;
mod sidecar;

use std::collections::BTreeMap;
use std::ffi::OsString;
use std::path::PathBuf;
use std::sync::Arc;

use motion_theater_library::catalogue::Folder;
use motion_theater_library::{Library, LibraryError};
use numpy::{IntoPyArray, PyArray1, PyArray3};
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::errors;
use clip::PyLibraryClip;
use preview::PyPreview;
use scan::{PyScan, PyScanProgress};

/// A catalogue of clips in a file.
#[pyclass(name = "Library", module = "motion_theater", frozen)]
pub struct PyLibrary(Arc<Library>);

/// A folder of the library.
#[pyclass(name = "LibraryFolder", module = "motion_theater", frozen, get_all)]
pub struct PyLibraryFolder {
    path: OsString,
    clips: u32,
    broken: u32,
    missing: u32,
    scanned_at: Option<i64>,
}

/// Adds the classes and functions to the module.
pub fn add_to(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add_class::<PyLibrary>()?;
    module.add_class::<PyLibraryFolder>()?;
    module.add_class::<PyLibraryClip>()?;
    module.add_class::<PyScan>()?;
    module.add_class::<PyScanProgress>()?;
    module.add_class::<figure::PyFigure>()?;
    module.add_class::<preview::PyPreview>()?;
    module.add_function(wrap_pyfunction!(figure::load_figure, module)?)?;
    sidecar::add_to(module)
}

impl PyLibrary {
    /// Does something with the library while Python goes on.
    fn with<T: Send>(
        &self,
        py: Python<'_>,
        task: impl FnOnce(&Arc<Library>) -> Result<T, LibraryError> + Send,
    ) -> PyResult<T> {
        py.detach(|| task(&self.0)).map_err(errors::library)
    }
}

#[pymethods]
impl PyLibrary {
    #[new]
    fn new(py: Python<'_>, path: PathBuf) -> PyResult<Self> {
        py.detach(|| Library::open(&path)).map(|library| Self(Arc::new(library))).map_err(errors::library)
    }

    #[getter]
    fn path(&self) -> OsString {
        self.0.path().as_os_str().to_owned()
    }

    fn folders(&self, py: Python<'_>) -> PyResult<Vec<PyLibraryFolder>> {
        Ok(self.with(py, |library| library.folders())?.into_iter().map(PyLibraryFolder::from).collect())
    }

    fn add_folder(&self, py: Python<'_>, path: PathBuf) -> PyResult<()> {
        self.with(py, |library| library.add_folder(&path).map(drop))
    }

    fn remove_folder(&self, py: Python<'_>, path: PathBuf) -> PyResult<()> {
        self.with(py, |library| library.remove_folder(&path))
    }

    #[pyo3(signature = (folders=None, *, with_previews=true, jobs=None))]
    fn scan(
        &self,
        py: Python<'_>,
        folders: Option<Vec<PathBuf>>,
        with_previews: bool,
        jobs: Option<usize>,
    ) -> PyResult<PyScan> {
        self.with(py, |library| scan::start(library, folders, with_previews, jobs))
    }

    fn check(&self, py: Python<'_>) -> PyResult<Vec<String>> {
        self.with(py, |library| library.check())
    }

    fn count(&self, py: Python<'_>) -> PyResult<u32> {
        self.with(py, |library| library.count())
    }

    #[pyo3(signature = (query="", *, sort="name", descending=false))]
    fn search<'py>(
        &self,
        py: Python<'py>,
        query: &str,
        sort: &str,
        descending: bool,
    ) -> PyResult<Bound<'py, PyArray1<i64>>> {
        let (query, order) = search::understand(query, sort, descending)?;
        Ok(self.with(py, |library| library.search(&query, order))?.into_pyarray(py))
    }

    fn clips(&self, py: Python<'_>, ids: Vec<i64>) -> PyResult<Vec<PyLibraryClip>> {
        Ok(self.with(py, |library| library.clips(&ids))?.into_iter().map(PyLibraryClip::from).collect())
    }

    fn values(&self, py: Python<'_>, field: &str) -> PyResult<Vec<(String, u32)>> {
        self.with(py, |library| library.values(field))
    }

    fn edit(&self, py: Python<'_>, ids: Vec<i64>, fields: &Bound<'_, PyDict>) -> PyResult<()> {
        let edits = edits::read(fields)?;
        self.with(py, |library| library.edit(&ids, &edits))
    }

    #[pyo3(signature = (ids, *, add=Vec::new(), remove=Vec::new()))]
    fn tag(&self, py: Python<'_>, ids: Vec<i64>, add: Vec<String>, remove: Vec<String>) -> PyResult<()> {
        self.with(py, |library| library.tag(&ids, &add, &remove))
    }

    fn set_segments(&self, py: Python<'_>, id: i64, segments: Vec<(i64, i64)>) -> PyResult<()> {
        self.with(py, |library| library.set_segments(id, &segments))
    }

    #[pyo3(signature = (path, columns=None))]
    fn import_index(
        &self,
        py: Python<'_>,
        path: PathBuf,
        columns: Option<BTreeMap<String, String>>,
    ) -> PyResult<usize> {
        self.with(py, |library| library.import_index(&path, columns.as_ref()))
    }

    fn mark_used(&self, py: Python<'_>, id: i64) -> PyResult<()> {
        self.with(py, |library| library.mark_used(id))
    }

    fn sidecar(&self, py: Python<'_>, id: i64) -> PyResult<sidecar::PySidecar> {
        self.with(py, |library| library.sidecar(id)).map(sidecar::PySidecar::from)
    }

    #[pyo3(signature = (id, *, emptied=Vec::new(), today=None, who=None))]
    fn write_sidecar(
        &self,
        py: Python<'_>,
        id: i64,
        emptied: Vec<String>,
        today: Option<String>,
        who: Option<String>,
    ) -> PyResult<OsString> {
        let (emptied, (today, who)) = (sidecar::fields(&emptied)?, sidecar::stamp_of(py, today, who)?);
        Ok(self.with(py, |library| library.write_sidecar(id, &emptied, &today, &who))?.into_os_string())
    }

    #[pyo3(signature = (id, *, edited=Vec::new()))]
    fn read_sidecar(&self, py: Python<'_>, id: i64, edited: Vec<String>) -> PyResult<()> {
        let edited = sidecar::fields(&edited)?;
        self.with(py, |library| library.read_sidecar(id, &edited))
    }

    fn still<'py>(&self, py: Python<'py>, id: i64) -> PyResult<Option<Bound<'py, PyArray3<u8>>>> {
        let still = self.with(py, |library| library.still(id))?;
        still.map(|still| preview::picture(py, still)).transpose()
    }

    fn strip(&self, py: Python<'_>, id: i64) -> PyResult<Option<PyPreview>> {
        let strip = self.with(py, |library| library.strip(id))?;
        strip.map(|strip| PyPreview::new(py, strip)).transpose()
    }

    fn __repr__(&self) -> String {
        format!("<Library '{}'>", self.0.path().display())
    }
}

impl From<Folder> for PyLibraryFolder {
    fn from(folder: Folder) -> Self {
        Self {
            path: folder.path.into_os_string(),
            clips: folder.clips,
            broken: folder.broken,
            missing: folder.missing,
            scanned_at: folder.scanned_at,
        }
    }
}
