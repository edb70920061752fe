//! [`Amc`] + [`Skeleton`] -> [`Motion`].

use super::Amc;
use crate::error::MisfitError;
use crate::formats::asf::{dof_words, rotation_order};
use crate::motion::{BoneMotion, Motion};
use crate::skeleton::{Bone, Dof, EulerOrder, Skeleton};
use glam::{DQuat, DVec3};
use rayon::prelude::*;
use std::collections::HashMap;

/// What `:FORCE-ALL-JOINTS-BE-3DOF` asks for, if it means what it says.
const THREE_ROTATIONS: [Dof; 3] = [Dof::Rotate(0), Dof::Rotate(1), Dof::Rotate(2)];

impl Amc {
    /// Returns the motion of a skeleton's bones and, a sentence each, what the user should know.
    ///
    /// A bone turns by `L = C * M * C^-1` in its parent's frame: `C` the bone's axes, `M` its rotations, the first listed
    /// applied first about fixed axes. The root's translation is in file axes, another bone's along the bone's own axes.
    /// Bones are found by their exact name, or else by the only one that differs in case alone. Bones without a line
    /// stay at rest.
    ///
    /// # Errors
    /// Where bones are not in the skeleton or have another number of values there: all of them are named.
    pub fn motion(&self, skeleton: &Skeleton) -> Result<(Motion, Vec<String>), MisfitError> {
        let mut notices = self.notices();
        let columns = self.match_bones(skeleton, &mut notices)?;
        let bones = skeleton.bones.par_iter().zip(&columns);
        let bones = bones
            .map(|(bone, columns)| columns.as_ref().map_or_else(BoneMotion::default, |c| self.bone_motion(bone, c)));
        let motion = Motion {
            bones: bones.collect(),
            first_frame: self.first_frame,
            frame_count: self.frame_count,
            rate_hz: self.header.rate_hz,
        };
        Ok((motion, notices))
    }

    /// Returns for each bone of the skeleton which columns are whose values.
    fn match_bones(&self, skeleton: &Skeleton, notices: &mut Vec<String>) -> Result<Vec<Option<Columns>>, MisfitError> {
        let names = Names::new(skeleton);
        let mut columns: Vec<Option<Columns>> = vec![None; skeleton.bones.len()];
        let (mut misfits, mut renamed, mut padded, mut free) = (Vec::new(), Vec::new(), Vec::new(), Vec::new());
        let mut start = 0;
        for bone in &self.bones {
            let first = start;
            start += bone.width;
            let Some(index) = names.find(&bone.name) else {
                misfits.push(bone.name.clone());
                continue;
            };
            let known = &skeleton.bones[index];
            if known.name != bone.name {
                renamed.push(format!("{} = {}", bone.name, known.name));
            }
            let dofs = if bone.width == known.dofs.len() {
                known.dofs.clone()
            } else if self.header.is_forced_to_3dof
                && bone.width == THREE_ROTATIONS.len()
                && known.dofs.len() < bone.width
            {
                if self.is_zero(first + known.dofs.len()..start) {
                    padded.push(known.name.as_str());
                    known.dofs.clone()
                } else {
                    free.push(known.name.as_str());
                    THREE_ROTATIONS.to_vec()
                }
            } else {
                misfits.push(format!("{} ({})", bone.name, wrong_count(known, bone.width)));
                continue;
            };
            if columns[index].replace(Columns { first, dofs }).is_some() {
                misfits.push(format!("{} (a second line for {})", bone.name, known.name));
            }
        }
        if !misfits.is_empty() {
            return Err(MisfitError { bones: misfits });
        }
        // Where one bone shows that three values are three rotations, they are that for all.
        if !free.is_empty() {
            for index in padded.drain(..).filter_map(|name| skeleton.index_of(name)) {
                if let Some(columns) = &mut columns[index] {
                    columns.dofs = THREE_ROTATIONS.to_vec();
                }
            }
        }
        let is_absent = |(bone, columns): &(&Bone, &Option<Columns>)| columns.is_none() && !bone.dofs.is_empty();
        let absent: Vec<_> =
            skeleton.bones.iter().zip(&columns).filter(is_absent).map(|(b, _)| b.name.as_str()).collect();
        if !renamed.is_empty() {
            notices.push(format!("Bones found by names that differ in case: {}", renamed.join(", ")));
        }
        if !padded.is_empty() {
            notices
                .push("Three values for every bone: they are its degrees of freedom, filled up with zeros".to_owned());
        }
        if !free.is_empty() {
            let names = free.join(", ");
            notices.push(format!(
                "Three values for every bone: taken as rx ry rz, also beyond degrees of freedom: {names}"
            ));
        }
        if !absent.is_empty() {
            notices.push(format!("Bones without motion stay at rest: {}", absent.join(", ")));
        }
        Ok(columns)
    }

    /// Returns whether these columns are zero in every frame.
    fn is_zero(&self, columns: std::ops::Range<usize>) -> bool {
        let mut frames = self.values.chunks_exact(self.width().max(1));
        frames.all(|row| row.get(columns.clone()).is_some_and(|values| values.iter().all(|value| *value == 0.0)))
    }

    fn bone_motion(&self, bone: &Bone, columns: &Columns) -> BoneMotion {
        let unit = self.angle_unit();
        let order = columns.order(bone);
        let has = |kind: fn(&Dof) -> bool| columns.dofs.iter().any(kind);
        let (rotates, translates) =
            (has(|dof| matches!(dof, Dof::Rotate(_))), has(|dof| matches!(dof, Dof::Translate(_))));
        let stretches = columns.dofs.contains(&Dof::Length);
        let room = |is_used: bool| if is_used { self.frame_count } else { 0 };
        let mut motion = BoneMotion {
            rotations: Vec::with_capacity(room(rotates)),
            angles: Vec::with_capacity(room(rotates)),
            translations: Vec::with_capacity(room(translates)),
            stretches: Vec::with_capacity(room(stretches)),
        };
        let mut previous = DQuat::IDENTITY;
        for row in self.values.chunks_exact(self.width().max(1)) {
            let values = row.get(columns.first..).unwrap_or_default();
            let (mut angles, mut translation, mut stretch) = ([0.0; 3], [0.0; 3], 0.0);
            for (dof, value) in columns.dofs.iter().zip(values) {
                match dof {
                    Dof::Rotate(axis) => angles[*axis] = unit.radians(*value),
                    Dof::Translate(axis) => translation[*axis] = *value,
                    Dof::Length => stretch = *value,
                }
            }
            if rotates {
                let turn = order.quat(angles);
                // C * M * C^-1 turns by the same angle about the axis turned by C.
                let axis = bone.axes * DVec3::new(turn.x, turn.y, turn.z);
                let rotation = DQuat::from_xyzw(axis.x, axis.y, axis.z, turn.w);
                previous = if rotation.dot(previous) < 0.0 { -rotation } else { rotation };
                motion.rotations.push(previous);
                motion.angles.push(angles);
            }
            if translates {
                let translation = DVec3::from(translation);
                motion.translations.push(if bone.parent.is_none() { translation } else { bone.axes * translation });
            }
            if stretches {
                motion.stretches.push(stretch);
            }
        }
        motion
    }
}

/// Which values of a frame are a bone's, and what they mean.
#[derive(Debug, Clone)]
struct Columns {
    first: usize,
    dofs: Vec<Dof>,
}

impl Columns {
    fn order(&self, bone: &Bone) -> EulerOrder {
        if self.dofs == bone.dofs {
            bone.order
        } else {
            rotation_order(&self.dofs)
        }
    }
}

fn wrong_count(bone: &Bone, found: usize) -> String {
    let wanted = bone.dofs.len();
    let plural = if wanted == 1 { "" } else { "s" };
    let dofs = if wanted == 0 { "no degree of freedom".to_owned() } else { dof_words(&bone.dofs) };
    format!("needs {wanted} value{plural}: {dofs}; the motion has {found}")
}

/// The bones of a skeleton by name.
struct Names<'a> {
    exact: HashMap<&'a str, usize>,
    /// By name in lower case; `None` where several bones share it.
    folded: HashMap<String, Option<usize>>,
}

impl<'a> Names<'a> {
    fn new(skeleton: &'a Skeleton) -> Self {
        let mut names = Self { exact: HashMap::new(), folded: HashMap::new() };
        for (index, bone) in skeleton.bones.iter().enumerate() {
            names.exact.entry(&bone.name).or_insert(index);
            let first = |slot: &mut Option<usize>| *slot = None;
            names.folded.entry(bone.name.to_lowercase()).and_modify(first).or_insert(Some(index));
        }
        names
    }

    fn find(&self, name: &str) -> Option<usize> {
        self.exact.get(name).copied().or_else(|| self.folded.get(&name.to_lowercase()).copied().flatten())
    }
}
