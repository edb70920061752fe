"""Rectangles in pixels of a region, with the origin at the bottom left."""

from __future__ import annotations

from typing import NamedTuple


class Rect(NamedTuple):
    """A rectangle; the left and bottom edges belong to it, the right and top ones do not."""

    x: float
    y: float
    width: float
    height: float

    @property
    def right(self) -> float:
        """The first pixel to the right of it."""
        return self.x + self.width

    @property
    def top(self) -> float:
        """The first pixel above it."""
        return self.y + self.height

    @property
    def middle(self) -> tuple[float, float]:
        """Its centre."""
        return self.x + self.width / 2, self.y + self.height / 2

    def contains(self, x: float, y: float) -> bool:
        """Return whether a point lies in it."""
        return self.x <= x < self.right and self.y <= y < self.top

    def inset(self, by: float) -> Rect:
        """Return it smaller by a margin on all sides, never less than empty."""
        width, height = max(0.0, self.width - 2 * by), max(0.0, self.height - 2 * by)
        return Rect(self.x + (self.width - width) / 2, self.y + (self.height - height) / 2, width, height)

    def fitted(self, aspect: float) -> Rect:
        """Return the largest rectangle of an aspect (width by height) in its middle."""
        width = min(self.width, self.height * aspect)
        height = width / aspect
        return Rect(self.x + (self.width - width) / 2, self.y + (self.height - height) / 2, width, height)


def cells(area: Rect, count: int, gap: float) -> list[Rect]:
    """Return the places of one, four or nine stages in an area, row by row from the top left."""
    side = next((side for side in (1, 2, 3) if side * side >= count), 3)
    width = (area.width - (side - 1) * gap) / side
    height = (area.height - (side - 1) * gap) / side
    return [
        Rect(area.x + column * (width + gap), area.top - (row + 1) * height - row * gap, width, height)
        for row in range(side)
        for column in range(side)
    ][:count]
