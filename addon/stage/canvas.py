"""Drawing flat shapes, pictures and words in pixels: collected first, then handed to the graphics card at once."""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache
from typing import TYPE_CHECKING, Any, Literal, NamedTuple

import blf
import gpu
import numpy as np

from ..logic.library import shapes
from ..logic.library.rect import Rect
from . import icons

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from ..logic.library.shapes import Color, Mesh

FONT = 0
ELLIPSIS = "…"
Align = Literal["LEFT", "CENTER", "RIGHT"]


class Text(NamedTuple):
    """A line of text; `x`, `y` is where its baseline begins, ends or has its middle."""

    x: float
    y: float
    text: str
    size: float
    color: Color
    align: Align


class Layer:
    """Rectangles, then other shapes, then pictures, then words: each covers those before it."""

    def __init__(self) -> None:
        self.boxes: list[Rect] = []
        self.radii: list[float] = []
        self.fills: list[Color] = []
        self.strokes: list[shapes.Strokes] = []
        self.meshes: list[Mesh] = []
        self.pictures: list[tuple[gpu.types.GPUTexture, Rect, float]] = []
        self.texts: list[Text] = []


class Canvas:
    """What one redraw shows. Sizes are in pixels; `scale` is that of the interface."""

    def __init__(self, scale: float) -> None:
        self.scale = scale
        self.roundness = 4
        """Points of the half circle at the end of a stroke: more for what is drawn large."""
        self._clips: list[tuple[Rect | None, list[Layer]]] = [(None, [Layer()])]

    @property
    def _layer(self) -> Layer:
        return self._clips[-1][1][-1]

    def layer(self) -> None:
        """Let what follows cover all that was drawn."""
        self._clips[-1][1].append(Layer())

    def within(self, area: Rect | None) -> None:
        """Let what follows cover all that was drawn, and be seen in an area only."""
        self._clips.append((area, [Layer()]))

    def box(self, area: Rect, color: Color, radius: float = 0.0) -> None:
        """Draw a filled rectangle."""
        self._layer.boxes.append(area)
        self._layer.radii.append(radius)
        self._layer.fills.append(color)

    def frame(self, area: Rect, color: Color, width: float, radius: float, inside: Color) -> None:
        """Draw a rectangle with a border."""
        self.box(area, color, radius)
        self.box(area.inset(width), inside, max(0.0, radius - width))

    def strokes(self, strokes: shapes.Strokes) -> None:
        """Draw strokes over the rectangles of this layer."""
        self._layer.strokes.append(strokes)

    def icon(self, name: str, area: Rect, color: Color) -> None:
        """Draw an icon in the middle of an area."""
        square = area.fitted(1.0)
        mesh = icons.icon(name, square.width, color)
        self._layer.meshes.append(mesh._replace(places=mesh.places + np.array(square[:2], np.float32)))

    def picture(self, texture: gpu.types.GPUTexture, area: Rect, opacity: float = 1.0) -> None:
        """Draw a picture whose rows begin at the top."""
        self._layer.pictures.append((texture, area, opacity))

    def text(
        self,
        x: float,
        y: float,
        text: str,
        color: Color,
        size: float = 11.0,
        *,
        width: float | None = None,
        align: Align = "LEFT",
    ) -> None:
        """Write a line; what is wider than `width` is cut with an ellipsis. `size` is before the interface's scale."""
        points = size * self.scale
        shown = text if width is None else shortened(text, points, width)
        self._layer.texts.append(Text(x, y, shown, points, color, align))

    def width(self, text: str, size: float = 11.0) -> float:
        """Return how wide a text is."""
        return measure(text, size * self.scale)

    def draw(self) -> None:
        """Hand everything to the graphics card: all shapes in one buffer, of which each layer draws its part."""
        layers = [layer for _, layers in self._clips for layer in layers]
        vertices, parts = _uploaded(layers, self.roundness)
        gpu.state.blend_set("ALPHA")
        gpu.state.depth_test_set("NONE")
        part = iter(parts)
        try:
            for area, clipped in self._clips:
                if area is not None:
                    gpu.state.scissor_test_set(True)
                    gpu.state.scissor_set(int(area.x), int(area.y), int(area.width), int(area.height))
                for layer in clipped:
                    _draw(layer, vertices, next(part))
                if area is not None:
                    gpu.state.scissor_test_set(False)
        finally:
            gpu.state.scissor_test_set(False)
            gpu.state.blend_set("NONE")


def _uploaded(layers: Sequence[Layer], cap: int) -> tuple[gpu.types.GPUVertBuf | None, list[NDArray[np.int32]]]:
    """Return the corners of all shapes on the graphics card, and the triangles of each layer."""
    boxes = shapes.rectangles(
        [box for layer in layers for box in layer.boxes],
        [radius for layer in layers for radius in layer.radii],
        [fill for layer in layers for fill in layer.fills],
    )
    strokes = shapes.capsules(shapes.gathered([some for layer in layers for some in layer.strokes]), cap)
    every = shapes.joined([boxes, strokes, *(mesh for layer in layers for mesh in layer.meshes)])
    if not len(every.triangles):
        return None, [every.triangles] * len(layers)
    starts = [0, len(boxes.triangles), len(boxes.triangles) + len(strokes.triangles)]
    parts = []
    for layer in layers:
        counts = (
            len(layer.boxes) * shapes.TRIANGLES_OF_RECTANGLE,
            sum(len(some.begins) for some in layer.strokes) * shapes.triangles_of_stroke(cap),
            sum(len(mesh.triangles) for mesh in layer.meshes),
        )
        pieces = [every.triangles[start : start + count] for start, count in zip(starts, counts, strict=True)]
        starts = [start + count for start, count in zip(starts, counts, strict=True)]
        parts.append(np.concatenate(pieces))
    vertices = gpu.types.GPUVertBuf(_format(), len(every.places))
    places: Any = every.places  # arrays are buffers, of which Blender's types know nothing
    colors: Any = every.colors
    vertices.attr_fill("pos", places)
    vertices.attr_fill("color", colors)
    return vertices, parts


@lru_cache(maxsize=4096)
def measure(text: str, points: float) -> float:
    """Return how many pixels wide a text is."""
    blf.size(FONT, points)
    return float(blf.dimensions(FONT, text)[0])


@lru_cache(maxsize=4096)
def shortened(text: str, points: float, width: float) -> str:
    """Return a text cut so that it is no wider than `width` pixels."""
    if measure(text, points) <= width:
        return text
    low, high = 0, len(text)
    while low < high:
        middle = (low + high + 1) // 2
        if measure(text[:middle].rstrip() + ELLIPSIS, points) <= width:
            low = middle
        else:
            high = middle - 1
    return text[:low].rstrip() + ELLIPSIS if low else ""


def _draw(layer: Layer, vertices: gpu.types.GPUVertBuf | None, triangles: Any) -> None:
    if vertices is not None and len(triangles):
        corners = gpu.types.GPUIndexBuf(type="TRIS", seq=triangles)
        gpu.types.GPUBatch(type="TRIS", buf=vertices, elem=corners).draw(gpu.shader.from_builtin("SMOOTH_COLOR"))
    if layer.pictures:
        _draw_pictures(layer.pictures)
    points = 0.0
    for text in layer.texts:
        if text.size != points:
            points = text.size
            blf.size(FONT, points)
        shift = {"LEFT": 0.0, "CENTER": 0.5, "RIGHT": 1.0}[text.align]
        x = text.x - shift * measure(text.text, points) if shift else text.x
        blf.position(FONT, round(x), round(text.y), 0.0)
        blf.color(FONT, *text.color)
        blf.draw(FONT, text.text)


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


def _draw_pictures(pictures: Sequence[tuple[gpu.types.GPUTexture, Rect, float]]) -> None:
    shader, square = gpu.shader.from_builtin("IMAGE_COLOR"), _square()
    for texture, area, opacity in pictures:
        with gpu.matrix.push_pop():
            gpu.matrix.translate((area.x, area.y))
            gpu.matrix.scale((area.width, area.height))
            shader.bind()
            shader.uniform_sampler("image", texture)
            shader.uniform_float("color", (1.0, 1.0, 1.0, opacity))
            square.draw(shader)


def close() -> None:
    """Forget what belongs to the graphics card."""
    _square.cache_clear()
    _format.cache_clear()
    measure.cache_clear()
    shortened.cache_clear()
