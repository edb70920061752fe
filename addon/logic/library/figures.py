"""A clip made ready for the stage: its strokes with their colors, its path, its size, and its pose at a moment."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.floating]

LIMB = 0.022  # radius of a limb and of a marker, by the height of the figure
MARKER = 0.011
LOOKED_AT = 200  # frames from which the extent of a clip is taken
SIDES = {-1: (0.36, 0.64, 1.0), 0: (0.93, 0.91, 0.86), 1: (1.0, 0.56, 0.33)}
"""Left blue, middle light, right orange."""


class FigureData(Protocol):
    """What the native module gives of a clip: metres, Z up."""

    points: Floats
    """(frames, points, 3), NaN in gaps."""
    lines: NDArray[np.int32]
    sides: NDArray[np.int8]
    rate_hz: float
    first_frame: int
    floor: float


@dataclass(frozen=True, eq=False)
class Body:
    """A clip made ready for the stage; none is equal to another."""

    points: Floats
    """(frames, points, 3)."""
    ends: tuple[NDArray[np.int32], NDArray[np.int32]]
    """Per stroke the points at its ends: first the limbs, then markers and points on no limb, whose ends are one."""
    thickness: Floats
    """(strokes,) metres."""
    tints: Floats
    """(strokes, 3) colors."""
    path: Floats
    """(frames, 2) where the figure is on the floor."""
    rate_hz: float
    first_frame: int
    floor: float
    height: float
    radius: float
    """How far the figure reaches from where it is, to the side."""
    reach: tuple[float, float, float]
    """Centre and radius on the floor of all that the clip passes through."""

    @property
    def frames(self) -> int:
        """How many there are."""
        return len(self.points)

    @property
    def bytes(self) -> int:
        """What it takes in memory."""
        arrays = (self.points, self.path, *self.ends, self.thickness, self.tints)
        return sum(array.nbytes for array in arrays)


def prepared(figure: FigureData, *, is_markers: bool, fallback_rate_hz: float = 120.0) -> Body:
    """Make a clip ready for the stage: its path, its size and its colors. Made to be called in the background."""
    points = figure.points
    with np.errstate(all="ignore"):
        path = _filled(_middles(points) if is_markers else points[:, 0, :2].astype(float))
        some = points[:: max(1, len(points) // LOOKED_AT)].astype(float)
        away = some[:, :, :2] - path[:: max(1, len(points) // LOOKED_AT)][:, None]
        sideways = np.hypot(away[..., 0], away[..., 1])
        radius = _finite(np.nanquantile(sideways, 0.995) if np.isfinite(sideways).any() else np.nan, 0.5)
        top = _finite(np.nanquantile(some[..., 2], 0.995) if np.isfinite(some).any() else np.nan, 1.75)
    height = max(top - figure.floor, 0.05)
    low, high = path.min(0), path.max(0)
    lines = figure.lines.reshape(-1, 2)
    every = np.arange(points.shape[1], dtype=np.int32)
    loose = every if is_markers else every[~np.isin(every, lines)]
    thin = 0.5 * LIMB if is_markers else LIMB
    tints = np.array([SIDES[int(np.sign(side))] for side in figure.sides] + [SIDES[0]] * len(loose)).reshape(-1, 3)
    return Body(
        points=points,
        ends=(np.concatenate([lines[:, 0], loose]), np.concatenate([lines[:, 1], loose])),
        thickness=height * np.concatenate([np.full(len(lines), thin), np.full(len(loose), MARKER)]),
        tints=tints,
        path=path,
        rate_hz=figure.rate_hz if figure.rate_hz and figure.rate_hz > 0 else fallback_rate_hz,
        first_frame=figure.first_frame,
        floor=float(figure.floor),
        height=height,
        radius=max(radius, 0.15 * height),
        reach=(*((low + high) / 2), float(np.hypot(*(high - low)) / 2)),
    )


def _middles(points: Floats) -> Floats:
    """Return where the middle of all visible markers is in each frame."""
    seen = np.isfinite(points[:, :, 0])
    sums: Floats = np.where(seen[:, :, None], points[:, :, :2], 0.0).sum(axis=1, dtype=float)
    count = np.count_nonzero(seen, axis=1)[:, None]
    return np.where(count, sums / np.maximum(count, 1), np.nan)


def _filled(path: Floats) -> Floats:
    """Return a path without gaps: straight from the place before to the place after."""
    known = np.isfinite(path).all(1)
    if known.all():
        return path
    if not known.any():
        return np.zeros_like(path)
    frames = np.arange(len(path))
    return np.stack([np.interp(frames, frames[known], path[known, axis]) for axis in (0, 1)], axis=1)


def _finite(value: float, otherwise: float) -> float:
    return float(value) if np.isfinite(value) else otherwise


def place(body: Body, frame: float) -> Floats:
    """Return the (2,) place on the floor at a frame counted from 0, straight between two frames."""
    before, after, share = _between(body, frame)
    here: Floats = body.path[before] + (body.path[after] - body.path[before]) * share
    return here


def poses(bodies: Sequence[Body], frames: Sequence[float]) -> Floats:
    """Return the (n, 3) points of several figures, one after another, each at its own frame."""
    moments = [_between(body, frame) for body, frame in zip(bodies, frames, strict=True)]
    here = np.concatenate(
        [body.points[before] for body, (before, _, _) in zip(bodies, moments, strict=True)], dtype=float
    )
    there = np.concatenate([body.points[after] for body, (_, after, _) in zip(bodies, moments, strict=True)])
    share = np.repeat([share for *_, share in moments], [body.points.shape[1] for body in bodies])[:, None]
    is_between = (share > 0.0) & np.isfinite(there)
    found: Floats = np.where(is_between, here + (there - here) * share, here)
    return found


def _between(body: Body, frame: float) -> tuple[int, int, float]:
    """Return the frames around a moment, and how far it is from the one to the other."""
    before = min(max(int(frame), 0), body.frames - 1)
    return before, min(before + 1, body.frames - 1), min(max(frame - before, 0.0), 1.0)
