//! [`C3d`] -> [`Markers`].

use super::C3d;
use crate::markers::{scale, Analog, AnalogChannel, Markers, PointKind, Positions, Quality, RawSamples};
use std::collections::HashMap;

/// The parameters that list the points which are no positions, and what they are.
pub(super) const KINDS: [(&str, PointKind); 5] = [
    ("ANGLES", PointKind::Angle),
    ("FORCES", PointKind::Force),
    ("MOMENTS", PointKind::Moment),
    ("POWERS", PointKind::Power),
    ("SCALARS", PointKind::Scalar),
];

impl C3d {
    /// Returns the points over frames and, a sentence each, what the user should know.
    pub fn markers(&self) -> (Markers, Vec<String>) {
        let mut notices = self.notices();
        let layout = self.layout();
        notices.extend(self.notice_of_words());
        let mut names = self.texts("POINT", "LABELS");
        if names.len() < layout.point_count {
            notices.push(format!(
                "{} of {} points have no label",
                layout.point_count - names.len(),
                layout.point_count
            ));
        }
        names.resize(layout.point_count, String::new());
        let kinds = self.kinds(&names);
        let positions = Positions::recorded(self.frames.clone());
        let extents = scale::extents(&positions, &kinds);
        let first_text =
            |name| self.parameter("POINT", name).and_then(|parameter| parameter.texts().into_iter().next());
        let unit = scale::unit(&first_text("UNITS").unwrap_or_default(), "the file", extents);
        let stated_up = first_text("Y_SCREEN").and_then(|name| scale::axis_of(&name));
        let up = scale::up(stated_up.map(|axis| (axis, "`POINT:Y_SCREEN`")), extents);
        let markers = Markers {
            names,
            kinds,
            positions,
            quality: Quality::recorded(self.frames.clone()),
            first_frame: layout.first_frame,
            rate_hz: layout.rate_hz,
            unit,
            up,
            events: self.events(),
            analog: self.analog(),
        };
        (markers, notices)
    }

    /// Returns the analog signals, as they were recorded.
    pub fn analog(&self) -> Analog {
        let layout = self.layout();
        let is_unsigned = self.is_unsigned();
        // 16 bits with a sign end at 32,767: where samples go beyond, offsets have no sign either (BTS, with an offset of
        // -32,768 and samples of 32,768 in a file that says SIGNED).
        let raw = RawSamples::Recorded { frames: self.frames.clone(), is_unsigned };
        let is_beyond = || raw.iter().any(|number| number > f64::from(i16::MAX));
        let offsets = self.numbers("ANALOG", "OFFSET");
        let are_offsets_unsigned = offsets.iter().any(|offset| *offset < 0.0) && (is_unsigned || is_beyond());
        let general = self.parameter("ANALOG", "GEN_SCALE").and_then(|parameter| parameter.number());
        let mut texts = ["LABELS", "DESCRIPTIONS", "UNITS"].map(|name| self.texts("ANALOG", name).into_iter());
        let mut numbers = [offsets, self.numbers("ANALOG", "SCALE")].map(Vec::into_iter);
        let channels = (0..layout.channel_count).map(|_| {
            let [name, description, unit] = texts.each_mut().map(|texts| texts.next().unwrap_or_default());
            let [offset, scale] = numbers.each_mut().map(|numbers| numbers.next().filter(|number| number.is_finite()));
            let offset = offset.unwrap_or(0.0);
            let offset = if are_offsets_unsigned && offset < 0.0 { offset + 65536.0 } else { offset };
            AnalogChannel { name, description, unit, offset, scale: scale.unwrap_or(1.0) }
        });
        let stated = self.parameter("ANALOG", "RATE").and_then(super::layout::rate);
        let by_frames = layout.rate_hz.map(|rate| rate * layout.samples_per_frame as f64);
        Analog {
            channels: channels.collect(),
            samples_per_frame: layout.samples_per_frame,
            rate_hz: stated.or(by_frames),
            general_scale: general.filter(|scale| scale.is_finite()).unwrap_or(1.0),
            raw,
        }
    }

    /// Returns what is odd in the words for cameras and residual, looking at some frames.
    fn notice_of_words(&self) -> Option<String> {
        const LOOKS: usize = 4;
        let frames = &self.frames;
        let (point_count, frame_count) = (frames.point_count(), frames.frame_count());
        let places = |step| {
            let frames = (0..frame_count).step_by(step);
            frames.flat_map(|frame| (0..point_count).map(move |point| (point, frame)))
        };
        let step = frame_count.div_ceil(LOOKS).max(1);
        let is_seen = |(point, frame)| frames.position(point, frame).is_some();
        if places(step).any(|(point, frame)| frames.has_odd_word(point, frame)) {
            let what = "The file has other numbers where cameras and residuals should be";
            return Some(format!("{what}: all samples but those with a negative number are taken as seen"));
        }
        let is_nothing_seen = places(1).next().is_some() && !places(step).any(is_seen) && !places(1).any(is_seen);
        let nothing = "All samples of all markers are marked as not seen: there is nothing to show";
        is_nothing_seen.then(|| nothing.to_owned())
    }

    /// Returns whether integer samples of analog channels have no sign.
    pub(super) fn is_unsigned(&self) -> bool {
        let format = self.parameter("ANALOG", "FORMAT");
        let is_unsigned = |text: &String| text.eq_ignore_ascii_case("UNSIGNED");
        format.and_then(|format| format.texts().into_iter().next()).is_some_and(|text| is_unsigned(&text))
    }

    /// Returns what the points of these names are.
    fn kinds(&self, names: &[String]) -> Vec<PointKind> {
        let mut known: HashMap<String, PointKind> = HashMap::new();
        for (parameter, kind) in KINDS {
            known.extend(self.texts("POINT", parameter).into_iter().map(|name| (name, kind)));
        }
        if known.is_empty() {
            return vec![PointKind::Position; names.len()];
        }
        let kind_of = |name: &String| known.get(name).copied().unwrap_or_default();
        names.iter().map(kind_of).collect()
    }
}
