"""The scan of the folders: started and stopped here, done by the native module's own threads."""

from __future__ import annotations

import time
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from ..logic.library.facts import count
from ..logic.messages import explained
from . import pictures, redraw, rows, session, work

if TYPE_CHECKING:
    import motion_theater

LOOK_S = 0.2
REFRESH_S = 3.0


class _Scan:
    """The scan that runs, if one does."""

    running: motion_theater.Scan | None = None
    progress: motion_theater.ScanProgress | None = None
    is_starting = False
    looked = 0.0
    refreshed = 0.0


def is_running() -> bool:
    """Return whether folders are being scanned."""
    return _Scan.running is not None or _Scan.is_starting


def progress() -> tuple[float, str]:
    """Return how far the scan is, between 0 and 1, and what it does, in words."""
    now = _Scan.progress
    if now is None:
        return 0.0, "Looking for files"
    if now.phase == "DRAWING":
        share = now.previews_done / max(1, now.previews_total)
        return share, f"Drawing {now.previews_done:,} of {now.previews_total:,}"
    return (now.done / now.total if now.total else 0.0), f"Reading {now.done:,} of {now.total:,}"


def start(folders: Sequence[str] | None = None) -> None:
    """Scan folders, all of them by default."""
    if is_running():
        return
    _Scan.is_starting, _Scan.progress = True, None
    session.say("")
    work.ask("edits", "scan", lambda: session.library().scan(folders), _started)


def stop() -> None:
    """Stop the scan; what it found is kept."""
    if _Scan.running is not None:
        _Scan.running.cancel()


def _started(scan: Any, error: BaseException | None) -> None:
    _Scan.is_starting = False
    if error is not None:
        session.say(explained(error) or repr(error), is_alarming=True)
        return
    _Scan.running, _Scan.refreshed = scan, time.monotonic()
    work.watch(_look)


def _look() -> bool:
    """See how far the scan is."""
    now = time.monotonic()
    if _Scan.running is None or now - _Scan.looked < LOOK_S:
        return _Scan.running is not None
    _Scan.looked = now
    seen = _Scan.progress = _Scan.running.progress()
    redraw.everything()
    if seen.is_finished:
        session.say(outcome(seen), is_alarming=bool(seen.error))
        _Scan.running = None
        _renew()
        return False
    if now - _Scan.refreshed > REFRESH_S:
        _Scan.refreshed = now
        _renew()
    return True


def _renew() -> None:
    rows.renew()
    pictures.forget_missing()
    session.refresh()


def outcome(seen: motion_theater.ScanProgress) -> str:
    """Return what a scan found, in one sentence."""
    if seen.error:
        return f"The scan stopped: {seen.error}"
    parts = [
        f"{number:,} {what}"
        for number, what in (
            (seen.new, "new"),
            (seen.changed, "changed"),
            (seen.moved, "moved"),
            (seen.missing, "missing"),
            (seen.broken, "not readable"),
        )
        if number
    ]
    if seen.done < seen.total or seen.previews_done < seen.previews_total:
        parts.append("stopped before the end")
    return f"Scanned {count(seen.done + seen.unchanged, 'file', 'files')}: {', '.join(parts) or 'nothing changed'}"


def close() -> None:
    """Stop a scan that still runs, and begin none."""
    work.forget("edits", "scan")
    stop()
    _Scan.running = _Scan.progress = None
    _Scan.is_starting = False
