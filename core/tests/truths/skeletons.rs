//! Skeletons: what is known of each, and copies of them.

use super::{acclaim, answer, extent, is_near, rates, turned, Tally, SCALES};
use glam::DVec3;
use motion_theater_core::formats::bvh::{Bvh, Channel};
use motion_theater_core::infer::infer;
use motion_theater_core::pose::pose;
use motion_theater_core::read::read_path;
use motion_theater_core::{Motion, Skeleton};
use std::path::Path;

const ACCLAIM_M: f64 = 0.0254 / 0.45;
const INCH_M: f64 = 0.0254;

/// What is known of a file: metres per unit, and which axes are up and ahead in its rest pose. What nobody can know, or
/// the rest pose does not have, is `None`; then nothing may be certain.
pub(super) struct Truth {
    pub(super) file: &'static str,
    pub(super) unit_m: Option<f64>,
    pub(super) up: Option<DVec3>,
    pub(super) facing: Option<DVec3>,
}

const fn truth(file: &'static str, unit_m: Option<f64>, up: Option<DVec3>, facing: Option<DVec3>) -> Truth {
    Truth { file, unit_m, up, facing }
}

const X: Option<DVec3> = Some(DVec3::X);
const Y: Option<DVec3> = Some(DVec3::Y);
const Z: Option<DVec3> = Some(DVec3::Z);
const BACK: Option<DVec3> = Some(DVec3::NEG_Y);
const CM: Option<f64> = Some(0.01);
const INCH: Option<f64> = Some(INCH_M);
const ACCLAIM: Option<f64> = Some(ACCLAIM_M);

const BVH_FILES: [Truth; 39] = [
    truth("accad_Male1_A13_Skipping", CM, Y, None),
    truth("bandai1_bow_active_001", CM, Y, None),
    truth("blender_walk01", CM, Y, Z),
    truth("cmu_daz_10_03", CM, Y, Z),
    truth("cmu_max_02_01", ACCLAIM, Y, Z),
    truth("cmu_mb_01_01", ACCLAIM, Y, Z),
    truth("cmu_mixed_orders_jumping_jacks", ACCLAIM, Y, Z),
    truth("debug_axes", None, None, None),
    // Its positions have another unit than its bones.
    truth("dynamicus_Example", None, Z, Y),
    truth("example3", None, None, None),
    truth("fair1_dab", None, Z, BACK),
    truth("full_precision_frame_time", None, None, None),
    truth("ganimator_Xia_proud", ACCLAIM, Y, Z),
    truth("geno_stance", CM, Y, Z),
    truth("kinect_openni_ah_cut_01", Some(0.001), Y, None),
    truth("lafan1_dance1_subject1_crop", CM, Y, None),
    truth("makehuman_benchmark", Some(0.1), Z, BACK),
    truth("makehuman_walk1", Some(0.1), Z, BACK),
    truth("mixamo_blender_Walking", CM, Y, Z),
    truth("mixamo_freebvh", CM, Y, Z),
    truth("mixed_orders_bvh_example", INCH, Z, Y),
    truth("mocapbank", CM, Y, Z),
    truth("mocapnet_02_03_498ch", CM, Y, Z),
    truth("motionbuilder_backflip", CM, Y, Z),
    truth("named_endsite_Matt_Happy2", CM, Y, None),
    truth("no_endsites_jump_from_stand", INCH, Z, X),
    truth("perception_neuron_scene", CM, Y, Z),
    truth("quadruped_Dog_example", None, None, None),
    truth("rokoko_jesse_dance", CM, Y, None),
    truth("rows_lead_blank_DanceTurn", INCH, Y, Z),
    truth("standard_skeleton", INCH, Z, Y),
    truth("swagger", CM, Y, Z),
    truth("test_simple", None, None, None),
    truth("truebones_Chicken_Walk", None, None, None),
    truth("upper_case_channels_sample-walk", Some(1.0), Y, Z),
    truth("usd_test_bvh", None, None, None),
    truth("xia_old_13_000", ACCLAIM, Y, Z),
    truth("xsens_BoxLift_S01_T01", CM, Y, Z),
    truth("xsens_S01_Trial02", CM, Y, Z),
];

const ASF_FILES: [(Truth, &str); 5] = [
    (truth("cmu01/01", ACCLAIM, Y, Z), "cmu01/01_01"),
    (truth("cmu02/02", ACCLAIM, Y, Z), "cmu02/02_04"),
    (truth("cmu09/09-run", ACCLAIM, Y, Z), "cmu09/09_06-run"),
    (truth("cmu135/135-martialArts", ACCLAIM, Y, Z), "cmu135/135_06-martialArts"),
    (truth("endorphin/skeleton", Some(1.0), Y, Z), "endorphin/walking"),
];

/// Asks what every BVH is, in every unit and with every axis up, and once turned as a whole.
pub fn bvh_copies(folder: &Path) -> Vec<Tally> {
    BVH_FILES.iter().map(|truth| bvh_tally(folder, truth)).collect()
}

fn bvh_tally(folder: &Path, truth: &Truth) -> Tally {
    let path = folder.join("bvh").join(truth.file).with_extension("bvh");
    let bvh = read_path(&path, None).unwrap().bvh.unwrap();
    let mut tally = Tally { file: truth.file, ..Tally::default() };
    for scale in SCALES {
        for turns in 0..3 {
            let (skeleton, motion) = changed(&bvh, scale, turns).skeleton_and_motion();
            let what = format!("{} x {scale}, turned {turns} times", truth.file);
            count(&mut tally, &what, truth, (scale, turns), &skeleton, &motion.unwrap());
        }
    }
    for hz in rates::RERATED_HZ {
        let mut copy = bvh.clone();
        // As most programs write it.
        let motion = copy.motion.as_mut().unwrap();
        motion.values.truncate(bvh.width());
        motion.frame_count = 1;
        motion.frame_time_s = format!("{:.7}", 1.0 / hz).parse().ok();
        let (skeleton, motion) = copy.skeleton_and_motion();
        let found = infer(&skeleton, motion.as_ref()).rate_hz;
        rates::count(&mut tally.rate, truth.file, hz, found.value, found.is_certain);
    }
    let (skeleton, motion) = turned_as_a_whole(&bvh).skeleton_and_motion();
    let found = infer(&skeleton, motion.as_ref()).up;
    let as_moving = truth.up.is_some_and(|up| found.value == DVec3::new(up.x, -up.z, up.y));
    tally.up.add(&format!("{} turned as a whole", truth.file), &found, as_moving);
    tally
}

/// Asks what every Acclaim skeleton is, in every unit and with every axis up.
pub fn acclaim_copies(folder: &Path) -> Vec<Tally> {
    ASF_FILES.iter().map(|(truth, motion)| acclaim_tally(&folder.join("asf_amc"), truth, motion)).collect()
}

fn acclaim_tally(folder: &Path, truth: &Truth, motion_file: &str) -> Tally {
    let asf = read_path(&folder.join(truth.file).with_extension("asf"), None).unwrap().asf.unwrap();
    let amc = read_path(&folder.join(motion_file).with_extension("amc"), None).unwrap().amc.unwrap();
    let mut tally = Tally { file: truth.file, ..Tally::default() };
    for scale in SCALES {
        for turns in 0..3 {
            let (skeleton, motion) = acclaim::read_copy(&asf, &amc, scale, turns);
            let what = format!("{} x {scale}, turned {turns} times", truth.file);
            count(&mut tally, &what, truth, (scale, turns), &skeleton, &motion);
        }
    }
    for hz in rates::RERATED_HZ {
        let found = acclaim::rate_of_copy(&amc, hz);
        rates::count(&mut tally.rate, truth.file, hz, found, found.is_some());
    }
    tally
}

/// Counts what is inferred of one copy. The unit of an Acclaim skeleton is not that of [`infer`] alone.
fn count(
    tally: &mut Tally,
    what: &str,
    truth: &Truth,
    (scale, turns): (f64, usize),
    skeleton: &Skeleton,
    motion: &Motion,
) {
    let found = infer(skeleton, Some(motion));
    let unit = answer(&skeleton.unit.reason, skeleton.unit.is_certain);
    tally.unit.add(what, &unit, is_near(skeleton.unit.metres, truth.unit_m.map(|unit| unit / scale)));
    tally.up.add(what, &found.up, truth.up.is_some_and(|up| skeleton.up == turned(up, turns)));
    let ahead = truth.facing.map(|facing| turned(facing, turns));
    tally.facing.add(what, &found.facing, Some(found.facing.value) == ahead);
    if truth.unit_m.is_some() {
        // At rest or at the first frame: some rest poses lie in a heap, and so does one file's only frame, whose
        // positions are all zero.
        let moved = pose(skeleton, motion, motion.first_frame as f64).heads;
        let heights = [skeleton.rest_heads(), moved].map(|heads| extent(heads.into_iter(), skeleton.up));
        tally.heights_m.push(heights[0].max(heights[1]) * skeleton.unit.metres);
    }
}

/// Returns a copy in another unit and with other axes: the same values in channels of other names.
fn changed(bvh: &Bvh, scale: f64, turns: usize) -> Bvh {
    let place = |offset: [f64; 3]| (turned(DVec3::from(offset), turns) * scale).to_array();
    let mut joints = bvh.joints.clone();
    for joint in &mut joints {
        joint.offset = place(joint.offset);
        joint.end_sites.iter_mut().for_each(|end| end.offset = place(end.offset));
        for channel in &mut joint.channels {
            *channel = match *channel {
                Channel::Position(axis) => Channel::Position((axis + turns) % 3),
                Channel::Rotation(axis) => Channel::Rotation((axis + turns) % 3),
            };
        }
    }
    let mut motion = bvh.motion.clone().unwrap();
    let is_length: Vec<_> =
        joints.iter().flat_map(|j| &j.channels).map(|c| matches!(c, Channel::Position(_))).collect();
    for row in motion.values.chunks_exact_mut(is_length.len()) {
        for (value, _) in row.iter_mut().zip(&is_length).filter(|(_, is_length)| **is_length) {
            *value *= scale;
        }
    }
    Bvh::new(joints, Some(motion))
}

/// Returns a copy in which another joint above the root is turned by a quarter about X: the motion is Z up, the rest pose is not.
fn turned_as_a_whole(bvh: &Bvh) -> Bvh {
    let mut joints = bvh.joints.clone();
    for joint in &mut joints {
        joint.parent = Some(joint.parent.map_or(0, |parent| parent + 1));
    }
    let above = motion_theater_core::formats::bvh::Joint {
        name: "Turn".to_owned(),
        channels: vec![Channel::Rotation(0)],
        ..Default::default()
    };
    joints.insert(0, above);
    let mut motion = bvh.motion.clone().unwrap();
    motion.values = motion
        .values
        .chunks_exact(bvh.width())
        .flat_map(|row| std::iter::once(90.0).chain(row.iter().copied()))
        .collect();
    Bvh::new(joints, Some(motion))
}
