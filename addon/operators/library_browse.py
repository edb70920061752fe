"""Looking through the library over a 3D View: the grid of stills, and the stage where clips play."""

from __future__ import annotations

from typing import TYPE_CHECKING

import bpy
from bpy.props import EnumProperty

from ..library import session
from ..stage import grid_view, overlay, stage_view
from ..translations import text
from . import target

if TYPE_CHECKING:
    from bpy.types import Context, Event

    from ..stage.view import View

TICK_S = 1 / 50
SIZES = (
    ("ONE", "One", "Open the selected clip, with a timeline and marks"),
    ("FOUR", "Four", "Play four clips, the selected one first"),
    ("NINE", "Nine", "Play nine clips, the selected one first"),
)


class _Looking(bpy.types.Operator):
    """What both operators do: hand events to the browser until it is left. Nothing of the scene is touched."""

    _status = ""

    @classmethod
    def poll(cls, context: Context) -> bool:
        reason = ""
        if context.area is None or context.area.type != "VIEW_3D":
            reason = text("The library opens over a 3D View")
        elif session.state.trouble:
            reason = session.state.trouble
        return target.allowed(cls, reason)

    def first_view(self, host: overlay.Overlay) -> View:
        """Return what is shown first."""
        raise NotImplementedError

    def invoke(self, context: Context, event: Event) -> set[str]:
        session.ensure_open()
        now = overlay.current
        if now is not None and now.views and now.area_key == context.area.as_pointer():
            now.show(self.first_view(now))
            return {"FINISHED"}
        self._overlay = overlay.open_in(context)
        self._overlay.mouse = (event.mouse_x, event.mouse_y)
        self._overlay.show(self.first_view(self._overlay))
        self._timer = context.window_manager.event_timer_add(TICK_S, window=context.window)
        context.window_manager.modal_handler_add(self)
        self._tell(context)
        return {"RUNNING_MODAL"}

    def execute(self, context: Context) -> set[str]:
        self.report({"ERROR"}, text("The library is looked at with mouse and keys: invoke this in a 3D View"))
        return {"CANCELLED"}

    def modal(self, context: Context, event: Event) -> set[str]:
        """Hand an event to the browser."""
        if overlay.current is not self._overlay:
            return self._end(context)
        taken = self._overlay.event(context, event)
        if not self._overlay.views:
            return self._end(context)
        self._tell(context)
        return {"RUNNING_MODAL"} if taken else {"PASS_THROUGH"}

    def cancel(self, context: Context) -> None:
        """Tidy up where Blender itself ends the operator, as when another file is opened."""
        self._end(context)

    def _tell(self, context: Context) -> None:
        """Show the keys in the status bar."""
        keys = self._overlay.status()
        if keys != self._status:
            self._status = keys
            context.workspace.status_text_set(keys)

    def _end(self, context: Context) -> set[str]:
        context.window_manager.event_timer_remove(self._timer)
        if context.workspace is not None:
            context.workspace.status_text_set(None)
        if overlay.current is self._overlay:
            overlay.close()
        return {"FINISHED"}


class MOTION_THEATER_OT_library_browse(_Looking):
    """Look through the library over this 3D View: pictures that move under the mouse, a search, sorting and filters"""

    bl_idname = "motion_theater.library_browse"
    bl_label = "Browse Library"
    bl_options = {"REGISTER"}

    def first_view(self, host: overlay.Overlay) -> View:
        """Return the grid."""
        return grid_view.GridView(host)


class MOTION_THEATER_OT_library_play(_Looking):
    """Play clips of the library over this 3D View, without importing them"""

    bl_idname = "motion_theater.library_play"
    bl_label = "Play Clips"
    bl_options = {"REGISTER"}

    at_a_time: EnumProperty(
        name="At a Time", description="How many clips play side by side", items=SIZES, default="FOUR"
    )

    @classmethod
    def description(cls, context: Context, properties: bpy.types.OperatorProperties) -> str:
        if properties.at_a_time == "ONE":
            return text("Open the selected clip over this 3D View, mark the piece you want, and add it as a track")
        return text("Play several clips of the library over this 3D View, beginning with the selected one")

    @classmethod
    def poll(cls, context: Context) -> bool:
        if not len(session.state.ids):
            return target.allowed(cls, text("No clips are shown: add a folder, or change the search"))
        return super().poll(context)

    def first_view(self, host: overlay.Overlay) -> View:
        """Return the stage."""
        return stage_view.StageView(host, {"ONE": 1, "FOUR": 4, "NINE": 9}[self.at_a_time])


CLASSES = (MOTION_THEATER_OT_library_browse, MOTION_THEATER_OT_library_play)
