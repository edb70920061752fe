//! `:hierarchy`: who starts where whose bone ends.

use super::read::next_of_section;
use super::{Asf, Family, ROOT};
use crate::error::ParseError;
use crate::text::{error_at, Lines, Word};
use std::cmp::Reverse;
use std::collections::{BinaryHeap, HashMap};

/// Where the words of a hierarchy stand in the file: line by line the parent, then its children.
pub(super) type FamilyPositions = Vec<usize>;

/// Reads `[begin] { parent { child } } [end]`.
pub(super) fn read_hierarchy(lines: &mut Lines<'_>) -> Result<(Vec<Family>, FamilyPositions), ParseError> {
    let (mut families, mut positions) = (Vec::new(), Vec::new());
    let mut is_open = false;
    while let Some(mut words) = next_of_section(lines) {
        let parent = words.expect("a bone")?;
        if parent.is("begin") && families.is_empty() && !is_open {
            words.finish()?;
            is_open = true;
        } else if parent.is("end") && is_open {
            words.finish()?;
            return match next_of_section(lines).and_then(|mut words| words.next()) {
                Some(word) => Err(word.unexpected("a section or the end of the file")),
                None => Ok((families, positions)),
            };
        } else {
            let children: Vec<_> = words.collect();
            positions.push(parent.at);
            positions.extend(children.iter().map(|child| child.at));
            families.push(Family { parent: parent.text(), children: children.iter().map(Word::text).collect() });
        }
    }
    match lines.peek_words().and_then(|mut words| words.next()) {
        _ if !is_open => Ok((families, positions)),
        Some(section) => Err(section.unexpected("`end` of the hierarchy")),
        None => Err(lines.ended("`end` of the hierarchy")),
    }
}

/// Checks that names are unique and known and that every bone hangs on the root in exactly one way.
pub(super) fn check_hierarchy(
    source: &[u8],
    asf: &Asf,
    bone_positions: &[usize],
    family_positions: &[usize],
) -> Result<(), ParseError> {
    let mut nodes = HashMap::with_capacity(asf.bones.len());
    for ((index, bone), at) in asf.bones.iter().enumerate().zip(bone_positions) {
        if bone.name.eq_ignore_ascii_case(ROOT) || nodes.insert(bone.name.as_str(), index + 1).is_some() {
            let found = format!("a second `{}`", bone.name);
            return Err(error_at(source, *at, "a bone with a name of its own", found));
        }
    }
    let mut parents: Vec<Option<usize>> = vec![None; asf.bones.len() + 1];
    let mut positions = family_positions.iter();
    for family in &asf.hierarchy {
        let mut parent = None;
        for (name, at) in std::iter::once(&family.parent).chain(&family.children).zip(positions.by_ref()) {
            let unexpected = |expected: &str| error_at(source, *at, expected, format_args!("`{name}`"));
            let node = node_of(&nodes, name).ok_or_else(|| unexpected("the name of a bone of `:bonedata`"))?;
            let Some(parent) = parent else {
                parent = Some(node);
                continue;
            };
            match parents.get_mut(node) {
                Some(free @ None) if node != 0 => *free = Some(parent),
                _ if node == 0 => return Err(unexpected("a bone, for nothing is above `root`")),
                _ => return Err(unexpected("a bone that has no parent yet")),
            }
        }
    }
    let connected = connected_with_root(&parents);
    for ((index, bone), at) in asf.bones.iter().enumerate().zip(bone_positions) {
        let expected = format!("bone `{}` to be connected with `root` by `:hierarchy`", bone.name);
        match parents.get(index + 1) {
            Some(None) => return Err(error_at(source, *at, expected, "no line that has it as a child")),
            _ if connected.get(index + 1) != Some(&true) => {
                return Err(error_at(source, *at, expected, "that its parents lead in a circle"));
            }
            _ => {}
        }
    }
    Ok(())
}

/// Returns for each node (0 the root, then the bones) whether its parents lead to the root.
fn connected_with_root(parents: &[Option<usize>]) -> Vec<bool> {
    let mut children = vec![Vec::new(); parents.len()];
    for (node, parent) in parents.iter().enumerate() {
        if let Some(siblings) = parent.and_then(|parent| children.get_mut(parent)) {
            siblings.push(node);
        }
    }
    let mut connected = vec![false; parents.len()];
    let mut open = vec![0];
    while let Some(node) = open.pop() {
        connected[node] = true;
        open.append(&mut children[node]);
    }
    connected
}

/// The nodes of a hierarchy (0 the root, then the bones in file order), with parents before children.
pub(super) struct Tree {
    /// The nodes; file order wherever that has parents first.
    pub(super) order: Vec<usize>,
    /// The parent of each node, by node; `None` for the root.
    pub(super) parents: Vec<Option<usize>>,
}

/// Returns the hierarchy as a tree. Bones that it does not connect with the root (no file that was read has any) hang
/// on the root.
pub(super) fn tree(asf: &Asf) -> Tree {
    let count = asf.bones.len() + 1;
    let nodes: HashMap<_, _> = asf.bones.iter().enumerate().map(|(i, bone)| (bone.name.as_str(), i + 1)).collect();
    let mut parents: Vec<Option<usize>> = vec![None; count];
    for family in &asf.hierarchy {
        let Some(parent) = node_of(&nodes, &family.parent) else { continue };
        for node in family.children.iter().filter_map(|child| node_of(&nodes, child)).filter(|node| *node != 0) {
            parents[node].get_or_insert(parent);
        }
    }
    let connected = connected_with_root(&parents);
    for node in 1..count {
        if !connected[node] {
            parents[node] = Some(0);
        }
    }
    let mut children = vec![Vec::new(); count];
    for (node, parent) in parents.iter().enumerate() {
        if let Some(parent) = parent {
            children[*parent].push(node);
        }
    }
    let mut order = Vec::with_capacity(count);
    let mut ready = BinaryHeap::from([Reverse(0)]);
    while let Some(Reverse(node)) = ready.pop() {
        order.push(node);
        ready.extend(std::mem::take(&mut children[node]).into_iter().map(Reverse));
    }
    Tree { order, parents }
}

/// Returns the node with that name; `root` is recognised in either case.
fn node_of(nodes: &HashMap<&str, usize>, name: &str) -> Option<usize> {
    nodes.get(name).copied().or_else(|| name.eq_ignore_ascii_case(ROOT).then_some(0))
}
