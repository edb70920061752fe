//! `motion_theater.Markers` and what belongs to it.

use std::borrow::Cow;
use std::collections::HashMap;
use std::sync::Arc;

use glam::DVec3;
use motion_theater_core::formats::c3d::{C3d, Encoding, Processor, Storage};
use motion_theater_core::formats::{csm::Csm, trc::Trc};
use motion_theater_core::gaps::{self, Fill, Gap};
use motion_theater_core::markers::{
    Analog, AnalogChannel, Event, Markers, PointKind, Positions, Quality, RawSamples, UpAxis,
};
use motion_theater_core::{LengthUnit, ParameterError};
use numpy::ndarray::{Array2, Array3};
use numpy::{Element, IntoPyArray, PyArray1, PyArray2, PyReadonlyArray1, PyReadonlyArray3, PyUntypedArrayMethods};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::PyBytes;

use crate::inference::{direction, PyAnswer};
use crate::{errors, filters};

/// Named points over frames.
#[pyclass(name = "Markers", module = "motion_theater", frozen)]
pub struct PyMarkers(pub Arc<Markers>);

/// Something that happened at a moment.
#[pyclass(name = "Event", module = "motion_theater", frozen, get_all)]
pub struct PyEvent {
    label: String,
    context: String,
    subject: String,
    time_s: f64,
    frame: Option<f64>,
}

/// One signal that was recorded beside the markers.
#[pyclass(name = "AnalogChannel", module = "motion_theater", frozen)]
pub struct PyAnalogChannel {
    markers: Arc<Markers>,
    channel: usize,
}

const KINDS: [(PointKind, &str); 6] = [
    (PointKind::Position, "POSITION"),
    (PointKind::Angle, "ANGLE"),
    (PointKind::Force, "FORCE"),
    (PointKind::Moment, "MOMENT"),
    (PointKind::Power, "POWER"),
    (PointKind::Scalar, "SCALAR"),
];

impl PyMarkers {
    fn changed(&self, change: impl FnOnce(&mut Markers)) -> Self {
        let mut markers = Markers::clone(&self.0);
        change(&mut markers);
        Self(Arc::new(markers))
    }

    /// Returns the markers of these names, or all; `NotFound` names those that are none.
    fn chosen(&self, names: Option<Vec<String>>) -> PyResult<Vec<usize>> {
        let Some(names) = names else { return Ok((0..self.0.count()).collect()) };
        let own: HashMap<&str, usize> =
            self.0.names.iter().enumerate().rev().map(|(index, name)| (name.as_str(), index)).collect();
        let find = |name: &String| {
            let found = own.get(name.as_str()).copied();
            found.ok_or_else(|| errors::parameter(&ParameterError(format!("there is no marker `{name}`"))))
        };
        names.iter().map(find).collect()
    }

    /// Shapes one value per sample as (markers, frames); (0, 0) where there are none.
    fn per_sample<'py, T: Element>(&self, py: Python<'py>, values: Vec<T>) -> PyResult<Bound<'py, PyArray2<T>>> {
        let shape = if values.is_empty() { (0, 0) } else { (self.0.count(), self.0.frame_count()) };
        Ok(Array2::from_shape_vec(shape, values).map_err(shape_error)?.into_pyarray(py))
    }
}

/// Marker, first frame and last frame of a gap.
type PyGap = (usize, usize, usize);

/// Name, description, unit and samples of an analog channel.
type GivenChannel<'py> = (String, String, String, PyReadonlyArray1<'py, f64>);

/// An event as a caller gives it.
#[derive(FromPyObject)]
enum GivenEvent {
    /// Label and time.
    #[pyo3(transparent)]
    Short((String, f64)),
    /// Label, time, context and subject.
    #[pyo3(transparent)]
    Full((String, f64, String, String)),
}

impl GivenEvent {
    fn into_event(self) -> Event {
        match self {
            Self::Short((label, time_s)) => Event { label, time_s, ..Event::default() },
            Self::Full((label, time_s, context, subject)) => Event { label, time_s, context, subject },
        }
    }
}

#[pymethods]
impl PyMarkers {
    #[new]
    #[pyo3(signature = (names, positions, *, rate_hz=None, first_frame=1, unit_m=1.0, up=(0.0, 0.0, 1.0), events=Vec::new()))]
    fn new(
        names: Vec<String>,
        positions: PyReadonlyArray3<'_, f64>,
        rate_hz: Option<f64>,
        first_frame: i64,
        unit_m: f64,
        up: (f64, f64, f64),
        events: Vec<GivenEvent>,
    ) -> PyResult<Self> {
        let shape = positions.shape();
        if shape[0] != names.len() || shape[2] != 3 {
            let expected = format!("positions: expected ({}, frames, 3), found {shape:?}", names.len());
            return Err(PyValueError::new_err(expected));
        }
        if !(unit_m.is_finite() && unit_m > 0.0) || rate_hz.is_some_and(|rate| !(rate.is_finite() && rate > 0.0)) {
            let why = "the unit and the rate are numbers above 0".to_owned();
            return Err(errors::parameter(&ParameterError(why)));
        }
        let axis = DVec3::from(up);
        if !axis.abs_diff_eq(axis.round(), 1e-9) || (axis.length() - 1.0).abs() > 1e-9 {
            return Err(errors::parameter(&ParameterError("up is one of the six axes".to_owned())));
        }
        let frame_count = shape[1];
        let given = "as given";
        Ok(Self(Arc::new(Markers {
            kinds: vec![PointKind::Position; names.len()],
            names,
            positions: Positions::of_f64(positions.as_slice()?.to_vec(), frame_count),
            quality: Quality::default(),
            first_frame,
            rate_hz,
            unit: LengthUnit { metres: unit_m, reason: given.to_owned(), is_certain: true },
            up: UpAxis { axis: axis.round(), reason: given.to_owned(), is_certain: true },
            events: events.into_iter().map(GivenEvent::into_event).collect(),
            analog: Analog::default(),
        })))
    }

    #[getter]
    fn names(&self) -> Vec<String> {
        self.0.names.clone()
    }

    #[getter]
    fn kinds(&self) -> Vec<&'static str> {
        let name = |kind: &PointKind| KINDS.iter().find(|(known, _)| known == kind).map_or("", |(_, name)| name);
        self.0.kinds.iter().map(name).collect()
    }

    #[getter]
    fn frames(&self) -> usize {
        self.0.frame_count()
    }

    #[getter]
    fn first_frame(&self) -> i64 {
        self.0.first_frame
    }

    #[getter]
    fn rate_hz(&self) -> Option<f64> {
        self.0.rate_hz
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
    fn up(&self) -> (f64, f64, f64) {
        self.0.up.axis.into()
    }

    #[getter]
    fn up_reason(&self) -> &str {
        &self.0.up.reason
    }

    #[getter]
    fn up_is_certain(&self) -> bool {
        self.0.up.is_certain
    }

    #[getter]
    fn positions<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let shape = (self.0.count(), self.0.frame_count(), 3);
        let positions = &self.0.positions;
        let single = py.detach(|| positions.to_f32().map(Cow::into_owned));
        if let Some(values) = single {
            return Ok(Array3::from_shape_vec(shape, values).map_err(shape_error)?.into_pyarray(py).into_any());
        }
        let values = positions.as_f64().unwrap_or_default().to_vec();
        Ok(Array3::from_shape_vec(shape, values).map_err(shape_error)?.into_pyarray(py).into_any())
    }

    #[getter]
    fn valid<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<bool>>> {
        let shape = (self.0.count(), self.0.frame_count());
        Ok(Array2::from_shape_vec(shape, self.0.positions.valid()).map_err(shape_error)?.into_pyarray(py))
    }

    #[getter]
    fn residuals<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<f32>>> {
        self.per_sample(py, self.0.quality.residuals())
    }

    #[getter]
    fn cameras<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<u8>>> {
        self.per_sample(py, self.0.quality.cameras())
    }

    #[getter]
    fn events(&self) -> Vec<PyEvent> {
        let event = |event: &Event| PyEvent {
            label: event.label.clone(),
            context: event.context.clone(),
            subject: event.subject.clone(),
            time_s: event.time_s,
            frame: self.0.frame_of(event),
        };
        self.0.events.iter().map(event).collect()
    }

    #[getter]
    fn analog(&self) -> Vec<PyAnalogChannel> {
        let channel = |channel| PyAnalogChannel { markers: Arc::clone(&self.0), channel };
        (0..self.0.analog.channels.len()).map(channel).collect()
    }

    #[getter]
    fn analog_samples_per_frame(&self) -> usize {
        self.0.analog.samples_per_frame
    }

    fn facing(&self, py: Python<'_>) -> PyResult<Py<PyAnswer>> {
        direction(py, py.detach(|| self.0.facing()))
    }

    fn gaps(&self, py: Python<'_>) -> Vec<PyGap> {
        py.detach(|| gaps::find(&self.0.positions, self.0.count())).into_iter().map(as_tuple).collect()
    }

    #[pyo3(signature = (*, how, longest, markers=None))]
    fn filled(
        &self,
        py: Python<'_>,
        how: &str,
        longest: usize,
        markers: Option<Vec<String>>,
    ) -> PyResult<(Self, Vec<PyGap>)> {
        let how = match how {
            "LINEAR" => Fill::Linear,
            "CUBIC" => Fill::Cubic,
            "RIGID" => Fill::Rigid,
            other => {
                let why = format!("expected LINEAR, CUBIC or RIGID, found `{other}`");
                return Err(errors::parameter(&ParameterError(why)));
            }
        };
        let chosen = self.chosen(markers)?;
        let count = self.0.count();
        let mut filled = Vec::new();
        let changed = py.detach(|| {
            self.changed(|markers| filled = gaps::fill(&mut markers.positions, count, &chosen, how, longest))
        });
        Ok((changed, filled.into_iter().map(as_tuple).collect()))
    }

    #[pyo3(signature = (*, kind, depth, markers=None))]
    fn filtered(&self, py: Python<'_>, kind: &str, depth: usize, markers: Option<Vec<String>>) -> PyResult<Self> {
        let (kind, depth) = (filters::kind(kind)?, filters::depth(depth)?);
        let chosen = self.chosen(markers)?;
        Ok(py.detach(|| self.changed(|markers| markers.filter(&chosen, kind, depth))))
    }

    fn resampled(&self, py: Python<'_>, rate_hz: f64) -> PyResult<Self> {
        let changed = py.detach(|| self.0.resampled(rate_hz)).map_err(|error| errors::parameter(&error))?;
        Ok(Self(Arc::new(changed)))
    }

    fn with_analog(&self, channels: Vec<GivenChannel<'_>>, samples_per_frame: usize) -> PyResult<Self> {
        let expected = samples_per_frame.saturating_mul(self.0.frame_count());
        let mut described = Vec::with_capacity(channels.len());
        let mut signals = Vec::with_capacity(channels.len());
        for (name, description, unit, samples) in channels {
            let samples = samples.as_slice()?.to_vec();
            if samples.len() != expected || samples_per_frame == 0 {
                let why = format!("`{name}`: expected {expected} samples, found {}", samples.len());
                return Err(errors::parameter(&ParameterError(why)));
            }
            described.push(AnalogChannel { name, description, unit, offset: 0.0, scale: 1.0 });
            signals.push(samples);
        }
        let at_once = |at: usize| signals.iter().filter_map(move |samples| samples.get(at)).map(|value| *value as f32);
        let values = if signals.is_empty() { Vec::new() } else { (0..expected).flat_map(at_once).collect() };
        let rate_hz = self.0.rate_hz.map(|rate| rate * samples_per_frame as f64);
        let raw = RawSamples::Values(values);
        let analog = Analog { channels: described, samples_per_frame, rate_hz, raw, ..Analog::default() };
        Ok(self.changed(|markers| markers.analog = analog))
    }

    fn neighbours(&self, py: Python<'_>) -> Vec<(usize, usize)> {
        py.detach(|| gaps::neighbours(&self.0.positions, &self.0.kinds))
    }

    #[pyo3(signature = (extension, *, processor="INTEL", storage="FLOAT"))]
    fn to_bytes<'py>(
        &self,
        py: Python<'py>,
        extension: &str,
        processor: &str,
        storage: &str,
    ) -> PyResult<Bound<'py, PyBytes>> {
        let encoding = encoding(processor, storage)?;
        let bytes = py.detach(|| match extension {
            "c3d" => C3d::compose(&self.0, encoding),
            "csm" => Ok(Csm::of_markers(&self.0).to_bytes()),
            "trc" => Ok(Trc::of_markers(&self.0, "markers.trc").to_bytes()),
            other => Err(ParameterError(format!("expected c3d, csm or trc, found `{other}`"))),
        });
        Ok(PyBytes::new(py, &bytes.map_err(|error| errors::parameter(&error))?))
    }

    fn __repr__(&self) -> String {
        format!("<Markers: {} markers, {} frames>", self.0.count(), self.0.frame_count())
    }
}

#[pymethods]
impl PyEvent {
    fn __repr__(&self) -> String {
        format!("<Event '{}' at {} s>", self.label, self.time_s)
    }
}

#[pymethods]
impl PyAnalogChannel {
    #[getter]
    fn name(&self) -> &str {
        self.markers.analog.channels.get(self.channel).map_or("", |channel| &channel.name)
    }

    #[getter]
    fn description(&self) -> &str {
        self.markers.analog.channels.get(self.channel).map_or("", |channel| &channel.description)
    }

    #[getter]
    fn unit(&self) -> &str {
        self.markers.analog.channels.get(self.channel).map_or("", |channel| &channel.unit)
    }

    #[getter]
    fn rate_hz(&self) -> Option<f64> {
        self.markers.analog.rate_hz
    }

    #[getter]
    fn samples<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<f64>> {
        py.detach(|| self.markers.analog.samples(self.channel)).into_pyarray(py)
    }

    fn __repr__(&self) -> String {
        format!("<AnalogChannel '{}': {} samples>", self.name(), self.markers.analog.sample_count())
    }
}

/// Reads how a C3D is written.
pub fn encoding(processor: &str, storage: &str) -> PyResult<Encoding> {
    let processors = [("INTEL", Processor::Intel), ("DEC", Processor::Dec), ("MIPS", Processor::Mips)];
    let storages = [("INTEGER", Storage::Integer), ("FLOAT", Storage::Float)];
    let processor = processors.iter().find(|(name, _)| *name == processor).map(|(_, known)| *known);
    let storage = storages.iter().find(|(name, _)| *name == storage).map(|(_, known)| *known);
    let wrong = || errors::parameter(&ParameterError("expected INTEL, DEC or MIPS, and INTEGER or FLOAT".to_owned()));
    Ok(Encoding { processor: processor.ok_or_else(wrong)?, storage: storage.ok_or_else(wrong)? })
}

fn as_tuple(gap: Gap) -> (usize, usize, usize) {
    (gap.marker, gap.frames.start, gap.frames.end)
}

fn shape_error(error: numpy::ndarray::ShapeError) -> PyErr {
    PyValueError::new_err(error.to_string())
}
