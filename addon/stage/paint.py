"""What the graphics card is given: shapes that stay from one redraw to the next, figures that move, and pictures."""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache
from typing import TYPE_CHECKING, Any, NamedTuple

import gpu
import numpy as np

from ..logic.library import shapes
from . import icons

if TYPE_CHECKING:
    from ..logic.library.cast import Cast
    from ..logic.library.rect import Rect
    from ..logic.library.shapes import Color, Floats


class Flat(NamedTuple):
    """Rectangles, then icons on them."""

    boxes: list[tuple[Rect, float, Color]]
    """With the radius of their corners."""
    icons: list[tuple[str, Rect, Color]]


class _Kept(NamedTuple):
    """Flat shapes as they were given to the graphics card."""

    shapes: Flat
    batch: gpu.types.GPUBatch


_kept: dict[int, _Kept] = {}
"""By the number of the layer: what the last redraw showed there. Much of the browser looks the same for seconds."""


def flat(number: int, wanted: Flat, shift: tuple[float, float]) -> None:
    """Draw the flat shapes of a layer; those that were there in the last redraw need not be made again."""
    if not wanted.boxes and not wanted.icons:
        return
    kept = _kept.get(number)
    if kept is None or kept.shapes != wanted:
        kept = _kept[number] = _Kept(wanted, _batch(wanted))
    with gpu.matrix.push_pop():
        gpu.matrix.translate(shift)
        kept.batch.draw(gpu.shader.from_builtin("SMOOTH_COLOR"))


def forget_above(count: int) -> None:
    """Let the shapes go that belong to layers which there no longer are."""
    for number in [number for number in _kept if number >= count]:
        del _kept[number]


def _batch(wanted: Flat) -> gpu.types.GPUBatch:
    boxes = shapes.rectangles(*(list(field) for field in zip(*wanted.boxes, strict=True))) if wanted.boxes else None
    meshes = [boxes] if boxes is not None else []
    for name, area, color in wanted.icons:
        square = area.fitted(1.0)
        mesh = icons.icon(name, square.width, color)
        meshes.append(mesh._replace(places=mesh.places + np.array(square[:2], np.float32)))
    every = shapes.joined(meshes)
    return gpu.types.GPUBatch(type="TRIS", buf=_vertices(every.places, every.colors), elem=_corners(every.triangles))


class Moving:
    """A cast on the graphics card: the triangles are brought there once, the places of their corners each redraw."""

    def __init__(self, cast: Cast) -> None:
        self.cast = cast
        self._parts: list[gpu.types.GPUIndexBuf] = []
        self._now: gpu.types.GPUVertBuf | None = None

    def renew(self) -> None:
        """Let the places be brought over anew."""
        self._now = None

    def draw(self, number: int) -> None:
        """Draw one figure."""
        if not self._parts:
            self._parts = [_corners(part) for part in self.cast.parts]
        if self._now is None:
            self._now = _vertices(self.cast.places, self.cast.colors)
        batch = gpu.types.GPUBatch(type="TRIS", buf=self._now, elem=self._parts[number])
        batch.draw(gpu.shader.from_builtin("SMOOTH_COLOR"))


def pictures(wanted: Sequence[tuple[gpu.types.GPUTexture, Rect]]) -> None:
    """Draw pictures whose rows begin at the top."""
    shader, square = gpu.shader.from_builtin("IMAGE"), _square()
    shader.bind()
    for texture, area in wanted:
        with gpu.matrix.push_pop():
            gpu.matrix.translate((area.x, area.y))
            gpu.matrix.scale((area.width, area.height))
            shader.uniform_sampler("image", texture)
            square.draw(shader)


def _vertices(places: Floats, colors: Floats) -> gpu.types.GPUVertBuf:
    vertices = gpu.types.GPUVertBuf(_format(), len(places))
    given: tuple[Any, Any] = (places, colors)  # arrays are buffers, of which Blender's types know nothing
    vertices.attr_fill("pos", given[0])
    vertices.attr_fill("color", given[1])
    return vertices


def _corners(triangles: Any) -> gpu.types.GPUIndexBuf:
    return gpu.types.GPUIndexBuf(type="TRIS", seq=triangles)


@lru_cache(maxsize=1)
def _format() -> gpu.types.GPUVertFormat:
    made = gpu.types.GPUVertFormat()
    made.attr_add(id="pos", comp_type="F32", len=2, fetch_mode="FLOAT")
    made.attr_add(id="color", comp_type="F32", len=4, fetch_mode="FLOAT")
    return made


@lru_cache(maxsize=1)
def _square() -> gpu.types.GPUBatch:
    """Return a square of one pixel with a picture on it, upside down: the first row is the top one."""
    made = gpu.types.GPUVertFormat()
    made.attr_add(id="pos", comp_type="F32", len=2, fetch_mode="FLOAT")
    made.attr_add(id="texCoord", comp_type="F32", len=2, fetch_mode="FLOAT")
    vertices = gpu.types.GPUVertBuf(made, 4)
    vertices.attr_fill("pos", [(0.0, 0.0), (1.0, 0.0), (0.0, 1.0), (1.0, 1.0)])
    vertices.attr_fill("texCoord", [(0.0, 1.0), (1.0, 1.0), (0.0, 0.0), (1.0, 0.0)])
    return gpu.types.GPUBatch(type="TRI_STRIP", buf=vertices)


def close() -> None:
    """Give everything back to the graphics card."""
    _kept.clear()
    _square.cache_clear()
    _format.cache_clear()
