"""Flat shapes with soft edges, as vertices, colors and triangles: many at a time, as arrays.

Blender does not smooth the edges of what an add-on draws. So each shape has a rim, one pixel wide, that fades out.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.floating]
Color = tuple[float, float, float, float]

CORNER = 5  # points of the quarter circle at the corner of a rectangle
RIM = 1.0  # pixels over which an edge fades


class Mesh(NamedTuple):
    """Triangles: (n, 2) float32 places in pixels, (n, 4) float32 colors, (m, 3) int32 numbers of their corners."""

    places: Floats
    colors: Floats
    triangles: NDArray[np.int32]


TRIANGLES_OF_RECTANGLE = 4 * CORNER - 2 + 8 * CORNER
EMPTY = Mesh(np.empty((0, 2), np.float32), np.empty((0, 4), np.float32), np.empty((0, 3), np.int32))


def joined(meshes: Sequence[Mesh]) -> Mesh:
    """Return several as one, drawn in their order."""
    meshes = [mesh for mesh in meshes if len(mesh.triangles)]
    if not meshes:
        return EMPTY
    starts = np.cumsum([0] + [len(mesh.places) for mesh in meshes[:-1]])
    return Mesh(
        np.concatenate([mesh.places for mesh in meshes]),
        np.concatenate([mesh.colors for mesh in meshes]),
        np.concatenate([mesh.triangles + start for mesh, start in zip(meshes, starts, strict=True)]).astype(np.int32),
    )


@lru_cache(maxsize=64)
def _pattern(corners: int) -> NDArray[np.int32]:
    """Return the triangles of one convex shape: its core as a fan, and two for each piece of its rim."""
    here = np.arange(corners)
    following = (here + 1) % corners
    fan = np.stack([np.zeros(corners - 2, int), here[1:-1], here[2:]], axis=1)
    inner = np.stack([here, following, here + corners], axis=1)
    outer = np.stack([following, following + corners, here + corners], axis=1)
    return np.concatenate([fan, inner, outer]).astype(np.int32)


def _outlined(core: Floats, rim: Floats, colors: Floats) -> Mesh:
    """Return convex shapes from (n, k, 2) corners, (n, k, 2) faded corners around them, and their (n, k, 4) colors."""
    count, corners = core.shape[:2]
    faded = colors.copy()
    faded[:, :, 3] = 0.0
    places = np.concatenate([core, rim], axis=1).reshape(-1, 2)
    tints = np.concatenate([colors, faded], axis=1)
    one = _pattern(corners)
    triangles = one[None] + (np.arange(count, dtype=np.int32) * 2 * corners)[:, None, None]
    return Mesh(places.astype(np.float32), tints.reshape(-1, 4).astype(np.float32), triangles.reshape(-1, 3))


class Strokes(NamedTuple):
    """Strokes with round ends that may taper; equal ends make a disc. All float64, without NaN."""

    begins: Floats
    """(n, 2) pixels."""
    ends: Floats
    radii: Floats
    """(n, 2) at both ends."""
    colors: Floats
    """(n, 2, 4) at both ends."""


NO_STROKES = Strokes(np.empty((0, 2)), np.empty((0, 2)), np.empty((0, 2)), np.empty((0, 2, 4)))


def strokes(begins: Floats, ends: Floats, begin_radii: Floats, end_radii: Floats, colors: Floats) -> Strokes:
    """Return strokes, without those of which an end is NaN. Colors are (n, 4), or (n, 2, 4) with one for each end."""
    tints = np.asarray(colors, float)
    if tints.ndim == 2:
        tints = np.repeat(tints[:, None], 2, axis=1)
    found = Strokes(begins, ends, np.stack([begin_radii, end_radii], axis=1), tints)
    keep = np.isfinite(begins).all(1) & np.isfinite(ends).all(1)
    return found if keep.all() else Strokes(*(field[keep] for field in found))


def gathered(found: Sequence[Strokes]) -> Strokes:
    """Return several lists of strokes as one, in their order."""
    if not found:
        return NO_STROKES
    return found[0] if len(found) == 1 else Strokes(*(np.concatenate(fields) for fields in zip(*found, strict=True)))


def triangles_of_stroke(cap: int) -> int:
    """Return how many triangles a stroke is made of, whose half circles at the ends have `cap` points."""
    return 6 * cap - 2


@lru_cache(maxsize=8)
def _turns(cap: int) -> tuple[Floats, Floats, NDArray[np.int64]]:
    """Return cosine and sine of the points around a stroke, and at which end each is."""
    half = np.linspace(np.pi / 2, 3 * np.pi / 2, cap)
    turn = np.concatenate([half, half + np.pi])
    return np.cos(turn), np.sin(turn), np.repeat([0, 1], cap)


def capsules(found: Strokes, cap: int = 6) -> Mesh:
    """Return strokes as triangles, the more the rounder."""
    if not len(found.begins):
        return EMPTY
    along = found.ends - found.begins
    length = np.hypot(along[:, 0], along[:, 1])[:, None]
    along = np.where(length > 1e-6, along / np.maximum(length, 1e-6), _RIGHT)
    x, y = along[:, :1], along[:, 1:]
    cosine, sine, at_end = _turns(cap)
    arrows = np.stack([cosine * x - sine * y, cosine * y + sine * x], axis=2)
    centres = np.stack([found.begins, found.ends], axis=1)[:, at_end]
    reach = found.radii[:, at_end, None]
    core, rim = centres + arrows * np.maximum(reach - RIM / 2, 0.0), centres + arrows * (reach + RIM / 2)
    return _outlined(core, rim, found.colors[:, at_end])


_RIGHT = np.array([1.0, 0.0])
_QUARTER = np.linspace(0.0, np.pi / 2, CORNER)
_ROUND = np.concatenate([_QUARTER + turn * np.pi / 2 for turn in range(4)])
_CORNER_X = np.repeat([1.0, 0.0, 0.0, 1.0], CORNER)
_CORNER_Y = np.repeat([1.0, 1.0, 0.0, 0.0], CORNER)


def rectangles(places: Sequence[Sequence[float]], radii: Sequence[float], colors: Sequence[Color]) -> Mesh:
    """Return rectangles (x, y, width, height) with round corners, `TRIANGLES_OF_RECTANGLE` for each."""
    if not places:
        return EMPTY
    box = np.asarray(places, float)
    radius = np.minimum(np.asarray(radii, float), box[:, 2:].min(1) / 2)[:, None]
    arrows = np.stack([np.cos(_ROUND), np.sin(_ROUND)], axis=1)
    x = box[:, :1] + radius + _CORNER_X * (box[:, 2:3] - 2 * radius)
    y = box[:, 1:2] + radius + _CORNER_Y * (box[:, 3:4] - 2 * radius)
    centres = np.stack([x, y], axis=2)
    reach = radius[:, :, None]
    inner = np.maximum(reach - RIM / 2, 0.0)
    tints = np.repeat(np.asarray(colors, float)[:, None], len(_ROUND), axis=1)
    return _outlined(centres + arrows * inner, centres + arrows * (reach + RIM / 2), tints)


def polygon(corners: Sequence[tuple[float, float]], color: Color) -> Mesh:
    """Return a convex shape, its corners counted against the clock."""
    points = np.asarray(corners, float)
    edges = np.roll(points, -1, axis=0) - points
    normals = np.stack([edges[:, 1], -edges[:, 0]], axis=1)
    normals /= np.maximum(np.hypot(normals[:, 0], normals[:, 1]), 1e-6)[:, None]
    outward = normals + np.roll(normals, 1, axis=0)
    outward /= np.maximum(np.hypot(outward[:, 0], outward[:, 1]), 1e-6)[:, None]
    core, rim = points - outward * RIM / 2, points + outward * RIM / 2
    return _outlined(core[None], rim[None], np.repeat([[color]], len(points), axis=1))
