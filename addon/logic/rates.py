"""Frame rates as Blender keeps them: a whole number, divided by a base."""

from __future__ import annotations

import math

HIGHEST_FPS = 32767
SNAP = 1e-4  # a rate that is so near to a usual one is meant to be it ("Frame Time: 0.0083333")


def usual(rate_hz: float) -> float:
    """Return the usual rate that is meant: a whole number or n / 1.001, if one is near; else the rate itself."""
    for base in (1.0, 1.001):
        whole = round(rate_hz * base)
        if whole >= 1 and abs(whole / base - rate_hz) <= SNAP * rate_hz:
            return whole / base
    return rate_hz


def settings(rate_hz: float) -> tuple[int, float]:
    """Return `fps` and `fps_base` of a scene for a rate.

    Whole and broadcast rates come out exactly; any other as the next whole number above it and the base that makes up
    for the difference, which Blender keeps to seven digits.
    """
    for base in (1.0, 1.001):
        whole = round(rate_hz * base)
        if 1 <= whole <= HIGHEST_FPS and abs(whole / base - rate_hz) <= 1e-9 * rate_hz:
            return whole, base
    fps = min(max(math.ceil(rate_hz), 1), HIGHEST_FPS)
    return fps, fps / rate_hz
