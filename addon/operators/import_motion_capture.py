"""Importing motion capture of every kind: one file or many, from the menu or dropped into the 3D View."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import bpy
from bpy.props import BoolProperty, CollectionProperty, EnumProperty, StringProperty
from bpy_extras.io_utils import ImportHelper

from .. import capture, properties
from ..logic.batch import files, short
from ..translations import text
from . import import_file, target

if TYPE_CHECKING:
    from bpy.types import Context, Event

EXTENSIONS = (".bvh", ".asf", ".amc", ".c3d", ".csm", ".trc")
TARGETS = (
    (
        "AUTO",
        "Automatic",
        "Add a single AMC to the active armature where it fits; give everything else an armature of its own",
    ),
    ("ACTIVE", "Active Armature", "Add motion to the active armature where it fits, as tracks"),
    ("NEW", "New Armature", "Give every motion an armature of its own"),
)
SHOWN_LINES = 20


class MOTION_THEATER_OT_import_motion_capture(
    bpy.types.Operator, import_file.SizeOption, import_file.RateOptions, ImportHelper
):
    """Import motion capture files of any kind. Of many files, Esc stops after the current one"""

    bl_idname = "motion_theater.import_motion_capture"
    bl_label = "Import Motion Capture"
    bl_options = {"REGISTER", "UNDO", "PRESET"}

    filepath: import_file.path()
    directory: StringProperty(subtype="DIR_PATH", options={"HIDDEN", "SKIP_SAVE", "SKIP_PRESET"})
    files: CollectionProperty(type=bpy.types.OperatorFileListElement, options={"HIDDEN", "SKIP_SAVE", "SKIP_PRESET"})
    filter_glob: StringProperty(default=";".join(f"*{name}" for name in EXTENSIONS), options={"HIDDEN"})
    target: EnumProperty(name="Add To", description="Which armature gets the motion", items=TARGETS)
    up: EnumProperty(
        name="Up",
        description="The axis of the file that points up",
        items=(("AUTO", "Automatic", "Take the axis along which the figure stands"), *properties.UP_AXES),
        default="AUTO",
    )
    forward: EnumProperty(
        name="Forward",
        description="The axis of the file along which the figure looks, in its rest pose where it has one",
        items=properties.FORWARD_AXES,
    )
    bone_style: EnumProperty(name="Bones", description="How the bones are oriented", items=properties.BONE_STYLES)
    with_lines: BoolProperty(
        name="Lines", description="Draw lines between markers whose distance stays nearly the same", default=False
    )
    with_events: BoolProperty(name="Events", description="Make markers of the timeline from events", default=False)
    with_analog: BoolProperty(
        name="Analog Channels", description="Keep analog channels as custom properties with F-curves", default=False
    )

    _is_asked = False
    _is_announced = False

    def invoke(self, context: Context, event: Event) -> set[str]:
        self._is_asked = True
        if self.files and self.directory:  # dropped
            import_file.preferred(self, context)
            return set(context.window_manager.invoke_props_dialog(self))
        return import_file.ask(self, context)

    def execute(self, context: Context) -> set[str]:
        self._batch = capture.Batch(self._paths(), self._options(), target.armature(context))
        if not self._batch.count:
            self.report({"ERROR"}, "No file was chosen")
            return {"CANCELLED"}
        is_in_window = self._is_asked and not self.options.is_repeat and context.window is not None
        if self._batch.count > 1 and is_in_window:
            return self._begin(context)
        while self._batch.left:
            self._batch.step(context)
        return self._told(context)

    def modal(self, context: Context, event: Event) -> set[str]:
        """Import one file per tick of the timer, after its name was shown."""
        if event.type == "ESC" and event.value == "PRESS":
            self._batch.stop()
        elif event.type != "TIMER":
            return {"RUNNING_MODAL"}
        elif self._batch.left and self._is_announced:
            self._batch.step(context)
            self._is_announced = False
        if self._batch.left:
            self._announce(context)
            return {"RUNNING_MODAL"}
        return self._end(context)

    def cancel(self, context: Context) -> None:
        """Tidy up where Blender itself ends the import."""
        if hasattr(self, "_timer"):
            self._put_away(context)

    def draw(self, context: Context) -> None:
        layout = self.layout
        layout.use_property_split = True
        layout.use_property_decorate = False
        for group in (
            ("target",),
            ("scale", "up", "forward", "bone_style"),
            ("rate", "rate_hz", "scene_range"),
            ("with_lines", "with_events", "with_analog"),
        ):
            column = layout.column(align=True, heading="Markers" if "with_lines" in group else "")
            for name in group:
                column.prop(self, name)

    def _paths(self) -> list[str]:
        named = [str(Path(self.directory) / item.name) for item in self.files if item.name]
        return list(dict.fromkeys(named or ([self.filepath] if self.filepath else [])))

    def _options(self) -> capture.Options:
        return capture.Options(**{name: getattr(self, name) for name in capture.Options.__dataclass_fields__})

    def _begin(self, context: Context) -> set[str]:
        manager = context.window_manager
        manager.progress_begin(0, self._batch.count)
        self._timer = manager.event_timer_add(0.01, window=context.window)
        manager.modal_handler_add(self)
        self._announce(context)
        return {"RUNNING_MODAL"}

    def _announce(self, context: Context) -> None:
        """Show the name of the file that comes next; Blender draws it before the next tick."""
        if self._is_announced:
            return
        number = self._batch.count - self._batch.left + 1
        message = text(
            "Importing {name} ({number} of {count}). Esc stops after it",
            name=self._batch.next_name,
            number=number,
            count=self._batch.count,
        )
        context.workspace.status_text_set(message)
        context.window_manager.progress_update(number)
        self._is_announced = True

    def _end(self, context: Context) -> set[str]:
        self._put_away(context)
        verdicts = self._batch.verdicts
        lines = [*verdicts.skipped, *verdicts.done]

        def draw(popup: bpy.types.UIPopupMenu, _: Context) -> None:
            for number, line in enumerate(lines[:SHOWN_LINES]):
                is_skipped = number < len(verdicts.skipped)
                popup.layout.label(text=short(line), icon="ERROR" if is_skipped else "CHECKMARK", translate=False)
            if len(lines) > SHOWN_LINES:
                popup.layout.label(text=text("{files} more, see the Info Log", files=files(len(lines) - SHOWN_LINES)))

        context.window_manager.popup_menu(draw, title=verdicts.counts(), icon="INFO")
        return self._told(context)

    def _put_away(self, context: Context) -> None:
        manager = context.window_manager
        manager.event_timer_remove(self._timer)
        manager.progress_end()
        context.workspace.status_text_set(None)
        del self._timer

    def _told(self, context: Context) -> set[str]:
        """Report each file and then all of them; where none came in, that is an error."""
        verdicts = self._batch.verdicts
        summary = verdicts.summary()
        if not verdicts.done:
            self.report({"ERROR"}, verdicts.skipped[0] if len(verdicts.skipped) == 1 else summary)
            return {"CANCELLED"}
        if self._batch.count > 1:
            for line in verdicts.done:
                self.report({"INFO"}, line)
            for line in verdicts.skipped:
                self.report({"WARNING"}, line)
        self.report({"WARNING" if verdicts.skipped else "INFO"}, summary)
        return {"FINISHED"}


CLASSES = (MOTION_THEATER_OT_import_motion_capture,)
