"""Paths of files: as they are stored, as the system knows them, and whether anything is there."""

from __future__ import annotations

import os
import time
from pathlib import Path
from typing import TYPE_CHECKING

import bpy

if TYPE_CHECKING:
    from bpy.types import Object

    from ..properties import MotionEntry

MISSING_CHECK_S = 2.0  # a panel asks at each redraw; the disk is asked at most this often

_existence: dict[str, tuple[float, bool]] = {}


def absolute(ob: Object, path: str) -> str:
    """Return a stored path as the system knows it; `//` is relative to the .blend file that the armature lies in."""
    library = ob.library or (ob.override_library.reference.library if ob.override_library else None)
    return os.path.normpath(bpy.path.abspath(path, library=library)) if path else ""


def full_path(path: str) -> str:
    """Return a path that still holds in another folder; links in it stay as they are."""
    return str(Path(path).absolute())


def is_missing(ob: Object, entry: MotionEntry) -> bool:
    """Return whether the file of a track is not where it was. Made to be asked at each redraw."""
    if entry.kind != "TRACK" or entry.packed_key:
        return False
    path = absolute(ob, entry.source)
    checked, missing = _existence.get(path, (-MISSING_CHECK_S, False))
    if time.monotonic() - checked >= MISSING_CHECK_S:
        missing = not Path(path).is_file()
        _existence[path] = (time.monotonic(), missing)
    return missing


def look_again() -> None:
    """Forget which files were there: paths have changed, or files were written."""
    _existence.clear()
