"""Rows of buttons: where they lie, how they look, and what they say when the mouse rests on them."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

from ..logic.library.rect import Rect
from . import look

if TYPE_CHECKING:
    from collections.abc import Callable

    from .canvas import Canvas


@dataclass(frozen=True)
class Button:
    """A button. Without a name it is a label; without label and icon it is a gap."""

    name: str = ""
    label: str = ""
    icon: str = ""
    tip: str = ""
    """A sentence, with the key that does the same."""
    is_on: bool = False
    is_main: bool = False
    """Whether it is what one came for."""
    reason: str = ""
    """Why it cannot be used."""
    width: float = 0.0
    """At least, before the scale of the interface."""


@dataclass(frozen=True)
class Placed:
    """A button and where it is."""

    button: Button
    area: Rect


def width_of(button: Button, scale: float, measure: Callable[[str], float]) -> float:
    """Return how wide a button is."""
    wide = measure(button.label) + 16 * scale if button.label else 0.0
    if button.icon:
        wide = wide + 14 * scale if button.label else look.BUTTON_HEIGHT * scale + 4 * scale
    return max(wide, button.width * scale)


def row(
    buttons: Iterable[Button], start: float, middle: float, scale: float, measure: Callable[[str], float]
) -> list[Placed]:
    """Return buttons side by side from `start` to the right, about a line at height `middle`."""
    placed, height, x = [], look.BUTTON_HEIGHT * scale, start
    for button in buttons:
        wide = width_of(button, scale, measure)
        placed.append(Placed(button, Rect(x, middle - height / 2, wide, height)))
        x += wide + (4 if button.name else 2) * scale
    return placed


def row_to(
    buttons: Sequence[Button], end: float, middle: float, scale: float, measure: Callable[[str], float]
) -> list[Placed]:
    """Return buttons side by side that end at `end`."""
    placed = row(buttons, 0.0, middle, scale, measure)
    shift = end - placed[-1].area.right if placed else 0.0
    return [Placed(one.button, one.area._replace(x=one.area.x + shift)) for one in placed]


def at(placed: Iterable[Placed], x: float, y: float) -> Placed | None:
    """Return the button under a point."""
    return next((one for one in placed if one.button.name and one.area.contains(x, y)), None)


def draw(canvas: Canvas, placed: Iterable[Placed], hovered: str) -> None:
    """Draw buttons; the one under the mouse is lighter."""
    for one in placed:
        button, area = one.button, one.area
        if not button.name:
            _draw_content(canvas, button, area, look.TEXT_DIM)
            continue
        is_hovered = button.name == hovered and not button.reason
        if button.reason:
            fill, ink = look.BUTTON_OFF, look.TEXT_FAINT
        elif button.is_on or button.is_main:
            fill, ink = (look.ACCENT_HOVERED if is_hovered else look.ACCENT), look.TEXT
        else:
            fill, ink = (look.BUTTON_HOVERED if is_hovered else look.BUTTON), look.TEXT
        canvas.box(area, fill, look.RADIUS * canvas.scale)
        _draw_content(canvas, button, area, ink)


def _draw_content(canvas: Canvas, button: Button, area: Rect, ink: tuple[float, float, float, float]) -> None:
    scale = canvas.scale
    baseline = area.y + area.height / 2 - 4 * scale
    if button.icon:
        side = 12 * scale
        x = area.x + 8 * scale if button.label else area.x + (area.width - side) / 2
        canvas.icon(button.icon, Rect(x, area.y + (area.height - side) / 2, side, side), ink)
        if button.label:
            canvas.text(x + side + 5 * scale, baseline, button.label, ink)
    elif button.label:
        canvas.text(area.x + area.width / 2, baseline, button.label, ink, align="CENTER")


def draw_tip(canvas: Canvas, one: Placed, room: Rect) -> None:
    """Say what a button does, and why it cannot be used, above it and inside of `room`."""
    scale = canvas.scale
    lines = [line for line in (one.button.tip, one.button.reason) if line]
    if not lines:
        return
    width = max(canvas.width(line) for line in lines) + 16 * scale
    height = (18 * len(lines) + 8) * scale
    x = min(max(one.area.x, room.x + 4), max(room.x + 4, room.right - width - 4))
    y = one.area.top + 5 * scale
    if y + height > room.top:
        y = one.area.y - height - 5 * scale
    canvas.layer()
    canvas.frame(Rect(x, y, width, height), look.LINE, 1.0, look.RADIUS * scale, look.TOOLTIP)
    for number, line in enumerate(lines):
        ink = look.ALERT if line == one.button.reason else look.TEXT
        canvas.text(x + 8 * scale, y + height - (17 + 18 * number) * scale, line, ink)
