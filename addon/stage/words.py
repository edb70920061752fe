"""Lines of text: how wide they are, and writing them."""

from __future__ import annotations

from collections.abc import Iterable
from functools import lru_cache
from typing import TYPE_CHECKING, Literal, NamedTuple

import blf

if TYPE_CHECKING:
    from ..logic.library.shapes import Color

FONT = 0
ELLIPSIS = "…"
Align = Literal["LEFT", "CENTER", "RIGHT"]
SHIFT = {"LEFT": 0.0, "CENTER": 0.5, "RIGHT": 1.0}


class Text(NamedTuple):
    """A line of text; `x`, `y` is where its baseline begins, ends or has its middle."""

    x: float
    y: float
    text: str
    size: float
    color: Color
    align: Align


@lru_cache(maxsize=4096)
def measure(text: str, points: float) -> float:
    """Return how many pixels wide a text is."""
    blf.size(FONT, points)
    return float(blf.dimensions(FONT, text)[0])


@lru_cache(maxsize=4096)
def shortened(text: str, points: float, width: float) -> str:
    """Return a text cut so that it is no wider than `width` pixels."""
    if measure(text, points) <= width:
        return text
    low, high = 0, len(text)
    while low < high:
        middle = (low + high + 1) // 2
        if measure(text[:middle].rstrip() + ELLIPSIS, points) <= width:
            low = middle
        else:
            high = middle - 1
    return text[:low].rstrip() + ELLIPSIS if low else ""


def write(texts: Iterable[Text]) -> None:
    """Write lines of text."""
    points = 0.0
    for text in texts:
        shift = SHIFT[text.align]
        x = text.x - shift * measure(text.text, text.size) if shift else text.x
        if text.size != points:
            points = text.size
            blf.size(FONT, points)
        blf.position(FONT, round(x), round(text.y), 0.0)
        blf.color(FONT, *text.color)
        blf.draw(FONT, text.text)


def close() -> None:
    """Forget how wide texts are: another font may be set."""
    measure.cache_clear()
    shortened.cache_clear()
