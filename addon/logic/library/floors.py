"""Round patches of floor below figures: a line each metre of the world, and the axes of the file's origin."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.floating]

FLOOR = (0.42, 0.45, 0.5)
AXES = np.array([(0.93, 0.31, 0.36), (0.52, 0.75, 0.2)])
"""X and Y at the origin, as in the 3D View."""
STEPS = (0.25, 0.5, 1.0, 2.0, 5.0, 10.0, 50.0, 1e9)
"""Metres between two lines: the least with which a radius is crossed by no more than `MOST`."""
MOST = 7
PLACES = np.arange(2 * MOST + 1)
HALVES = 2 * 2 * len(PLACES)
"""Half lines of each patch, in both directions; those that it has no room for are as long as nothing."""
RIM_OPACITY = 0.03


class Patches(NamedTuple):
    """Where floors lie, one for each stage."""

    centres: Floats
    """(n, 2) metres."""
    radii: Floats
    levels: Floats
    """(n,) heights."""
    origins: Floats
    """(n, 2) where the origins of the files are."""


def half_lines(patches: Patches) -> tuple[Floats, Floats, Floats]:
    """Return `HALVES` lines of each patch from the middle to the rim, where they are faint.

    As (n HALVES, 3) beginnings and ends in metres, and (n HALVES, 2, 4) colors at both ends.
    """
    centres, origins, radii = patches.centres[:, :, None], patches.origins[:, :, None], patches.radii[:, None, None]
    step = np.array([next(step for step in STEPS if radius / step <= MOST) for radius in patches.radii])[:, None, None]
    numbers = np.ceil((centres - radii - origins) / step) + PLACES
    across = origins + step * numbers - centres  # by patch, axis and line
    half = np.sqrt(np.maximum(radii**2 - across**2, 0.0))
    middles = np.empty((*across.shape, 2, 3))
    middles[..., 2] = patches.levels[:, None, None, None]
    middles[..., :2] = patches.centres[:, None, None, None]
    for axis in (0, 1):
        middles[:, axis, :, :, axis] += across[:, axis, :, None]
    rims = middles.copy()
    for axis in (0, 1):
        rims[:, axis, :, :, 1 - axis] += half[:, axis, :, None] * (-1.0, 1.0)
    is_axis = numbers == 0
    colors = np.empty((*across.shape, 2, 2, 4))
    colors[..., :3] = np.where(is_axis[..., None], AXES[::-1, None], FLOOR)[..., None, None, :]
    colors[..., 0, 3] = (np.where(is_axis, 1.0, 0.5) * half / radii)[..., None]
    colors[..., 1, 3] = np.where(half > 0.0, RIM_OPACITY, 0.0)[..., None]
    return middles.reshape(-1, 3), rims.reshape(-1, 3), colors.reshape(-1, 2, 4)
