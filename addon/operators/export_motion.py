"""Exporting the motion of an armature: as BVH, and as an Acclaim skeleton with its motion."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import bpy
from bpy.props import StringProperty
from bpy_extras.io_utils import ExportHelper

import motion_theater

from .. import exporting
from . import target
from .export_options import FrameOptions, SpaceOptions

if TYPE_CHECKING:
    from bpy.types import Context


class _ExportOptions(FrameOptions, SpaceOptions):
    """What both kinds of file have in common."""

    @classmethod
    def poll(cls, context: Context) -> bool:
        reason = "" if target.armature(context) else target.text("Select an armature first")
        return target.allowed(cls, reason)  # type: ignore[arg-type]

    def draw(self, context: Context) -> None:
        layout = self.layout  # type: ignore[attr-defined]
        layout.use_property_split = True
        layout.use_property_decorate = False
        self.draw_frames(layout)
        self.draw_space(layout)

    def carry_out(self, context: Context, *, keeps_axes: bool) -> set[str]:
        """Convert, write, and say what was written; on an error nothing is."""
        ob = target.armature(context)

        def convert() -> tuple[list[tuple[str, bytes]], list[str]]:
            start, end = self.span(context, ob)
            request = exporting.Request(start, end, self.rate_hz, self.up, self.unit_m(), keeps_axes)
            exported = exporting.convert(context, ob, request)
            files = self.files(exported)  # type: ignore[attr-defined]
            return files, [exporting.told([path for path, _ in files], exported), *exported.notices]

        return self.write(convert)


class MOTION_THEATER_OT_export_bvh(bpy.types.Operator, _ExportOptions, ExportHelper):  # type: ignore[misc]
    """Export the active armature and its motion as a BVH file"""

    bl_idname = "motion_theater.export_bvh"
    bl_label = "Export BVH"
    bl_options = {"REGISTER", "PRESET"}

    filename_ext = ".bvh"
    filter_glob: StringProperty(default="*.bvh", options={"HIDDEN"})

    def execute(self, context: Context) -> set[str]:
        return self.carry_out(context, keeps_axes=False)

    def files(self, exported: exporting.Exported) -> list[tuple[str, bytes]]:
        """Return what is written where."""
        return [(self.filepath, motion_theater.to_bvh(exported.skeleton, exported.motion))]


class MOTION_THEATER_OT_export_acclaim(bpy.types.Operator, _ExportOptions, ExportHelper):  # type: ignore[misc]
    """Export the motion of the active armature as an AMC file, and its skeleton as an ASF file of the same name"""

    bl_idname = "motion_theater.export_acclaim"
    bl_label = "Export Acclaim"
    bl_options = {"REGISTER", "PRESET"}

    filename_ext = ".amc"
    filter_glob: StringProperty(default="*.amc;*.asf", options={"HIDDEN"})

    def execute(self, context: Context) -> set[str]:
        return self.carry_out(context, keeps_axes=True)

    def files(self, exported: exporting.Exported) -> list[tuple[str, bytes]]:
        """Return what is written where."""
        asf, amc = motion_theater.to_acclaim(exported.skeleton, exported.motion)
        return [(str(Path(self.filepath).with_suffix(".asf")), asf), (self.filepath, amc)]


CLASSES = (MOTION_THEATER_OT_export_bvh, MOTION_THEATER_OT_export_acclaim)
