"""The part of a 3D View that its toolbar, sidebar and headers leave free."""

from __future__ import annotations

from collections.abc import Iterable

from .rect import Rect


def free_area(whole: Rect, others: Iterable[Rect]) -> Rect:
    """Return a view without what lies over its edges: tall things at the sides, wide ones above and below."""
    left, bottom, right, top = whole.x, whole.y, whole.right, whole.top
    for other in others:
        if other.x >= whole.right or other.right <= whole.x or other.y >= whole.top or other.top <= whole.y:
            continue  # beside the view, not over it
        x, y = other.middle
        if other.width < other.height:
            left, right = (max(left, other.right), right) if x < whole.middle[0] else (left, min(right, other.x))
        else:
            bottom, top = (max(bottom, other.top), top) if y < whole.middle[1] else (bottom, min(top, other.y))
    return Rect(left, bottom, max(0.0, right - left), max(0.0, top - bottom))
