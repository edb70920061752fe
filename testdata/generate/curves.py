"""Curves over time from which the clips are made: smooth passes through key values, and slow natural wandering."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from .noise import uniform
from .rotations import Floats


def spline(times: Floats, keys: Sequence[tuple[float, float]]) -> Floats:
    """A curve with continuous acceleration through (time, value) pairs, at rest at both ends and beyond them."""
    knots = np.array([time for time, _ in keys])
    values = np.array([value for _, value in keys])
    steps = np.diff(knots)
    slopes = np.diff(values) / steps
    size = len(knots)
    system = np.eye(size)
    wanted = np.zeros(size)
    for k in range(1, size - 1):
        system[k, k - 1 : k + 2] = steps[k], 2 * (steps[k - 1] + steps[k]), steps[k - 1]
        wanted[k] = 3 * (steps[k] * slopes[k - 1] + steps[k - 1] * slopes[k])
    velocities: Floats = np.linalg.solve(system, wanted).astype(float)
    x = np.clip(times, knots[0], knots[-1])
    i = np.clip(np.searchsorted(knots, x, side="right") - 1, 0, size - 2)
    return hermite(
        (x - knots[i]) / steps[i], values[i], values[i + 1], velocities[i] * steps[i], velocities[i + 1] * steps[i]
    )


def hermite(u: Floats, start: Floats, end: Floats, leave: Floats, arrive: Floats) -> Floats:
    """The cubic from `start` to `end` for `u` in 0..1, with the derivatives `leave` and `arrive` by `u`."""
    return (
        (2 * u**3 - 3 * u**2 + 1) * start
        + (u**3 - 2 * u**2 + u) * leave
        + (3 * u**2 - 2 * u**3) * end
        + (u**3 - u**2) * arrive
    )


def quintic(times: Floats, start: tuple[float, float, float, float], end: tuple[float, float, float, float]) -> Floats:
    """The motion of least jerk between two states (time, position, velocity, acceleration)."""
    t0, p0, v0, a0 = start
    t1, p1, v1, a1 = end
    d = t1 - t0
    u = (times - t0) / d
    rise, v0, v1, a0, a1 = p1 - p0, v0 * d, v1 * d, a0 * d * d, a1 * d * d
    c3 = 10 * rise - 6 * v0 - 4 * v1 - 1.5 * a0 + 0.5 * a1
    c4 = -15 * rise + 8 * v0 + 7 * v1 + 1.5 * a0 - a1
    c5 = 6 * rise - 3 * v0 - 3 * v1 - 0.5 * a0 + 0.5 * a1
    return p0 + v0 * u + a0 / 2 * u**2 + c3 * u**3 + c4 * u**4 + c5 * u**5


def ease(times: Floats, start: float, end: float) -> Floats:
    """From 0 before `start` to 1 after `end`, with no jump in speed or acceleration."""
    u = np.clip((times - start) / (end - start), 0.0, 1.0)
    return u**3 * (10 - 15 * u + 6 * u**2)


def wander(times: Floats, seed: str, size: float, period_s: float = 1.6) -> Floats:
    """Aimless movement of about `size` to either side: what a living body adds to every joint."""
    phases = uniform(seed, 6)
    curve = np.zeros_like(times)
    for share, pace, phase, shift in ((0.6, 1.0, 0, 3), (0.35, 1.73, 1, 4), (0.2, 2.91, 2, 5)):
        frequency = pace * (0.85 + 0.3 * phases[shift]) / period_s
        curve = curve + share * np.sin(2 * np.pi * (frequency * times + phases[phase]))
    return size * curve
