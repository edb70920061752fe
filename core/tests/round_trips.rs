//! What is written reads back as the same: random files and random motions.

use glam::{DQuat, DVec3};
use motion_theater_core::formats::amc::{with_dofs_for, Amc, AmcBone, AmcHeader};
use motion_theater_core::formats::asf::{Asf, AsfBone, Family, OtherSection, Root, Units};
use motion_theater_core::formats::AngleUnit;
use motion_theater_core::{Bone, BoneMotion, Dof, EulerOrder, LengthUnit, Motion, Skeleton};
use proptest::collection::vec;
use proptest::option;
use proptest::prelude::*;

/// Any number that a file may hold, those with all their digits and those that people write.
fn number() -> impl Strategy<Value = f64> {
    let any_bits = any::<f64>().prop_filter("bearable", |value| value.abs() <= 1e15);
    prop_oneof![any_bits, -200.0..200.0, (-20_000..20_000).prop_map(|n| f64::from(n) / 100.0), Just(-0.0)]
}

fn numbers() -> impl Strategy<Value = [f64; 3]> {
    [number(), number(), number()]
}

fn order() -> impl Strategy<Value = EulerOrder> {
    proptest::sample::select(EulerOrder::ALL.to_vec())
}

fn dofs() -> impl Strategy<Value = Vec<Dof>> {
    let all: Vec<_> = (0..3).flat_map(|axis| [Dof::Translate(axis), Dof::Rotate(axis)]).chain([Dof::Length]).collect();
    let count = all.len();
    proptest::sample::subsequence(all, 0..=count).prop_shuffle()
}

fn angle_unit() -> impl Strategy<Value = AngleUnit> {
    prop_oneof![Just(AngleUnit::Degrees), Just(AngleUnit::Radians)]
}

fn limit() -> impl Strategy<Value = (f64, f64)> {
    let bound = || prop_oneof![any::<f64>().prop_filter("a number", |v| !v.is_nan()), Just(f64::INFINITY), number()];
    (bound(), bound())
}

/// A line that no reader takes for something else.
fn other_line() -> impl Strategy<Value = String> {
    "x[a-z]{0,5}( {1,3}[-(a-z0-9.é]{1,6}){0,4}"
}

fn asf_bone(name: String) -> impl Strategy<Value = AsfBone> {
    let place = (option::of(any::<i64>()), numbers(), number(), numbers(), order());
    let freedom = (dofs(), vec(limit(), 0..4), option::of(number()), vec(number(), 0..4), vec(other_line(), 0..3));
    (place, freedom).prop_map(move |((id, direction, length, axis, axis_order), freedom)| {
        let (dofs, limits, body_mass, centre_of_mass, others) = freedom;
        let name = name.clone();
        AsfBone { id, name, direction, length, axis, axis_order, dofs, limits, body_mass, centre_of_mass, others }
    })
}

/// Bones with names of their own; the parent of each is the root or any bone before it.
fn bones_and_hierarchy() -> impl Strategy<Value = (Vec<AsfBone>, Vec<Family>)> {
    let names = vec("[A-Za-z_é][-A-Za-z0-9_:.#(]{0,8}", 0..12).prop_map(|mut names| {
        for (index, name) in names.iter_mut().enumerate() {
            name.push_str(&index.to_string());
        }
        names
    });
    names.prop_flat_map(|names| {
        let parents = vec(any::<prop::sample::Index>(), names.len());
        let bones: Vec<_> = names.iter().map(|name| asf_bone(name.clone())).collect();
        (bones, parents, Just(names)).prop_map(|(bones, parents, names)| {
            let with_root: Vec<_> = std::iter::once("root".to_owned()).chain(names.clone()).collect();
            let families = names.iter().zip(parents).enumerate().map(|(index, (name, parent))| Family {
                parent: with_root[parent.index(index + 1)].clone(),
                children: vec![name.clone()],
            });
            let families = families.collect();
            (bones, families)
        })
    })
}

fn asf() -> impl Strategy<Value = Asf> {
    let text = || option::of("[a-z0-9.]{0,8}( [a-z]{1,5}){0,2}".prop_map(|text| text.trim().to_owned()));
    let units = (option::of(number()), option::of(1e-9..1e9), option::of(angle_unit()), vec(other_line(), 0..2))
        .prop_map(|(mass, length, angle, others)| Units { mass, length, angle, others });
    let root = (dofs(), order(), numbers(), numbers(), vec(other_line(), 0..2))
        .prop_map(|(order, axis, position, orientation, others)| Root { order, axis, position, orientation, others });
    let lines = || {
        vec("[ #a-z]{0,3}[a-z0-9 #():é\t]{0,12}".prop_filter("no section", |l| !l.trim_start().starts_with(':')), 0..4)
    };
    let other = (":x[a-z-]{0,6}", "([a-z]{1,4}  ?[a-z]{1,4})?", lines())
        .prop_map(|(name, value, lines)| OtherSection { name, value, lines });
    (text(), text(), units, option::of(lines()), root, bones_and_hierarchy(), vec(other, 0..3)).prop_map(
        |(version, name, units, documentation, root, (bones, hierarchy), others)| Asf {
            version,
            name,
            units,
            documentation,
            root,
            bones,
            hierarchy,
            others,
        },
    )
}

fn amc() -> impl Strategy<Value = Amc> {
    let widths = vec(0_usize..7, 1..8);
    let header =
        (option::of("[A-Z]:[a-z ]{0,8}[a-z]"), any::<[bool; 2]>(), option::of(angle_unit()), option::of(1e-3..1e6_f64));
    let others = vec(":X[A-Z]{0,6}( {1,2}[a-z0-9]{1,5}){0,2}", 0..3);
    (widths, 1_usize..6, any::<i32>(), any::<bool>(), header, others).prop_flat_map(
        |(widths, frame_count, first, is_even, (skeleton_hint, flags, angle, rate_hz), others)| {
            let first_frame = i64::from(first);
            let bones = widths.iter().enumerate().map(|(i, width)| AmcBone { name: format!("b{i}"), width: *width });
            let bones: Vec<_> = bones.collect();
            let is_listed = !is_even && frame_count > 1;
            let frame_numbers =
                if is_listed { (0..frame_count as i64).map(|i| first_frame - 2 * i).collect() } else { vec![] };
            let header = AmcHeader {
                skeleton_hint,
                is_fully_specified: flags[0],
                is_forced_to_3dof: flags[1],
                angle,
                rate_hz,
                others,
            };
            let amc = Amc { header, bones, first_frame, frame_count, frame_numbers, values: Vec::new() };
            vec(number(), frame_count * amc.width()).prop_map(move |values| Amc { values, ..amc.clone() })
        },
    )
}

fn vector() -> impl Strategy<Value = DVec3> {
    prop_oneof![3 => [-9.0..9.0, -9.0..9.0, -9.0..9.0].prop_map(DVec3::from), 1 => Just(DVec3::ZERO)]
}

fn rotation() -> impl Strategy<Value = DQuat> {
    (order(), [-3.0..3.0, -3.0..3.0, -3.0..3.0]).prop_map(|(order, angles)| order.quat(angles))
}

/// Any skeleton and motion, also such as no Acclaim file can say directly.
fn skeleton_and_motion() -> impl Strategy<Value = (Skeleton, Motion)> {
    let bone = ("[a-z: #]{0,4}", vector(), vector(), rotation(), order(), any::<prop::sample::Index>(), 0..10_u8);
    let channels = (any::<[bool; 3]>(), vec((rotation(), vector(), -1.0..1.0), 4));
    vec((bone, channels), 1..8).prop_map(|bones| {
        let (bones, motions): (Vec<_>, Vec<_>) = bones
            .into_iter()
            .enumerate()
            .map(|(index, ((name, offset, tail, axes, order, parent, freedom), (has, frames)))| {
                let parent = (index > 0 && freedom > 0).then(|| parent.index(index.max(1)));
                let bone = Bone { name, parent, offset, tail, axes, order, dofs: Vec::new(), limits: Vec::new() };
                let motion = BoneMotion {
                    rotations: frames.iter().filter(|_| has[0]).map(|frame| frame.0).collect(),
                    angles: Vec::new(),
                    translations: frames.iter().filter(|_| has[1]).map(|frame| frame.1).collect(),
                    stretches: frames.iter().filter(|_| has[2]).map(|frame| frame.2).collect(),
                };
                (bone, motion)
            })
            .unzip();
        let unit = LengthUnit { metres: 0.0254 / 0.45, reason: String::new(), is_certain: true };
        let skeleton = Skeleton { name: "any".to_owned(), bones, up: DVec3::Y, unit };
        (skeleton, Motion { bones: motions, first_frame: 7, frame_count: 4, rate_hz: Some(60.0) })
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(400))]

    #[test]
    fn a_skeleton_file_reads_back_as_it_was_written(asf in asf()) {
        let bytes = asf.to_bytes();
        let again = Asf::parse(&bytes);
        prop_assert_eq!(again.as_ref(), Ok(&asf), "{}", String::from_utf8_lossy(&bytes));
        // Equality takes 0 for -0; the text does not.
        prop_assert_eq!(again.map(|asf| asf.to_bytes()), Ok(bytes));
    }

    #[test]
    fn a_motion_file_reads_back_as_it_was_written(amc in amc()) {
        let bytes = amc.to_bytes();
        let again = Amc::parse(&bytes);
        prop_assert_eq!(again.as_ref(), Ok(&amc), "{}", String::from_utf8_lossy(&bytes));
        prop_assert_eq!(again.map(|amc| amc.to_bytes()), Ok(bytes));
    }

    #[test]
    fn an_unusual_layout_reads_as_the_usual_one(amc in amc(), seed in any::<u64>()) {
        let usual = amc.to_bytes();
        let mut dice = seed | 1;
        let mut unusual = Vec::new();
        for byte in usual {
            dice = dice.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            match (byte, dice >> 61) {
                (b' ', 0) if !unusual.ends_with(b"ASF") => unusual.extend_from_slice(b"  \t"),
                (b'\n', 1) => unusual.extend_from_slice(b"\r\n"),
                (b'\n', 2) => unusual.extend_from_slice(b"\n\n# x\n  "),
                (b'\n', 3) => unusual.extend_from_slice(b" # 1 2\n"),
                (byte, _) => unusual.push(byte),
            }
        }
        // Blanks within other keywords' lines and a comment behind the hint belong to them.
        let mut again = Amc::parse(&unusual).map_err(|error| TestCaseError::fail(error.to_string()))?;
        again.header.others.clone_from(&amc.header.others);
        again.header.skeleton_hint.clone_from(&amc.header.skeleton_hint);
        prop_assert_eq!(again, amc);
    }

    #[test]
    fn any_skeleton_and_motion_can_be_written((skeleton, motion) in skeleton_and_motion(), unit in angle_unit()) {
        let skeleton = with_dofs_for(&skeleton, &motion);
        let file = Asf::from_skeleton(&skeleton);
        let reread = Asf::parse(&file.to_bytes());
        prop_assert_eq!(reread.as_ref(), Ok(&file), "{}", String::from_utf8_lossy(&file.to_bytes()));
        let again = file.skeleton();

        let amc = Amc::from_motion(&skeleton, &motion, unit);
        prop_assume!(!amc.bones.is_empty());
        prop_assert_eq!(Amc::parse(&amc.to_bytes()), Ok(amc.clone()));
        let (moved, notices) = amc.motion(&again).map_err(|error| TestCaseError::fail(error.to_string()))?;
        prop_assert!(notices.is_empty(), "{:?}", notices);
        prop_assert_eq!((moved.first_frame, moved.frame_count, moved.rate_hz), (7, 4, Some(60.0)));

        // Bones keep their relative order; what links them is new and has no degrees of freedom.
        let has_single_root = skeleton.bones.iter().filter(|bone| bone.parent.is_none()).count() == 1;
        let links = |bone: &&Bone| bone.name.ends_with("_dum") || !has_single_root && bone.parent.is_none();
        let heads = again.rest_heads();
        let kept: Vec<_> = (0..again.bones.len()).filter(|i| !links(&&again.bones[*i])).collect();
        prop_assert_eq!(kept.len(), skeleton.bones.len());
        for ((index, head), (bone, channels)) in kept.into_iter().zip(skeleton.rest_heads()).zip(skeleton.bones.iter().zip(&motion.bones)) {
            prop_assert!(heads[index].distance(head) < 1e-9, "{} at {}", bone.name, head);
            prop_assert!(again.bones[index].axes.dot(bone.axes).abs() > 1.0 - 1e-12);
            for (wanted, found) in channels.rotations.iter().zip(&moved.bones[index].rotations) {
                prop_assert!(wanted.dot(*found).abs() > 1.0 - 1e-12, "{wanted} {found}");
            }
            let wanted = channels.translations.iter().copied().filter(|_| !bone.dofs.is_empty());
            for (wanted, found) in wanted.zip(&moved.bones[index].translations) {
                prop_assert!(wanted.distance(*found) < 1e-9, "{wanted} {found}");
            }
            prop_assert!(channels.stretches.is_empty() || moved.bones[index].stretches == channels.stretches);
        }
    }
}
