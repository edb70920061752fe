//! "Preserve old position/rotation": new motion goes on from where the old root was, moved as a rigid body.

use glam::{DQuat, DVec3};

/// What of the old root's placement is taken over besides its place on the ground.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Alignment {
    /// The whole rotation instead of the heading alone.
    pub full_rotation: bool,
    /// The height above the ground too.
    pub height: bool,
}

/// A root at one moment, in armature space.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RootPose {
    /// Where it is.
    pub position: DVec3,
    /// How it is turned.
    pub rotation: DQuat,
}

/// A rigid motion of space: turn about a point, then move that point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Rigid {
    turn: DQuat,
    from: DVec3,
    to: DVec3,
}

impl Rigid {
    /// Moves a root.
    pub fn apply(&self, pose: RootPose) -> RootPose {
        RootPose {
            position: self.to + self.turn * (pose.position - self.from),
            rotation: (self.turn * pose.rotation).normalize(),
        }
    }
}

/// Returns the rigid motion that brings `new` to where `old` is: its heading about `up` and its place on the ground,
/// and what `alignment` asks for besides. `up` is a unit vector.
pub fn align(old: RootPose, new: RootPose, up: DVec3, alignment: Alignment) -> Rigid {
    let difference = old.rotation * new.rotation.conjugate();
    let turn = if alignment.full_rotation { difference.normalize() } else { heading(difference, up) };
    let mut to = old.position;
    if !alignment.height {
        to += up * (new.position - old.position).dot(up);
    }
    Rigid { turn, from: new.position, to }
}

/// Returns the part of a rotation that turns about `up` (the twist of its swing-twist decomposition).
fn heading(rotation: DQuat, up: DVec3) -> DQuat {
    let along = up * rotation.xyz().dot(up);
    let twist = DQuat::from_xyzw(along.x, along.y, along.z, rotation.w);
    // A half turn about a level axis has no heading of its own.
    if twist.length() < 1e-9 {
        DQuat::IDENTITY
    } else {
        twist.normalize()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn rotation() -> impl Strategy<Value = DQuat> {
        (-1.0..1.0f64, -1.0..1.0f64, -1.0..1.0f64, 0.1..1.0f64)
            .prop_map(|(x, y, z, w)| DQuat::from_xyzw(x, y, z, w).normalize())
    }

    fn position() -> impl Strategy<Value = DVec3> {
        (-9.0..9.0f64, -9.0..9.0f64, -9.0..9.0f64).prop_map(DVec3::from)
    }

    proptest! {
        #[test]
        fn full_alignment_lands_exactly_on_the_old_root(a in rotation(), b in rotation(), p in position(), q in position()) {
            let (old, new) = (RootPose { position: p, rotation: a }, RootPose { position: q, rotation: b });
            let moved = align(old, new, DVec3::Z, Alignment { full_rotation: true, height: true }).apply(new);
            prop_assert!((moved.position - p).length() < 1e-9);
            prop_assert!(moved.rotation.dot(a).abs() > 1.0 - 1e-9);
        }

        #[test]
        fn heading_alignment_keeps_the_ground_level(a in rotation(), b in rotation(), p in position(), q in position()) {
            let (old, new) = (RootPose { position: p, rotation: a }, RootPose { position: q, rotation: b });
            let rigid = align(old, new, DVec3::Z, Alignment::default());
            let moved = rigid.apply(new);
            prop_assert!((moved.position - DVec3::new(p.x, p.y, q.z)).length() < 1e-9);
            let up = rigid.apply(RootPose { position: q + DVec3::Z, rotation: b }).position - moved.position;
            prop_assert!((up - DVec3::Z).length() < 1e-9);
        }
    }

    #[test]
    fn a_turned_walk_goes_on_along_the_old_heading() {
        let old = RootPose { position: DVec3::new(3.0, 4.0, 0.9), rotation: DQuat::from_rotation_z(1.2) };
        let new = RootPose { position: DVec3::new(-1.0, 0.0, 1.0), rotation: DQuat::from_rotation_z(-0.4) };
        let rigid = align(old, new, DVec3::Z, Alignment::default());
        let step = rigid.apply(RootPose { position: new.position + DVec3::X, rotation: new.rotation });
        let expected = DQuat::from_rotation_z(1.6) * DVec3::X;
        assert!((step.position - DVec3::new(3.0, 4.0, 1.0) - expected).length() < 1e-12);
    }
}
