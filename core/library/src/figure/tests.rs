use super::*;
use glam::{DQuat, DVec3};
use motion_theater_core::markers::{Analog, Markers, PointKind, Positions, Quality, UpAxis};
use motion_theater_core::{Bone, BoneMotion, EulerOrder, LengthUnit, Motion, Skeleton};

fn unit(metres: f64) -> LengthUnit {
    LengthUnit { metres, reason: String::new(), is_certain: true }
}

fn bone(name: &str, parent: Option<usize>, offset: [f64; 3], tail: [f64; 3]) -> Bone {
    Bone {
        name: name.to_owned(),
        parent,
        offset: offset.into(),
        tail: tail.into(),
        axes: DQuat::IDENTITY,
        order: EulerOrder::default(),
        dofs: Vec::new(),
        limits: Vec::new(),
    }
}

/// In centimetres, Y up: hips with two thighs, as Acclaim has them: joints without length between.
pub(crate) fn legs() -> Skeleton {
    let bones = vec![
        bone("root", None, [0.0, 100.0, 0.0], [0.0; 3]),
        bone("lhipjoint", Some(0), [0.0; 3], [10.0, 0.0, 0.0]),
        bone("lfemur", Some(1), [10.0, 0.0, 0.0], [0.0, -100.0, 0.0]),
        bone("rhipjoint", Some(0), [0.0; 3], [-10.0, 0.0, 0.0]),
        bone("rfemur", Some(3), [-10.0, 0.0, 0.0], [0.0, -100.0, 0.0]),
        bone("lowerback", Some(0), [0.0; 3], [0.0, 20.0, 0.0]),
        bone("lclavicle", Some(5), [0.0, 20.0, 0.0], [0.0; 3]),
        bone("rclavicle", Some(5), [0.0, 20.0, 0.0], [0.0; 3]),
    ];
    Skeleton { name: String::new(), bones, up: DVec3::Y, unit: unit(0.01) }
}

/// The root goes 1 m along Z per frame.
pub(crate) fn walk(frame_count: usize) -> Motion {
    let translations = (0..frame_count).map(|frame| DVec3::Z * 100.0 * frame as f64).collect();
    let root = BoneMotion { translations, ..BoneMotion::default() };
    let bones = std::iter::once(root).chain(std::iter::repeat_n(BoneMotion::default(), 7)).collect();
    Motion { bones, first_frame: 5, frame_count, rate_hz: Some(60.0) }
}

/// Marker after marker, frame after frame, in metres with Z up.
pub(crate) fn markers(names: &[&str], trajectories: &[Vec<[f64; 3]>]) -> Markers {
    let frame_count = trajectories.first().map_or(0, Vec::len);
    Markers {
        names: names.iter().map(|name| (*name).to_owned()).collect(),
        kinds: vec![PointKind::Position; names.len()],
        positions: Positions::of_f64(trajectories.iter().flatten().flatten().copied().collect(), frame_count),
        quality: Quality::default(),
        first_frame: 1,
        rate_hz: None,
        unit: unit(1.0),
        up: UpAxis { axis: DVec3::Z, reason: String::new(), is_certain: true },
        events: Vec::new(),
        analog: Analog::default(),
    }
}

#[test]
fn joints_in_one_place_are_one_point_and_every_line_has_a_length() {
    let (skeleton, motion) = (legs(), walk(3));
    let figure = Figure::new(&Actor::of_skeleton(&skeleton, Some(&motion)), None);
    assert_eq!(figure.names, ["root", "lfemur", "lfemur_End", "rfemur", "rfemur_End", "lclavicle"]);
    assert_eq!(figure.lines, [[0, 1], [1, 2], [0, 3], [3, 4], [0, 5]]);
    assert!(figure.segments(0.0).iter().all(|[a, b]| a.distance(*b) > 0.09));
}

#[test]
fn lines_have_the_side_of_their_bones_and_the_middle_where_both_go_on() {
    let skeleton = legs();
    let figure = Figure::new(&Actor::of_skeleton(&skeleton, None), None);
    let sides: Vec<i8> = figure.sides.iter().map(|side| side.number()).collect();
    assert_eq!(sides, [-1, -1, 1, 1, 0]);
    assert_eq!(figure.colours('l', 'm', 'r')[2..], [['r', 'r'], ['r', 'r'], ['m', 'm']]);
}

#[test]
fn points_are_in_metres_with_z_up() {
    let (skeleton, motion) = (legs(), walk(3));
    let figure = Figure::new(&Actor::of_skeleton(&skeleton, Some(&motion)), None);
    assert_eq!(figure.frame(2)[0], Vec3::new(0.0, -2.0, 1.0));
    assert_eq!(figure.frame(2)[2], Vec3::new(0.1, -2.0, 0.0));
    assert_eq!(figure.bounds, Some([Vec3::new(-0.1, -2.0, 0.0), Vec3::new(0.1, 0.0, 1.2)]));
    assert_eq!((figure.floor, figure.first_frame, figure.rate_hz), (0.0, 5, 60.0));
}

#[test]
fn a_long_clip_is_thinned_evenly_and_keeps_its_speed() {
    let (skeleton, motion) = (legs(), walk(10));
    let actor = Actor::of_skeleton(&skeleton, Some(&motion));
    let figure = Figure::new(&actor, Some(4));
    assert_eq!((figure.frame_count, figure.frame_step, figure.rate_hz), (4, 3, 20.0));
    assert_eq!((0..4).map(|frame| figure.frame(frame)[0].y).collect::<Vec<_>>(), [0.0, -3.0, -6.0, -9.0]);
    assert_eq!(Figure::new(&actor, Some(10)).frame_count, 10);
    assert_eq!(Figure::new(&actor, Some(0)).frame_count, 1);
}

#[test]
fn between_frames_points_go_straight_and_outside_the_ends_hold() {
    let (skeleton, motion) = (legs(), walk(3));
    let figure = Figure::new(&Actor::of_skeleton(&skeleton, Some(&motion)), None);
    assert_eq!(figure.segments(0.25)[0], [Vec3::new(0.0, -0.25, 1.0), Vec3::new(0.1, -0.25, 1.0)]);
    assert_eq!(figure.positions(-3.0), figure.frame(0));
    assert_eq!(figure.positions(f64::INFINITY), figure.frame(2));
    assert_eq!(figure.positions(f64::NAN), figure.frame(0));
}

#[test]
fn a_line_with_an_end_in_a_gap_has_no_length() {
    let still = |x: f64| vec![[x, 0.0, 1.0]; 6];
    let mut with_gap = still(0.1);
    with_gap[2] = [f64::NAN; 3];
    let markers = markers(&["LA", "RA", "C", "D"], &[still(0.01), with_gap, still(0.2), still(1.2)]);
    let figure = Figure::new(&Actor::of_markers(&markers), None);
    assert_eq!(figure.lines[0], [0, 1]);
    assert!(figure.frame(2)[1].is_nan());
    let seen = Vec3::new(0.01, 0.0, 1.0);
    assert_eq!(figure.segments(2.0)[0], [seen, seen]);
    assert_eq!(figure.segments(2.25)[0], [seen, seen], "the nearer frame has the gap");
    assert_eq!(figure.segments(2.75)[0], [seen, Vec3::new(0.1, 0.0, 1.0)]);
    assert_eq!((figure.dots(2.0).len(), figure.dots(0.0).len()), (3, 4));
    assert_eq!(figure.sides[0], Side::Middle, "from left to right");
}

#[test]
fn groups_of_markers_are_joined_into_one_figure() {
    let still = |x: f64, z: f64| vec![[x, 0.0, z]; 6];
    // Legs that swing against each other: no distance to the hips or to the other leg is kept to a twentieth.
    let swing = |x: f64, y: f64, z: f64| (0..6).map(|frame| [x, y * f64::from(frame), z]).collect::<Vec<_>>();
    let names = ["LHIP", "RHIP", "LKNE", "RKNE", "LANK", "RANK", "HEAD"];
    let legs = [swing(0.1, 0.05, 0.5), swing(-0.1, -0.05, 0.5), swing(0.1, 0.05, 0.1), swing(-0.1, -0.05, 0.1)];
    let all = [vec![still(0.1, 0.9), still(-0.1, 0.9)], legs.to_vec(), vec![still(0.01, 1.4)]].concat();
    let figure = Figure::new(&Actor::of_markers(&markers(&names, &all)), None);
    let mut groups = Groups::new(names.len());
    for [a, b] in &figure.lines {
        groups.join(*a, *b);
    }
    assert!((0..names.len()).all(|point| groups.of(point) == groups.of(0)), "{:?}", figure.lines);
    assert!(!figure.lines.contains(&[2, 3]) && !figure.lines.contains(&[4, 5]), "the legs are apart");
}

#[test]
fn nothing_is_a_figure_too() {
    let none = markers(&[], &[]);
    let figure = Figure::new(&Actor::of_markers(&none), Some(5));
    assert_eq!((figure.frame_count, figure.bounds, figure.floor), (0, None, 0.0));
    assert!(figure.segments(1.0).is_empty() && figure.dots(0.0).is_empty());
    let gaps = markers(&["A", "B"], &[vec![[f64::NAN; 3]; 4], vec![[0.0; 3]; 4]]);
    let figure = Figure::new(&Actor::of_markers(&gaps), None);
    assert_eq!((figure.frame_count, figure.bounds), (4, None));
    assert!(figure.dots(1.5).is_empty());
    let empty = Skeleton { name: String::new(), bones: Vec::new(), up: DVec3::Y, unit: unit(1.0) };
    assert_eq!(Figure::new(&Actor::of_skeleton(&empty, None), None).bounds, None);
}

#[test]
fn a_figure_stands_on_the_files_zero_or_else_on_its_feet() {
    let at = |z: f64| vec![[0.5, 0.0, z]; 40];
    let floor =
        |low: f64, high: f64| Figure::new(&Actor::of_markers(&markers(&["A", "B"], &[at(low), at(high)])), None).floor;
    assert_eq!(floor(0.1, 1.7), 0.0);
    assert_eq!(floor(-0.9, 0.8), -0.9);
    assert_eq!(floor(3.0, 4.5), 3.0);
}

#[test]
fn a_line_that_grows_is_no_bone() {
    let mut skeleton = legs();
    skeleton.bones[5].name = "walks away".to_owned();
    let mut motion = walk(5);
    motion.bones.swap(0, 5);
    let figure = Figure::new(&Actor::of_skeleton(&skeleton, Some(&motion)), None);
    assert!(figure.lines.iter().all(|line| *line != [0, 5]), "{:?}", figure.lines);
}

#[test]
fn a_root_on_the_floor_that_carries_the_figure_has_no_line() {
    let mut skeleton = legs();
    skeleton.bones.insert(0, bone("Reference", None, [0.0; 3], [0.0; 3]));
    for bone in skeleton.bones.iter_mut().skip(1) {
        bone.parent = Some(bone.parent.map_or(0, |parent| parent + 1));
    }
    let figure = Figure::new(&Actor::of_skeleton(&skeleton, None), None);
    assert_eq!(figure.lines, [[1, 2], [2, 3], [1, 4], [4, 5], [1, 6]]);
}

#[test]
fn who_walks_has_sides_even_without_names() {
    let track = |x: f64, z: f64| (0..50).map(|frame| [x, -0.1 * f64::from(frame), z]).collect::<Vec<_>>();
    let points =
        [track(0.3, 0.1), track(0.35, 0.4), track(-0.3, 0.1), track(-0.35, 0.4), track(0.0, 1.6), track(0.01, 1.3)];
    let markers = markers(&["1", "2", "3", "4", "5", "6"], &points);
    let figure = Figure::new(&Actor::of_markers(&markers), None);
    let side =
        |line: [usize; 2]| figure.lines.iter().position(|known| *known == line).map(|at| figure.sides[at].number());
    assert_eq!((side([0, 1]), side([2, 3]), side([4, 5])), (Some(-1), Some(1), Some(0)));
}
