"""Timelines and curves under the figures, drawn larger and reduced so that lines are smooth."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cache

import numpy as np
from PIL import Image, ImageDraw, ImageFont

from .camera import Colour, Floats
from .states import Row

SCALE = 2
PAPER: Colour = (238, 240, 244)
INK: Colour = (38, 44, 54)
MUTED: Colour = (112, 121, 135)
TRACK: Colour = (224, 227, 233)
BAR: Colour = (186, 195, 208)

Font = ImageFont.FreeTypeFont | ImageFont.ImageFont


@cache
def font(size: float) -> Font:
    """Pillow's own typeface: the pictures come out the same on every machine."""
    return ImageFont.load_default(size)


class Sheet:
    """A blank image with a pen; coordinates are those of the final image."""

    def __init__(self, width: int, height: int) -> None:
        self._image = Image.new("RGB", (width * SCALE, height * SCALE), PAPER)
        self._pen = ImageDraw.Draw(self._image, "RGBA")

    def box(self, left: float, top: float, right: float, bottom: float, colour: Colour, alpha: int = 255) -> None:
        """A filled rectangle."""
        self._pen.rectangle([round(v * SCALE) for v in (left, top, right, bottom)], fill=(*colour, alpha))

    def line(self, points: Sequence[tuple[float, float]], colour: Colour, width: float = 1.0, alpha: int = 255) -> None:
        """A line through points."""
        scaled = [(x * SCALE, y * SCALE) for x, y in points]
        self._pen.line(scaled, fill=(*colour, alpha), width=max(round(width * SCALE), 1), joint="curve")

    def area(self, points: Sequence[tuple[float, float]], colour: Colour, alpha: int) -> None:
        """A filled shape."""
        self._pen.polygon([(x * SCALE, y * SCALE) for x, y in points], fill=(*colour, alpha))

    def text(self, x: float, y: float, text: str, size: float, colour: Colour = INK, anchor: str = "la") -> None:
        """A line of text; `anchor` as in Pillow."""
        self._pen.text((x * SCALE, y * SCALE), text, font=font(size * SCALE), fill=colour, anchor=anchor)

    def paragraph(self, x: float, y: float, text: str, size: float, width: float, colour: Colour = INK) -> None:
        """Text in as many lines as its width needs."""
        line = ""
        for word in text.split():
            longer = f"{line} {word}".strip()
            if line and font(size).getlength(longer) > width:
                self.text(x, y, line, size, colour)
                y += size * 1.35
                longer = word
            line = longer
        self.text(x, y, line, size, colour)

    def image(self) -> Image.Image:
        """The sheet at its final size."""
        width, height = self._image.size
        return self._image.resize((width // SCALE, height // SCALE), Image.Resampling.LANCZOS)


ROW_HEIGHT = 19
LABEL_WIDTH = 44


@dataclass(frozen=True)
class Area:
    """Where something is drawn, in pixels of the final image."""

    left: float
    top: float
    width: float
    height: float = 0.0


def timeline(sheet: Sheet, area: Area, rows: Sequence[Row], frames: int, tint: Colour, frame: int | None) -> None:
    """Rows of bars with their crossfades, and the playhead at `frame` (from 0)."""
    scale = (area.width - LABEL_WIDTH) / (frames - 1)

    def place(number: float) -> float:
        return area.left + LABEL_WIDTH + (min(max(number, 1), frames) - 1) * scale

    for index, row in enumerate(rows):
        top = area.top + index * ROW_HEIGHT + 2
        bottom, middle = top + ROW_HEIGHT - 6, top + ROW_HEIGHT / 2 - 3
        sheet.text(area.left, middle, row.label, 11, MUTED, "lm")
        sheet.box(place(1), top, place(frames), bottom, TRACK)
        for span in row.spans:
            sheet.box(place(span.start), top, place(span.end), bottom, BAR)
        for span in row.spans:
            label = place(span.start)
            if span.blend is not None:
                low, high = place(span.blend[0]), place(span.blend[1])
                label = max(label, high)
                sheet.box(low, top, high, bottom, tint, 165)
                sheet.line([(low, bottom), (high, top)], (255, 255, 255), 1.2)
            sheet.text(label + 4, middle, span.label, 10.5, INK, "lm")
    if frame is not None:
        x = place(frame + 1)
        sheet.line([(x, area.top - 2), (x, area.top + len(rows) * ROW_HEIGHT)], INK, 1.5)


def curves(
    sheet: Sheet, area: Area, title: str, unit: str, series: Sequence[tuple[str, Floats, Colour]], frame: int | None
) -> None:
    """Curves over the frames with a common scale, the first filled, with a legend."""
    frames = len(series[0][1])
    highest = float(max(values.max() for _, values, _ in series)) * 1.05
    bottom, head = area.top + area.height, 20.0
    scale = (area.height - head) / highest

    def x_of(index: float) -> float:
        return area.left + index * area.width / (frames - 1)

    sheet.text(area.left, area.top, title, 11.5, INK)
    right = area.left + area.width
    for name, _, colour in reversed(series):
        sheet.text(right, area.top, name, 11.5, colour, "ra")
        right -= font(11.5).getlength(name) + 18
    step = 10.0 ** np.floor(np.log10(highest / 2))
    step *= max(factor for factor in (1, 2, 5) if factor * step * 2 <= highest)
    for level in np.arange(0.0, highest, step):
        y = bottom - float(level) * scale
        sheet.line([(area.left, y), (area.left + area.width, y)], BAR, 1.0, 255 if level == 0 else 120)
        if level > 0:
            sheet.text(area.left + 2, y - 1, f"{level:g} {unit}", 10, MUTED, "lb")
    for index, (_, values, colour) in enumerate(series):
        curve = [(x_of(i), bottom - float(value) * scale) for i, value in enumerate(values)]
        if index == 0:
            sheet.area([(area.left, bottom), *curve, (area.left + area.width, bottom)], colour, 46)
        sheet.line(curve, colour, 1.6)
    if frame is not None:
        sheet.line([(x_of(frame), area.top + head - 2), (x_of(frame), bottom)], INK, 1.5)


def paths(sheet: Sheet, area: Area, title: str, lines: Sequence[tuple[Floats, Colour]]) -> None:
    """Paths in the plane (points, 2), y up, to a common scale that fills the area, with a dot per frame."""
    everything = np.concatenate([line for line, _ in lines])
    low, high = everything.min(axis=0), everything.max(axis=0)
    room, head = 10.0, 22.0
    size = np.maximum(high - low, 1e-9)
    scale = min((area.width - 2 * room) / size[0], (area.height - head - 2 * room) / size[1])
    sheet.box(area.left, area.top + head, area.left + area.width, area.top + area.height, (252, 252, 254))
    sheet.text(area.left, area.top, title, 11.5, INK)
    centre = (low + high) / 2
    middle = (area.left + area.width / 2, area.top + head + (area.height - head) / 2)
    for line, colour in lines:
        points = [(middle[0] + float(x - centre[0]) * scale, middle[1] - float(y - centre[1]) * scale) for x, y in line]
        sheet.line(points, colour, 1.4, 200)
        for x, y in points:
            sheet.box(x - 1.6, y - 1.6, x + 1.6, y + 1.6, colour)
