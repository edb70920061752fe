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

CORNER = 4  # points of the quarter circle at the corner of a rectangle
RIM = 1.0  # pixels over which an edge fades


class Mesh(NamedTuple):
    """Triangles: (n, 2) float32 places in pixels, (n, 4) float32 colors, (m, 3) int32 numbers of their corners."""

    places: Floats
    colors: Floats
    triangles: NDArray[np.int32]


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
def _pattern(corners: int, rings: int) -> NDArray[np.int32]:
    """Return the triangles of one convex shape: its core as a fan, and two for each piece between two rings."""
    here = np.arange(corners)
    following = (here + 1) % corners
    found = [np.stack([np.zeros(corners - 2, int), here[1:-1], here[2:]], axis=1)]
    for inside in range(0, (rings - 1) * corners, corners):
        outside = inside + corners
        found.append(np.stack([inside + here, inside + following, outside + here], axis=1))
        found.append(np.stack([inside + following, outside + following, outside + here], axis=1))
    return np.concatenate(found).astype(np.int32)


@lru_cache(maxsize=64)
def triangles(count: int, corners: int, rings: int) -> NDArray[np.int32]:
    """Return the triangles of several convex shapes of as many rings with as many corners each."""
    one = _pattern(corners, rings)
    starts = np.arange(count, dtype=np.int32) * rings * corners
    return (one[None] + starts[:, None, None]).reshape(-1, 3)


def _ringed(rings: Sequence[Floats], colors: Sequence[Floats]) -> Mesh:
    """Return convex shapes from their rings, the innermost first: (n, k, 2) corners and (n, k, 4) colors of each."""
    count, corners = rings[0].shape[:2]
    places = np.concatenate(rings, axis=1, dtype=np.float32).reshape(-1, 2)
    tints = np.concatenate(colors, axis=1, dtype=np.float32).reshape(-1, 4)
    return Mesh(places, tints, triangles(count, corners, len(rings)))


def faded(colors: Floats) -> Floats:
    """Return colors that cannot be seen."""
    clear = colors.copy()
    clear[..., 3] = 0.0
    return clear


@lru_cache(maxsize=8)
def _turns(cap: int) -> tuple[Floats, Floats, NDArray[np.int64]]:
    """Return cosine and sine of the points around a stroke, and at which end each is."""
    half = np.linspace(np.pi / 2, 3 * np.pi / 2, cap)
    turn = np.concatenate([half, half + np.pi])
    return np.cos(turn, dtype=np.float32), np.sin(turn, dtype=np.float32), np.repeat([0, 1], cap)


def outlines(begins: Floats, ends: Floats, radii: Floats, away: Sequence[float], cap: int) -> Floats:
    """Return rings around strokes with round ends that may taper, as (n, rings, 2 cap, 2); equal ends make a disc.

    `begins` and `ends` are (n, 2) pixels, `radii` (n, 2) at both ends; none may be NaN. Each ring is so many pixels
    beyond the radius. The half circle at an end has `cap` points, those of the beginning come first.
    """
    begins, ends, radii = (field.astype(np.float32) for field in (begins, ends, radii))
    along = ends - begins
    length = np.hypot(along[:, 0], along[:, 1])[:, None]
    along = np.where(length > 1e-6, along / np.maximum(length, 1e-6), _RIGHT)
    x, y = along[:, :1], along[:, 1:]
    cosine, sine, at_end = _turns(cap)
    arrows = np.stack([cosine * x - sine * y, cosine * y + sine * x], axis=2)
    centres = np.stack([begins, ends], axis=1)[:, at_end]
    reach = radii[:, None, at_end] + np.array(away, np.float32)[:, None]
    rings: Floats = centres[:, None] + arrows[:, None] * np.maximum(reach, 0.0)[..., None]
    return rings


def strokes(begins: Floats, ends: Floats, radius: float, color: Color, cap: int) -> Mesh:
    """Return strokes with round ends and soft edges."""
    rings = outlines(begins, ends, np.full((len(begins), 2), radius), (-RIM / 2, RIM / 2), cap)
    tints = np.broadcast_to(np.array(color), (len(begins), 2 * cap, 4))
    return _ringed([rings[:, 0], rings[:, 1]], [tints, faded(tints)])


def ribbon_triangles(count: int) -> NDArray[np.int32]:
    """Return the triangles of ribbons: two on each side of the line."""
    one = np.array([(0, 1, 3), (0, 3, 2), (2, 3, 5), (2, 5, 4)], np.int32)
    return (one[None] + 6 * np.arange(count, dtype=np.int32)[:, None, None]).reshape(-1, 3)


def ribbons(begins: Floats, ends: Floats, width: float) -> Floats:
    """Return thin straight lines with as much to each side, for a color that fades out there, as (n, 3, 2, 2).

    `begins` and `ends` are (n, 2) pixels without NaN. First come the ends of the one side, then those of the line.
    """
    along = ends - begins
    aside = np.stack([-along[:, 1], along[:, 0]], axis=1)
    aside *= width / np.maximum(np.hypot(along[:, 0], along[:, 1]), 1e-6)[:, None]
    middle = np.stack([begins, ends], axis=1)
    return np.stack([middle - aside[:, None], middle, middle + aside[:, None]], axis=1)


_RIGHT = np.array([1.0, 0.0], np.float32)
_QUARTER = np.linspace(0.0, np.pi / 2, CORNER)
_ROUND = np.concatenate([_QUARTER + turn * np.pi / 2 for turn in range(4)])
_CORNER_X = np.repeat([1.0, 0.0, 0.0, 1.0], CORNER)
_CORNER_Y = np.repeat([1.0, 1.0, 0.0, 0.0], CORNER)


def rectangles(places: Sequence[Sequence[float]], radii: Sequence[float], colors: Sequence[Color]) -> Mesh:
    """Return rectangles (x, y, width, height) with round corners."""
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
    return _ringed([centres + arrows * inner, centres + arrows * (reach + RIM / 2)], [tints, faded(tints)])


def polygon(corners: Sequence[tuple[float, float]], color: Color) -> Mesh:
    """Return a convex shape, its corners counted against the clock."""
    points = np.asarray(corners, float)
    edges = np.roll(points, -1, axis=0) - points
    normals = np.stack([edges[:, 1], -edges[:, 0]], axis=1)
    normals /= np.maximum(np.hypot(normals[:, 0], normals[:, 1]), 1e-6)[:, None]
    outward = normals + np.roll(normals, 1, axis=0)
    outward /= np.maximum(np.hypot(outward[:, 0], outward[:, 1]), 1e-6)[:, None]
    core, rim = points - outward * RIM / 2, points + outward * RIM / 2
    tints = np.repeat([[color]], len(points), axis=1)
    return _ringed([core[None], rim[None]], [tints, faded(tints)])
