"""A whole body's plan over frames, and the joint angles that carry it out."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from . import feet, skeleton
from .curves import wander
from .kinematics import Dofs, Pose, centre_of_mass, forward, solve_leg, solve_upper_arm
from .rotations import Floats, about, rotate, to_euler


@dataclass
class Arm:
    """One arm; angles in degrees, zero for an arm that hangs with the palm to the thigh."""

    flexion: Floats
    """The upper arm forwards."""
    abduction: Floats
    """The upper arm outwards."""
    inward: Floats
    """Where the elbow bends to: 0 straight ahead, positive towards the other arm."""
    elbow: Floats
    twist: Floats
    """The forearm's own turn; positive brings the thumb inwards."""
    hand_bend: Floats
    """Positive towards the palm."""
    hand_side: Floats
    """Positive towards the thumb."""
    fingers: Floats
    shrug: Floats
    """The shoulder upwards."""
    reach: Floats
    """The shoulder forwards."""


@dataclass
class Plan:
    """What a clip asks of the body. Angles in degrees, places in metres, arrays over frames."""

    seed: str
    times: Floats
    root: Floats
    """Where the hips are (frames, 3)."""
    heading: Floats
    tilt: Floats
    """The pelvis forwards."""
    list: Floats
    """The pelvis sideways; positive raises the left hip."""
    bend: Floats
    """The trunk forwards, over all three back bones."""
    twist: Floats
    """The trunk to the left, against the pelvis."""
    lean: Floats
    """The trunk sideways; positive to the right."""
    gaze_side: Floats
    """Where the head looks, relative to the heading; positive to the left."""
    gaze_down: Floats
    arms: dict[str, Arm]
    feet: dict[str, feet.FootPath]
    knee_out: float = 6.0
    """How far the knees point outwards from the feet."""


BACK = ("lowerback", "upperback", "thorax")
NECK = ("lowerneck", "upperneck", "head")


def solve(plan: Plan) -> Dofs:
    """The angles of every bone."""
    heading, tilt, side = np.radians(plan.heading), np.radians(plan.tilt), np.radians(plan.list)
    pelvis = about(1, heading) @ about(0, tilt) @ about(2, side)
    dofs: Dofs = {"root": np.concatenate([plan.root, to_euler(pelvis)], axis=-1)}
    dofs |= _column(plan)
    for s in skeleton.SIDES:
        dofs |= _arm(plan, s)
        dofs |= _leg(plan, s, pelvis)
    return dofs


def _column(plan: Plan) -> Dofs:
    """Back and neck: the back shares out the trunk's movement, the neck takes it back so that the gaze is steady."""
    total = np.stack([plan.bend, plan.twist, plan.lean], axis=-1)
    result: Dofs = {}
    for name, share in zip(BACK, (0.4, 0.3, 0.3), strict=True):
        result[name] = np.radians(total * share + _alive(plan, name, 3, 0.8))
    # Turns are small, so that they may be added: what the head must do is its gaze less what carries it.
    carried = np.stack([plan.tilt + plan.bend, plan.twist, plan.list + plan.lean], axis=-1)
    gaze = np.stack([plan.gaze_down, plan.gaze_side, np.zeros_like(plan.gaze_side)], axis=-1)
    for name, share in zip(NECK, (0.3, 0.35, 0.35), strict=True):
        result[name] = np.radians((gaze - 0.9 * carried) * share + _alive(plan, name, 3, 0.7))
    return result


def _arm(plan: Plan, side: str) -> Dofs:
    """Arm, hand, fingers and thumb; the mirror changes the sign of turns about Y and Z."""
    arm, s = plan.arms[side], skeleton.sign(side)
    alive = _alive(plan, side + "arm", 11, 0.9)
    flexion, abduction, inward = (
        np.radians(angle + alive[:, i]) for i, angle in enumerate((arm.flexion, arm.abduction, arm.inward))
    )
    clavicle = np.stack([-s * (arm.reach + 0.6 * alive[:, 3]), s * (arm.shrug + 0.6 * alive[:, 4])], axis=-1)
    hand = np.stack([arm.hand_bend + 2 * alive[:, 6], s * (arm.hand_side + 1.5 * alive[:, 7])], axis=-1)
    thumb = np.stack([0.5 * arm.fingers - 6 + 2 * alive[:, 9], s * (8 + 2.5 * alive[:, 10])], axis=-1)
    return {
        side + "clavicle": np.radians(clavicle),
        side + "humerus": solve_upper_arm(side, flexion, abduction, inward),
        side + "radius": np.radians(arm.elbow + alive[:, 5])[:, None],
        side + "wrist": np.radians(s * (arm.twist + 2 * alive[:, 8]))[:, None],
        side + "hand": np.radians(hand),
        side + "fingers": np.radians(arm.fingers + 3 * alive[:, 9])[:, None],
        side + "thumb": np.radians(thumb),
    }


def _leg(plan: Plan, side: str, pelvis: Floats) -> Dofs:
    foot, s = plan.feet[side], skeleton.sign(side)
    hip = plan.root + rotate(pelvis, skeleton.BY_NAME[side + "hipjoint"].offset_m)
    knee = foot.heading + s * np.radians(plan.knee_out + wander(plan.times, plan.seed + side + "knee", 1.0))
    return solve_leg(
        side,
        pelvis,
        hip,
        foot.ankle,
        feet.forwards(knee),
        feet.raised(foot.heading, foot.pitch - feet.SLOPE),
        feet.raised(foot.heading, foot.pitch + foot.toe_bend),
    )


def _alive(plan: Plan, name: str, count: int, size: float) -> Floats:
    return np.stack([wander(plan.times, f"{plan.seed} {name} {i}", size) for i in range(count)], axis=-1)


def sole(pose: Pose, side: str) -> Floats:
    """Heel, ball and tip of a foot's sole (frames, 3 points, 3), in metres."""
    heel = np.array([0.0, -feet.ANKLE_M, -feet.HEEL_BACK_M])
    # The rest pose spreads the legs, so that the sole is level after the spread is taken out.
    spread = about(2, np.radians(skeleton.sign(side) * skeleton.LEG_SPREAD_DEG))
    foot, toes = side + "foot", side + "toes"
    down = np.array([0.0, -feet.SOLE_M, 0.0])
    return np.stack(
        [
            pose.heads[foot] + rotate(pose.rotations[foot], spread @ heel),
            pose.tails[foot] + rotate(pose.rotations[toes], spread @ down),
            pose.tails[toes] + rotate(pose.rotations[toes], spread @ down),
        ],
        axis=1,
    )


def carry(plan: Plan, centre: Floats, axes: tuple[int, ...] = (0, 1, 2), rounds: int = 14) -> Dofs:
    """Move the hips until the body's centre of mass follows `centre` on `axes`; planted feet stay where they are."""
    columns = list(axes)
    plan.root = plan.root.copy()
    for _ in range(rounds):
        missing = centre - centre_of_mass(forward(solve(plan)))
        plan.root[:, columns] += missing[:, columns]
    return solve(plan)


def hanging_arm(times: Floats) -> Arm:
    """An arm at rest by the side."""

    def still(value: float) -> Floats:
        return np.full(len(times), value)

    return Arm(
        flexion=still(3.0),
        abduction=still(9.0),
        inward=still(20.0),
        elbow=still(16.0),
        twist=still(10.0),
        hand_bend=still(6.0),
        hand_side=still(0.0),
        fingers=still(24.0),
        shrug=still(0.0),
        reach=still(0.0),
    )
