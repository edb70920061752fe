"""The browser over one 3D View: which view of it is shown, what it is told, and that it leaves nothing behind."""

from __future__ import annotations

import time
import traceback
from collections import deque
from typing import TYPE_CHECKING, Any

import bpy
import numpy as np

from ..library import redraw, session
from ..logic.library.free_area import free_area
from ..logic.library.rect import Rect
from . import canvas, look, textures
from .view import Input, Window

if TYPE_CHECKING:
    from bpy.types import Area, Context, Event, Region

    from .view import View

SAID_S = 6.0
"""How long a message stays."""


class Overlay:
    """The one browser that is open. It knows its area by number: references do not survive changes of the screen."""

    def __init__(self, context: Context) -> None:
        self.area_key = context.area.as_pointer()
        self.views: list[View] = []
        self.mouse = (-1, -1)
        self.said: tuple[str, bool, float] = ("", False, 0.0)
        self.heard = session.state.message
        self.draw_s: deque[float] = deque(maxlen=1000)
        """Processor time that each of the last redraws took of the main thread. What the graphics card takes, or a
        program in its place, is not ours: the view below costs the same."""
        self._handle: Any = bpy.types.SpaceView3D.draw_handler_add(self._draw, (), "WINDOW", "POST_PIXEL")
        self._wish: Any = None
        self._look = _look_of(_region(context.area))
        redraw.also(self.tag)

    # -- What it shows ------------------------------------------------------------------------------------------------

    @property
    def view(self) -> View:
        """The view on top."""
        return self.views[-1]

    def show(self, view: View) -> None:
        """Show another view; leaving it comes back to this one."""
        self.views.append(view)
        self.tag()

    def leave(self) -> None:
        """Go back to the view before; without one the browser closes with the next event."""
        self.views.pop()
        self.tag()

    def say(self, words: str, *, is_error: bool = False) -> None:
        """Show a message for a while."""
        self.said = (words, is_error, time.monotonic())
        self.tag()

    def hear(self) -> None:
        """Show what could not be done in the background, once."""
        message = session.state.message
        if message != self.heard:
            self.heard = message
            if session.state.is_alarming:
                self.say(message, is_error=True)

    def run(self, operator: str, **options: object) -> None:
        """Call an operator of ours once the event is over, as one undo step."""
        self._wish = (operator, options)

    def menu(self, name: str) -> None:
        """Open a menu or pop-over at the mouse once the event is over."""
        self._wish = (name, None)

    def reason(self, operator: str) -> str:
        """Return why an operator of ours cannot be used now, or nothing."""
        from ..operators import library_use

        return library_use.reason(bpy.context, operator)

    def paste(self) -> str:
        """Return the text of the clipboard."""
        return bpy.context.window_manager.clipboard

    # -- The window ---------------------------------------------------------------------------------------------------

    def area(self) -> Area | None:
        """Return the area that it lies in, if that is still a 3D View on the screen."""
        manager = bpy.context.window_manager
        for window in manager.windows if manager else ():
            for area in window.screen.areas:
                if area.as_pointer() == self.area_key and area.type == "VIEW_3D":
                    return area
        return None

    def tag(self) -> None:
        """Have it drawn."""
        area = self.area()
        if area is not None:
            _region(area).tag_redraw()

    def event(self, context: Context, event: Event) -> bool:
        """Take an event; False lets it pass through."""
        area = self.area()
        if area is None:
            self.views.clear()
            return False
        region = _region(area)
        self.mouse = (event.mouse_x, event.mouse_y)
        if event.type.startswith("TIMER"):
            self.hear()
            if self.view.is_moving(time.monotonic()) or self.said[0]:
                region.tag_redraw()
            return False
        window = _window(area, region, self.mouse)
        taken = self.view.take(
            Input(
                kind=event.type,
                value=event.value,
                x=window.mouse[0],
                y=window.mouse[1],
                is_over=window.is_over,
                now=window.now,
                text=event.unicode or "",
                ctrl=event.ctrl or event.oskey,
                shift=event.shift,
                alt=event.alt,
            )
        )
        if taken or window.is_over:
            region.tag_redraw()
        self._fulfil(context, area, region)
        return taken

    def _fulfil(self, context: Context, area: Area, region: Region) -> None:
        """Do what the view asked for, with the 3D View as the context."""
        if self._wish is None:
            return
        (name, options), self._wish = self._wish, None
        with context.temp_override(window=context.window, area=area, region=region):
            if options is None:
                _open_menu(name)
                return
            session.say("")
            self.heard = ""  # the same trouble again is news
            try:
                getattr(bpy.ops.motion_theater, name)("INVOKE_DEFAULT", True, **options)
                self.say(session.state.message)
            except RuntimeError as error:  # how Blender hands a reported error to a Python caller
                self.say(str(error).strip().removeprefix("Error: ").splitlines()[0], is_error=True)

    def _draw(self) -> None:
        """Draw, from Blender's own redraw. An error is printed; it must not reach Blender."""
        context = bpy.context
        if not self.views or context.area is None or context.area.as_pointer() != self.area_key:
            return
        begin = time.thread_time()
        try:
            textures.begin_redraw()
            scale = context.preferences.system.ui_scale
            sheet = canvas.Canvas(scale)
            window = _window(context.area, context.region, self.mouse)
            self.view.draw(sheet, window)
            self._draw_message(sheet, window)
            sheet.draw()
        except Exception:
            traceback.print_exc()
        self.draw_s.append(time.thread_time() - begin)

    def _draw_message(self, sheet: canvas.Canvas, window: Window) -> None:
        words, is_error, since = self.said
        if not words or window.now - since > SAID_S:
            self.said = ("", False, 0.0)
            return
        scale = sheet.scale
        room = window.free.width - 80 * scale
        wide = min(sheet.width(words, 12) + 28 * scale, room)
        place = Rect(window.free.middle[0] - wide / 2, window.free.top - 46 * scale, wide, 30 * scale)
        sheet.within(None)
        sheet.frame(place, look.ALERT if is_error else look.ACCENT_HOVERED, 1.5 * scale, 6 * scale, look.TOOLTIP)
        ink = look.ALERT if is_error else look.TEXT
        sheet.text(place.middle[0], place.y + 10 * scale, words, ink, 12, width=wide - 16 * scale, align="CENTER")

    def status(self) -> str:
        """Return the keys for the status bar."""
        return "     ".join(f"{key}: {words}" for key, words in self.view.help()) if self.views else ""

    def close(self) -> None:
        """Take everything away, and turn the view back to where it was."""
        if self._handle is not None:
            bpy.types.SpaceView3D.draw_handler_remove(self._handle, "WINDOW")
            self._handle = None
        redraw.no_longer(self.tag)
        self.views.clear()
        area = self.area()
        if area is not None:
            _look_again(_region(area), self._look)
            _region(area).tag_redraw()


current: Overlay | None = None
"""The browser that is open, if one is."""


def open_in(context: Context) -> Overlay:
    """Open the browser over the area of the context."""
    global current
    close()
    current = Overlay(context)
    return current


def close() -> None:
    """Close the browser."""
    global current
    if current is not None:
        current.close()
        current = None


def _region(area: Area) -> Region:
    return next(region for region in area.regions if region.type == "WINDOW")


def _window(area: Area, region: Region, mouse: tuple[float, float]) -> Window:
    """Return what the views must know of the 3D View now."""
    others = [
        Rect(other.x - region.x, other.y - region.y, other.width, other.height)
        for other in area.regions
        if other.type != "WINDOW" and other.width > 1 and other.height > 1
    ]
    whole = Rect(0, 0, region.width, region.height)
    free = free_area(whole, others)
    x, y = mouse[0] - region.x, mouse[1] - region.y
    seen = area.spaces.active.region_3d
    return Window(
        region=whole,
        free=free,
        scale=bpy.context.preferences.system.ui_scale,
        mouse=(x, y),
        is_over=free.contains(x, y),
        now=time.monotonic(),
        rotation=np.array(seen.view_matrix.to_3x3().normalized()),
        location=np.array(seen.view_location),
        distance=seen.view_distance,
        has_perspective=seen.is_perspective,
    )


def _open_menu(name: str) -> None:
    if "_PT_" in name:
        bpy.ops.wm.call_panel("INVOKE_DEFAULT", name=name, keep_open=True)
    else:
        bpy.ops.wm.call_menu("INVOKE_DEFAULT", name=name)


def _look_of(region: Region) -> tuple[Any, ...]:
    seen = region.data
    return seen.view_location.copy(), seen.view_rotation.copy(), seen.view_distance, seen.view_perspective


def _look_again(region: Region, before: tuple[Any, ...]) -> None:
    seen = region.data
    seen.view_location, seen.view_rotation, seen.view_distance, seen.view_perspective = before
