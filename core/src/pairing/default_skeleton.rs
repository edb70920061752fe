//! The skeleton that stands in where a motion's own is not to be found.

use std::sync::LazyLock;

use crate::formats::asf::Asf;
use crate::skeleton::Skeleton;

/// The built-in default skeleton as an ASF file: the usual Acclaim human, root and 30 bones.
pub const DEFAULT_SKELETON_ASF: &str = include_str!("default_skeleton.asf");

/// What is told where it is used.
pub const DEFAULT_SKELETON_NOTICE: &str =
    "No skeleton was found; the built-in default skeleton is used: sizes are a guess";

/// Returns the built-in default skeleton: a person of about 1.75 m, Y up, facing +Z, in inches times 0.45.
pub fn default_skeleton() -> &'static Skeleton {
    static SKELETON: LazyLock<Skeleton> =
        LazyLock::new(|| Asf::parse(DEFAULT_SKELETON_ASF.as_bytes()).unwrap_or_default().skeleton());
    &SKELETON
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::formats::asf::dof_words;
    use glam::DVec3;

    #[test]
    fn it_is_the_usual_human_of_root_and_thirty_bones() {
        assert!(Asf::parse(DEFAULT_SKELETON_ASF.as_bytes()).is_ok());
        let skeleton = default_skeleton();
        assert_eq!((skeleton.bones.len(), skeleton.up), (31, DVec3::Y));
        let parent_of = |name: &str| {
            let parent = skeleton.bones[skeleton.index_of(name).unwrap()].parent;
            parent.map(|parent| skeleton.bones[parent].name.as_str())
        };
        let middle = ["root", "lowerback", "upperback", "thorax", "lowerneck", "upperneck", "head"];
        for pair in middle.windows(2) {
            assert_eq!(parent_of(pair[1]), Some(pair[0]));
        }
        for side in ["l", "r"] {
            let chains: [&[&str]; 4] = [
                &["hipjoint", "femur", "tibia", "foot", "toes"],
                &["clavicle", "humerus", "radius", "wrist", "hand", "fingers"],
                &["wrist", "thumb"],
                &["wrist", "hand"],
            ];
            for pair in chains.iter().flat_map(|chain| chain.windows(2)) {
                assert_eq!(parent_of(&format!("{side}{}", pair[1])), Some(format!("{side}{}", pair[0]).as_str()));
            }
            assert_eq!(parent_of(&format!("{side}hipjoint")), Some("root"));
            assert_eq!(parent_of(&format!("{side}clavicle")), Some("thorax"));
        }
    }

    #[test]
    fn its_degrees_of_freedom_are_the_usual_ones() {
        let usual = [
            ("root", "tx ty tz rx ry rz"),
            ("hipjoint", ""),
            ("femur", "rx ry rz"),
            ("tibia", "rx"),
            ("foot", "rx rz"),
            ("toes", "rx"),
            ("lowerback", "rx ry rz"),
            ("upperback", "rx ry rz"),
            ("thorax", "rx ry rz"),
            ("lowerneck", "rx ry rz"),
            ("upperneck", "rx ry rz"),
            ("head", "rx ry rz"),
            ("clavicle", "ry rz"),
            ("humerus", "rx ry rz"),
            ("radius", "rx"),
            ("wrist", "ry"),
            ("hand", "rx rz"),
            ("fingers", "rx"),
            ("thumb", "rx rz"),
        ];
        for bone in &default_skeleton().bones {
            let dofs = usual.iter().find(|(name, _)| bone.name == *name || bone.name.get(1..) == Some(name));
            assert_eq!(Some(dof_words(&bone.dofs).as_str()), dofs.map(|(_, dofs)| *dofs), "{}", bone.name);
        }
    }

    #[test]
    fn it_is_a_person_of_about_1_75_m() {
        let skeleton = default_skeleton();
        let metres = |name: &str| skeleton.bones[skeleton.index_of(name).unwrap()].tail.length() * skeleton.unit.metres;
        assert!((skeleton.unit.metres - 0.0254 / 0.45).abs() < 1e-15);
        let back =
            ["lowerback", "upperback", "thorax", "lowerneck", "upperneck", "head"].map(metres).iter().sum::<f64>();
        let legs = ["lfemur", "ltibia"].map(metres).iter().sum::<f64>();
        // The bones end at the ankles and within the skull: a person is about a seventh of a metre taller.
        let hip_drop = 0.76 * metres("lhipjoint");
        let tall = back + hip_drop + legs + 0.14;
        assert!((tall - 1.75).abs() < 0.05, "{tall}");
    }
}
