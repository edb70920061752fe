"""Feet: where they stand, how they roll over heel and toes, and how they travel in between.

A foot is planned as the position of its ankle, its heading, the pitch of its sole (positive: toes up) and the bend of
its toes; `body` turns that into joint angles.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from . import skeleton
from .curves import ease, hermite, wander
from .rotations import Floats

SOLE_M = 0.025
"""Height of the toe joints above the sole."""

HEEL_BACK_M = 0.05
"""How far the heel reaches back from the ankle."""

FOOT_M = float(np.linalg.norm(skeleton.BY_NAME["lfoot"].offset_m))
TOES_M = float(np.linalg.norm(skeleton.BY_NAME["ltoes"].offset_m))
SLOPE = np.radians(skeleton.FOOT_SLOPE_DEG)
ANKLE_M = SOLE_M + FOOT_M * np.sin(SLOPE)
"""Height of the ankle over a flat sole."""

TOE_BEND_LIMIT = np.radians(42.0)
"""When the heel rises further, the ball leaves the floor too and the foot stands on the tip of its toes."""

TOE_BEND_SOFTNESS = 0.2

TOUCHDOWN = 0.25
"""Speed of the foot over the floor just before it touches down, as a share of its mean speed in the swing."""

STEP_S = 1e-4
"""Time step for the speed with which a foot leaves and meets the floor."""


@dataclass(frozen=True)
class Stance:
    """One contact of a foot with the floor. Times in seconds, angles in degrees, places in metres."""

    strike: float
    release: float
    x: float
    """Where the ball of the foot stands."""
    z: float
    heading: float = 0.0
    strike_pitch: float = 0.0
    """At first contact: positive for the heel first, negative for the ball first."""
    release_pitch: float = 0.0
    """At last contact: negative, the heel is raised."""
    settle: float = 0.1
    """Seconds from first contact to the flat sole."""
    roll: float = 0.25
    """Seconds over which the heel rises before the release."""
    lift: float = 0.03
    """By how much the foot is raised on its way here, in metres."""
    drop: float = 0.0
    """How fast the foot falls onto the floor, in metres a second."""


@dataclass(frozen=True)
class FootPath:
    """A foot over frames; angles in radians."""

    ankle: Floats
    heading: Floats
    pitch: Floats
    toe_bend: Floats
    """How far the toes point up from the sole."""
    planted: NDArray[np.bool_]


def forwards(heading: Floats) -> Floats:
    """The horizontal unit vector of a heading (0 is +Z, positive turns to the left)."""
    return np.stack([np.sin(heading), np.zeros_like(heading), np.cos(heading)], axis=-1)


def raised(heading: Floats, elevation: Floats) -> Floats:
    """The unit vector of a heading, lifted from the horizontal by `elevation`."""
    vector = forwards(heading) * np.cos(elevation)[:, None]
    vector[:, 1] = np.sin(elevation)
    return vector


def _stance_pitch(stance: Stance, times: Floats) -> Floats:
    landing = 1 - ease(times, stance.strike, stance.strike + stance.settle)
    # The heel rises ever faster until the foot leaves.
    leaving = np.clip((times - stance.release + stance.roll) / stance.roll, 0.0, 1.0) ** 2.6
    return np.radians(stance.strike_pitch * landing + stance.release_pitch * leaving)


def _toe_lift(pitch: Floats) -> Floats:
    """How steeply the toes themselves fall from the ball to their tip once they cannot bend further."""
    excess = -pitch - TOE_BEND_LIMIT
    soft = 0.5 * (excess + np.hypot(excess, TOE_BEND_SOFTNESS))
    none = 0.5 * (-TOE_BEND_LIMIT + np.hypot(TOE_BEND_LIMIT, TOE_BEND_SOFTNESS))
    lift: Floats = np.maximum(soft - none, 0.0)
    return lift


def _stance_ankle(stance: Stance, times: Floats, pitch: Floats) -> Floats:
    """The ankle of a foot that rolls over its heel (toes up), or over its ball and then its toes (heel up)."""
    heading = np.full(len(times), np.radians(stance.heading))
    ball = np.array([stance.x, SOLE_M, stance.z]) + np.zeros((len(times), 3))
    tip = ball + TOES_M * forwards(heading)
    over_ball = tip - TOES_M * raised(heading, -_toe_lift(pitch)) - FOOT_M * raised(heading, pitch - SLOPE)
    flat_ankle = ball - FOOT_M * raised(heading, np.full(len(times), -SLOPE))
    heel = flat_ankle - HEEL_BACK_M * forwards(heading)
    heel[:, 1] = 0.0
    over_heel = heel + HEEL_BACK_M * raised(heading, pitch) + ANKLE_M * raised(heading, pitch + np.pi / 2)
    return np.where((pitch > 0)[:, None], over_heel, over_ball)


def _swing_toes(u: Floats, before: Stance, after: Stance, ball_height: Floats, pitch: Floats) -> Floats:
    """Toes straighten after the release and get ready for a landing on the ball; the floor holds them up."""
    leaving = np.radians(np.array(before.release_pitch))
    bend = (-leaving - _toe_lift(leaving)) * (1 - ease(u, 0.0, 0.45))
    bend = bend + max(-np.radians(after.strike_pitch), 0.0) * ease(u, 0.6, 1.0)
    lowest = -np.arcsin(np.clip(ball_height / TOES_M, 0.0, 1.0))
    held: Floats = np.maximum(pitch + bend, lowest)
    return held - pitch


def path(times: Floats, stances: Sequence[Stance], seed: str) -> FootPath:
    """The foot through its stances, in order; between two of them it swings."""
    count = len(times)
    ankle, pitch, bend = np.zeros((count, 3)), np.zeros(count), np.zeros(count)
    heading = np.zeros(count)
    planted = np.zeros(count, dtype=bool)
    for stance in stances:
        now = (times >= stance.strike) & (times <= stance.release)
        pitch[now] = _stance_pitch(stance, times[now])
        ankle[now] = _stance_ankle(stance, times[now], pitch[now])
        heading[now] = np.radians(stance.heading)
        bend[now] = np.maximum(-pitch[now], 0.0) - _toe_lift(pitch[now])
        planted |= now
    for before, after in pairwise(stances):
        now = (times > before.release) & (times < after.strike)
        duration = after.strike - before.release
        u = (times[now] - before.release) / duration

        ends = np.array([before.release - STEP_S, before.release]), np.array([after.strike, after.strike + STEP_S])
        pitches = _stance_pitch(before, ends[0]), _stance_pitch(after, ends[1])
        ankles = _stance_ankle(before, ends[0], pitches[0]), _stance_ankle(after, ends[1], pitches[1])
        rates = [np.diff(pair, axis=0)[0] / STEP_S * duration for pair in (*pitches, *ankles)]
        rates[3] = rates[3] + TOUCHDOWN * (ankles[1][0] - ankles[0][1])
        rates[3][1] -= after.drop * duration
        pitch[now] = hermite(u, pitches[0][1], pitches[1][0], rates[0] * 0.6, rates[1])
        column = u[:, None]
        ankle[now] = hermite(column, ankles[0][1], ankles[1][0], rates[2], rates[3])
        ankle[now, 1] += after.lift * 64 * (u * (1 - u)) ** 3
        turn = ease(u, 0.05, 0.95)
        heading[now] = np.radians(before.heading + (after.heading - before.heading) * turn)
        ball_height = ankle[now, 1] + FOOT_M * np.sin(pitch[now] - SLOPE) - SOLE_M
        bend[now] = _swing_toes(u, before, after, ball_height, pitch[now])
    return FootPath(ankle, heading, pitch, bend + wander(times, seed + " toes", np.radians(0.8), 0.9), planted)


def standing(x: float, z: float, heading: float = 0.0) -> Stance:
    """A stance without beginning or end."""
    return Stance(-1e3, 1e3, x, z, heading)


def support(times: Floats, left: FootPath, right: FootPath, smoothing_s: float = 0.09) -> Floats:
    """The point on the floor (frames, 3) over which the weight is carried.

    It lies between the feet, moves over the standing foot while the other swings, and does so before the swing begins,
    as weight is shifted in order to lift a foot.
    """
    weights = np.stack([left.planted, right.planted], axis=-1).astype(float)
    weights[weights.sum(axis=-1) == 0] = 1.0
    weights = smoothed(times, weights, smoothing_s)
    weights /= weights.sum(axis=-1, keepdims=True)
    middles = [foot.ankle + 0.45 * FOOT_M * forwards(foot.heading) for foot in (left, right)]
    point = weights[:, :1] * middles[0] + weights[:, 1:] * middles[1]
    point[:, 1] = 0.0
    return smoothed(times, point, smoothing_s)


def smoothed(times: Floats, values: Floats, deviation_s: float) -> Floats:
    """Gaussian means over time; the ends are continued as they are."""
    reach = int(np.ceil(4 * deviation_s / (times[1] - times[0])))
    kernel = np.exp(-0.5 * (np.arange(-reach, reach + 1) * (times[1] - times[0]) / deviation_s) ** 2)
    padded = np.pad(values, ((reach, reach), (0, 0)), mode="edge")
    columns = [np.convolve(padded[:, i], kernel / kernel.sum(), mode="valid") for i in range(values.shape[1])]
    return np.stack(columns, axis=-1)
