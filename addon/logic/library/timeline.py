"""The bar under an open clip: which frame is where, and what the mouse takes hold of."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from .marks import Marks
from .rect import Rect

Grip = Literal["BEGIN", "END", "HEAD"]
STEPS = (1, 2, 5, 10, 20, 25, 50, 100, 200, 250, 500, 1000, 2000, 2500, 5000, 10_000, 25_000, 50_000, 100_000)


@dataclass(frozen=True)
class Timeline:
    """Frames `first` to `last` over the width of a bar."""

    bar: Rect
    first: float
    last: float

    def x(self, frame: float) -> float:
        """Return where a frame is."""
        length = self.last - self.first
        return self.bar.x + (self.bar.width * (frame - self.first) / length if length > 0 else 0.0)

    def frame(self, x: float) -> float:
        """Return the frame at a place, between first and last."""
        share = (x - self.bar.x) / self.bar.width if self.bar.width > 0 else 0.0
        return self.first + min(max(share, 0.0), 1.0) * (self.last - self.first)

    def grip(self, x: float, y: float, marks: Marks | None, reach: float) -> Grip | None:
        """Return what a press takes hold of: a mark in reach, or the playhead wherever else on the bar."""
        if not self.bar.inset(-reach).contains(x, y):
            return None
        if marks is not None:
            begin, end = (abs(x - self.x(frame)) for frame in marks.range)
            if min(begin, end) <= reach:
                # With both marks at one place, the side from which it is taken decides.
                return "BEGIN" if begin < end or (begin == end and x <= self.x(marks.range[0])) else "END"
        return "HEAD"

    def ticks(self, spacing: float) -> list[int]:
        """Return round frame numbers that are at least `spacing` pixels apart."""
        per_frame = self.bar.width / (self.last - self.first) if self.last > self.first else 0.0
        step = next((step for step in STEPS if step * per_frame >= spacing), 0)
        if not step:
            return []
        begin = int(-(-self.first // step)) * step
        return list(range(begin, int(self.last) + 1, step))
