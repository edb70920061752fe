"""The pictures on buttons, drawn as shapes so that they are sharp at every size."""

from __future__ import annotations

from functools import lru_cache
from itertools import pairwise
from typing import TYPE_CHECKING

import numpy as np

from ..logic.library import shapes
from ..logic.library.shapes import Color, Mesh

if TYPE_CHECKING:
    from collections.abc import Sequence

Points = list[tuple[float, float]]

CAP = 6  # points of the half circle at the end of a stroke

# Convex shapes in a square from (0, 0) to (1, 1), their corners against the clock.
POLYGONS: dict[str, Sequence[Points]] = {
    "PLAY": [[(0.24, 0.1), (0.88, 0.5), (0.24, 0.9)]],
    "PAUSE": [
        [(0.2, 0.12), (0.42, 0.12), (0.42, 0.88), (0.2, 0.88)],
        [(0.58, 0.12), (0.8, 0.12), (0.8, 0.88), (0.58, 0.88)],
    ],
    "STOP": [[(0.17, 0.17), (0.83, 0.17), (0.83, 0.83), (0.17, 0.83)]],
    "STEP_BACK": [
        [(0.66, 0.16), (0.66, 0.84), (0.2, 0.5)],
        [(0.74, 0.16), (0.86, 0.16), (0.86, 0.84), (0.74, 0.84)],
    ],
    "STEP_ON": [
        [(0.34, 0.16), (0.8, 0.5), (0.34, 0.84)],
        [(0.14, 0.16), (0.26, 0.16), (0.26, 0.84), (0.14, 0.84)],
    ],
    "PAGE_BACK": [[(0.5, 0.16), (0.5, 0.84), (0.06, 0.5)], [(0.94, 0.16), (0.94, 0.84), (0.5, 0.5)]],
    "PAGE_ON": [[(0.06, 0.16), (0.5, 0.5), (0.06, 0.84)], [(0.5, 0.16), (0.94, 0.5), (0.5, 0.84)]],
    "HEAD": [[(0.5, 0.0), (0.95, 0.6), (0.05, 0.6)]],
    "BEGIN": [
        [(0.3, 0.1), (0.44, 0.1), (0.44, 0.9), (0.3, 0.9)],
        [(0.44, 0.52), (0.84, 0.71), (0.44, 0.9)],
    ],
    "END": [
        [(0.56, 0.1), (0.7, 0.1), (0.7, 0.9), (0.56, 0.9)],
        [(0.56, 0.52), (0.56, 0.9), (0.16, 0.71)],
    ],
    "FOUR": [[(x, y), (x + 0.34, y), (x + 0.34, y + 0.34), (x, y + 0.34)] for x in (0.08, 0.58) for y in (0.08, 0.58)],
}
# Strokes: x and y of both ends.
LINES: dict[str, Sequence[tuple[float, float, float, float]]] = {
    "CLOSE": [(0.22, 0.22, 0.78, 0.78), (0.22, 0.78, 0.78, 0.22)],
    "BACK": [(0.6, 0.18, 0.3, 0.5), (0.3, 0.5, 0.6, 0.82)],
    "ADD": [(0.5, 0.18, 0.5, 0.82), (0.18, 0.5, 0.82, 0.5)],
    "CHECK": [(0.18, 0.5, 0.42, 0.24), (0.42, 0.24, 0.84, 0.78)],
    "FILTER": [(0.14, 0.76, 0.86, 0.76), (0.28, 0.5, 0.72, 0.5), (0.42, 0.24, 0.58, 0.24)],
    "SORT": [
        (0.3, 0.15, 0.3, 0.85),
        (0.3, 0.15, 0.12, 0.34),
        (0.3, 0.15, 0.48, 0.34),
        (0.62, 0.76, 0.9, 0.76),
        (0.62, 0.5, 0.82, 0.5),
        (0.62, 0.24, 0.74, 0.24),
    ],
    "FIND": [(0.62, 0.38, 0.86, 0.14)],
}


@lru_cache(maxsize=512)
def icon(name: str, size: float, color: Color) -> Mesh:
    """Return an icon in a square of `size` pixels at the origin."""
    meshes = [shapes.polygon([(x * size, y * size) for x, y in corners], color) for corners in POLYGONS.get(name, ())]
    lines = [*LINES.get(name, ()), *(_ring() if name == "FIND" else ())]
    if lines:
        ends = np.array(lines) * size
        meshes.append(shapes.strokes(ends[:, :2], ends[:, 2:], max(0.9, 0.075 * size), color, CAP))
    return shapes.joined(meshes)


def _ring() -> list[tuple[float, float, float, float]]:
    """Return the glass of the magnifier."""
    turn = np.linspace(0.0, 2 * np.pi, 13)
    ring = np.stack([0.42 + 0.28 * np.cos(turn), 0.58 + 0.28 * np.sin(turn)], axis=1)
    return [(*start, *end) for start, end in pairwise(ring)]


def _star() -> list[Points]:
    """Return a star with five points, as five pieces that are convex."""
    turn = np.pi / 2 + np.arange(10) * np.pi / 5
    reach = np.where(np.arange(10) % 2, 0.22, 0.5)
    corners = [(0.5 + r * np.cos(t), 0.5 + r * np.sin(t)) for r, t in zip(reach, turn, strict=True)]
    return [[(0.5, 0.5), corners[k - 1], corners[k], corners[k + 1]] for k in range(0, 10, 2)]


POLYGONS["STAR"] = _star()
