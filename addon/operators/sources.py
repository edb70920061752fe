"""Operators for the files that tracks come from: find a moved one, keep them inside the .blend, write them out."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import bpy
from bpy_extras.io_utils import ImportHelper

from .. import relinking, sources, stack
from ..translations import text
from . import target

if TYPE_CHECKING:
    from bpy.types import Context, Event, Object

    from ..properties import MotionEntry


def _tracks(ob: Object, *, packed: bool) -> list[MotionEntry]:
    """Return the tracks whose source is packed, or is not."""
    return [entry for entry in stack.of(ob).entries if entry.kind == "TRACK" and bool(entry.packed_key) is packed]


class MOTION_THEATER_OT_relink_source(bpy.types.Operator, ImportHelper):
    """Choose the file of the active track, if it was moved or renamed"""

    bl_idname = "motion_theater.relink_source"
    bl_label = "Relink Source"
    bl_options = {"REGISTER", "UNDO"}

    filename_ext = ".amc"
    filter_glob: bpy.props.StringProperty(default="*.amc;*.bvh", options={"HIDDEN"})

    @classmethod
    def poll(cls, context: Context) -> bool:
        return target.allowed(cls, target.track_reason(context))

    def invoke(self, context: Context, event: Event) -> set[str]:
        if not self.properties.is_property_set("filepath"):
            ob = target.armature(context)
            self.properties.filepath = sources.absolute(ob, target.entry(ob).source)
        return ImportHelper.invoke(self, context, event)

    def execute(self, context: Context) -> set[str]:
        def relink(ob: Object) -> str:
            entry = target.entry(ob)
            relinking.relink(ob, entry, self.filepath)
            return text("“{name}” now comes from {file}", name=entry.name, file=Path(self.filepath).name)

        return target.carry_out(self, context, relink)

    def draw(self, context: Context) -> None:
        """Nothing to choose but the file."""


class MOTION_THEATER_OT_pack_sources(bpy.types.Operator):
    """Store the files of all tracks inside the .blend, so that it can be moved without them"""

    bl_idname = "motion_theater.pack_sources"
    bl_label = "Pack Sources"
    bl_options = {"REGISTER", "UNDO"}

    @classmethod
    def poll(cls, context: Context) -> bool:
        reason = target.stack_reason(context)
        if not reason and not _tracks(target.armature(context), packed=False):
            reason = text("All sources are packed already")
        return target.allowed(cls, reason)

    def execute(self, context: Context) -> set[str]:
        def pack(ob: Object) -> str:
            tracks = _tracks(ob, packed=False)
            for entry in tracks:
                sources.load(ob, entry)  # all can be read, or none is packed
            for entry in tracks:
                sources.pack(ob, entry)
            return text("Packed the sources of {count} tracks into the .blend", count=len(tracks))

        return target.carry_out(self, context, pack)


class MOTION_THEATER_OT_unpack_sources(bpy.types.Operator):
    """Write the packed files of all tracks into a folder, and use them from there"""

    bl_idname = "motion_theater.unpack_sources"
    bl_label = "Unpack Sources"
    bl_options = {"REGISTER", "UNDO"}

    directory: bpy.props.StringProperty(
        name="Folder",
        description="Folder into which the files are written",
        subtype="DIR_PATH",
        options={"SKIP_SAVE"},
    )
    filter_folder: bpy.props.BoolProperty(default=True, options={"HIDDEN"})

    @classmethod
    def poll(cls, context: Context) -> bool:
        reason = target.stack_reason(context)
        if not reason and not _tracks(target.armature(context), packed=True):
            reason = text("No source is packed")
        return target.allowed(cls, reason)

    def invoke(self, context: Context, event: Event) -> set[str]:
        context.window_manager.fileselect_add(self)
        return {"RUNNING_MODAL"}

    def execute(self, context: Context) -> set[str]:
        def unpack(ob: Object) -> str:
            tracks = _tracks(ob, packed=True)
            packed = stack.of(ob).packed
            for entry in tracks:
                relinking.unpack(ob, entry, str(Path(self.directory) / packed[entry.packed_key].filename))
            return text("Wrote the sources of {count} tracks to {folder}", count=len(tracks), folder=self.directory)

        return target.carry_out(self, context, unpack)

    def draw(self, context: Context) -> None:
        """Nothing to choose but the folder."""


CLASSES = (MOTION_THEATER_OT_relink_source, MOTION_THEATER_OT_pack_sources, MOTION_THEATER_OT_unpack_sources)
