"""Values that are kept as long as there is room, by how many bytes they take."""

from __future__ import annotations

from collections import OrderedDict
from collections.abc import Callable, Hashable
from typing import Generic, TypeVar

T = TypeVar("T")


class Kept(Generic[T]):
    """The values that were asked for last, in no more than `limit` bytes."""

    def __init__(self, name: str, limit: int) -> None:
        self.name = name
        self.limit = limit
        self.bytes = 0
        self.peak = 0
        """The most bytes that were ever held."""
        self._values: OrderedDict[Hashable, tuple[T, int]] = OrderedDict()

    def __len__(self) -> int:
        return len(self._values)

    def __contains__(self, key: Hashable) -> bool:
        return key in self._values

    def get(self, key: Hashable) -> T | None:
        """Return what was kept under a key, which is then the last to go."""
        found = self._values.get(key)
        if found is None:
            return None
        self._values.move_to_end(key)
        return found[0]

    def keep(self, key: Hashable, value: T, size: int) -> T:
        """Keep a value; those that were not asked for the longest go. The newest stays, whatever its size."""
        self.forget(key)
        while self._values and self.bytes + size > self.limit:
            _, (_, freed) = self._values.popitem(last=False)
            self.bytes -= freed
        self._values[key] = (value, size)
        self.bytes += size
        self.peak = max(self.peak, self.bytes)
        return value

    def keys_of(self, fits: Callable[[T], bool]) -> list[Hashable]:
        """Return the keys of all values that fit."""
        return [key for key, (value, _) in self._values.items() if fits(value)]

    def forget(self, key: Hashable) -> None:
        """Let one value go."""
        found = self._values.pop(key, None)
        if found is not None:
            self.bytes -= found[1]

    def clear(self) -> None:
        """Let everything go."""
        self._values.clear()
        self.bytes = 0
