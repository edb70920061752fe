"""Words in panels: sentences over several lines, and the short texts that describe an entry."""

from __future__ import annotations

import textwrap
from typing import TYPE_CHECKING

from ..logic import names
from ..logic.messages import bones, frame
from ..translations import text

if TYPE_CHECKING:
    from bpy.types import Context, UILayout

    from ..properties import MotionEntry

# Mean width of a character of Blender's interface font, and what icon and margins take, in points.
CHARACTER_WIDTH = 6.4
MARGIN = 76


def sentence(layout: UILayout, context: Context, message: str, *, icon: str = "BLANK1", alert: bool = False) -> None:
    """Draw a sentence on as many lines as the panel's width asks for, with the icon on the first.

    Blender cuts a label that is too long for its panel instead of breaking it.
    """
    scale = context.preferences.system.ui_scale or 1.0  # zero where there is no window
    width = context.region.width if context.region else 300
    characters = max(16, int((width / scale - MARGIN) / CHARACTER_WIDTH))
    column = layout.column(align=True)
    column.scale_y = 0.8
    column.alert = alert
    for number, line in enumerate(textwrap.wrap(message, characters)):
        column.label(text=line, icon="BLANK1" if number else icon, translate=False)


def sentences(layout: UILayout, context: Context, messages: str, *, icon: str) -> None:
    """Draw every line of a newline separated text as a sentence of its own."""
    for message in names.split(messages):
        sentence(layout, context, message, icon=icon)


def bone_count(entry: MotionEntry) -> str:
    """Return how many bones an entry works on."""
    if entry.all_bones:
        return text("All bones")
    return bones(len(names.split(entry.bones)))


def extent(entry: MotionEntry) -> str:
    """Return what the list shows beside the name: the frames of a track, the depth of a filter."""
    if entry.kind == "FILTER":
        return str(entry.depth)
    if entry.kind == "TRACK" and entry.result_end > entry.result_start:
        return f"{frame(entry.result_start)}-{frame(entry.result_end)}"
    return ""


def clip_facts(entry: MotionEntry) -> str:
    """Return what the file of a track holds."""
    first, last = entry.clip_first, entry.clip_first + entry.clip_frames - 1
    if not entry.clip_rate_hz:
        return text("Frames {first}-{last}", first=first, last=last)
    return text("Frames {first}-{last} at {rate} Hz", first=first, last=last, rate=f"{entry.clip_rate_hz:g}")


def labelled(layout: UILayout, label: str) -> UILayout:
    """Draw a label where properties have theirs, and return the row beside it."""
    split = layout.split(factor=0.4)
    left = split.row()
    left.alignment = "RIGHT"
    left.label(text=label)
    return split.row(align=True)
