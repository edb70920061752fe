"""A turn on the spot by 180 degrees to the left, in eight small steps."""

from __future__ import annotations

import numpy as np

from . import feet
from .body import Arm, Plan, carry, hanging_arm
from .curves import ease, spline, wander
from .feet import Stance
from .kinematics import Dofs
from .rotations import Floats

START_DEG = 60.0
"""The clip begins at this heading, so that it passes the 180 degrees where angles change their sign."""

TURN_DEG = 180.0
HALF_WIDTH_M = 0.095
BALL_AHEAD_M = 0.12

STEPS: tuple[tuple[str, float, float, float], ...] = (
    ("l", 0.24, 0.56, 48.0),
    ("r", 0.63, 0.98, 62.0),
    ("l", 1.02, 1.35, 100.0),
    ("r", 1.41, 1.76, 112.0),
    ("l", 1.80, 2.13, 150.0),
    ("r", 2.19, 2.52, 160.0),
    ("l", 2.57, 2.84, 187.0),
    ("r", 2.88, 3.16, 174.0),
)
"""Foot, release, strike and the foot's heading afterwards, from where the body began."""

TURNED: tuple[tuple[float, float], ...] = (
    (0.1, 0.0),
    (0.56, 20.0),
    (0.98, 54.0),
    (1.35, 82.0),
    (1.76, 110.0),
    (2.13, 135.0),
    (2.52, 160.0),
    (3.1, TURN_DEG - 1.0),
    (3.35, TURN_DEG),
)
"""When the pelvis has turned how far."""


def turn(times: Floats) -> Dofs:
    """The clip, around the origin."""
    paths = {side: feet.path(times, _stances(side), f"turn {side}") for side in ("l", "r")}
    ground = feet.support(times, paths["l"], paths["r"])
    middle = feet.smoothed(times, (paths["l"].ankle + paths["r"].ankle) / 2, 0.12)
    centre = middle + 0.62 * (ground - middle)
    turned = spline(times, TURNED)
    heading = START_DEG + turned
    speed = np.gradient(turned, times)
    swinging = {side: _swing(times, side) for side in ("l", "r")}
    tilt = 3.5 + 0.6 * (swinging["l"] + swinging["r"])
    side_tilt = 2.6 * (swinging["r"] - swinging["l"])
    height = 1.022 - 0.012 * ease(times, 0.1, 0.4) + 0.010 * (swinging["l"] + swinging["r"])
    plan = Plan(
        seed="turn",
        times=times,
        root=np.stack([middle[:, 0], height, middle[:, 2]], axis=-1),
        heading=heading,
        tilt=tilt + wander(times, "turn tilt", 0.6, 1.4),
        list=side_tilt,
        bend=2.0 + wander(times, "turn bend", 1.2, 1.8),
        # The trunk leads the hips into the turn and the head leads the trunk.
        twist=0.10 * speed + 2.0 * (swinging["r"] - swinging["l"]),
        lean=-0.8 * side_tilt,
        gaze_side=0.22 * speed + wander(times, "turn gaze", 2.5, 2.0),
        gaze_down=9.0 + wander(times, "turn nod", 2.5, 1.6),
        arms={side: _arm(times, side, speed, swinging) for side in ("l", "r")},
        feet=paths,
    )
    return carry(plan, centre, axes=(0, 2))


def _stances(side: str) -> list[Stance]:
    steps = [(release, strike, heading) for foot, release, strike, heading in STEPS if foot == side]
    splay = 6.0 if side == "l" else -6.0
    begins = [-9.0] + [strike for _, strike, _ in steps]
    ends = [release for release, _, _ in steps] + [99.0]
    headings = [splay] + [heading for _, _, heading in steps]
    stances = []
    for begin, end, turned in zip(begins, ends, headings, strict=True):
        toes = START_DEG + turned
        # The foot stands beside the middle of the body, which faces where the foot does, less its splay.
        faces = np.radians(toes - splay)
        s = 1 if side == "l" else -1
        x = s * HALF_WIDTH_M * np.cos(faces) + BALL_AHEAD_M * np.sin(faces)
        z = -s * HALF_WIDTH_M * np.sin(faces) + BALL_AHEAD_M * np.cos(faces)
        stances.append(
            Stance(
                begin,
                end,
                float(x),
                float(z),
                toes,
                strike_pitch=-6.0,
                release_pitch=-24.0,
                settle=0.09,
                roll=0.16,
                lift=0.035,
            )
        )
    return stances


def _swing(times: Floats, side: str) -> Floats:
    """1 in the middle of each swing of a foot, 0 while it stands."""
    curve = np.zeros_like(times)
    for foot, release, strike, _ in STEPS:
        if foot == side:
            curve += ease(times, release - 0.12, release + 0.12) - ease(times, strike - 0.1, strike + 0.12)
    return curve


def _arm(times: Floats, side: str, speed: Floats, swinging: dict[str, Floats]) -> Arm:
    s = 1 if side == "l" else -1
    arm = hanging_arm(times)
    opposite = swinging["r" if side == "l" else "l"]
    arm.flexion = 5.0 + 9.0 * (opposite - swinging[side]) - 0.05 * s * speed
    # Arms are carried outwards by the turn.
    arm.abduction = 10.0 + 0.05 * np.abs(speed)
    arm.elbow = 24.0 + 9.0 * opposite + 0.05 * speed
    arm.inward = 22.0 + 5.0 * opposite
    arm.twist = 10.0 + 4.0 * (opposite - swinging[side])
    arm.hand_bend = 6.0 + 3.0 * opposite
    arm.fingers = 25.0 + 3.0 * opposite
    arm.reach = 2.5 * (opposite - swinging[side])
    arm.shrug = 1.2 * opposite
    return arm
