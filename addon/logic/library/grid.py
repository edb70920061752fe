"""Where the tiles of a scrolling grid lie, which of them are seen, and which one is under the mouse."""

from __future__ import annotations

import math
from dataclasses import dataclass

from .rect import Rect


@dataclass(frozen=True)
class Grid:
    """Tiles of one size in rows from the top left. `scroll` is how many pixels lie above the upper edge."""

    view: Rect
    count: int
    tile_width: float
    """What a tile has at least: the columns share what is left over."""
    tile_height: float
    gap: float

    @property
    def columns(self) -> int:
        """How many tiles stand side by side."""
        return max(1, int((self.view.width - self.gap) // (self.tile_width + self.gap)))

    @property
    def rows(self) -> int:
        """How many rows all tiles take."""
        return math.ceil(self.count / self.columns)

    @property
    def stride(self) -> float:
        """From one row to the next."""
        return self.tile_height + self.gap

    @property
    def largest_scroll(self) -> float:
        """The scroll that shows the last row."""
        return max(0.0, self.rows * self.stride + self.gap - self.view.height)

    def clamped(self, scroll: float) -> float:
        """Return a scroll that shows tiles."""
        return min(max(scroll, 0.0), self.largest_scroll)

    def visible(self, scroll: float) -> range:
        """Return the tiles of which at least a part is seen."""
        first = max(0, int((scroll - self.gap) // self.stride))
        last = int((scroll + self.view.height) // self.stride)
        return range(min(self.count, first * self.columns), min(self.count, (last + 1) * self.columns))

    def tile(self, index: int, scroll: float) -> Rect:
        """Return where a tile lies, which may be outside of the view."""
        row, column = divmod(index, self.columns)
        width = (self.view.width - self.gap) / self.columns - self.gap
        x = self.view.x + self.gap + column * (width + self.gap)
        y = self.view.top - self.gap - row * self.stride - self.tile_height + scroll
        return Rect(x, y, width, self.tile_height)

    def at(self, x: float, y: float, scroll: float) -> int | None:
        """Return the tile under a point; None between tiles and outside of the view."""
        if not self.view.contains(x, y):
            return None
        found = (index for index in self.visible(scroll) if self.tile(index, scroll).contains(x, y))
        return next(found, None)

    def scroll_to(self, index: int, scroll: float) -> float:
        """Return the scroll nearest to the present one that shows a tile as a whole."""
        top = index // self.columns * self.stride
        bottom = top + self.stride + self.gap - self.view.height
        return self.clamped(min(max(scroll, bottom), top))

    def moved(self, index: int, columns: int, rows: int) -> int:
        """Return the tile to which arrow keys lead from another; it stays at the borders."""
        if not self.count:
            return 0
        target = index + columns + rows * self.columns
        if rows and not 0 <= target < self.count:
            return index
        return min(max(target, 0), self.count - 1)

    def bar(self, scroll: float, width: float) -> Rect | None:
        """Return the handle of the scroll bar at the right edge; None where everything is seen."""
        if not self.largest_scroll:
            return None
        share = self.view.height / (self.view.height + self.largest_scroll)
        height = max(3 * width, share * self.view.height)
        y = self.view.top - height - (self.view.height - height) * scroll / self.largest_scroll
        return Rect(self.view.right - width, y, width, height)

    def scroll_at(self, y: float, bar_height: float) -> float:
        """Return the scroll for which the middle of the scroll bar's handle is at a height."""
        room = max(1.0, self.view.height - bar_height)
        return self.clamped((self.view.top - bar_height / 2 - y) / room * self.largest_scroll)
