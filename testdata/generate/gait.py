"""A walk at 1.3 metres a second, 110 steps a minute, no step quite like another."""

from __future__ import annotations

import numpy as np

from . import feet
from .body import Plan, hanging_arm, solve
from .curves import wander
from .feet import Stance
from .kinematics import Dofs
from .noise import gaussian
from .rotations import Floats

STEP_S = 60.0 / 110.0
STEP_M = 1.3 * STEP_S
SWING_S = 0.42
BEFORE = 3
"""Steps before the first frame, so that the clip begins in full stride."""


def walk(times: Floats) -> Dofs:
    """The walk, straight ahead along +Z, in full stride from the first frame to the last."""
    count = int(times[-1] / STEP_S) + 2 * BEFORE + 2
    variation = gaussian("walk steps", 4 * count).reshape(count, 4)
    strikes = (np.arange(count) - BEFORE) * STEP_S + 0.008 * variation[:, 0]
    places = (np.arange(count) - BEFORE) * STEP_M + 0.010 * variation[:, 1]
    stances: dict[str, list[Stance]] = {"l": [], "r": []}
    for k in range(count - 2):
        side, s = ("l", 1) if k % 2 == 0 else ("r", -1)
        stances[side].append(
            Stance(
                strike=strikes[k],
                release=strikes[k + 2] - SWING_S,
                x=s * (0.062 + 0.006 * variation[k, 2]),
                z=places[k],
                heading=s * (6.0 + variation[k, 3]),
                strike_pitch=19.0 + 1.5 * variation[k, 2],
                release_pitch=-66.0 + 2.0 * variation[k, 3],
                settle=0.12,
                roll=0.37,
                lift=0.012,
            )
        )

    # Whole numbers of `step` are strikes, even ones of the left foot.
    step = _smooth_through(times, strikes, np.arange(count, dtype=float))
    place = _smooth_through(times, strikes, places)
    stride, half = 2 * np.pi * step, np.pi * step
    root = np.stack(
        [
            0.02 * np.sin(half - 0.15) + wander(times, "walk x", 0.006, 4.0),
            0.996 - 0.0125 * np.cos(stride - 0.5) + wander(times, "walk y", 0.002, 3.0),
            place - 0.474 + 0.008 * np.sin(stride),
        ],
        axis=-1,
    )
    tilt = 4.0 + 1.2 * np.cos(stride - 0.3)
    side_tilt = 3.6 * np.sin(half - 0.05) + 0.5 * np.sin(3 * half)
    arms = {}
    for side, s in (("l", 1), ("r", -1)):
        arm = hanging_arm(times)
        swing = -s * np.cos(half - 0.25) + 0.06 * np.sin(stride)
        late = -s * np.cos(half - 0.55)
        reach = 1.0 + wander(times, f"walk {side} swing", 0.1, 5.0)
        arm.flexion = 4.0 + 21.0 * swing * reach
        arm.abduction = 9.0 - 2.0 * late
        arm.inward = 24.0 + 10.0 * late
        arm.elbow = 25.0 + 13.0 * late * reach
        arm.twist = 12.0 + 6.0 * late
        arm.hand_bend = 5.0 - 5.0 * np.cos(half - 1.1) * -s
        arm.hand_side = 2.0 * late
        arm.fingers = 26.0 + 4.0 * late
        arm.reach = 4.0 * swing
        arm.shrug = 1.0 * np.cos(stride - 0.9)
        arms[side] = arm
    plan = Plan(
        seed="walk",
        times=times,
        root=root,
        heading=-5.0 * np.cos(half - 0.1) + wander(times, "walk heading", 0.8, 4.0),
        tilt=tilt,
        list=side_tilt,
        bend=0.5 - 1.0 * np.cos(stride - 0.3),
        twist=9.5 * np.cos(half - 0.25),
        lean=-0.85 * side_tilt + 1.2 * np.sin(half - 0.4),
        gaze_side=wander(times, "walk gaze side", 4.0, 3.5),
        gaze_down=4.0 + wander(times, "walk gaze down", 2.0, 4.0),
        arms=arms,
        feet={side: feet.path(times, stances[side], f"walk {side}") for side in ("l", "r")},
    )
    return solve(plan)


def _smooth_through(times: Floats, knots: Floats, values: Floats) -> Floats:
    """A smooth curve that follows `values` at `knots` up to the small unevenness of single steps.

    The body is heavy: its speed does not follow every long or short step.
    """
    window = np.exp(-0.5 * ((times[:, None] - knots[None, :]) / 0.6) ** 2)
    # A straight line is fitted around each moment: it keeps a steady pace steady, up to the ends.
    weight = window.sum(axis=1)
    mean_t = (window * knots).sum(axis=1) / weight
    mean_v = (window * values).sum(axis=1) / weight
    dt = knots[None, :] - mean_t[:, None]
    slope = (window * dt * (values[None, :] - mean_v[:, None])).sum(axis=1) / (window * dt**2).sum(axis=1)
    curve: Floats = mean_v + slope * (times - mean_t)
    return curve
