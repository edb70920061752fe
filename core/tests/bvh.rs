//! BVH: what is written reads back as the same, random files and real ones, and other formats' motions keep their places.

use glam::{DQuat, DVec3};
use motion_theater_core::formats::amc::{with_dofs_for, Amc};
use motion_theater_core::formats::asf::Asf;
use motion_theater_core::formats::bvh::{Bvh, BvhMotion, Channel, EndSite, Joint};
use motion_theater_core::formats::AngleUnit;
use motion_theater_core::pose::pose;
use motion_theater_core::read::{read_bytes, read_path, Format};
use motion_theater_core::{Bone, BoneMotion, EulerOrder, LengthUnit, Motion, Skeleton};
use proptest::collection::vec;
use proptest::option;
use proptest::prelude::*;
use std::path::{Path, PathBuf};

fn number() -> impl Strategy<Value = f64> {
    let any_bits = any::<f64>().prop_filter("bearable", |value| value.abs() <= 1e15);
    prop_oneof![any_bits, -200.0..200.0, (-20_000..20_000).prop_map(|n| f64::from(n) / 100.0), Just(-0.0)]
}

fn numbers() -> impl Strategy<Value = [f64; 3]> {
    [number(), number(), number()]
}

fn name() -> impl Strategy<Value = String> {
    "([-A-Za-z0-9_:.#(\\[{}é]{1,6}( {1,2}[a-z:#)]{1,3}){0,2})?".prop_filter("fits", |name| !name.starts_with('{'))
}

fn channels() -> impl Strategy<Value = Vec<Channel>> {
    vec(prop_oneof![(0..3_usize).prop_map(Channel::Position), (0..3_usize).prop_map(Channel::Rotation)], 0..8)
}

fn joint() -> impl Strategy<Value = Joint> {
    let end_sites = vec((name(), numbers()).prop_map(|(name, offset)| EndSite { name, offset }), 0..3);
    (name(), numbers(), channels(), end_sites).prop_map(|(name, offset, channels, end_sites)| Joint {
        name,
        parent: None,
        offset,
        channels,
        end_sites,
    })
}

/// Joints of which each hangs from the one before it, from one of its ancestors, or from nothing.
fn joints() -> impl Strategy<Value = Vec<Joint>> {
    vec((joint(), 0..4_usize), 1..10).prop_map(|described| {
        let mut joints: Vec<Joint> = Vec::new();
        for (mut joint, steps_up) in described {
            let mut parent = joints.len().checked_sub(1);
            for _ in 0..steps_up {
                parent = parent.and_then(|parent| joints[parent].parent);
            }
            joint.parent = parent;
            joints.push(joint);
        }
        joints
    })
}

fn bvh() -> impl Strategy<Value = Bvh> {
    (joints(), option::of((option::of(number()), 0..5_usize))).prop_flat_map(|(joints, motion)| {
        let width: usize = joints.iter().map(|joint| joint.channels.len()).sum();
        let (time, frames) = motion.unwrap_or_default();
        let frame_count = if width == 0 { 0 } else { frames };
        vec(number(), width * frame_count).prop_map(move |values| {
            let motion = motion.map(|_| BvhMotion { frame_time_s: time, frame_count, values });
            Bvh::new(joints.clone(), motion)
        })
    })
}

fn vector() -> impl Strategy<Value = DVec3> {
    prop_oneof![3 => [-9.0..9.0, -9.0..9.0, -9.0..9.0].prop_map(DVec3::from), 1 => Just(DVec3::ZERO)]
}

fn rotation() -> impl Strategy<Value = DQuat> {
    let order = proptest::sample::select(EulerOrder::ALL.to_vec());
    (order, [-3.0..3.0, -3.0..3.0, -3.0..3.0]).prop_map(|(order, angles)| order.quat(angles))
}

/// Any skeleton and motion, also such as come from other formats and in another order of bones.
fn skeleton_and_motion() -> impl Strategy<Value = (Skeleton, Motion)> {
    let bone = ("[a-z: #{\n]{0,4}", vector(), vector(), rotation(), any::<prop::sample::Index>(), any::<bool>());
    let samples = (any::<[bool; 3]>(), vec((rotation(), vector(), -1.0..1.0), 3));
    vec((bone, samples), 1..8).prop_map(|described| {
        let mut bones: Vec<Bone> = Vec::new();
        let mut motions = Vec::new();
        for ((name, offset, tail, axes, parent, is_root), (has, frames)) in described {
            let parent = (!bones.is_empty() && !is_root).then(|| parent.index(bones.len()));
            let order = EulerOrder::Xyz;
            bones.push(Bone { name, parent, offset, tail, axes, order, dofs: vec![], limits: vec![] });
            motions.push(BoneMotion {
                rotations: frames.iter().filter(|_| has[0]).map(|frame| frame.0).collect(),
                angles: Vec::new(),
                translations: frames.iter().filter(|_| has[1]).map(|frame| frame.1).collect(),
                stretches: frames.iter().filter(|_| has[2]).map(|frame| frame.2).collect(),
            });
        }
        let unit = LengthUnit { metres: 1.0, reason: String::new(), is_certain: false };
        let skeleton = Skeleton { name: String::new(), bones, up: DVec3::Y, unit };
        (skeleton, Motion { bones: motions, first_frame: 1, frame_count: 3, rate_hz: Some(60.0) })
    })
}

/// Returns how far joints are from where they were, at most, at some frames of the motion. The second skeleton has them
/// in the order `places` says.
fn furthest(first: (&Skeleton, &Motion), second: (&Skeleton, &Motion), places: &[usize]) -> f64 {
    let frames = 0..first.1.frame_count as i64;
    let frames = frames.step_by(first.1.frame_count / 20 + 1);
    let distance = |frame: i64| {
        let before = pose(first.0, first.1, (first.1.first_frame + frame) as f64);
        let after = pose(second.0, second.1, (second.1.first_frame + frame) as f64);
        let pairs = before.heads.into_iter().zip(places.iter().map(|place| after.heads[*place]));
        pairs.map(|(before, after)| before.distance(after)).fold(0.0, f64::max)
    };
    frames.map(distance).fold(0.0, f64::max)
}

/// Returns where bones of these names are among others.
fn places(names: &Skeleton, among: &Skeleton) -> Vec<usize> {
    names.bones.iter().map(|bone| among.index_of(&bone.name).unwrap_or_else(|| panic!("{}", bone.name))).collect()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(400))]

    #[test]
    fn a_file_reads_back_as_it_was_written(bvh in bvh()) {
        let bytes = bvh.to_bytes();
        let again = Bvh::parse(&bytes);
        prop_assert_eq!(again.as_ref(), Ok(&bvh), "{}", String::from_utf8_lossy(&bytes));
        // Equality takes 0 for -0; the text does not.
        prop_assert_eq!(again.map(|bvh| bvh.to_bytes()), Ok(bytes));
    }

    #[test]
    fn values_may_stand_on_any_lines(values in vec(number(), 12), breaks in any::<u16>()) {
        let joint = |channels| Joint { channels, ..Joint::default() };
        let bvh = Bvh::new(
            vec![joint(vec![Channel::Position(1), Channel::Rotation(2), Channel::Rotation(0)])],
            Some(BvhMotion { frame_time_s: Some(1.0), frame_count: 4, values }),
        );
        let text = String::from_utf8(bvh.to_bytes()).unwrap();
        let (head, rows) = text.split_once("Frame Time: 1\n").unwrap();
        // Every line at most one value: then no line is a frame, and line ends mean nothing.
        let single = rows.split_whitespace().enumerate().map(|(index, value)| {
            let blank = if breaks >> (index % 16) & 1 == 1 { "\n\n \t" } else { "\r\n" };
            format!("{value}{blank}")
        });
        let text = format!("{head}Frame Time: 1\n{}", single.collect::<Vec<_>>().concat());
        prop_assert_eq!(Bvh::parse(text.as_bytes()), Ok(bvh));
    }

    #[test]
    fn any_skeleton_and_motion_keep_their_places((skeleton, motion) in skeleton_and_motion()) {
        let mut named = skeleton.clone();
        for (index, bone) in named.bones.iter_mut().enumerate() {
            bone.name = format!("{index}");
        }
        let file = Bvh::from_motion(&skeleton, &motion);
        prop_assert_eq!(Bvh::parse(&file.to_bytes()), Ok(file));
        let again = Bvh::parse(&Bvh::from_motion(&named, &motion).to_bytes()).unwrap();
        let (reread, moved) = again.skeleton_and_motion();
        let moved = moved.unwrap();
        prop_assert_eq!((moved.frame_count, moved.rate_hz), (3, Some(60.0)));
        let places = places(&named, &reread);
        prop_assert!(furthest((&named, &motion), (&reread, &moved), &places) < 1e-8);
        for (bone, place) in named.bones.iter().zip(places) {
            let same = reread.bones[place].tail.distance(bone.tail) < 1e-8;
            prop_assert!(same || bone.tail == DVec3::ZERO, "{:?}", bone);
        }
    }
}

fn folder() -> Option<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../shared/data");
    folder.is_dir().then_some(folder)
}

fn real_files(folder: &Path) -> Vec<PathBuf> {
    let mut files: Vec<_> = std::fs::read_dir(folder.join("bvh")).unwrap().map(|entry| entry.unwrap().path()).collect();
    files.sort();
    assert_eq!(files.len(), 39);
    files
}

#[test]
fn every_real_file_is_read_without_fault_and_survives_writing() {
    let Some(folder) = folder() else { return };
    for path in real_files(&folder) {
        let clip = read_path(&path, None).unwrap();
        let (bvh, motion) = (clip.bvh.as_ref().unwrap(), clip.motion.as_ref().unwrap());
        assert_eq!((clip.format, bvh.notices()), (Format::Bvh, vec![]), "{}", path.display());
        assert_eq!(bvh.motion.as_ref().unwrap().values.len(), bvh.width() * motion.frame_count);
        let again = Bvh::parse(&clip.to_bytes()).unwrap();
        let bits = |bvh: &Bvh| bvh.motion.iter().flat_map(|m| &m.values).map(|v| v.to_bits()).collect::<Vec<_>>();
        assert_eq!((&again, bits(&again)), (bvh, bits(bvh)), "{}", path.display());
    }
}

#[test]
fn every_real_file_keeps_its_places_as_a_motion_and_through_acclaim_files() {
    let Some(folder) = folder() else { return };
    for path in real_files(&folder) {
        let clip = read_path(&path, None).unwrap();
        let (skeleton, motion) = (clip.skeleton.unwrap(), clip.motion.unwrap());
        let size: f64 = skeleton.bones.iter().map(|bone| bone.offset.length()).fold(1e-9, f64::max);

        let file = Bvh::from_motion(&skeleton, &motion);
        let (reread, moved) = file.skeleton_and_motion();
        let in_order: Vec<_> = (0..skeleton.bones.len()).collect();
        let off = furthest((&skeleton, &motion), (&reread, &moved.unwrap()), &in_order);
        assert!(off < 1e-9 * size, "{}: {off} as a motion", path.display());

        let dofs = with_dofs_for(&skeleton, &motion);
        let asf = Asf::parse(&Asf::from_skeleton(&dofs).to_bytes()).unwrap();
        let amc = Amc::parse(&Amc::from_motion(&dofs, &motion, AngleUnit::Degrees).to_bytes()).unwrap();
        let acclaim = asf.skeleton();
        let (moved, _) = amc.motion(&acclaim).unwrap();
        let back = Bvh::parse(&Bvh::from_motion(&acclaim, &moved).to_bytes()).unwrap();
        let (reread, moved) = back.skeleton_and_motion();
        // An Acclaim file adds bones that only link others; the joints are the rest, in their order.
        let joints: Vec<_> = acclaim_places(&skeleton, &reread);
        let off = furthest((&skeleton, &motion), (&reread, &moved.unwrap()), &joints);
        assert!(off < 1e-5 * size, "{}: {off} through Acclaim files", path.display());
    }
}

/// Returns where joints are among those of an Acclaim skeleton, which gives keywords another name.
fn acclaim_places(skeleton: &Skeleton, among: &Skeleton) -> Vec<usize> {
    let place = |bone: &Bone| {
        let own = bone.parent.map_or_else(|| "root".to_owned(), |_| bone.name.clone());
        among.index_of(&own).or(among.index_of(&format!("bone_{own}"))).unwrap_or_else(|| panic!("{own}"))
    };
    skeleton.bones.iter().map(place).collect()
}

#[test]
fn every_real_acclaim_motion_keeps_its_places_as_a_bvh() {
    let Some(folder) = folder().map(|folder| folder.join("asf_amc")) else { return };
    for (skeleton_file, motion_file) in [
        ("cmu01/01.asf", "cmu01/01_01.amc"),
        ("cmu02/02.asf", "cmu02/02_03.amc"),
        ("cmu02/02.asf", "cmu02/02_04.amc"),
        ("cmu09/09-run.asf", "cmu09/09_06-run.amc"),
        ("cmu135/135-martialArts.asf", "cmu135/135_06-martialArts.amc"),
        ("cmu135/135-martialArts.asf", "cmu135/135_06-martialArts-le-N40.amc"),
        ("endorphin/skeleton.asf", "endorphin/walking.amc"),
    ] {
        let skeleton = read_path(&folder.join(skeleton_file), None).unwrap().skeleton.unwrap();
        let mut motion = read_path(&folder.join(motion_file), Some(&skeleton)).unwrap().motion.unwrap();
        motion.rate_hz = Some(120.0);
        let written = Bvh::from_motion(&skeleton, &motion).to_bytes();
        let clip = read_bytes(&written, Path::new("again.bvh"), None).unwrap();
        let (reread, moved) = (clip.skeleton.unwrap(), clip.motion.unwrap());
        assert_eq!((moved.rate_hz, moved.frame_count), (Some(120.0), motion.frame_count));
        let places = places(&skeleton, &reread);
        let off = furthest((&skeleton, &motion), (&reread, &moved), &places);
        assert!(off < 1e-9 * skeleton.height(), "{motion_file}: {off}");
        for (bone, place) in skeleton.bones.iter().zip(places) {
            assert!(reread.bones[place].tail.distance(bone.tail) < 1e-9, "{motion_file}: {}", bone.name);
        }
    }
}
