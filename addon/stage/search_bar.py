"""The search box of the grid."""

from __future__ import annotations

import time
from typing import TYPE_CHECKING

from ..logic.library.rect import Rect
from ..translations import text
from . import look

if TYPE_CHECKING:
    from ..logic.library.field import TextField
    from .canvas import Canvas

BLINK_S = 0.55


def draw(canvas: Canvas, area: Rect, field: TextField, *, is_misunderstood: bool) -> None:
    """Draw the box with its text, a cursor while it takes keys, and a cross that empties it."""
    scale = canvas.scale
    border = look.ALERT if is_misunderstood else look.ACCENT_HOVERED if field.is_active else look.LINE
    canvas.frame(area, border, 1.0 * scale, look.RADIUS * scale, look.FIELD)
    side = 12 * scale
    canvas.icon("FIND", Rect(area.x + 7 * scale, area.y + 6 * scale, side, side), look.TEXT_DIM)
    x, baseline = area.x + 26 * scale, area.y + 8 * scale
    room = area.width - 52 * scale
    shown, before = _visible_part(canvas, field, room)
    if field.is_all_selected:
        canvas.box(Rect(x - 1, area.y + 5 * scale, canvas.width(shown) + 2, area.height - 10 * scale), look.ACCENT)
    if shown:
        canvas.text(x, baseline, shown, look.TEXT)
    elif not field.is_active:
        canvas.text(x, baseline, text("Search: walk rate>=100 subject:07"), look.TEXT_FAINT, width=room)
    if field.is_active and time.monotonic() % (2 * BLINK_S) < BLINK_S:
        place = x + canvas.width(before)
        canvas.layer()
        canvas.box(Rect(place, area.y + 5 * scale, max(1.0, scale), area.height - 10 * scale), look.TEXT)
    if field.text:
        canvas.icon("CLOSE", cross(area).inset(6 * scale), look.TEXT_DIM)


def cross(area: Rect) -> Rect:
    """Return where a press empties the box."""
    return Rect(area.right - area.height, area.y, area.height, area.height)


def _visible_part(canvas: Canvas, field: TextField, room: float) -> tuple[str, str]:
    """Return the part of the text around the cursor that fits, and what of it is before the cursor."""
    start = 0
    while start < field.cursor and canvas.width(field.text[start : field.cursor]) > room:
        start += 1
    end = len(field.text)
    while end > field.cursor and canvas.width(field.text[start:end]) > room:
        end -= 1
    return field.text[start:end], field.text[start : field.cursor]
