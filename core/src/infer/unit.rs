//! How long a file's unit is: what makes the figure a person.

use super::body::Body;
use super::Answer;
use std::ops::RangeInclusive;

/// Heights that can be a person's, in metres.
const PERSON_M: RangeInclusive<f64> = 1.0..=2.2;

/// What a figure is scaled to where no unit makes it a person.
pub(crate) const TYPICAL_PERSON_M: f64 = 1.65;

/// A way to understand a file's lengths.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Reading {
    /// Metres per file unit.
    pub(crate) metres: f64,
    /// The unit's name in words.
    pub(crate) name: String,
}

impl Reading {
    /// Makes a reading.
    pub(crate) fn new(metres: f64, name: impl Into<String>) -> Self {
        Self { metres, name: name.into() }
    }

    /// Returns the first reading in which `height` is a person's, and the next one that differs from it.
    pub(crate) fn plausible(readings: &[Self], height: f64) -> Option<(&Self, Option<&Self>)> {
        let mut plausible = readings.iter().filter(|reading| PERSON_M.contains(&(height * reading.metres)));
        let first = plausible.next()?;
        // Centimetres / 0.01 and metres are the same: only readings that differ make a choice doubtful.
        Some((first, plausible.find(|other| (other.metres / first.metres - 1.0).abs() > 1e-9)))
    }
}

/// Units in which files are, and for the common ones between which heights a figure makes them certain. Nobody is as
/// tall as the public Acclaim data sets would have to be for an old millimetre file that was taken for inches.
const UNITS: [(f64, &str, Option<RangeInclusive<f64>>); 7] = [
    (0.01, "centimetres", Some(1.35..=2.05)),
    (1.0, "metres", Some(1.35..=2.05)),
    (0.0254, "inches", Some(1.35..=2.05)),
    (0.0254 / 0.45, "inches / 0.45, as in the public Acclaim data sets", Some(1.35..=1.85)),
    (0.001, "millimetres", Some(1.35..=2.05)),
    (0.1, "decimetres", Some(1.35..=2.05)),
    (0.3048, "feet", None),
];

/// Nobody moves up and down by more than this many times their own height.
const HIGHEST_JUMP: f64 = 1.0;

/// Works out the unit from the lengths of a body's bones. `rise` is how far its pelvis goes up and down.
pub(super) fn unit(body: Option<&Body>, rise: f64) -> Answer<f64> {
    let Some(body) = body.filter(|body| body.is_person()) else {
        let reason = "centimetres, as in most files: the joints are not a person's, or their names do not say so";
        return Answer::unsure(0.01, reason);
    };
    let height = body.stature();
    let distance = |reading: &Reading| (height * reading.metres / TYPICAL_PERSON_M).ln().abs();
    let mut readings = UNITS.map(|(metres, name, _)| Reading::new(metres, name));
    readings.sort_by(|a, b| distance(a).total_cmp(&distance(b)));
    let Some((reading, other)) = Reading::plausible(&readings, height) else {
        let reason = format!("no usual unit makes the figure a person: taken as {TYPICAL_PERSON_M:.2} m tall");
        return Answer::unsure(TYPICAL_PERSON_M / height, reason);
    };
    let metres = reading.metres;
    let reason = format!("{}: by its bones the figure is about {:.2} m tall", reading.name, height * metres);
    if let Some(other) = other {
        return Answer::unsure(metres, format!("{reason}; {} would be plausible too", other.name));
    }
    if rise > HIGHEST_JUMP * height {
        return Answer::unsure(metres, format!("{reason}, but it moves as if its positions had another unit"));
    }
    let sure = UNITS.into_iter().find(|(known, ..)| *known == metres).and_then(|(_, _, heights)| heights);
    if sure.is_some_and(|heights| heights.contains(&(height * metres))) {
        Answer::certain(metres, reason)
    } else {
        Answer::unsure(metres, reason)
    }
}
