//! `motion_theater.LibraryClip`: one clip as the library knows it.

use std::collections::BTreeMap;
use std::ffi::OsString;

use motion_theater_library::catalogue::ClipRow;
use pyo3::prelude::*;

/// A clip as the library knows it.
#[pyclass(name = "LibraryClip", module = "motion_theater", frozen, get_all)]
pub struct PyLibraryClip {
    id: i64,
    path: OsString,
    name: String,
    folder: String,
    size: i64,
    modified_ns: i64,
    content_hash: Option<String>,
    format: String,
    frames: Option<i64>,
    first_frame: Option<i64>,
    rate_hz: Option<f64>,
    duration_s: Option<f64>,
    joints: Option<i64>,
    markers: Option<i64>,
    skeleton_fingerprint: Option<String>,
    height_m: Option<f64>,
    unit_m: Option<f64>,
    up: Option<String>,
    skeleton_path: Option<OsString>,
    skeleton_reason: Option<String>,
    subject: Option<String>,
    recorded_on: Option<String>,
    description: Option<String>,
    session_group: Option<String>,
    cleaned: Option<bool>,
    rating: u8,
    is_favourite: bool,
    used_at: Option<i64>,
    notices: Vec<String>,
    error: Option<String>,
    is_missing: bool,
    tags: Vec<String>,
    segments: Vec<(i64, i64)>,
    sources: BTreeMap<String, String>,
}

#[pymethods]
impl PyLibraryClip {
    fn __repr__(&self) -> String {
        format!("<LibraryClip {}: '{}'>", self.id, self.path.to_string_lossy())
    }
}

impl From<ClipRow> for PyLibraryClip {
    fn from(row: ClipRow) -> Self {
        let hex = |bytes: [u8; 32]| bytes.iter().map(|byte| format!("{byte:02x}")).collect();
        Self {
            id: row.id,
            path: row.path.into_os_string(),
            name: row.name,
            folder: row.folder,
            size: row.size,
            modified_ns: row.modified_ns,
            content_hash: row.content_hash.map(hex),
            format: row.format,
            frames: row.frames,
            first_frame: row.first_frame,
            rate_hz: row.rate_hz,
            duration_s: row.duration_s,
            joints: row.joints,
            markers: row.markers,
            skeleton_fingerprint: row.skeleton_fingerprint,
            height_m: row.height_m,
            unit_m: row.unit_m,
            up: row.up,
            skeleton_path: row.skeleton_path.map(Into::into),
            skeleton_reason: row.skeleton_reason,
            subject: row.subject,
            recorded_on: row.recorded_on,
            description: row.description,
            session_group: row.session_group,
            cleaned: row.cleaned,
            rating: row.rating,
            is_favourite: row.is_favourite,
            used_at: row.used_at,
            notices: row.notices,
            error: row.error,
            is_missing: row.is_missing,
            tags: row.tags,
            segments: row.segments,
            sources: row.sources.into_iter().collect(),
        }
    }
}
