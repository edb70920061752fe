//! [`Skeleton`] -> [`Asf`].

use super::read::BEARABLE_LENGTH_UNITS;
use super::{Asf, AsfBone, Family, Root, Units, ROOT};
use crate::formats::AngleUnit;
use crate::skeleton::{Bone, Dof, EulerOrder, Skeleton};
use crate::{number, text};
use glam::{DQuat, DVec3, EulerRot};
use std::collections::HashSet;

/// Metres per inch: written files have their lengths in inches times `length`, as the public data sets do.
const INCH_M: f64 = 0.0254;

/// Points closer than this, as a part of the lengths involved, are one point: above the rounding of a few sums.
const SAME_POINT: f64 = 1e-12;

impl Asf {
    /// Returns a file that describes a skeleton.
    ///
    /// A single bone without parent becomes `root`, which is a point without a name; where there are several, `root` is a
    /// point at the origin that does not move. In this format a bone starts where its parent ends: where the
    /// skeleton has it elsewhere, a bone without degrees of freedom leads there. Names become single words
    /// that no other bone has.
    pub fn from_skeleton(skeleton: &Skeleton) -> Self {
        let names = file_names(skeleton);
        let mut asf = Self {
            version: Some("1.10".to_owned()),
            name: Some(skeleton.name.clone()).filter(|name| is_one_line(name)),
            units: Units {
                mass: Some(1.0),
                length: Some(INCH_M / skeleton.unit.metres).filter(|length| BEARABLE_LENGTH_UNITS.contains(length)),
                angle: Some(AngleUnit::Degrees),
                others: Vec::new(),
            },
            root: single_root(skeleton).map_or_else(unmoved_root, moving_root),
            ..Self::default()
        };
        let mut taken: HashSet<String> = names.iter().cloned().collect();
        let mut families: Vec<Family> = Vec::with_capacity(names.len() + 1);
        let mut family_of = vec![0; names.len()];
        families.push(Family { parent: ROOT.to_owned(), children: Vec::new() });
        for (index, (bone, name)) in skeleton.bones.iter().zip(&names).enumerate() {
            if name == ROOT {
                continue;
            }
            let parent = bone.parent.and_then(|parent| Some((parent, skeleton.bones.get(parent)?)));
            let parent_end = parent.filter(|(parent, _)| names[*parent] != ROOT).map_or(DVec3::ZERO, |(_, p)| p.tail);
            let mut family = parent.map_or(0, |(parent, _)| family_of[parent]);
            let gap = bone.offset - parent_end;
            if gap.length() > SAME_POINT * (bone.offset.length() + parent_end.length()) {
                let link = unique(format!("{name}_dum"), &mut taken);
                asf.bones.push(AsfBone { name: link.clone(), ..pointing(gap) });
                families[family].children.push(link.clone());
                family = families.len();
                families.push(Family { parent: link, children: Vec::new() });
            }
            asf.bones.push(file_bone(bone, name));
            families[family].children.push(name.clone());
            family_of[index] = families.len();
            families.push(Family { parent: name.clone(), children: Vec::new() });
        }
        for (id, bone) in (1..).zip(&mut asf.bones) {
            bone.id = Some(id);
        }
        families.retain(|family| !family.children.is_empty());
        asf.hierarchy = families;
        asf
    }
}

/// Returns the name of each bone as Acclaim files have it: one word, no keyword, no number, no other bone's; the only
/// bone without parent is `root`.
pub(crate) fn file_names(skeleton: &Skeleton) -> Vec<String> {
    let root = single_root(skeleton);
    let mut taken = HashSet::new();
    let names = skeleton.bones.iter().map(|bone| match root {
        Some(root) if std::ptr::eq(root, bone) => ROOT.to_owned(),
        _ => unique(one_word(&bone.name), &mut taken),
    });
    names.collect()
}

fn single_root(skeleton: &Skeleton) -> Option<&Bone> {
    let mut roots = skeleton.bones.iter().filter(|bone| bone.parent.is_none());
    roots.next().filter(|_| roots.next().is_none())
}

fn one_word(name: &str) -> String {
    let unusable = |c: char| c.is_whitespace() || c.is_control();
    let word = name.replace(unusable, "_");
    let is_keyword = [ROOT, "begin", "end"].iter().any(|keyword| word.eq_ignore_ascii_case(keyword));
    let is_number = number::read_or_infinity(word.as_bytes()).is_some();
    if word.is_empty() || word.starts_with(['#', ':', '(']) || is_keyword || is_number {
        format!("bone_{word}")
    } else {
        word
    }
}

fn unique(name: String, taken: &mut HashSet<String>) -> String {
    let numbered = (2..).map(|number| format!("{name}_{number}"));
    let mut names = std::iter::once(name.clone()).chain(numbered);
    names.find(|name| taken.insert(name.clone())).unwrap_or(name)
}

fn is_one_line(text: &str) -> bool {
    !text.contains(char::is_control) && text::Lines::new(text.as_bytes()).next_line().is_some_and(|l| l.rest() == text)
}

fn unmoved_root() -> Root {
    Root { order: Vec::new(), ..Root::default() }
}

fn moving_root(bone: &Bone) -> Root {
    Root {
        order: bone.dofs.clone(),
        axis: EulerOrder::Xyz,
        position: bone.offset.to_array(),
        orientation: degrees(bone.axes),
        others: Vec::new(),
    }
}

fn file_bone(bone: &Bone, name: &str) -> AsfBone {
    let in_degrees = |(dof, (low, high)): (&Dof, &(f64, f64))| match dof {
        Dof::Rotate(_) => (low.to_degrees(), high.to_degrees()),
        _ => (*low, *high),
    };
    AsfBone {
        name: name.to_owned(),
        axis: degrees(bone.axes),
        dofs: bone.dofs.clone(),
        limits: bone.dofs.iter().zip(&bone.limits).map(in_degrees).collect(),
        ..pointing(bone.tail)
    }
}

/// Returns a bone with that direction and length; a point is a bone of no length, whatever its direction.
fn pointing(tail: DVec3) -> AsfBone {
    let direction = tail.try_normalize().unwrap_or(DVec3::Y);
    AsfBone { direction: direction.to_array(), length: tail.length(), ..AsfBone::default() }
}

/// Returns the angles about X, Y and Z that make up the rotation in the order `XYZ`.
fn degrees(axes: DQuat) -> [f64; 3] {
    let (x, y, z) = axes.to_euler(EulerRot::XYZEx);
    [x, y, z].map(f64::to_degrees)
}
