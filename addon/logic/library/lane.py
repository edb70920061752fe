"""Work for one background thread, in its order, or the newest first where what is out of sight need never be done.

A person who scrolls asks for hundreds of pictures and looks at the last ones only. Results wait in a queue until the
main thread fetches them, for nothing but the main thread may touch Blender.
"""

from __future__ import annotations

import threading
from collections import OrderedDict, deque
from collections.abc import Callable, Hashable
from typing import Any, NamedTuple


class Done(NamedTuple):
    """A call that was made: its result or its error, and what to do with either."""

    deliver: Callable[[Any, BaseException | None], None]
    result: Any
    error: BaseException | None


class Lane:
    """A thread that makes calls, in their order; or the newest first, and of those that wait the oldest are dropped."""

    LONGEST = 256

    def __init__(self, name: str, finished: deque[Done], *, newest_first: bool = False) -> None:
        self._finished = finished
        self._newest_first = newest_first
        self._waiting: OrderedDict[Hashable, tuple[Callable[[], Any], Callable[..., None]]] = OrderedDict()
        self._running: Hashable | None = None
        self._is_open = True
        self._changed = threading.Condition()
        self._thread = threading.Thread(target=self._run, name=f"motion-theater-{name}", daemon=True)
        self._thread.start()

    def ask(self, key: Hashable, call: Callable[[], Any], deliver: Callable[[Any, BaseException | None], None]) -> None:
        """Have a call made. One of the same key that still waits is replaced, and counts as new."""
        with self._changed:
            self._waiting.pop(key, None)
            self._waiting[key] = (call, deliver)
            while self._newest_first and len(self._waiting) > self.LONGEST:
                self._waiting.popitem(last=False)
            self._changed.notify()

    def waits(self, key: Hashable) -> bool:
        """Return whether a call waits or is being made."""
        with self._changed:
            return key in self._waiting or (self._running is not None and self._running == key)

    @property
    def is_idle(self) -> bool:
        """Whether nothing waits and nothing is being made."""
        with self._changed:
            return not self._waiting and self._running is None

    def drop(self) -> None:
        """Forget everything that has not begun."""
        with self._changed:
            self._waiting.clear()

    def forget(self, key: Hashable) -> None:
        """Forget the call of a key, if it has not begun."""
        with self._changed:
            self._waiting.pop(key, None)

    def close(self, timeout_s: float = 2.0, *, finishes: bool = False) -> None:
        """End the thread after the call that it is making, or after all that wait."""
        with self._changed:
            self._is_open = False
            if not finishes:
                self._waiting.clear()
            self._changed.notify()
        self._thread.join(timeout_s)

    def _run(self) -> None:
        while True:
            with self._changed:
                self._changed.wait_for(lambda: self._waiting or not self._is_open)
                if not self._waiting:
                    return
                key, (call, deliver) = self._waiting.popitem(last=self._newest_first)
                self._running = key
            try:
                done = Done(deliver, call(), None)
            except BaseException as error:  # an error is a result: whoever asked says it
                done = Done(deliver, None, error)
            with self._changed:
                self._finished.append(done)
                self._running = None
