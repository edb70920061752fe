"""In and out marks of a clip, which become *cut from/to* of the track that is made of it.

Zero means *not set* there. So a mark is never on a frame 0 inside of the clip, but on the one next to it: what is shown
is what the track will have.
"""

from __future__ import annotations

from dataclasses import dataclass, replace


@dataclass(frozen=True)
class Marks:
    """Marks in frame numbers of the file; None where none is set."""

    first: int
    last: int
    begin: int | None = None
    end: int | None = None

    @property
    def range(self) -> tuple[int, int]:
        """The first and last frame between the marks."""
        return (
            self.first if self.begin is None else self.begin,
            self.last if self.end is None else self.end,
        )

    @property
    def are_set(self) -> bool:
        """Whether the clip is cut at all."""
        return self.begin is not None or self.end is not None

    def with_begin(self, frame: float) -> Marks:
        """Return them with the in mark at a frame; an out mark before it goes."""
        begin = self._placed(frame, self.first, inwards=1)
        end = self.end if self.end is not None and self.end > begin else None
        return replace(self, begin=None if begin == self.first else begin, end=end)

    def with_end(self, frame: float) -> Marks:
        """Return them with the out mark at a frame; an in mark behind it goes."""
        end = self._placed(frame, self.last, inwards=-1)
        begin = self.begin if self.begin is not None and self.begin < end else None
        return replace(self, begin=begin, end=None if end == self.last else end)

    def cleared(self) -> Marks:
        """Return them with none set."""
        return Marks(self.first, self.last)

    def cut(self) -> tuple[int, int]:
        """Return *Cut Start* and *Cut End* of a track, where zero means *not set*."""
        return self.begin or 0, self.end or 0

    def _placed(self, frame: float, edge: int, *, inwards: int) -> int:
        """Return where a mark for a frame is; at the edge of the clip it needs none."""
        number = min(max(round(frame), self.first), self.last)
        if number or number == edge:
            return number
        return inwards if self.first <= inwards <= self.last else -inwards
