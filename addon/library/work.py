"""Work in the background: threads ask the native module, a timer hands what they found to the main thread.

The timer never holds the main thread longer than a slice, whatever is waiting, and does not run when nothing is.
"""

from __future__ import annotations

import time
import traceback
from collections import deque
from collections.abc import Callable, Hashable
from typing import Any

import bpy

from ..logic.library.lane import Done, Lane

SLICE_S = 0.008
INTERVAL_S = 0.03
EDITS_S = 10.0
"""So long the end of the add-on waits for edits that are still to be written."""
NEWEST_FIRST = frozenset({"pictures", "figures"})
"""Lanes of what is only looked at. In the others, "data" and "edits", everything is done in its order."""

Deliver = Callable[[Any, BaseException | None], None]

_finished: deque[Done] = deque()
_lanes: dict[str, Lane] = {}
_watchers: list[Callable[[], bool]] = []
longest_slice_s = 0.0
"""The longest time that the timer has held the main thread."""


def ask(lane: str, key: Hashable, call: Callable[[], Any], deliver: Deliver) -> None:
    """Have a call made in the thread of a lane; `deliver` gets its result or its error on the main thread."""
    if lane not in _lanes:
        _lanes[lane] = Lane(lane, _finished, newest_first=lane in NEWEST_FIRST)
    _lanes[lane].ask(key, call, deliver)
    wake()


def waits(lane: str, key: Hashable) -> bool:
    """Return whether a call of that key waits or is being made."""
    return lane in _lanes and _lanes[lane].waits(key)


def give(lane: str, key: Hashable, longest_s: float) -> None:
    """Give a call a moment to be made, and deliver: for what is so quick that nothing need be shown without it."""
    global longest_slice_s
    begin = time.perf_counter()
    while waits(lane, key) and time.perf_counter() - begin < longest_s:
        time.sleep(0.001)
    turn()
    longest_slice_s = max(longest_slice_s, time.perf_counter() - begin)


def drop(lane: str) -> None:
    """Forget what has not begun in a lane."""
    if lane in _lanes:
        _lanes[lane].drop()


def forget(lane: str, key: Hashable) -> None:
    """Forget a call of a lane that has not begun."""
    if lane in _lanes:
        _lanes[lane].forget(key)


def watch(watcher: Callable[[], bool]) -> None:
    """Have a function called with each turn of the timer, until it returns False."""
    if watcher not in _watchers:
        _watchers.append(watcher)
    wake()


def wake() -> None:
    """Let the timer run."""
    if not bpy.app.timers.is_registered(_pulse):
        bpy.app.timers.register(_pulse, first_interval=INTERVAL_S, persistent=True)


def _pulse() -> float | None:
    return INTERVAL_S if turn() else None


def turn() -> bool:
    """Deliver what is finished, for no longer than a slice; return whether more is to come."""
    global longest_slice_s
    begin = time.perf_counter()
    for watcher in list(_watchers):
        if not _guarded(watcher):
            _watchers.remove(watcher)
    while _finished and time.perf_counter() - begin < SLICE_S:
        done = _finished.popleft()
        _guarded(lambda done=done: done.deliver(done.result, done.error))  # type: ignore[misc]
    longest_slice_s = max(longest_slice_s, time.perf_counter() - begin)
    return not is_idle()


def is_idle() -> bool:
    """Return whether nothing is under way."""
    # The lanes first: one that is idle has handed over all that it found.
    return all(lane.is_idle for lane in _lanes.values()) and not _finished and not _watchers


def wait(timeout_s: float = 60.0) -> bool:
    """Deliver everything before going on, for scripts without a window; return whether all was done in time."""
    end = time.monotonic() + timeout_s
    while turn():
        if time.monotonic() > end:
            return False
        time.sleep(0.002)
    return True


def close() -> None:
    """End the threads and the timer."""
    if bpy.app.timers.is_registered(_pulse):
        bpy.app.timers.unregister(_pulse)
    for name, lane in _lanes.items():
        if name == "edits":  # what was typed is kept, also by who quits at once
            lane.close(EDITS_S, finishes=True)
        else:
            lane.close()
    _lanes.clear()
    _watchers.clear()
    _finished.clear()


def _guarded(call: Callable[[], Any]) -> Any:
    """Call; a mistake of our own is printed and must not end the timer."""
    try:
        return call()
    except Exception:
        traceback.print_exc()
        return None
