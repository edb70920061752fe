"""In and out marks of a clip, which become *cut from/to* of the track that is made of it."""

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
        begin = self._inside(frame)
        end = self.end if self.end is not None and self.end > begin else None
        return replace(self, begin=None if begin == self.first else begin, end=end)

    def with_end(self, frame: float) -> Marks:
        """Return them with the out mark at a frame; an in mark behind it goes."""
        end = self._inside(frame)
        begin = self.begin if self.begin is not None and self.begin < end else None
        return replace(self, begin=begin, end=None if end == self.last else end)

    def cleared(self) -> Marks:
        """Return them with none set."""
        return Marks(self.first, self.last)

    def cut(self) -> tuple[int, int]:
        """Return *Cut Start* and *Cut End* of a track, where zero means *not set*.

        A mark on the frame 0 itself, in a file whose numbers begin below it, is set one frame further inside.
        """
        begin = 0 if self.begin is None else self.begin or 1
        end = 0 if self.end is None else self.end or -1
        return begin, end

    def _inside(self, frame: float) -> int:
        return min(max(round(frame), self.first), self.last)
