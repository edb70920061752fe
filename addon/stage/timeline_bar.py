"""The bar of the timeline: usable pieces, frame numbers, marks, and the playhead."""

from __future__ import annotations

from typing import TYPE_CHECKING

from ..logic.library.rect import Rect
from . import look

if TYPE_CHECKING:
    from collections.abc import Iterable

    from ..logic.library.marks import Marks
    from ..logic.library.timeline import Timeline
    from .canvas import Canvas

TICK_SPACING = 70.0


def draw(canvas: Canvas, timeline: Timeline, marks: Marks | None, segments: Iterable[tuple[int, int]]) -> None:
    """Draw the bar without its playhead; without marks it shows no frames."""
    scale, bar = canvas.scale, timeline.bar
    canvas.box(bar, look.FIELD, 3 * scale)
    if marks is None:
        return
    for first, last in segments:
        x, end = (timeline.x(min(max(frame, marks.first), marks.last)) for frame in (first, last))
        canvas.box(Rect(x, bar.y, max(2.0, end - x), 4 * scale), look.USABLE)
    begin, end = (timeline.x(frame) for frame in marks.range)
    if marks.are_set:
        canvas.box(Rect(begin, bar.y, max(1.0, end - begin), bar.height), (*look.MARK[:3], 0.28))
    _draw_ticks(canvas, timeline, (begin, end) if marks.are_set else (0.0, 0.0))
    for x, is_begin in ((begin, True), (end, False)):
        _draw_mark(canvas, bar, x, is_begin=is_begin, is_set=marks.are_set)


def draw_head(canvas: Canvas, timeline: Timeline, place: float) -> None:
    """Draw the playhead at a frame, over what was drawn."""
    scale, bar = canvas.scale, timeline.bar
    canvas.layer((timeline.x(place), bar.y))
    canvas.box(Rect(-scale, -3 * scale, 2 * scale, bar.height + 6 * scale), look.TEXT, scale)
    canvas.icon("HEAD", Rect(-6 * scale, bar.height - 2 * scale, 12 * scale, 12 * scale), look.TEXT)
    canvas.layer()


def _draw_ticks(canvas: Canvas, timeline: Timeline, marked: tuple[float, float]) -> None:
    """Draw frame numbers, bright between the marks, where the bar is."""
    scale, bar = canvas.scale, timeline.bar
    for frame in timeline.ticks(TICK_SPACING * scale):
        x = timeline.x(frame)
        canvas.box(Rect(x, bar.y, 1, bar.height), (*look.TEXT_FAINT[:3], 0.5))
        if x + 34 * scale < bar.right:
            ink = look.TEXT if marked[0] <= x + 4 * scale < marked[1] else look.TEXT_FAINT
            canvas.text(x + 4 * scale, bar.y + 4.5 * scale, str(frame), ink, 9)


def _draw_mark(canvas: Canvas, bar: Rect, x: float, *, is_begin: bool, is_set: bool) -> None:
    """Draw a bracket that can be taken hold of."""
    scale = canvas.scale
    color = look.MARK if is_set else look.TEXT_FAINT
    canvas.box(Rect(x - scale, bar.y - 2 * scale, 2 * scale, bar.height + 4 * scale), color)
    foot = 6 * scale
    for y in (bar.y - 2 * scale, bar.top):
        canvas.box(Rect(x if is_begin else x - foot, y, foot, 2 * scale), color)
