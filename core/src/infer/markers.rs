//! Which way markers face: by their names, and by the way they walk.

use super::marker_names::{end, pairs, End, Region};
use super::stance::{nearest_axis, usual_facing, ALONG_AXIS, MOST_OF_THE_TIME, UPRIGHT};
use super::Answer;
use crate::markers::scale::{axis_name, frames_to_look_at};
use crate::markers::{Markers, PointKind};
use glam::DVec3;

/// So many pairs, markers before and behind, and markers that walk are looked at, each on every second of the frames that
/// say how large markers are.
const MOST: usize = 24;

/// Within this cosine two signs say the same: 45 degrees.
const AGREED: f64 = 0.7;

/// Who walks gets at least so many times as far as the markers of a frame are apart.
const WALK: f64 = 0.5;

/// The share of all steps that a straight walk gets ahead.
const STRAIGHT: f64 = 0.75;

/// Works out the axis towards which markers look. Certain is only what two signs say, and most of the time: left and
/// right, front and back, the way of walking.
pub(crate) fn facing(markers: &Markers) -> Answer<DVec3> {
    let places = Places(markers);
    let [sides, ends] = places.headings();
    let (heading, why) = match (&sides, &ends) {
        (Some(sides), Some(ends)) if sides.mean.dot(ends.mean) >= AGREED => {
            (sides, "by the names of left and right, and of front and back")
        }
        (Some(sides), Some(ends)) => {
            let [axis, other] = [ends, sides].map(|heading| axis_of(heading.mean));
            let other = if axis == other { "something in between" } else { axis_name(other) };
            return unsure(axis, &format!("by the names of front and back, but left and right say {other}"));
        }
        (Some(sides), None) => (sides, "by the names of left and right"),
        (None, Some(ends)) => (ends, "by the names of front and back"),
        (None, None) => {
            let usual = || unsure(usual_facing(markers.up.axis), "as in most files: neither names nor a walk say it");
            let walks = |way| unsure(axis_of(way), "the way it walks; the names of the markers do not say");
            return places.walk().map_or_else(usual, walks);
        }
    };
    if !heading.is_steady {
        return unsure(axis_of(heading.first), &format!("{why}, on the first frame: it does not stay so"));
    }
    let axis = axis_of(heading.mean);
    if axis.dot(heading.mean) < ALONG_AXIS {
        unsure(axis, &format!("{why}, though not quite"))
    } else if !markers.up.is_certain {
        unsure(axis, &format!("{why}, if {} is up", axis_name(markers.up.axis)))
    } else if sides.is_some() && ends.is_some() {
        Answer::certain(axis, format!("{}, {why}", axis_name(axis)))
    } else {
        match places.walk().map(|way| way.dot(heading.mean) >= AGREED) {
            Some(true) => Answer::certain(axis, format!("{}, {why}, and by the way it walks", axis_name(axis))),
            Some(false) => unsure(axis, &format!("{why}, but it walks another way")),
            None => unsure(axis, &format!("{why} alone")),
        }
    }
}

fn unsure(axis: DVec3, reason: &str) -> Answer<DVec3> {
    Answer::unsure(axis, format!("{}, {reason}", axis_name(axis)))
}

fn axis_of(direction: DVec3) -> DVec3 {
    nearest_axis(direction).map_or(DVec3::X, |(axis, _)| axis)
}

/// Where something points over time.
struct Heading {
    /// On the first frame that shows it; a unit vector like the others.
    first: DVec3,
    mean: DVec3,
    /// Whether it points there most of the time.
    is_steady: bool,
}

impl Heading {
    fn of(directions: &[DVec3]) -> Option<Self> {
        let mean = directions.iter().sum::<DVec3>().normalize_or_zero();
        let there = directions.iter().filter(|direction| direction.dot(mean) >= UPRIGHT).count();
        let is_steady = there as f64 >= MOST_OF_THE_TIME * directions.len() as f64;
        Some(Self { first: *directions.first()?, mean, is_steady })
    }
}

/// Where markers are on frames spread over a recording.
struct Places<'a>(&'a Markers);

impl Places<'_> {
    /// Returns the markers that are positions, as indices.
    fn positions(&self) -> impl Iterator<Item = usize> + Clone + '_ {
        (0..self.0.count()).filter(|index| self.0.kinds.get(*index) == Some(&PointKind::Position))
    }

    fn frames(&self) -> impl Iterator<Item = usize> {
        frames_to_look_at(self.0.frame_count()).step_by(2)
    }

    fn at(&self, index: usize, frame: usize) -> Option<DVec3> {
        self.0.positions.get(index, frame).filter(|at| at.is_finite() && *at != DVec3::ZERO)
    }

    fn level(&self, v: DVec3) -> DVec3 {
        let up = self.0.up.axis;
        v - up * v.dot(up)
    }

    /// Returns where the front is by left and right, and by front and back.
    fn headings(&self) -> [Option<Heading>; 2] {
        let names = self.positions().filter_map(|index| Some((index, self.0.names.get(index)?.as_str())));
        let mut pairs = pairs(names.clone());
        pairs.truncate(MOST);
        let ends: Vec<_> = names.filter_map(|(index, name)| Some((index, end(name)?))).take(MOST).collect();
        let by_sides = |frame| {
            let left = leftward(&pairs, |index| self.at(index, frame));
            self.level(left).cross(self.0.up.axis).try_normalize()
        };
        let by_ends = |frame| self.level(forward(&ends, |index| self.at(index, frame))).try_normalize();
        let (sides, ends): (Vec<_>, Vec<_>) = self.frames().map(|frame| (by_sides(frame), by_ends(frame))).unzip();
        [sides, ends].map(|directions| Heading::of(&directions.into_iter().flatten().collect::<Vec<_>>()))
    }

    /// Returns the way of a straight walk; a unit vector.
    fn walk(&self) -> Option<DVec3> {
        let every = self.positions().count().div_ceil(MOST).max(1);
        let walkers: Vec<usize> = self.positions().step_by(every).collect();
        let frames = self.frames().map(|frame| walkers.iter().map(|index| self.at(*index, frame)).collect());
        let frames: Vec<Vec<Option<DVec3>>> = frames.collect();
        let step = |pair: &[Vec<Option<DVec3>>]| {
            let [before, after] = pair else { return None };
            mean(before.iter().zip(after).filter_map(|(before, after)| Some((*after)? - (*before)?)))
        };
        let steps: Vec<DVec3> = frames.windows(2).filter_map(step).map(|step| self.level(step)).collect();
        let height = |frame: &Vec<Option<DVec3>>| {
            let heights = || frame.iter().flatten().map(|at| at.dot(self.0.up.axis));
            heights().fold(f64::NEG_INFINITY, f64::max) - heights().fold(f64::INFINITY, f64::min)
        };
        let height = frames.iter().map(height).fold(0.0, f64::max);
        let way: DVec3 = steps.iter().sum();
        let length: f64 = steps.iter().map(|step| step.length()).sum();
        let walks = height > 0.0 && way.length() >= WALK * height && way.length() >= STRAIGHT * length;
        way.try_normalize().filter(|_| walks)
    }
}

/// Returns the way from right to left, all pairs together.
fn leftward(pairs: &[[usize; 2]], at: impl Fn(usize) -> Option<DVec3>) -> DVec3 {
    pairs.iter().filter_map(|[left, right]| Some(at(*left)? - at(*right)?)).sum()
}

/// Returns the way from back to front, all regions together.
fn forward(ends: &[(usize, (Region, End))], at: impl Fn(usize) -> Option<DVec3>) -> DVec3 {
    let middle = |region, side| {
        let own = ends.iter().filter(|(_, end)| *end == (region, side));
        mean(own.filter_map(|(index, _)| at(*index)))
    };
    let regions = [Region::Chest, Region::Pelvis, Region::Foot].into_iter();
    regions.filter_map(|region| Some(middle(region, End::Front)? - middle(region, End::Back)?)).sum()
}

fn mean(places: impl Iterator<Item = DVec3>) -> Option<DVec3> {
    let (sum, count) = places.fold((DVec3::ZERO, 0), |(sum, count), place| (sum + place, count + 1));
    (count > 0).then(|| sum / f64::from(count))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::markers::{Analog, Positions, Quality, UpAxis};
    use crate::skeleton::LengthUnit;

    /// A person of a metre who faces +X at first, Z up, left to +Y.
    const BODY: [(&str, [f64; 3]); 8] = [
        ("LASI", [0.1, 0.1, 0.9]),
        ("RASI", [0.1, -0.1, 0.9]),
        ("SACR", [-0.1, 0.0, 0.9]),
        ("LSHO", [0.0, 0.2, 1.0]),
        ("RSHO", [0.0, -0.2, 1.0]),
        ("STRN", [0.1, 0.0, 1.0]),
        ("C7", [-0.1, 0.0, 1.0]),
        ("M1", [0.0, 0.0, 0.0]),
    ];

    /// Markers of the body that walk `way` over the recording, turned about Z by `turn` on each frame.
    fn recorded(names: &[&str], way: DVec3, turn: impl Fn(f64) -> f64) -> Markers {
        const FRAMES: usize = 32;
        let places = names.iter().map(|name| {
            let place = BODY.iter().find(|(known, _)| known == name).unwrap().1;
            let at = |frame: usize| {
                let time = frame as f64 / (FRAMES - 1) as f64;
                let turned = glam::DQuat::from_rotation_z(turn(time).to_radians()) * DVec3::from(place);
                (turned + way * time).to_array()
            };
            (0..FRAMES).flat_map(at).collect::<Vec<f64>>()
        });
        Markers {
            kinds: vec![PointKind::Position; names.len()],
            positions: Positions::of_f64(places.flatten().collect(), FRAMES),
            names: names.iter().map(|name| (*name).to_owned()).collect(),
            quality: Quality::default(),
            first_frame: 1,
            rate_hz: None,
            unit: LengthUnit { metres: 1.0, reason: String::new(), is_certain: true },
            up: UpAxis { axis: DVec3::Z, reason: String::new(), is_certain: true },
            events: Vec::new(),
            analog: Analog::default(),
        }
    }

    #[test]
    fn what_two_signs_say_is_certain_and_what_one_says_is_not() {
        let (stand, walk) = (DVec3::ZERO, DVec3::X * 4.0);
        let sides = ["LSHO", "RSHO", "M1"];
        let (quarter, none) = (90.0, 0.0);
        let table = [
            (
                &["LASI", "RASI", "SACR"][..],
                stand,
                quarter,
                true,
                "+Y, by the names of left and right, and of front and back",
            ),
            (&sides, walk, none, true, "+X, by the names of left and right, and by the way it walks"),
            (&sides, stand, none, false, "+X, by the names of left and right alone"),
            (&sides, -walk, none, false, "+X, by the names of left and right, but it walks another way"),
            (&sides, stand, 40.0, false, "+X, by the names of left and right, though not quite"),
            (&["STRN", "C7", "M1"], walk, none, true, "+X, by the names of front and back, and by the way it walks"),
            (&["M1"], walk, none, false, "-Y, as in most files: neither names nor a walk say it"),
            (&["M1", "LSHO"], walk, none, false, "+X, the way it walks; the names of the markers do not say"),
            (&["M1", "LSHO"], stand, none, false, "-Y, as in most files: neither names nor a walk say it"),
        ];
        for (names, way, turn, is_certain, reason) in table {
            let found = facing(&recorded(names, way, |_| turn));
            assert_eq!((found.reason.as_str(), found.is_certain), (reason, is_certain));
            assert!(found.reason.starts_with(axis_name(found.value)));
        }
    }

    #[test]
    fn signs_that_disagree_are_not_certain() {
        let mut swapped = recorded(&["LASI", "RASI", "SACR"], DVec3::ZERO, |_| 0.0);
        swapped.names.swap(0, 1);
        let found = facing(&swapped);
        let reason = "+X, by the names of front and back, but left and right say -X";
        assert_eq!((found.reason.as_str(), found.is_certain), (reason, false));
    }

    #[test]
    fn who_turns_faces_where_the_first_frame_does() {
        let found = facing(&recorded(&["LASI", "RASI", "SACR"], DVec3::ZERO, |time| 180.0 * time));
        let reason =
            "+X, by the names of left and right, and of front and back, on the first frame: it does not stay so";
        assert_eq!((found.reason.as_str(), found.is_certain), (reason, false));
    }

    #[test]
    fn without_a_certain_up_axis_left_and_right_mean_little() {
        let mut markers = recorded(&["LASI", "RASI", "SACR"], DVec3::ZERO, |_| 0.0);
        markers.up.is_certain = false;
        assert!(!facing(&markers).is_certain);
        markers.positions = Positions::of_f64(vec![f64::NAN; 9], 1);
        assert!(!facing(&markers).is_certain);
    }
}
