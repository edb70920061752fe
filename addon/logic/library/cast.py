"""All figures that are on the stage at once: from back to front, each with its shadow and the floor below.

They are computed together, for what takes long is not their number but the number of steps.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from . import figures, floors, shapes
from .camera import Cameras

Floats = NDArray[np.floating]
Triangles = NDArray[np.int32]

THINNEST = 1.1  # pixels
TAPER = 0.75
HALO = (0.03, 0.032, 0.035, 0.9)
"""Dark around a limb, which keeps crossing limbs apart. Each follows its own, and so covers only what lies behind."""
RINGS = (-shapes.RIM / 2, shapes.RIM / 2, 2.0)
"""Around a limb: where its color ends, where the halo begins, and where that has faded; pixels beyond its radius."""
SHADOW = (0.0, 0.0, 0.0, 0.33)
WIDER = 1.2  # a shadow, by its limb
LINE = 1.05  # pixels within which a line of the floor fades out to either side
DARKER, DARKEST_FROM = 0.42, 0.6
"""How much of its light a limb loses at the most, and how far behind the nearest one, by the height of the figure."""


class Cast:
    """Figures side by side. Which corners make which triangle never changes, only where the corners are."""

    def __init__(self, bodies: Sequence[figures.Body], cap: int) -> None:
        """Take the figures, and how many points the half circle at the end of a limb has."""
        self.bodies, self.cap = tuple(bodies), cap
        points = [body.points.shape[1] for body in bodies]
        strokes = [len(body.thickness) for body in bodies]
        numbers = np.arange(len(bodies))
        self._whose = np.repeat(numbers, points)
        self._of_line = np.repeat(numbers, floors.HALVES)
        self._of_stroke = np.repeat(numbers, strokes)
        first = np.repeat(np.cumsum([0, *points[:-1]]), strokes)
        self._begin, self._end = (first + np.concatenate([body.ends[k] for body in bodies]) for k in (0, 1))
        self._thickness = np.concatenate([body.thickness for body in bodies])
        self._tints = np.concatenate([body.tints for body in bodies])
        self._heights = np.array([body.height for body in bodies])
        self._floors = np.array([body.floor for body in bodies])
        lines, around, total = len(bodies) * floors.HALVES, 2 * cap, sum(strokes)
        self._sizes = ((lines, 3, 2), (total, 1, around), (total, len(RINGS), around))
        """Of lines, shadows and limbs: how many there are, their rows or rings, and the corners of each of these."""
        corners = sum(int(np.prod(size)) for size in self._sizes)
        self.places, self.colors = np.zeros((corners, 2), np.float32), np.zeros((corners, 4), np.float32)
        self._line_places, self._shadow_places, self._limb_places = self._by_kind(self.places)
        self._line_colors, self._shadow_colors, self._limb_colors = self._by_kind(self.colors)
        self.parts = self._triangles()
        """(m, 3) numbers of the corners of each figure with its floor, in the order in which they are drawn."""

    def _by_kind(self, fields: Floats) -> list[Floats]:
        """Return what belongs to lines, shadows and limbs, by stroke, ring and corner."""
        ends = np.cumsum([np.prod(size) for size in self._sizes])[:-1]
        pieces = np.split(fields, ends)
        return [piece.reshape(*size, fields.shape[1]) for piece, size in zip(pieces, self._sizes, strict=True)]

    def _triangles(self) -> list[Triangles]:
        lines, shadows, limbs = self._sizes
        kinds = (
            shapes.ribbon_triangles(lines[0]),
            shapes.triangles(shadows[0], shadows[2], 1),
            shapes.triangles(limbs[0], limbs[2], len(RINGS)),
        )
        shifts = np.cumsum([0, np.prod(lines), np.prod(shadows)])
        owners = (self._of_line, self._of_stroke, self._of_stroke)
        return [
            np.concatenate(
                [
                    every[np.repeat(of == number, len(every) // max(1, len(of)))] + shift
                    for every, of, shift in zip(kinds, owners, shifts, strict=True)
                ],
                dtype=np.int32,
            )
            for number in range(len(self.bodies))
        ]

    def place(self, frames: Sequence[float], cameras: Cameras, patches: floors.Patches) -> None:
        """Put all corners, (n, 2) `places` in pixels with (n, 4) `colors`, where they are at a moment.

        The frames are counted from 0. A figure stands where the origin of its patch says.
        """
        points = figures.poses(self.bodies, frames)
        points[:, :2] += patches.origins[self._whose]
        ground = points.copy()
        ground[:, 2] = self._floors[self._whose]
        middles, rims, tints = floors.half_lines(patches)
        pixels, depth, scale = cameras.project(
            np.concatenate([points, ground, middles, rims]),
            np.concatenate([self._whose, self._whose, self._of_line, self._of_line]),
        )
        count, lines = len(points), len(middles)
        self._place_lines(pixels[2 * count : 2 * count + lines], pixels[2 * count + lines :], tints)
        self._place_shadows(pixels[count : 2 * count], scale[count : 2 * count])
        self._place_limbs(pixels[:count], depth[:count], scale[:count])

    def _place_lines(self, begins: Floats, ends: Floats, tints: Floats) -> None:
        begins, ends, is_seen = _seen(begins, ends)
        self._line_places[:] = shapes.ribbons(begins, ends, LINE)
        self._line_colors[..., :3] = tints[:, None, :, :3]
        self._line_colors[:, 1, :, 3] = tints[..., 3] * is_seen[:, None]

    def _place_shadows(self, pixels: Floats, scale: Floats) -> None:
        begins, ends, is_seen = _seen(pixels[self._begin], pixels[self._end])
        radii = _radii(WIDER * self._thickness, scale[self._begin], scale[self._end])
        self._shadow_places[:] = shapes.outlines(begins, ends, radii, (0.0,), self.cap)
        self._shadow_colors[..., 3] = SHADOW[3] * is_seen[:, None, None]

    def _place_limbs(self, pixels: Floats, depth: Floats, scale: Floats) -> None:
        away = (depth[self._begin] + depth[self._end]) / 2
        order = np.lexsort((-away, self._of_stroke))
        begin, end = self._begin[order], self._end[order]
        begins, ends, is_seen = _seen(pixels[begin], pixels[end])
        radii = _radii(self._thickness[order], scale[begin], scale[end])
        self._limb_places[:] = shapes.outlines(begins, ends, radii, RINGS, self.cap)
        colors = self._limb_colors
        colors[:, 0, :, :3] = (self._tints * self._light(away))[order][:, None]
        colors[:, 0, :, 3] = is_seen[:, None]
        colors[:, 1:, :, :3] = HALO[:3]
        colors[:, 1, :, 3] = HALO[3] * is_seen[:, None]

    def _light(self, away: Floats) -> Floats:
        """Return (n, 1) factors: what is nearer is a little lighter."""
        far = np.where(np.isnan(away), np.inf, away)
        nearest = np.full(len(self.bodies), np.inf)
        np.minimum.at(nearest, self._of_stroke, far)
        with np.errstate(invalid="ignore"):
            behind = (far - nearest[self._of_stroke]) / self._heights[self._of_stroke]
        shade: Floats = np.nan_to_num(np.clip(behind / DARKEST_FROM, 0.0, 1.0))
        return 1.0 - DARKER * shade[:, None]


def _seen(begins: Floats, ends: Floats) -> tuple[Floats, Floats, NDArray[np.bool_]]:
    """Return (n, 2) ends of strokes, at one point where one of them is not to be seen, and which are to be seen."""
    is_seen = np.isfinite(begins[:, 0] + ends[:, 0])
    if is_seen.all():
        return begins, ends, is_seen
    return np.where(is_seen[:, None], begins, 0.0), np.where(is_seen[:, None], ends, 0.0), is_seen


def _radii(thickness: Floats, begin_scale: Floats, end_scale: Floats) -> Floats:
    """Return the (n, 2) radii in pixels of strokes that taper."""
    both = np.stack([thickness * begin_scale, TAPER * thickness * end_scale], axis=1)
    return np.nan_to_num(np.maximum(both, THINNEST))
