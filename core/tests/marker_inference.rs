//! The unit and the axis that points up of every real marker file, and of copies that are scaled and turned while the file
//! goes on stating the same: it may be unsure, but where it is certain it is right.

use glam::{DQuat, DVec3};
use motion_theater_core::formats::c3d::{C3d, Encoding, Processor, Storage};
use motion_theater_core::markers::Positions;
use motion_theater_core::read::read_path;
use motion_theater_core::Markers;
use std::f64::consts::FRAC_PI_2;
use std::path::Path;

const SCALES: [f64; 6] = [0.01, 0.0254, 0.1, 1.0, 10.0, 100.0];

/// People who stand along another axis than their files state.
const STATED_WRONG: [(&str, DVec3); 3] = [
    ("c3d/c3dorg_13/Dance.c3d", DVec3::X),
    ("c3d/c3dorg_13/golfswing.c3d", DVec3::X),
    ("c3d/c3dorg_37/ART-Human_hands_real_no6dof.c3d", DVec3::Z),
];

/// Files of people, with the true unit in metres and axis: stated, plausible, and seen in the data.
const PEOPLE: [(&str, f64, DVec3); 14] = [
    ("c3d/FP_Type1.c3d", 1.0, DVec3::Y),
    ("c3d/anybody_GaitFast_1.c3d", 0.001, DVec3::Y),
    ("c3d/btk_561xxa01_anonym.C3D", 0.001, DVec3::Y),
    ("c3d/btk_Gait.c3d", 0.001, DVec3::Z),
    ("c3d/c3dorg_00/ist_Gait_with_EMG.c3d", 1.0, DVec3::Z),
    ("c3d/c3dorg_00/mac_Walk1.c3d", 0.001, DVec3::Z),
    ("c3d/c3dorg_00/nexgen_test1.c3d", 1.0, DVec3::Y),
    ("c3d/c3dorg_24/MotionMonitorC3D.c3d", 1.0, DVec3::Y),
    ("c3d/c3dorg_28/type1.C3D", 0.001, DVec3::Y),
    ("c3d/c3dorg_30/marche281.c3d", 0.001, DVec3::Z),
    ("c3d/cmu_02_01.c3d", 0.001, DVec3::Z),
    ("csm/ThomasFechten.csm", 0.001, DVec3::Z),
    ("other/trc/motek_ballet_reduced.trc", 0.001, DVec3::Y),
    ("other/trc/opensim_marker_trajectories.trc", 0.001, DVec3::Y),
];

fn markers(file: &str) -> Option<Markers> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../shared/data");
    let markers = folder.is_dir().then(|| read_path(&folder.join(file), None).unwrap().markers.unwrap())?;
    Some(Markers::clone(&markers))
}

/// Writes moved markers with what the file states of unit and axes left as it is, and reads them.
fn copy(markers: &Markers, change: impl Fn(DVec3) -> DVec3) -> Markers {
    let moved = (0..markers.count()).flat_map(|marker| markers.positions.trajectory(marker));
    let moved: Vec<f64> = moved.flat_map(|at| change(at).to_array()).collect();
    let positions = Positions::of_f64(moved, markers.frame_count());
    let encoding = Encoding { processor: Processor::Intel, storage: Storage::Float };
    let bytes = C3d::compose(&Markers { positions, ..markers.clone() }, encoding).unwrap();
    C3d::parse(bytes).unwrap().markers().0
}

#[test]
fn people_have_their_size_and_stand_up() {
    for (file, metres, up) in PEOPLE {
        let Some(found) = markers(file) else { return };
        assert_eq!((found.unit.metres, found.unit.is_certain), (metres, true), "{file}: {}", found.unit.reason);
        assert_eq!((found.up.axis, found.up.is_certain), (up, true), "{file}: {}", found.up.reason);
    }
}

#[test]
fn an_axis_that_the_people_contradict_is_not_believed() {
    for (file, up) in STATED_WRONG {
        let Some(found) = markers(file) else { return };
        assert_eq!((found.up.axis, found.up.is_certain), (up, false), "{file}: {}", found.up.reason);
    }
}

#[test]
fn what_is_certain_of_a_scaled_or_turned_copy_is_right() {
    let turns = [DQuat::IDENTITY, DQuat::from_rotation_x(FRAC_PI_2), DQuat::from_rotation_y(FRAC_PI_2)];
    let mut right = [0, 0];
    for (file, metres, up) in PEOPLE {
        let Some(original) = markers(file) else { return };
        for scale in SCALES {
            for turn in turns {
                let found = copy(&original, |at| turn * at * scale);
                let what = format!("{file} by {scale}: {}; {}", found.unit.reason, found.up.reason);
                let is_unit_right = (found.unit.metres * scale / metres - 1.0).abs() < 1e-9;
                assert!(is_unit_right || !found.unit.is_certain, "{what}");
                let is_up_right = found.up.axis.dot(turn * up) > 0.9;
                assert!(is_up_right || !found.up.is_certain, "{what}");
                right[0] += usize::from(is_unit_right);
                right[1] += usize::from(is_up_right);
            }
        }
    }
    let count = PEOPLE.len() * SCALES.len() * turns.len();
    println!("of {count} copies: unit right {}, up right {}", right[0], right[1]);
    // Scaled copies state a wrong unit, and some cannot be known.
    assert!(right[0] * 4 >= count && right[1] * 10 >= count * 9, "{right:?} of {count}");
}
