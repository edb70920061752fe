"""A step forward with each foot, then a jump from both, in 113 frames."""

from __future__ import annotations

from itertools import pairwise

import numpy as np

from . import feet
from .body import Arm, Plan, carry, hanging_arm, solve
from .curves import quintic, spline
from .feet import Stance
from .kinematics import Dofs, centre_of_mass, forward
from .rotations import Floats

GRAVITY = 9.81
TAKE_OFF_S = 1.08
LANDING_S = 1.44
STEP_M = 0.36
JUMP_M = 0.46
BEFORE_S, AFTER_S = -9.0, 9.0
"""Before the clip begins and after it ends."""

TILT = ((0.0, 3.0), (0.45, 6.0), (0.84, 27.0), (1.08, 3.0), (1.25, -3.0), (1.45, 9.0), (1.63, 24.0), (1.87, 8.0))
BEND = ((0.0, 2.0), (0.45, 7.0), (0.84, 34.0), (1.1, -3.0), (1.25, -2.0), (1.45, 12.0), (1.65, 32.0), (1.87, 12.0))


def step_and_jump(times: Floats) -> Dofs:
    """The clip, along +Z."""
    paths = {side: feet.path(times, _stances(side), f"jump {side}") for side in ("l", "r")}
    ground = feet.support(times, paths["l"], paths["r"])
    plan = Plan(
        seed="jump",
        times=times,
        root=np.stack([ground[:, 0], np.full(len(times), 1.01), ground[:, 2]], axis=-1),
        heading=spline(times, [(0.0, 0.0), (0.25, 5.0), (0.6, -3.0), (0.85, 0.0), (1.4, 1.0), (1.87, 0.0)]),
        tilt=spline(times, TILT),
        list=spline(times, [(0.0, 0.0), (0.25, 2.5), (0.6, -2.5), (0.85, 0.0), (1.3, 0.8), (1.6, -0.6), (1.87, 0.0)]),
        bend=spline(times, BEND),
        twist=spline(times, [(0.0, 0.0), (0.25, -7.0), (0.6, 5.0), (0.85, 0.0), (1.3, -1.5), (1.87, 1.0)]),
        lean=spline(times, [(0.0, 0.0), (0.25, -3.0), (0.6, 3.0), (0.85, 0.0), (1.3, -0.8), (1.6, 0.8), (1.87, 0.0)]),
        gaze_side=spline(times, [(0.0, 0.0), (0.5, 2.0), (1.2, -2.0), (1.87, 0.0)]),
        gaze_down=spline(times, [(0.0, 6.0), (0.5, 16.0), (0.85, 10.0), (1.15, 2.0), (1.45, 22.0), (1.87, 8.0)]),
        arms={side: _arm(times, side) for side in ("l", "r")},
        feet=paths,
    )
    standing = float(centre_of_mass(forward(solve(plan)))[0, 1])
    return carry(plan, _centre(times, ground, standing))


def _stances(side: str) -> list[Stance]:
    """The right foot steps first, the left follows, both jump."""
    s = 1 if side == "l" else -1
    left = side == "l"
    start = Stance(
        strike=BEFORE_S,
        release=0.47 if left else 0.13,
        x=s * 0.09,
        z=0.0,
        heading=s * 5.0,
        release_pitch=-50.0 if left else -38.0,
        roll=0.26 if left else 0.13,
    )
    step = Stance(
        strike=0.75 if left else 0.43,
        release=TAKE_OFF_S,
        x=s * 0.095,
        z=STEP_M - s * 0.005,
        heading=s * 6.0,
        strike_pitch=5.0 if left else 12.0,
        release_pitch=-60.0,
        settle=0.08,
        roll=0.24,
        lift=0.05,
    )
    landing = Stance(
        strike=LANDING_S + (0.012 if left else 0.0),
        release=AFTER_S,
        x=s * 0.11,
        z=STEP_M + JUMP_M + s * 0.01,
        heading=s * 8.0,
        strike_pitch=-24.0,
        settle=0.11,
        lift=0.11,
        drop=1.2,
    )
    return [start, step, landing]


def _arm(times: Floats, side: str) -> Arm:
    """Arms swing with the steps, back in the crouch, and throw the body up."""
    s = 1 if side == "l" else -1
    late = 0.01 * s
    arm = hanging_arm(times)

    def keyed(*keys: tuple[float, float]) -> Floats:
        return spline(times - late, list(keys))

    with_steps = ((-0.1, 4.0), (0.25, 4.0 + 15.0 * s), (0.52, 8.0 - 6.0 * s))
    with_jump = ((0.82, -52.0), (1.12, 96.0), (1.26, 116.0), (1.47, 58.0), (1.68, 4.0), (1.9, 14.0))
    arm.flexion = keyed(*with_steps, *with_jump)
    arm.abduction = keyed((-0.1, 9.0), (0.5, 11.0), (0.82, 16.0), (1.15, 14.0), (1.45, 26.0), (1.65, 20.0), (1.9, 13.0))
    arm.inward = keyed((-0.1, 20.0), (0.82, 12.0), (1.15, 24.0), (1.6, 24.0), (1.9, 22.0))
    arm.elbow = keyed(
        (-0.1, 18.0), (0.5, 32.0), (0.82, 22.0), (1.0, 48.0), (1.2, 34.0), (1.45, 42.0), (1.68, 52.0), (1.9, 34.0)
    )
    arm.twist = keyed((-0.1, 10.0), (0.82, 24.0), (1.2, 2.0), (1.6, 16.0), (1.9, 12.0))
    arm.hand_bend = keyed((-0.1, 6.0), (0.82, 16.0), (1.15, -12.0), (1.5, 12.0), (1.9, 5.0))
    arm.hand_side = keyed((-0.1, 0.0), (0.82, -5.0), (1.2, 6.0), (1.6, -3.0), (1.9, 0.0))
    arm.fingers = keyed((-0.1, 24.0), (0.82, 42.0), (1.2, 14.0), (1.55, 34.0), (1.9, 24.0))
    arm.shrug = keyed((-0.1, 0.0), (0.82, 4.0), (1.18, 14.0), (1.55, 3.0), (1.9, 0.0))
    arm.reach = keyed((-0.1, 0.0), (0.82, -8.0), (1.15, 10.0), (1.6, 4.0), (1.9, 0.0))
    return arm


def _centre(times: Floats, ground: Floats, standing: float) -> Floats:
    """Where the centre of mass has to be: between the waypoints it moves with the least jerk, in flight it falls.

    Waypoints are (time, place, speed, acceleration).
    """
    flight = LANDING_S - TAKE_OFF_S
    take_off_y, landing_y = standing + 0.07, standing - 0.01
    speed = (landing_y - take_off_y) / flight + GRAVITY * flight / 2
    take_off_z, landing_z = STEP_M + 0.06, STEP_M + JUMP_M - 0.13
    pace = (landing_z - take_off_z) / flight
    end = float(times[-1])
    height = [
        (0.0, standing, 0.0, 0.0),
        (0.48, standing - 0.03, -0.22, -1.5),
        (0.83, standing - 0.25, 0.0, 9.0),
        (TAKE_OFF_S, take_off_y, speed, -GRAVITY),
        (LANDING_S, landing_y, speed - GRAVITY * flight, -GRAVITY),
        (1.62, standing - 0.215, 0.0, 14.0),
        (end, standing - 0.03, 0.3, -3.0),
    ]
    ahead = [
        (0.0, float(ground[0, 2]), 0.08, 0.6),
        (0.45, 0.17, 0.62, 0.0),
        (0.83, 0.31, 0.22, 0.0),
        (TAKE_OFF_S, take_off_z, pace, 0.0),
        (LANDING_S, landing_z, pace, 0.0),
        (end, STEP_M + JUMP_M - 0.05, 0.03, 0.0),
    ]
    # Sideways the weight goes from foot to foot until both stand, then stays between them.
    settled = spline(times, [(0.72, 1.0), (0.95, 0.0)])
    return np.stack([0.75 * ground[:, 0] * settled, _through(times, height), _through(times, ahead)], axis=-1)


def _through(times: Floats, waypoints: list[tuple[float, float, float, float]]) -> Floats:
    curve = np.zeros_like(times)
    for start, end in pairwise(waypoints):
        now = (times >= start[0]) & (times <= end[0])
        curve[now] = quintic(times[now], start, end)
    return curve
