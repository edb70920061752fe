"""Having the views drawn anew when something arrived from the background."""

from __future__ import annotations

from collections.abc import Iterator

import bpy


def everything() -> None:
    """Draw the sidebars of all 3D Views, and the views themselves where the browser is open."""
    for region in _regions("UI"):
        region.tag_redraw()
    for callback in _extra:
        callback()


def _regions(kind: str) -> Iterator[bpy.types.Region]:
    manager = bpy.context.window_manager
    for window in manager.windows if manager else ():
        for area in window.screen.areas:
            if area.type == "VIEW_3D":
                yield from (region for region in area.regions if region.type == kind)


_extra: list = []


def also(callback: object) -> None:
    """Have something else drawn with everything."""
    if callback not in _extra:
        _extra.append(callback)


def no_longer(callback: object) -> None:
    """Take that back."""
    if callback in _extra:
        _extra.remove(callback)
