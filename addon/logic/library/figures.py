"""What is drawn of a clip at a moment: limbs, joints and markers from back to front, its shadow, the floor below."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from .camera import Camera
from .shapes import NO_STROKES, Strokes, gathered, strokes

Floats = NDArray[np.floating]

LIMB = 0.022  # radius of a limb and of a marker, by the height of the figure
MARKER = 0.011
THINNEST = 1.1  # pixels
HALO = 1.4  # pixels of dark around a limb, which keeps crossing limbs apart
LOOKED_AT = 200  # frames from which the extent of a clip is taken
HALO_COLOR = (0.03, 0.032, 0.035, 0.9)
SHADOW = (0.0, 0.0, 0.0, 0.33)
SIDES = {-1: (0.36, 0.64, 1.0), 0: (0.93, 0.91, 0.86), 1: (1.0, 0.56, 0.33)}
"""Left blue, middle light, right orange."""
FLOOR = (0.42, 0.45, 0.5)
FLOOR_LINE = 0.55  # pixels to each side
AXES = ((0.93, 0.31, 0.36), (0.52, 0.75, 0.2))
"""X and Y at the origin, as in the 3D View."""


class FigureData(Protocol):
    """What the native module gives of a clip: metres, Z up."""

    points: Floats
    """(frames, points, 3), NaN in gaps."""
    lines: NDArray[np.int32]
    sides: NDArray[np.int8]
    rate_hz: float
    first_frame: int
    floor: float


@dataclass(frozen=True)
class Body:
    """A clip made ready for the stage."""

    points: Floats
    """(frames, points, 3)."""
    ends: tuple[NDArray[np.int32], NDArray[np.int32]]
    """Per stroke the points at its ends: first the limbs, then markers and points on no limb, whose ends are one."""
    thickness: Floats
    """(strokes,) metres."""
    colors: Floats
    """(strokes, 2, 4) of the halo and of the stroke."""
    shadow: Floats
    """(strokes, 4)."""
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
        return self.points.nbytes + self.path.nbytes


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
    count = len(lines) + len(loose)
    colors = np.ones((count, 2, 4))
    colors[:, 0], colors[:, 1, :3] = HALO_COLOR, tints
    return Body(
        points=points,
        ends=(np.concatenate([lines[:, 0], loose]), np.concatenate([lines[:, 1], loose])),
        thickness=height * np.concatenate([np.full(len(lines), thin), np.full(len(loose), MARKER)]),
        colors=colors,
        shadow=np.repeat([SHADOW], count, 0),
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


def pose(body: Body, frame: float) -> tuple[Floats, Floats]:
    """Return (points, 3) and the (2,) place on the floor at a frame counted from 0, straight between two frames."""
    before = min(max(int(frame), 0), body.frames - 1)
    after = min(before + 1, body.frames - 1)
    share = min(max(frame - before, 0.0), 1.0)
    here, there = body.points[before].astype(float), body.points[after]
    between = here + (there - here) * share
    points = np.where(np.isfinite(there), between, here) if share else here
    return points, body.path[before] + (body.path[after] - body.path[before]) * share


def drawn(body: Body, frame: float, camera: Camera, offset: Floats) -> Strokes:
    """Return the figure as the camera sees it, moved by an (3,) offset, from back to front, above its shadow."""
    points, _ = pose(body, frame)
    points = points + offset
    ground = points.copy()
    ground[:, 2] = body.floor + offset[2]
    count = len(points)
    places, depths = camera.project(np.concatenate([points, ground]))
    begin, end = body.ends
    dark = _strokes(camera, places[count:], depths[count:], begin, end, body.thickness * 1.2, body.shadow, 0.0)
    pixels, depth = places[:count], depths[:count]
    order = np.argsort(-(depth[begin] + depth[end]), kind="stable")
    begin, end = begin[order], end[order]
    tints = body.colors[order]
    tints[:, 1, :3] *= _light(depth, begin, end, body.height)
    # Each limb follows its own halo, so that it covers only what lies behind it.
    twice = np.repeat(np.arange(len(begin)), 2)
    halo = np.tile([HALO, 0.0], len(begin))
    thick = body.thickness[order][twice]
    limbs = _strokes(camera, pixels, depth, begin[twice], end[twice], thick, tints.reshape(-1, 4), halo)
    return gathered([dark, limbs])


def _strokes(
    camera: Camera,
    pixels: Floats,
    depth: Floats,
    begin: NDArray[np.int32],
    end: NDArray[np.int32],
    thick: Floats,
    colors: Floats,
    wider: Floats | float,
) -> Strokes:
    scale = camera.pixels_per_metre(depth)
    first = np.maximum(thick * scale[begin], THINNEST) + wider
    last = np.maximum(0.75 * thick * scale[end], THINNEST) + wider
    return strokes(pixels[begin], pixels[end], first, last, colors)


def _light(depth: Floats, begin: NDArray[np.int32], end: NDArray[np.int32], height: float) -> Floats:
    """Return (n, 1) factors: what is nearer is a little lighter."""
    middle = (depth[begin] + depth[end]) / 2
    if not np.isfinite(middle).any():
        return np.ones((len(begin), 1))
    away = (middle - np.nanmin(middle)) / max(height, 1e-6)
    return np.nan_to_num(1.0 - 0.42 * np.clip(away / 0.6, 0.0, 1.0), nan=1.0)[:, None]


def floor(camera: Camera, centre: Floats, radius: float, level: float, origin: Floats) -> Strokes:
    """Return a round patch of floor: a line each metre of the world, or each ten of a large one, and the origin's axes.

    `centre` is the (2,) middle of the patch, `origin` the (2,) place of the file's origin.
    """
    spacing = next(step for step in (0.25, 0.5, 1.0, 2.0, 5.0, 10.0, 50.0, 1e9) if radius / step <= 7)
    middles, rims, tints = [], [], []
    for axis in (0, 1):
        low, high = centre[axis] - radius, centre[axis] + radius
        first = np.ceil((low - origin[axis]) / spacing)
        numbers = np.arange(first, first + 2 * radius / spacing + 1)
        places = origin[axis] + spacing * numbers
        inside = (places > low) & (places < high)
        places, is_axis = places[inside], numbers[inside] == 0
        half = np.sqrt(radius**2 - (places - centre[axis]) ** 2)
        middle = np.full((len(places), 3), level)
        middle[:, axis], middle[:, 1 - axis] = places, centre[1 - axis]
        color = np.where(is_axis[:, None], AXES[1 - axis], FLOOR)
        near = np.column_stack([color, np.where(is_axis, 1.0, 0.5) * half / radius])
        far = np.column_stack([color, np.full(len(places), 0.03)])  # fades towards the rim
        for along in (-half, half):
            rim = middle.copy()
            rim[:, 1 - axis] += along
            middles.append(middle)
            rims.append(rim)
            tints.append(np.stack([near, far], axis=1))
    begins, ends = np.concatenate(middles), np.concatenate(rims)
    if not len(begins):
        return NO_STROKES
    pixels, _ = camera.project(np.concatenate([begins, ends]))
    width = np.full(len(begins), FLOOR_LINE)
    return strokes(pixels[: len(begins)], pixels[len(begins) :], width, width, np.concatenate(tints))
