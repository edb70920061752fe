//! The limbs of a figure: lines of one side that hang together.

use crate::figure::{Actor, Groups, Side};
use std::collections::BTreeMap;

/// An arm, a leg, the trunk; of markers those that belong together, or one that hangs on none.
#[derive(Debug, PartialEq)]
pub(super) struct Limb {
    pub(super) side: Side,
    pub(super) lines: Vec<[usize; 2]>,
    /// Points that are in no limb before this one.
    pub(super) points: Vec<usize>,
}

/// More lines than this fill a small picture anyway, and more points.
const MOST: usize = 3000;

/// Returns the limbs of an actor; each line and each point is in one, but for what is beyond all measure.
pub(super) fn limbs(actor: &Actor<'_>) -> Vec<Limb> {
    let count = actor.names.len().min(MOST);
    let mut limbs: BTreeMap<(i8, usize), Limb> = BTreeMap::new();
    let mut is_free = vec![true; count];
    for side in [Side::Middle, Side::Left, Side::Right] {
        let is_own = |(line, known): &(&[usize; 2], &Side)| **known == side && line.iter().all(|point| *point < count);
        let own = || actor.lines.iter().zip(&actor.sides).take(MOST).filter(is_own).map(|(line, _)| *line);
        let mut groups = Groups::new(count);
        for [a, b] in own() {
            groups.join(a, b);
        }
        for line in own() {
            let group = groups.of(line[0]);
            let empty = Limb { side, lines: Vec::new(), points: Vec::new() };
            let limb = limbs.entry((side.number(), group)).or_insert(empty);
            limb.lines.push(line);
            for point in line {
                if let Some(is_free) = is_free.get_mut(point).filter(|is_free| **is_free) {
                    *is_free = false;
                    limb.points.push(point);
                }
            }
        }
    }
    let lonely = (0..count).filter(|point| is_free.get(*point) == Some(&true));
    let lonely = lonely.map(|point| Limb { side: Side::Middle, lines: Vec::new(), points: vec![point] });
    limbs.into_values().chain(lonely).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::figure::tests::{legs, markers};

    #[test]
    fn both_legs_and_the_trunk_are_limbs() {
        let skeleton = legs();
        let limbs = limbs(&Actor::of_skeleton(&skeleton, None));
        let lines: Vec<(i8, usize)> = limbs.iter().map(|limb| (limb.side.number(), limb.lines.len())).collect();
        assert_eq!(lines, [(-1, 2), (0, 1), (1, 2)]);
        assert_eq!(limbs.iter().map(|limb| limb.points.len()).sum::<usize>(), 6);
    }

    #[test]
    fn a_marker_without_neighbours_is_a_limb_by_itself() {
        let at = |z: f64| vec![[0.5, 0.0, z]; 3];
        let markers = markers(&["A", "B", "C"], &[at(0.1), at(9.0), at(0.3)]);
        let limbs = limbs(&Actor::of_markers(&markers));
        assert_eq!(limbs.iter().map(|limb| limb.points.clone()).collect::<Vec<_>>(), [vec![0, 2], vec![1]]);
    }
}
