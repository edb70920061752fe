//! `motion_theater.Track` and `motion_theater.Filter`.

use std::sync::Arc;

use motion_theater_core::combine::{Alignment, KeySpacing, Span};
use motion_theater_core::sample::Sampling;
use motion_theater_core::stack::{Entry, FilterEntry, Track};
use motion_theater_core::ParameterError;
use pyo3::prelude::*;

use crate::errors;
use crate::filters;
use crate::motion::PyMotion;

/// A clip on some bones, with its cut, scale and blend.
#[pyclass(name = "Track", module = "motion_theater", frozen)]
pub struct PyTrack(Track);

/// A filter on some bones.
#[pyclass(name = "Filter", module = "motion_theater", frozen)]
pub struct PyFilter(FilterEntry);

/// Either of them, as an argument.
#[derive(FromPyObject)]
pub enum AnyEntry<'py> {
    Track(PyRef<'py, PyTrack>),
    Filter(PyRef<'py, PyFilter>),
}

impl AnyEntry<'_> {
    pub fn entry(&self) -> Entry {
        match self {
            Self::Track(track) => Entry::Track(track.0.clone()),
            Self::Filter(filter) => Entry::Filter(filter.0.clone()),
        }
    }
}

fn one_of<T: Copy>(name: &str, choices: &[(&str, T)]) -> PyResult<T> {
    let names = || choices.iter().map(|(name, _)| *name).collect::<Vec<_>>().join(" or ");
    choices
        .iter()
        .find_map(|(choice, value)| (*choice == name).then_some(*value))
        .ok_or_else(|| errors::parameter(&ParameterError(format!("expected {}, found `{name}`", names()))))
}

#[pymethods]
impl PyTrack {
    #[new]
    #[pyo3(signature = (
        motion, *, label=String::new(), bones=None, cut_start=None, cut_end=None, scale_start=None, scale_end=None,
        blend_depth=None, preserve=false, preserve_rotation="HEADING", preserve_height=false, discard=false,
        blend="SLERP", sampling="LINEAR", keys="FRAMES", rate_hz=None
    ))]
    #[allow(clippy::too_many_arguments, clippy::fn_params_excessive_bools)] // keyword-only in Python
    fn new(
        motion: &PyMotion,
        label: String,
        bones: Option<Vec<usize>>,
        cut_start: Option<i64>,
        cut_end: Option<i64>,
        scale_start: Option<i64>,
        scale_end: Option<i64>,
        blend_depth: Option<u32>,
        preserve: bool,
        preserve_rotation: &str,
        preserve_height: bool,
        discard: bool,
        blend: &str,
        sampling: &str,
        keys: &str,
        rate_hz: Option<f64>,
    ) -> PyResult<Self> {
        let full_rotation = one_of(preserve_rotation, &[("HEADING", false), ("FULL", true)])?;
        Ok(Self(Track {
            source: Arc::clone(&motion.source),
            label,
            bones,
            cut: Span { start: cut_start, end: cut_end },
            scale: Span { start: scale_start, end: scale_end },
            blend_depth,
            preserve: preserve.then_some(Alignment { full_rotation, height: preserve_height }),
            discard,
            blend: blend.parse().map_err(|error: ParameterError| errors::parameter(&error))?,
            sampling: one_of(sampling, &[("LINEAR", Sampling::Linear), ("SMOOTH", Sampling::Smooth)])?,
            spacing: one_of(keys, &[("FRAMES", KeySpacing::Frames), ("SAMPLES", KeySpacing::Samples)])?,
            rate_hz,
        }))
    }
}

#[pymethods]
impl PyFilter {
    #[new]
    #[pyo3(signature = (*, kind, depth, label=String::new(), bones=None, channels="ROTATION"))]
    fn new(kind: &str, depth: usize, label: String, bones: Option<Vec<usize>>, channels: &str) -> PyResult<Self> {
        Ok(Self(FilterEntry {
            label,
            bones,
            kind: filters::kind(kind)?,
            depth: filters::depth(depth)?,
            channels: channels.parse().map_err(|error: ParameterError| errors::parameter(&error))?,
        }))
    }
}
