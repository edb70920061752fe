"""Stack files: the settings that an entry of the stack and one of a file share, and paths beside the file."""

from __future__ import annotations

import math
import os
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from .messages import UserError

TRACK_SETTINGS = (
    "rate_hz",
    "cut_start",
    "cut_end",
    "scale_start",
    "scale_end",
    "blend_depth",
    "preserve",
    "preserve_rotation",
    "preserve_height",
    "discard",
    "blend",
    "sampling",
    "keys",
)
FILTER_SETTINGS = ("filter_kind", "depth", "filter_channels")
MOST = 1_048_574  # of frames, as in Blender


def relative(path: str, folder: str) -> str:
    """Return a path as seen from a folder, with slashes; as it is where there is no way, as from drive to drive."""
    try:
        return Path(os.path.relpath(path, folder)).as_posix()
    except ValueError:
        return Path(path).as_posix()


def settings(entry: Mapping[str, Any], label: str) -> dict[str, object]:
    """Return the settings that an entry of a stack file names, checked: Blender would cut off what is too large."""
    names = TRACK_SETTINGS if entry.get("kind", "TRACK") == "TRACK" else FILTER_SETTINGS
    found = {name: entry[name] for name in names if name in entry}
    for name, value in found.items():
        if isinstance(value, bool | str):
            continue
        if value is None or not math.isfinite(value) or abs(value) > MOST or (name == "rate_hz" and value < 0.0):
            raise UserError(f"{label}: {name} makes no sense: {value}")
    if names is FILTER_SETTINGS and "filter_kind" not in found:
        raise UserError(f"{label}: filter_kind is missing: MEDIAN, AVERAGE or WEIGHTED")
    return found


def label(entry: Mapping[str, Any], number: int) -> str:
    """Return what an entry of a stack file is called in messages."""
    return str(entry.get("name") or entry.get("source") or f"Entry {number}")
