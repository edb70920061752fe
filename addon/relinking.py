"""Tracks whose file is elsewhere from now on: in another place, or written out of the .blend."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

from . import sources, stack
from .logic.messages import UserError

if TYPE_CHECKING:
    from bpy.types import Object

    from .properties import MotionEntry


def relink(ob: Object, entry: MotionEntry, path: str) -> None:
    """Let a track come from another file, and rebuild; on an error the old source stays."""
    before = (entry.source, entry.packed_key)
    _take_from(entry, sources.full_path(path))
    try:
        stack.rebuild(ob)
    except UserError:
        _take_from(entry, *before)
        raise


def unpack(ob: Object, entry: MotionEntry, path: str) -> None:
    """Write the packed file of a track to disk and use it from there; never over another file in that place."""
    sources.write_out(ob, entry, path)
    key = entry.packed_key
    _take_from(entry, str(Path(path)))
    sources.drop_unused(ob.motion_theater, key)


def _take_from(entry: MotionEntry, source: str, packed_key: str = "") -> None:
    with stack.quietly():
        entry.source, entry.packed_key = source, packed_key
    sources.look_again()
