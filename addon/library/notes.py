"""What the user says of clips: kept in the library, and in the sidecars beside them too where that is wished.

The library is written first. Where a sidecar cannot be saved, the library keeps the edit, the file is what it was, and
a message says both.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence

import motion_theater

from ..logic.messages import UserError, explained
from ..translations import text
from . import session

LINES = {
    "subject": "subject",
    "recorded_on": "date",
    "description": "comment",
    "session_group": "group",
    "cleaned": "cleaned",
}
"""Fields of the library by the lines that a sidecar has for them. Stars, tags and favorites have none."""


def edit(clip_id: int, fields: dict[str, object]) -> None:
    """Write fields of a clip; None takes back what the user said, and empties the line of the sidecar."""
    lines = {LINES[name]: value for name, value in fields.items() if name in LINES}
    emptied = [line for line, value in lines.items() if value is None]
    _write(clip_id, lambda: session.library().edit([clip_id], fields), emptied, has_line=bool(lines))


def tag(clip_id: int, add: Sequence[str], remove: Sequence[str]) -> None:
    """Put tags on a clip, and take others off."""
    _write(clip_id, lambda: session.library().tag([clip_id], add=add, remove=remove), (), has_line=False)


def mark_usable(clip_id: int, piece: tuple[int, int], said: str) -> None:
    """Note that one more piece of a clip is usable."""

    def add() -> None:
        # Looked up here, in the order of all edits: one that waits still is not lost.
        library = session.library()
        pieces = {known for clip in library.clips([clip_id]) for known in clip.segments}
        library.set_segments(clip_id, sorted({*pieces, piece}))

    _write(clip_id, add, (), has_line=True, said=said)


def forget_usable(clip_id: int, said: str) -> None:
    """Forget which pieces of a clip are usable."""
    emptied = ("usable_segments",)
    _write(clip_id, lambda: session.library().set_segments(clip_id, []), emptied, has_line=True, said=said)


def sidecar_saved(clip_id: int, edited: Sequence[str]) -> None:
    """Let the library know what a sidecar says, and that of these lines it is the user's latest word."""
    session.change(lambda: session.library().read_sidecar(clip_id, edited=edited), about=clip_id)


def _write(
    clip_id: int, to_library: Callable[[], object], emptied: Iterable[str], *, has_line: bool, said: str = ""
) -> None:
    to_sidecar = has_line and session.state.also_sidecar

    def write() -> None:
        to_library()
        if not to_sidecar:
            return
        try:
            session.library().write_sidecar(clip_id, emptied=list(emptied))
        except (OSError, motion_theater.MotionTheaterError) as error:
            reason = explained(error) or str(error)
            raise UserError(text("{reason}. The library keeps what you changed", reason=reason)) from error

    session.say(said)
    session.change(write, about=clip_id)
