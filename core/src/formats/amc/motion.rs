//! [`Amc`] + [`Skeleton`] -> [`Motion`].

use super::Amc;
use crate::error::MisfitError;
use crate::formats::asf::{dof_words, rotation_order};
use crate::formats::frame_values::FrameValues;
use crate::motion::{BoneMotion, Motion};
use crate::skeleton::{Bone, Dof, EulerOrder, Skeleton};
use glam::{DQuat, DVec3};
use rayon::prelude::*;
use std::collections::HashMap;

/// What `:FORCE-ALL-JOINTS-BE-3DOF` asks for, if it means what it says.
const THREE_ROTATIONS: [Dof; 3] = [Dof::Rotate(0), Dof::Rotate(1), Dof::Rotate(2)];

impl Amc {
    /// Whether [`Amc::motion`] would find no misfit.
    pub(crate) fn fits(&self, skeleton: &Skeleton) -> bool {
        self.match_bones(skeleton).is_ok()
    }

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
        let matching = self.match_bones(skeleton)?;
        let bones = skeleton.bones.par_iter().zip(&matching.columns);
        let bones = bones
            .map(|(bone, columns)| columns.as_ref().map_or_else(BoneMotion::default, |c| self.bone_motion(bone, c)));
        let motion = Motion {
            bones: bones.collect(),
            first_frame: self.first_frame,
            frame_count: self.frame_count,
            rate_hz: self.header.rate_hz,
        };
        let mut notices = self.notices();
        notices.extend(matching.notices(skeleton));
        Ok((motion, notices))
    }

    /// Finds each bone of the file in the skeleton.
    fn match_bones(&self, skeleton: &Skeleton) -> Result<Matching, MisfitError> {
        let names = Names::new(skeleton);
        let mut matching = Matching { columns: vec![None; skeleton.bones.len()], ..Matching::default() };
        let mut misfits = Vec::new();
        let mut next = 0;
        for bone in &self.bones {
            let first = next;
            next += bone.width;
            let Some(index) = names.find(&bone.name) else {
                misfits.push(bone.name.clone());
                continue;
            };
            let known = &skeleton.bones[index];
            let dofs = if bone.width == known.dofs.len() {
                known.dofs.clone()
            } else if !self.header.is_forced_to_3dof || bone.width != 3 || known.dofs.len() > 3 {
                misfits.push(format!("{} ({})", bone.name, wrong_count(known, bone.width)));
                continue;
            } else if self.is_zero(first + known.dofs.len()..next) {
                matching.padded.push(index);
                known.dofs.clone()
            } else {
                matching.free.push(index);
                THREE_ROTATIONS.to_vec()
            };
            if known.name != bone.name {
                matching.renamed.push(format!("{} = {}", bone.name, known.name));
            }
            if matching.columns[index].replace(Columns { first, dofs }).is_some() {
                misfits.push(format!("{} (a second line for {})", bone.name, known.name));
            }
        }
        if misfits.is_empty() {
            matching.agree_on_three_values();
            Ok(matching)
        } else {
            Err(MisfitError { bones: misfits })
        }
    }

    fn frame_values(&self) -> FrameValues<'_> {
        FrameValues::new(&self.values, self.values.len() / self.frame_count.max(1))
    }

    /// Returns whether these columns are zero in every frame.
    fn is_zero(&self, columns: std::ops::Range<usize>) -> bool {
        let is_zero = |values: &[f64]| values.iter().all(|value| *value == 0.0);
        self.frame_values().rows().all(|row| row.get(columns.clone()).is_some_and(is_zero))
    }

    fn bone_motion(&self, bone: &Bone, columns: &Columns) -> BoneMotion {
        let values = self.frame_values();
        let columns_of = |axis_of: fn(&Dof) -> Option<usize>| -> Vec<(usize, usize)> {
            let dofs = columns.dofs.iter().zip(columns.first..);
            dofs.filter_map(|(dof, column)| Some((axis_of(dof)?, column))).collect()
        };
        let turns = columns_of(|dof| if let Dof::Rotate(axis) = dof { Some(*axis) } else { None });
        let places = columns_of(|dof| if let Dof::Translate(axis) = dof { Some(*axis) } else { None });
        let lengths = columns_of(|dof| (*dof == Dof::Length).then_some(0));
        let mut motion = BoneMotion::default();
        if !turns.is_empty() {
            motion.angles = values.triples(&turns, self.angle_unit().radians(1.0), [0.0; 3]);
            motion.rotations = columns.order(bone).quats(&motion.angles, bone.axes);
        }
        if !places.is_empty() {
            let axes = if bone.parent.is_none() { DQuat::IDENTITY } else { bone.axes };
            let places = values.triples(&places, 1.0, [0.0; 3]);
            motion.translations = places.into_iter().map(|place| axes * DVec3::from(place)).collect();
        }
        if let Some((_, column)) = lengths.last() {
            motion.stretches = values.column(*column).collect();
        }
        motion
    }
}

/// The bones of a file as a skeleton's.
#[derive(Default)]
struct Matching {
    /// For each bone of the skeleton which columns are its values, if any.
    columns: Vec<Option<Columns>>,
    /// Pairs of names that differ in case.
    renamed: Vec<String>,
    /// Bones with three values, of which those beyond their degrees of freedom are zero throughout.
    padded: Vec<usize>,
    /// Bones with three values that use more than their degrees of freedom.
    free: Vec<usize>,
}

impl Matching {
    /// Where one bone shows that three values are three rotations, they are that for every bone.
    fn agree_on_three_values(&mut self) {
        if self.free.is_empty() {
            return;
        }
        for index in self.padded.drain(..) {
            if let Some(columns) = &mut self.columns[index] {
                columns.dofs = THREE_ROTATIONS.to_vec();
            }
        }
    }

    /// Returns what was decided, a sentence each.
    fn notices(&self, skeleton: &Skeleton) -> Vec<String> {
        let mut notices = Vec::new();
        if !self.renamed.is_empty() {
            notices.push(format!("Bones found by names that differ in case: {}", self.renamed.join(", ")));
        }
        if !self.padded.is_empty() {
            let words = "they are its degrees of freedom, filled up with zeros";
            notices.push(format!("Three values for every bone: {words}"));
        }
        if !self.free.is_empty() {
            let names: Vec<_> = self.free.iter().map(|index| skeleton.bones[*index].name.as_str()).collect();
            let words = "taken as rx ry rz, also beyond degrees of freedom";
            notices.push(format!("Three values for every bone: {words}: {}", names.join(", ")));
        }
        let is_absent = |(bone, columns): &(&Bone, &Option<Columns>)| columns.is_none() && !bone.dofs.is_empty();
        let absent = skeleton.bones.iter().zip(&self.columns).filter(is_absent);
        let absent: Vec<_> = absent.map(|(bone, _)| bone.name.as_str()).collect();
        if !absent.is_empty() {
            notices.push(format!("Bones without motion stay at rest: {}", absent.join(", ")));
        }
        notices
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
