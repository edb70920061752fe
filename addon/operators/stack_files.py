"""The stack of an armature as a file that other armatures, and the command line, can take."""

from __future__ import annotations

from typing import TYPE_CHECKING

import bpy
from bpy.props import BoolProperty, StringProperty
from bpy_extras.io_utils import ExportHelper, ImportHelper

from .. import exporting, rig, stack, stack_files
from ..logic.messages import sentences
from ..translations import text
from . import outcome, target

if TYPE_CHECKING:
    from bpy.types import Context


class MOTION_THEATER_OT_stack_export(bpy.types.Operator, ExportHelper):  # type: ignore[misc]
    """Write the stack of the active armature as a small text file, TOML or, with that extension, JSON"""

    bl_idname = "motion_theater.stack_export"
    bl_label = "Export Stack"
    bl_options = {"REGISTER"}

    filename_ext = ".toml"
    check_extension = None  # the extension says which of the two
    filter_glob: StringProperty(default="*.toml;*.json", options={"HIDDEN"})

    @classmethod
    def poll(cls, context: Context) -> bool:
        ob = target.armature(context)
        reason = text("Select an armature first") if ob is None else ""
        if ob is not None and not stack.of(ob).entries:
            reason = text("Add a motion track first")
        return target.allowed(cls, reason)

    def execute(self, context: Context) -> set[str]:
        def export() -> str:
            path = self.filepath if self.filepath.lower().endswith((".toml", ".json")) else f"{self.filepath}.toml"
            files, told = stack_files.export(target.armature(context), context.scene, path)
            exporting.write(files)
            return sentences(told)

        return outcome.carry_out(self, context, export)

    def draw(self, context: Context) -> None:
        """Nothing to choose but the file."""


class MOTION_THEATER_OT_stack_import(bpy.types.Operator, ImportHelper):  # type: ignore[misc]
    """Put the entries of a stack file on the active armature. Without an armature the file's skeleton is imported"""

    bl_idname = "motion_theater.stack_import"
    bl_label = "Import Stack"
    bl_options = {"REGISTER", "UNDO"}

    filename_ext = ".toml"
    filter_glob: StringProperty(default="*.toml;*.json", options={"HIDDEN"})
    replace: BoolProperty(
        name="Replace Entries", description="Take away the entries that the armature has, instead of adding on top"
    )
    set_rate: BoolProperty(
        name="Set Scene Rate", description="Set the frame rate of the scene to the one that the stack was made for"
    )

    @classmethod
    def poll(cls, context: Context) -> bool:
        ob = target.armature(context)
        return target.allowed(cls, rig.writable_reason(ob) if ob is not None else "")

    def execute(self, context: Context) -> set[str]:
        ob = target.armature(context)
        return outcome.carry_out(
            self,
            context,
            lambda: stack_files.take(context, ob, self.filepath, instead=self.replace, set_rate=self.set_rate),
        )

    def draw(self, context: Context) -> None:
        layout = self.layout
        layout.use_property_split = True
        layout.use_property_decorate = False
        layout.prop(self, "replace")
        layout.prop(self, "set_rate")


CLASSES = (MOTION_THEATER_OT_stack_export, MOTION_THEATER_OT_stack_import)
