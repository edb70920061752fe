//! `motion_theater.Sidecar`: what people say of a clip, in a small text beside it.

use std::ffi::OsString;
use std::path::PathBuf;

use motion_theater_core::ParameterError;
use motion_theater_library::sidecar::{cleaned, Field, SidecarFile};
use pyo3::prelude::*;
use pyo3::types::{PyBytes, PyDict};

use crate::errors;

/// A sidecar and where it is kept.
#[pyclass(name = "Sidecar", module = "motion_theater")]
pub struct PySidecar(SidecarFile);

impl From<SidecarFile> for PySidecar {
    fn from(file: SidecarFile) -> Self {
        Self(file)
    }
}

/// Opens a sidecar that is there.
#[pyfunction]
pub fn read_sidecar(py: Python<'_>, path: PathBuf) -> PyResult<PySidecar> {
    py.detach(|| SidecarFile::open(&path)).map(PySidecar).map_err(errors::sidecar)
}

/// Opens the sidecar beside a clip, or makes a new one with what the clip tells.
#[pyfunction]
pub fn sidecar_for(py: Python<'_>, clip_path: PathBuf) -> PyResult<PySidecar> {
    py.detach(|| SidecarFile::beside(&clip_path)).map(PySidecar).map_err(errors::sidecar)
}

/// What *Cleaned* says: yes, no, or nothing where it is empty.
#[pyfunction]
pub fn sidecar_cleaned(value: &str) -> PyResult<Option<bool>> {
    cleaned(value).map_err(|error| errors::sidecar(error.into()))
}

/// Returns the day and the name to write; those that Python knows where none are given, for it knows the time zone.
pub fn stamp_of(py: Python<'_>, today: Option<String>, who: Option<String>) -> PyResult<(String, String)> {
    let local_day =
        || py.import("datetime")?.getattr("date")?.call_method0("today")?.call_method0("isoformat")?.extract();
    // A system may know no name of the user.
    let name = || py.import("getpass").and_then(|module| module.call_method0("getuser")?.extract()).unwrap_or_default();
    Ok((today.map_or_else(local_day, Ok)?, who.unwrap_or_else(name)))
}

/// Returns the lines of some names.
pub fn fields(names: &[String]) -> PyResult<Vec<Field>> {
    names.iter().map(|name| field(name)).collect()
}

fn field(name: &str) -> PyResult<Field> {
    Field::of_name(name).ok_or_else(|| {
        let names = Field::ALL.map(Field::name).join(", ");
        errors::parameter(&ParameterError(format!("a sidecar has no field `{name}`: they are {names}")))
    })
}

/// Adds what this file has to the module.
pub fn add_to(module: &Bound<'_, PyModule>) -> PyResult<()> {
    let labels = PyDict::new(module.py());
    for field in Field::ALL {
        labels.set_item(field.name(), field.label())?;
    }
    module.add("SIDECAR_LABELS", labels)?;
    module.add_class::<PySidecar>()?;
    module.add_function(wrap_pyfunction!(read_sidecar, module)?)?;
    module.add_function(wrap_pyfunction!(sidecar_cleaned, module)?)?;
    module.add_function(wrap_pyfunction!(sidecar_for, module)?)
}

#[pymethods]
impl PySidecar {
    #[getter]
    fn path(&self) -> OsString {
        self.0.path().as_os_str().to_owned()
    }

    #[getter]
    fn is_on_disk(&self) -> bool {
        self.0.is_on_disk()
    }

    #[getter]
    fn is_edited(&self) -> bool {
        self.0.is_edited()
    }

    #[getter]
    fn fields<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let fields = PyDict::new(py);
        for field in Field::ALL {
            fields.set_item(field.name(), self.0.sidecar.get(field).unwrap_or_default())?;
        }
        Ok(fields)
    }

    #[getter]
    fn unknown(&self) -> Vec<String> {
        self.0.sidecar.unknown().map(str::to_owned).collect()
    }

    #[getter]
    fn faults(&self) -> Vec<String> {
        self.0.sidecar.faults()
    }

    fn set(&mut self, field: &str, value: &str) -> PyResult<()> {
        let known = self::field(field)?;
        self.0.sidecar.set(known, value).map_err(|error| errors::sidecar(error.into()))
    }

    #[pyo3(signature = (*, today=None, who=None))]
    fn stamp(&mut self, py: Python<'_>, today: Option<String>, who: Option<String>) -> PyResult<()> {
        let (today, who) = stamp_of(py, today, who)?;
        self.0.stamp(&today, &who).map_err(errors::sidecar)
    }

    fn save(&mut self, py: Python<'_>) -> PyResult<()> {
        py.detach(|| self.0.save()).map_err(errors::sidecar)
    }

    fn to_bytes<'py>(&self, py: Python<'py>) -> Bound<'py, PyBytes> {
        PyBytes::new(py, &self.0.sidecar.to_bytes())
    }

    fn __repr__(&self) -> String {
        format!("<Sidecar '{}'>", self.0.path().display())
    }
}
