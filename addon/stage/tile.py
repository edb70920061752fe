"""One clip in the grid: its still, or its moving strip under the mouse, and what must be known of it at a glance."""

from __future__ import annotations

import textwrap
from typing import TYPE_CHECKING

from ..library import pictures, rows
from ..logic.library import facts
from ..logic.library.rect import Rect
from ..translations import text
from . import look, textures

if TYPE_CHECKING:
    import motion_theater

    from .canvas import Canvas

CAPTION = 38.0
"""The height below the picture for two lines."""
MOVES_AFTER_S = 0.12


def draw(canvas: Canvas, area: Rect, clip_id: int, *, is_active: bool, hovered_s: float | None) -> Rect | None:
    """Draw a tile. `hovered_s` is how long the mouse has been on it. Return the bar that says how far its strip is."""
    scale = canvas.scale
    radius = look.RADIUS * scale
    fill = look.TILE if hovered_s is None else look.TILE_HOVERED
    if is_active:
        canvas.box(area.inset(-2 * scale), look.ACCENT_HOVERED, radius + 2 * scale)
    canvas.box(area, fill, radius)
    clip = rows.get(clip_id)
    picture = Rect(area.x, area.y + CAPTION * scale, area.width, area.height - CAPTION * scale).inset(3 * scale)
    if clip is None:
        _ask_for_pictures(clip_id, is_hovered=hovered_s is not None)
        return None
    _draw_caption(canvas, area, clip)
    if clip.error:
        _draw_error(canvas, picture, clip.error)
        return None
    played = _draw_strip(canvas, picture, clip_id, hovered_s - MOVES_AFTER_S) if hovered_s is not None else None
    if played is None:
        _draw_still(canvas, picture, clip_id)
    return played


def is_moving(clip_id: int) -> bool:
    """Return whether a clip has a strip that moves under the mouse, or may yet get one."""
    strip = pictures.STRIPS.get(clip_id)
    return strip is None or len(strip.frames) > 0


def _ask_for_pictures(clip_id: int, *, is_hovered: bool) -> None:
    """Have pictures fetched: they need not wait until what is known of the clip has come."""
    pictures.still(clip_id)
    if is_hovered:
        pictures.strip(clip_id)


def _draw_strip(canvas: Canvas, area: Rect, clip_id: int, played_s: float) -> Rect | None:
    """Draw the moving picture, by time. Return how far it is, as a bar below it; None where there is none yet."""
    strip = pictures.strip(clip_id)  # asked for at once, so that it is there when it is to move
    if played_s < 0.0 or strip is None or not len(strip.frames) or strip.rate_hz <= 0:
        return None
    number = int(played_s * strip.rate_hz) % len(strip.frames)
    frame = strip.frames[number]
    texture = textures.get((clip_id, number), frame)
    if texture is None:
        return None
    place = area.fitted(frame.shape[1] / frame.shape[0])
    canvas.picture(texture, place)
    return Rect(place.x, area.y, place.width * (number + 1) / len(strip.frames), 2 * canvas.scale)


def _draw_still(canvas: Canvas, area: Rect, clip_id: int) -> None:
    still = pictures.still(clip_id)
    if still is None:
        return
    if not still.size:
        x, y = area.middle
        canvas.text(x, y - 4 * canvas.scale, text("No picture yet"), look.TEXT_FAINT, align="CENTER")
        return
    texture = textures.get((clip_id, -1), still)
    if texture is not None:
        canvas.picture(texture, area.fitted(still.shape[1] / still.shape[0]))


def _draw_error(canvas: Canvas, area: Rect, error: str) -> None:
    """Say why a file cannot be read, as far as there is room."""
    scale = canvas.scale
    canvas.text(area.x + 5 * scale, area.top - 16 * scale, text("Not readable"), look.ALERT, 11)
    lines = textwrap.wrap(error, max(12, int(area.width / (5.6 * scale))))
    room = int((area.height - 24 * scale) // (14 * scale))
    for number, line in enumerate(lines[:room]):
        shown = line + "…" if number == room - 1 and len(lines) > room else line
        canvas.text(
            area.x + 5 * scale,
            area.top - (33 + 14 * number) * scale,
            shown,
            look.TEXT_DIM,
            10,
            width=area.width - 8 * scale,
        )


def _draw_caption(canvas: Canvas, area: Rect, clip: motion_theater.LibraryClip) -> None:
    scale = canvas.scale
    left, right = area.x + 8 * scale, area.right - 8 * scale
    name_end = right
    if clip.is_favourite:
        name_end -= 16 * scale
        canvas.icon("STAR", Rect(right - 12 * scale, area.y + 20 * scale, 12 * scale, 12 * scale), look.STAR)
    ink = look.TEXT if not clip.is_missing else look.TEXT_FAINT
    canvas.text(left, area.y + 22 * scale, clip.name, ink, 11, width=name_end - left)
    canvas.text(left, area.y + 7 * scale, line(clip), look.TEXT_DIM, 9.5, width=right - left)


def line(clip: motion_theater.LibraryClip) -> str:
    """Return what is known of a clip in a few words."""
    if clip.is_missing:
        return text("Missing")
    rate = facts.rate(clip.rate_hz) if clip.rate_hz else ""
    parts = [(clip.format or "").upper(), facts.duration(clip.duration_s), rate]
    return "   ".join(part for part in parts if part)
