"""Drawing flat shapes, figures, pictures and words in pixels: collected first, then handed to the graphics card."""

from __future__ import annotations

from typing import TYPE_CHECKING

import gpu

from . import paint, words
from .words import Text

if TYPE_CHECKING:
    from ..logic.library.rect import Rect
    from ..logic.library.shapes import Color
    from .words import Align


class Layer:
    """Rectangles, then icons, then figures, then pictures, then words: each covers those before it."""

    def __init__(self, shift: tuple[float, float] = (0.0, 0.0)) -> None:
        self.shift = shift
        self.flat = paint.Flat([], [])
        self.figures: list[tuple[paint.Moving, int]] = []
        self.pictures: list[tuple[gpu.types.GPUTexture, Rect]] = []
        self.texts: list[Text] = []


class Canvas:
    """What one redraw shows. Sizes are in pixels; `scale` is that of the interface."""

    def __init__(self, scale: float) -> None:
        self.scale = scale
        self._clips: list[tuple[Rect | None, list[Layer]]] = [(None, [Layer()])]

    @property
    def _layer(self) -> Layer:
        return self._clips[-1][1][-1]

    def layer(self, shift: tuple[float, float] = (0.0, 0.0)) -> None:
        """Let what follows cover all that was drawn. What changes often is worth a layer of its own.

        Rectangles and icons are shifted: those that only move need not be made anew.
        """
        self._clips[-1][1].append(Layer(shift))

    def within(self, area: Rect | None) -> None:
        """Let what follows cover all that was drawn, and be seen in an area only."""
        self._clips.append((area, [Layer()]))

    def box(self, area: Rect, color: Color, radius: float = 0.0) -> None:
        """Draw a filled rectangle."""
        self._layer.flat.boxes.append((area, radius, color))

    def frame(self, area: Rect, color: Color, width: float, radius: float, inside: Color) -> None:
        """Draw a rectangle with a border."""
        self.box(area, color, radius)
        self.box(area.inset(width), inside, max(0.0, radius - width))

    def icon(self, name: str, area: Rect, color: Color) -> None:
        """Draw an icon in the middle of an area."""
        self._layer.flat.icons.append((name, area, color))

    def figure(self, moving: paint.Moving, number: int) -> None:
        """Draw one figure of a cast over the rectangles of this layer."""
        self._layer.figures.append((moving, number))

    def picture(self, texture: gpu.types.GPUTexture, area: Rect) -> None:
        """Draw a picture whose rows begin at the top."""
        self._layer.pictures.append((texture, area))

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
        shown = text if width is None else words.shortened(text, points, width)
        self._layer.texts.append(Text(x, y, shown, points, color, align))

    def width(self, text: str, size: float = 11.0) -> float:
        """Return how wide a text is."""
        return words.measure(text, size * self.scale)

    def draw(self) -> None:
        """Hand everything to the graphics card."""
        gpu.state.depth_test_set("NONE")
        number = 0
        try:
            for area, layers in self._clips:
                if area is not None:
                    gpu.state.scissor_test_set(True)
                    gpu.state.scissor_set(int(area.x), int(area.y), int(area.width), int(area.height))
                for layer in layers:
                    _draw(number, layer)
                    number += 1
                if area is not None:
                    gpu.state.scissor_test_set(False)
        finally:
            gpu.state.scissor_test_set(False)
            gpu.state.blend_set("NONE")
            paint.forget_above(number)


def _draw(number: int, layer: Layer) -> None:
    gpu.state.blend_set("ALPHA")  # writing ends it
    paint.flat(number, layer.flat, layer.shift)
    for moving, figure in layer.figures:
        moving.draw(figure)
    if layer.pictures:
        paint.pictures(layer.pictures)
    words.write(layer.texts)
