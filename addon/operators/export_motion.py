"""Exporting the motion of an armature: as BVH, and as an Acclaim skeleton with its motion."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import bpy
from bpy.props import EnumProperty, FloatProperty, IntProperty, StringProperty
from bpy_extras.io_utils import ExportHelper

import motion_theater

from .. import exporting, properties
from ..logic.messages import explained, sentences
from . import target

if TYPE_CHECKING:
    from bpy.types import Context, Object

RANGES = (
    ("ACTION", "Action", "All frames of the action; those of the scene where there is none"),
    ("SCENE", "Scene", "The frame range of the scene"),
    ("CUSTOM", "Custom", "The frames given below"),
)
UNITS = (
    ("AUTO", "Automatic", "The unit of the file that the armature came from; centimeters for any other"),
    ("0.01", "Centimeters", "One unit of the file is a centimeter"),
    ("1", "Meters", "One unit of the file is a meter"),
    ("0.001", "Millimeters", "One unit of the file is a millimeter"),
    ("0.0254", "Inches", "One unit of the file is an inch"),
)


class _ExportOptions:
    """What both kinds of file have in common."""

    range: EnumProperty(name="Range", description="Which frames are written", items=RANGES)
    frame_start: IntProperty(
        name="Start",
        description="The first frame of a custom range",
        default=1,
        min=-properties.FRAME_LIMIT,
        max=properties.FRAME_LIMIT,
    )
    frame_end: IntProperty(
        name="End",
        description="The last frame of a custom range",
        default=250,
        min=-properties.FRAME_LIMIT,
        max=properties.FRAME_LIMIT,
    )
    rate_hz: FloatProperty(
        name="Rate",
        description="Frames per second of the file. Zero takes the rate of the scene",
        min=0.0,
        soft_max=1000.0,
    )
    up: EnumProperty(
        name="Up",
        description="The axis of the file that points up",
        items=(
            ("AUTO", "Automatic", "The axis of the file that the armature came from; Y for any other"),
            *properties.UP_AXES,
        ),
        default="AUTO",
    )
    unit: EnumProperty(name="Length Unit", description="How long a unit of the file is", items=UNITS)

    @classmethod
    def poll(cls, context: Context) -> bool:
        reason = "" if target.armature(context) else target.text("Select an armature first")
        return target.allowed(cls, reason)  # type: ignore[arg-type]

    def draw(self, context: Context) -> None:
        layout = self.layout  # type: ignore[attr-defined]
        layout.use_property_split = True
        layout.use_property_decorate = False
        column = layout.column(align=True)
        column.prop(self, "range")
        if self.range == "CUSTOM":
            column.prop(self, "frame_start")
            column.prop(self, "frame_end")
        column.prop(self, "rate_hz")
        column = layout.column(align=True)
        column.prop(self, "up")
        column.prop(self, "unit")

    def request(self, context: Context, ob: Object, *, keeps_axes: bool) -> exporting.Request:
        """Return the options as plain values."""
        scene = context.scene
        start, end = float(scene.frame_start), float(scene.frame_end)
        action = ob.animation_data.action if ob.animation_data else None
        if self.range == "CUSTOM":
            start, end = float(self.frame_start), float(self.frame_end)
        elif self.range == "ACTION" and action is not None:
            start, end = (float(frame) for frame in action.frame_range)
        unit_m = 0.0 if self.unit == "AUTO" else float(self.unit)
        return exporting.Request(start, end, self.rate_hz, self.up, unit_m, keeps_axes)

    def carry_out(self, context: Context, *, keeps_axes: bool) -> set[str]:
        """Convert, write, and say what was written; on an error nothing is."""
        ob = target.armature(context)
        try:
            exported = exporting.convert(context, ob, self.request(context, ob, keeps_axes=keeps_axes))
            files = self.files(exported)  # type: ignore[attr-defined]
            exporting.write(files)
        except Exception as error:
            text = explained(error)
            if text is None:
                raise
            self.report({"ERROR"}, text)  # type: ignore[attr-defined]
            return {"CANCELLED"}
        message = sentences([exporting.told([path for path, _ in files], exported), *exported.notices])
        self.report({"INFO"}, message)  # type: ignore[attr-defined]
        return {"FINISHED"}


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
