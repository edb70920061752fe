//! A skeleton as plain data: names, parents and the rest pose, in the file's own axes and units.

use glam::{DQuat, DVec3};

/// The order in which three Euler angles are applied, named as Blender and Acclaim do:
/// `XYZ` turns about X first, then Y, then Z, about fixed axes (column vectors, `R = Rz * Ry * Rx`).
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Hash)]
pub enum EulerOrder {
    /// X, then Y, then Z.
    #[default]
    Xyz,
    /// X, then Z, then Y.
    Xzy,
    /// Y, then X, then Z.
    Yxz,
    /// Y, then Z, then X.
    Yzx,
    /// Z, then X, then Y.
    Zxy,
    /// Z, then Y, then X.
    Zyx,
}

/// One degree of freedom of a bone: the meaning of one value of a frame.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Dof {
    /// Translation along the bone's own X, Y or Z (0, 1, 2).
    Translate(usize),
    /// Rotation about the bone's own X, Y or Z (0, 1, 2).
    Rotate(usize),
    /// Change of the bone's length (Acclaim `l`).
    Length,
}

/// Inclusive bounds of one degree of freedom; radians for rotations, file units otherwise.
/// Infinite where the file says so.
pub type Limit = (f64, f64);

/// One joint and the bone that starts there.
#[derive(Debug, Clone, PartialEq)]
pub struct Bone {
    /// The file's own name.
    pub name: String,
    /// Index of the parent, always smaller than the bone's own; `None` for a root.
    pub parent: Option<usize>,
    /// From the parent's start to this bone's start in the rest pose (for a root: from the origin), file axes and units.
    pub offset: DVec3,
    /// From this bone's start to its end in the rest pose, file axes and units; zero for a point.
    pub tail: DVec3,
    /// The bone's own rotation axes in the rest pose: bone axes to file axes (the rotation by Acclaim `axis`).
    pub axes: DQuat,
    /// The order of the rotations among `dofs`; `Xyz` where there are fewer than two.
    pub order: EulerOrder,
    /// The values of a frame, in file order; empty for a bone that does not move by itself.
    pub dofs: Vec<Dof>,
    /// One per degree of freedom, or empty where the file gives none.
    pub limits: Vec<Limit>,
}

/// The unit in which a file's lengths are to be understood, and why.
#[derive(Debug, Clone, PartialEq)]
pub struct LengthUnit {
    /// Metres per file unit.
    pub metres: f64,
    /// The reason in words: "inches / 0.45, as in the public Acclaim data sets: a person of 1.74 m".
    pub reason: String,
    /// False where several readings were plausible, or none.
    pub is_certain: bool,
}

/// Names, hierarchy and rest pose.
#[derive(Debug, Clone, PartialEq)]
pub struct Skeleton {
    /// The skeleton's own name, possibly empty.
    pub name: String,
    /// Parents before children.
    pub bones: Vec<Bone>,
    /// The axis that points up in the rest pose, in file axes.
    pub up: DVec3,
    /// How long a file unit is.
    pub unit: LengthUnit,
}

impl Skeleton {
    /// Returns where each bone starts in the rest pose, in file axes and units.
    pub fn rest_heads(&self) -> Vec<DVec3> {
        let mut heads: Vec<DVec3> = Vec::with_capacity(self.bones.len());
        for bone in &self.bones {
            let from = bone.parent.map_or(DVec3::ZERO, |parent| heads[parent]);
            heads.push(from + bone.offset);
        }
        heads
    }

    /// Returns the extent of the rest pose along [`Skeleton::up`], in file units.
    pub fn height(&self) -> f64 {
        let ends = self.rest_heads().into_iter().zip(&self.bones);
        let along_up = ends.flat_map(|(head, bone)| [head.dot(self.up), (head + bone.tail).dot(self.up)]);
        let (low, high) = along_up.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), y| (low.min(y), high.max(y)));
        if low <= high {
            high - low
        } else {
            0.0
        }
    }

    /// Returns the index of the bone with that exact name.
    pub fn index_of(&self, name: &str) -> Option<usize> {
        self.bones.iter().position(|bone| bone.name == name)
    }
}
