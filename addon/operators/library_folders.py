"""The folders of the library, and scanning them."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import bpy
from bpy.props import StringProperty

from ..library import scanning, session, work
from ..logic.messages import base_name
from ..translations import text
from . import target

if TYPE_CHECKING:
    from bpy.types import Context, Event

TICK_S = 0.1


class MOTION_THEATER_OT_library_folder_add(bpy.types.Operator):
    """Add a folder with motion capture to the library, and look for clips in it and in all folders below"""

    bl_idname = "motion_theater.library_folder_add"
    bl_label = "Add Folder"
    bl_options = {"REGISTER"}

    directory: StringProperty(name="Folder", description="The folder to look for clips in", subtype="DIR_PATH")

    def invoke(self, context: Context, event: Event) -> set[str]:
        context.window_manager.fileselect_add(self)
        return {"RUNNING_MODAL"}

    def execute(self, context: Context) -> set[str]:
        folder = bpy.path.abspath(self.directory)
        if not self.directory or not Path(folder).is_dir():
            self.report({"ERROR"}, text("{folder} is no folder", folder=folder or text("Nothing")))
            return {"CANCELLED"}
        folder = str(Path(folder))
        session.ensure_open()
        session.change(lambda: session.library().add_folder(folder))
        return set(bpy.ops.motion_theater.library_scan("INVOKE_DEFAULT", folder=folder))


class MOTION_THEATER_OT_library_folder_remove(bpy.types.Operator):
    """Take a folder out of the library. Its files stay where they are; what was noted of them in the library goes"""

    bl_idname = "motion_theater.library_folder_remove"
    bl_label = "Remove Folder"
    bl_options = {"REGISTER"}

    folder: StringProperty(name="Folder", description="The folder to take out", options={"SKIP_SAVE"})

    def invoke(self, context: Context, event: Event) -> set[str]:
        return set(context.window_manager.invoke_confirm(self, event))

    def execute(self, context: Context) -> set[str]:
        if not self.folder:
            self.report({"ERROR"}, text("No folder was named"))
            return {"CANCELLED"}
        folder = self.folder
        said = text("Took {name} out of the library", name=base_name(folder))
        session.change(lambda: session.library().remove_folder(folder), said)
        return _finish()


class MOTION_THEATER_OT_library_scan(bpy.types.Operator):
    """Look for new, changed, moved and missing clips in the folders. Esc stops, and what was found is kept"""

    bl_idname = "motion_theater.library_scan"
    bl_label = "Rescan"
    bl_options = {"REGISTER"}

    folder: StringProperty(
        name="Folder", description="The folder to scan. Empty scans all of the library", options={"SKIP_SAVE"}
    )

    @classmethod
    def poll(cls, context: Context) -> bool:
        return target.allowed(cls, text("A scan is running") if scanning.is_running() else "")

    def invoke(self, context: Context, event: Event) -> set[str]:
        if bpy.app.background or context.window is None:
            return self.execute(context)
        scanning.start(self._folders())
        manager = context.window_manager
        manager.progress_begin(0, 100)
        self._timer = manager.event_timer_add(TICK_S, window=context.window)
        manager.modal_handler_add(self)
        return {"RUNNING_MODAL"}

    def execute(self, context: Context) -> set[str]:
        scanning.start(self._folders())
        work.wait(timeout_s=24 * 3600.0)
        return _told(self)

    def modal(self, context: Context, event: Event) -> set[str]:
        """Show how far the scan is, and stop it at Esc."""
        if not scanning.is_running():
            self._put_away(context)
            return _told(self)
        if event.type == "ESC" and event.value == "PRESS":
            scanning.stop()
            return {"RUNNING_MODAL"}
        if event.type == "TIMER":
            share, words = scanning.progress()
            context.window_manager.progress_update(int(100 * share))
            context.workspace.status_text_set(text("{doing}. Esc stops; what was found is kept", doing=words))
        return {"PASS_THROUGH"}

    def cancel(self, context: Context) -> None:
        """Tidy up where Blender itself ends the operator; the scan goes on."""
        self._put_away(context)

    def _folders(self) -> list[str] | None:
        return [self.folder] if self.folder else None

    def _put_away(self, context: Context) -> None:
        manager = context.window_manager
        manager.event_timer_remove(self._timer)
        manager.progress_end()
        if context.workspace is not None:
            context.workspace.status_text_set(None)


class MOTION_THEATER_OT_library_scan_stop(bpy.types.Operator):
    """Stop the scan; what was found is kept"""

    bl_idname = "motion_theater.library_scan_stop"
    bl_label = "Stop Scan"
    bl_options = {"REGISTER"}

    @classmethod
    def poll(cls, context: Context) -> bool:
        return target.allowed(cls, "" if scanning.is_running() else text("No scan is running"))

    def execute(self, context: Context) -> set[str]:
        scanning.stop()
        return {"FINISHED"}


def _finish() -> set[str]:
    """Let a script go on only when the library says what was asked for; a window shows it as it comes."""
    if bpy.app.background:
        work.wait()
    return {"FINISHED"}


def _told(operator: bpy.types.Operator) -> set[str]:
    message = session.state.message
    operator.report({"INFO"}, message or text("Scanned"))
    return {"FINISHED"}


CLASSES = (
    MOTION_THEATER_OT_library_folder_add,
    MOTION_THEATER_OT_library_folder_remove,
    MOTION_THEATER_OT_library_scan,
    MOTION_THEATER_OT_library_scan_stop,
)
