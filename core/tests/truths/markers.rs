//! Markers: what is known of each file, copies of which nothing is stated, and copies that go on stating what they are
//! no more.

use super::{answer, extent, is_near, rates, turned, Counts, Tally, SCALES};
use glam::DVec3;
use motion_theater_core::formats::c3d::{C3d, Encoding, Processor, Storage};
use motion_theater_core::formats::csm::Csm;
use motion_theater_core::formats::trc::Trc;
use motion_theater_core::markers::{Analog, Positions, Quality, UpAxis};
use motion_theater_core::read::{read_bytes, read_path};
use motion_theater_core::{LengthUnit, Markers};
use std::path::Path;

/// Metres per unit, which axis is up, and towards which the figure looks most of the time; `None` where nobody can know,
/// or it turns.
type Truth = (&'static str, Option<f64>, Option<DVec3>, Option<DVec3>);

const X: Option<DVec3> = Some(DVec3::X);
const Y: Option<DVec3> = Some(DVec3::Y);
const Z: Option<DVec3> = Some(DVec3::Z);
const NEG_X: Option<DVec3> = Some(DVec3::NEG_X);
const NEG_Y: Option<DVec3> = Some(DVec3::NEG_Y);
const MM: Option<f64> = Some(0.001);
const M: Option<f64> = Some(1.0);

/// Every file with markers, but those without points and those that never show three at once: what it states where that
/// is plausible, else what its markers show.
const FILES: [Truth; 54] = [
    ("c3d/FP_Type1.c3d", M, Y, NEG_X),
    ("c3d/Vicon.c3d", MM, Z, NEG_X),
    ("c3d/anybody_GaitFast_1.c3d", MM, Y, X),
    ("c3d/btk_561xxa01_anonym.C3D", MM, Y, X),
    ("c3d/btk_ADemo1_pc_integer.c3d", MM, Z, NEG_X),
    ("c3d/btk_Gait.c3d", MM, Z, NEG_X),
    ("c3d/btk_MyCube.c3d", MM, Z, None),
    ("c3d/btk_PiG_one_frame.c3d", MM, Z, NEG_Y),
    ("c3d/c3dorg_00/codamotion_gaitwands_19970212.c3d", MM, Z, NEG_X),
    ("c3d/c3dorg_00/ist_Gait_with_EMG.c3d", M, Z, X),
    ("c3d/c3dorg_00/mac_Walk1.c3d", MM, Z, X),
    ("c3d/c3dorg_00/nexgen_test1.c3d", M, Y, X),
    ("c3d/c3dorg_01/Eb015pi.c3d", MM, Z, Y),
    ("c3d/c3dorg_01/Eb015pr.c3d", MM, Z, Y),
    ("c3d/c3dorg_01/Eb015si.c3d", MM, Z, Y),
    ("c3d/c3dorg_01/Eb015vi.c3d", MM, Z, Y),
    ("c3d/c3dorg_02/dec_int.c3d", MM, Z, Y),
    ("c3d/c3dorg_02/pc_int.c3d", MM, Z, Y),
    ("c3d/c3dorg_02/pc_real.c3d", MM, Z, Y),
    ("c3d/c3dorg_03/gait-pig.c3d", MM, Z, X),
    ("c3d/c3dorg_03/gait-raw.c3d", MM, Z, X),
    ("c3d/c3dorg_06/newwalk.c3d", MM, Z, X),
    ("c3d/c3dorg_08/TESTAPI.c3d", MM, Z, Y),
    ("c3d/c3dorg_08/TESTBPI.c3d", MM, Z, Y),
    ("c3d/c3dorg_09/PlugInC3D.c3d", MM, Z, X),
    ("c3d/c3dorg_10/TYPE-2.C3D", MM, Z, X),
    ("c3d/c3dorg_10/TYPE-2a.c3d", MM, Z, X),
    ("c3d/c3dorg_11/evart.c3d", MM, Z, NEG_X),
    ("c3d/c3dorg_13/Dance.c3d", MM, X, None),
    ("c3d/c3dorg_13/golfswing.c3d", MM, X, None),
    ("c3d/c3dorg_15/FP1.C3D", None, None, None),
    ("c3d/c3dorg_21/sample21.c3d", MM, Z, X),
    ("c3d/c3dorg_24/MotionMonitorC3D.c3d", M, Y, None),
    ("c3d/c3dorg_25/analogfpscale03.c3d", MM, Z, Y),
    ("c3d/c3dorg_25/analogfpscale04.c3d", MM, Z, Y),
    ("c3d/c3dorg_26/Capture0002.c3d", MM, Z, X),
    ("c3d/c3dorg_28/standing.C3D", MM, Y, X),
    ("c3d/c3dorg_28/type1.C3D", MM, Y, X),
    ("c3d/c3dorg_30/admarche2.c3d", MM, Z, X),
    ("c3d/c3dorg_30/marche281.c3d", MM, Z, X),
    ("c3d/c3dorg_32/vicon_zerowire.c3d", MM, Z, NEG_X),
    ("c3d/c3dorg_37/ART-Human_hands_real_no6dof.c3d", MM, Z, NEG_Y),
    ("c3d/cmu_02_01.c3d", MM, Z, X),
    ("c3d/ktk_walkingOptiTrack.c3d", MM, Z, None),
    ("c3d/pycgm_Sample_Static.c3d", MM, Z, Y),
    ("c3d/pyorerun_example.c3d", MM, Z, None),
    ("csm/ThomasFechten.csm", MM, Z, None),
    ("csm/malformed_zero_framerange.csm", None, None, None),
    ("other/trc/btk_Gait.trc", MM, Z, NEG_X),
    ("other/trc/motek_ballet_reduced.trc", MM, Y, None),
    ("other/trc/opensim_dataWithBlanksForMissingMarkers.trc", MM, Z, NEG_X),
    ("other/trc/opensim_marker_trajectories.trc", MM, Y, X),
    ("c3d/c3dorg_16/basketball.c3d", None, None, None),
    ("c3d/c3dorg_07/16bitanalog.c3d", None, None, None),
];

/// Files of people from head to foot: stated, plausible, and seen in the data.
pub const PEOPLE: [&str; 14] = [
    "c3d/FP_Type1.c3d",
    "c3d/anybody_GaitFast_1.c3d",
    "c3d/btk_561xxa01_anonym.C3D",
    "c3d/btk_Gait.c3d",
    "c3d/c3dorg_00/ist_Gait_with_EMG.c3d",
    "c3d/c3dorg_00/mac_Walk1.c3d",
    "c3d/c3dorg_00/nexgen_test1.c3d",
    "c3d/c3dorg_24/MotionMonitorC3D.c3d",
    "c3d/c3dorg_28/type1.C3D",
    "c3d/c3dorg_30/marche281.c3d",
    "c3d/cmu_02_01.c3d",
    "csm/ThomasFechten.csm",
    "other/trc/motek_ballet_reduced.trc",
    "other/trc/opensim_marker_trajectories.trc",
];

/// Returns what is known of a file.
pub fn truth(file: &str) -> Truth {
    FILES.into_iter().find(|(known, ..)| *known == file).unwrap()
}

/// Reads the markers of a file.
pub fn read(folder: &Path, file: &str) -> Markers {
    let markers = read_path(&folder.join(file), None).unwrap().markers().unwrap().clone();
    Markers::clone(&markers)
}

/// Asks which way every file faces, as it is.
pub fn facing_as_read(folder: &Path) -> Counts {
    let mut counts = Counts::default();
    for (file, .., facing) in FILES {
        let found = read(folder, file).facing();
        counts.add(file, &found, Some(found.value) == facing);
    }
    counts
}

/// Asks what every file is when it states nothing, in every unit and with every axis up.
pub fn silent_copies(folder: &Path) -> Vec<Tally> {
    let tally = |(file, ..): &Truth| {
        let markers = read(folder, file);
        let mut tally = tally(file, |change| silent(&markers, change));
        for hz in rates::RERATED_HZ {
            for found in rerated(&markers, hz) {
                rates::count(&mut tally.rate, file, hz, found, found.is_some());
            }
        }
        tally
    };
    FILES.iter().map(tally).collect()
}

/// Asks what files of people are when they go on stating what they were, in every unit and with every axis up.
pub fn lying_copies(folder: &Path) -> Vec<Tally> {
    let tally = |file: &&'static str| {
        let markers = read(folder, file);
        tally(file, |change| lying(&markers, change))
    };
    PEOPLE.iter().map(tally).collect()
}

/// Asks the same of people in CSM, of which the format itself says the unit and the axis.
pub fn csm_copies(folder: &Path) -> Vec<Tally> {
    let tally = |file: &&'static str| {
        let markers = read(folder, file);
        tally(file, |change| as_csm(&markers, change))
    };
    PEOPLE.iter().map(tally).collect()
}

fn tally(file: &'static str, copy: impl Fn(&dyn Fn(DVec3) -> DVec3) -> Markers) -> Tally {
    let (_, unit_m, up, facing) = truth(file);
    let mut tally = Tally { file, ..Tally::default() };
    for scale in SCALES {
        for turns in 0..3 {
            let found = copy(&|at| turned(at, turns) * scale);
            let what = format!("{file} x {scale}, turned {turns} times");
            let is_right = is_near(found.unit.metres, unit_m.map(|unit| unit / scale));
            tally.unit.add(&what, &answer(&found.unit.reason, found.unit.is_certain), is_right);
            let is_right = up.is_some_and(|up| found.up.axis == turned(up, turns));
            tally.up.add(&what, &answer(&found.up.reason, found.up.is_certain), is_right);
            let ahead = found.facing();
            let is_right = facing.is_some_and(|facing| ahead.value == turned(facing, turns));
            tally.facing.add(&what, &ahead, is_right);
            if PEOPLE.contains(&file) {
                let middle = found.frame_count() / 2;
                let seen = (0..found.count()).filter_map(|marker| found.positions.get(marker, middle));
                tally.heights_m.push(extent(seen, found.up.axis) * found.unit.metres);
            }
        }
    }
    tally
}

fn moved(markers: &Markers, change: &dyn Fn(DVec3) -> DVec3) -> Markers {
    let moved = (0..markers.count()).flat_map(|marker| markers.positions.trajectory(marker));
    let moved: Vec<f64> = moved.flat_map(|at| change(at).to_array()).collect();
    Markers { positions: Positions::of_f64(moved, markers.frame_count()), ..markers.clone() }
}

/// A table of numbers that says neither unit nor axis.
fn silent(markers: &Markers, change: &dyn Fn(DVec3) -> DVec3) -> Markers {
    // A unit with a name: then the numbers are written as they are.
    let unit = LengthUnit { metres: 0.001, ..markers.unit.clone() };
    let mut trc = Trc::of_markers(&Markers { unit, ..moved(markers, change) }, "silent.trc");
    trc.header.retain(|(key, _)| key != "Units");
    trc.markers().0
}

/// A file that states what the original stated.
fn lying(markers: &Markers, change: &dyn Fn(DVec3) -> DVec3) -> Markers {
    as_c3d(&moved(markers, change)).markers().0
}

/// The same numbers as millimetres and Z up.
fn as_csm(markers: &Markers, change: &dyn Fn(DVec3) -> DVec3) -> Markers {
    let unit = LengthUnit { metres: 0.001, ..markers.unit.clone() };
    let up = UpAxis { axis: DVec3::Z, ..markers.up.clone() };
    Csm::of_markers(&Markers { unit, up, ..moved(markers, change) }).markers().0
}

fn as_c3d(markers: &Markers) -> C3d {
    let encoding = Encoding { processor: Processor::Intel, storage: Storage::Float };
    C3d::parse(C3d::compose(markers, encoding).unwrap()).unwrap()
}

/// Returns which rate copies of the first frame have, one in each format, that state this one.
fn rerated(markers: &Markers, hz: f64) -> [Option<f64>; 3] {
    let first = (0..markers.count()).map(|marker| markers.positions.get(marker, 0).unwrap_or(DVec3::NAN));
    let positions = Positions::of_f64(first.flat_map(|at| at.to_array()).collect(), 1);
    let copy = Markers { rate_hz: Some(hz), positions, quality: Quality::default(), ..markers.clone() };
    let copy = Markers { analog: Analog::default(), ..copy };
    let text = |bytes: Vec<u8>, name: &str| read_bytes(&bytes, Path::new(name), None).unwrap().rate_hz();
    let [csm, trc] = [Csm::of_markers(&copy).to_bytes(), Trc::of_markers(&copy, "copy.trc").to_bytes()];
    [as_c3d(&copy).markers().0.rate_hz, text(csm, "copy.csm"), text(trc, "copy.trc")]
}
