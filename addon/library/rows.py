"""What the library knows of single clips, fetched as they come into sight."""

from __future__ import annotations

from collections.abc import Hashable
from typing import TYPE_CHECKING, Any

from ..logic.library.kept import Kept
from . import redraw, session, work

if TYPE_CHECKING:
    import motion_theater

ROW_BYTES = 2_100  # what one takes in memory, measured over 3,000 clips
ROWS: Kept[motion_theater.LibraryClip] = Kept("Clips in the list", 8_000_000)
BATCH = 200

_wanted: dict[int, None] = {}
_asked: dict[int, int] = {}
_stale: set[Hashable] = set()
_batches = 0


def get(clip_id: int) -> motion_theater.LibraryClip | None:
    """Return a clip, or None if it has yet to be fetched, which then happens soon.

    One that may have changed is shown as it was until it is fetched anew, so that nothing flickers.
    """
    known = ROWS.get(clip_id)
    if (known is None or clip_id in _stale) and not _is_coming(clip_id):
        _wanted[clip_id] = None
        work.watch(fetch)
    return known


def active() -> motion_theater.LibraryClip | None:
    """Return the selected clip."""
    chosen = session.state.active_id
    return get(chosen) if chosen is not None else None


def renew() -> None:
    """Fetch all clips anew when they are next asked for."""
    _asked.clear()
    _stale.update(ROWS.keys_of(lambda clip: True))


def close() -> None:
    """Forget all clips."""
    ROWS.clear()
    _asked.clear()
    _stale.clear()
    _wanted.clear()


def _is_coming(clip_id: int) -> bool:
    return clip_id in _asked and work.waits("data", ("rows", _asked[clip_id]))


def fetch() -> bool:
    """Ask for all that was wanted since the last time, in one call. The timer does so, or a view that knows it all."""
    global _batches
    ids = list(_wanted)[-BATCH:]
    _wanted.clear()
    if ids:
        _batches += 1
        _asked.update(dict.fromkeys(ids, _batches))
        work.ask("data", ("rows", _batches), lambda: session.library().clips(ids), lambda *result: _keep(ids, *result))
    return False


def _keep(ids: list[int], clips: Any, error: BaseException | None) -> None:
    for clip_id in ids:
        _asked.pop(clip_id, None)
        _stale.discard(clip_id)
    if error is not None:
        session.state.trouble = str(error)
    for clip in clips or ():
        ROWS.keep(clip.id, clip, ROW_BYTES)
    for clip_id in set(ids) - {clip.id for clip in clips or ()}:
        ROWS.forget(clip_id)  # it is no longer in the library
    redraw.everything()
