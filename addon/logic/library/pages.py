"""Which clips of a list are on the stage at once, and paging through them."""

from __future__ import annotations

from dataclasses import dataclass

SIZES = (1, 4, 9)


@dataclass(frozen=True)
class Pages:
    """A list of `count` clips, `size` of them at a time; the first of the page may be any clip."""

    count: int
    size: int
    first: int = 0

    @property
    def shown(self) -> range:
        """The clips of this page."""
        return range(self.first, min(self.count, self.first + self.size))

    @property
    def has_next(self) -> bool:
        """Whether clips follow."""
        return self.first + self.size < self.count

    @property
    def has_previous(self) -> bool:
        """Whether clips come before."""
        return self.first > 0

    def turned(self, by: int) -> Pages:
        """Return the page that many pages on or back, no further than to the ends."""
        first = self.first + by * self.size
        if first >= self.count:
            return self
        return Pages(self.count, self.size, max(0, first))

    def resized(self, size: int) -> Pages:
        """Return a page of another size that begins with the same clip."""
        return Pages(self.count, size, self.first)

    def words(self) -> str:
        """Return which clips are shown, for people."""
        if not self.count:
            return "0"
        last = self.shown.stop
        first = self.first + 1
        return f"{first} of {self.count:,}" if first == last else f"{first:,}-{last:,} of {self.count:,}"
