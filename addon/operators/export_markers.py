"""Exporting marker sets, the joints of armatures, and objects as recordings of markers."""

from __future__ import annotations

from typing import TYPE_CHECKING

import bpy
from bpy.props import BoolProperty, EnumProperty, StringProperty
from bpy_extras.io_utils import ExportHelper

from .. import markers
from ..markers import exporting
from ..translations import text
from . import target
from .export_options import FrameOptions, SpaceOptions

if TYPE_CHECKING:
    from collections.abc import Sequence

    from bpy.types import Context, Object

JOINTS = (
    ("HEADS", "Heads", "Where each bone begins, and where the last one of a chain ends"),
    ("TAILS", "Tails", "Where each bone ends, as Acclaim files name their joints"),
)


class _MarkerOptions(FrameOptions):
    """What all kinds of file have in common."""

    joints: EnumProperty(name="Joints", description="Which points of an armature's bones are written", items=JOINTS)
    selected_only: BoolProperty(
        name="Selected Bones Only", description="Write the selected markers, or the joints of the selected bones, only"
    )

    @classmethod
    def poll(cls, context: Context) -> bool:
        reason = "" if _source(context) else text("Select a marker set, an armature or objects first")
        return target.allowed(cls, reason)  # type: ignore[arg-type]

    def draw(self, context: Context) -> None:
        layout = self.layout  # type: ignore[attr-defined]
        layout.use_property_split = True
        layout.use_property_decorate = False
        source = _source(context)
        self.draw_frames(layout)
        if isinstance(self, SpaceOptions):
            self.draw_space(layout)
        column = layout.column(align=True)
        if isinstance(source, bpy.types.Object):
            if not markers.is_set(source):
                column.prop(self, "joints")
            column.prop(self, "selected_only")
        if hasattr(self, "with_events"):
            column.prop(self, "with_events")
            if isinstance(source, bpy.types.Object) and markers.is_set(source):
                column.prop(self, "with_analog")

    def carry_out(self, context: Context, kind: exporting.Kind) -> set[str]:
        """Convert, write, and say what was written; on an error nothing is."""

        def convert() -> tuple[list[tuple[str, bytes]], list[str]]:
            source = _source(context)
            start, end = self.span(context, source if isinstance(source, bpy.types.Object) else None)
            request = exporting.Request(
                kind,
                start,
                end,
                self.rate_hz,
                getattr(self, "up", "AUTO"),
                self.unit_m() if isinstance(self, SpaceOptions) else 0.0,
                self.joints,
                self.selected_only,
                getattr(self, "with_events", True),
                getattr(self, "with_analog", True),
            )
            recording = exporting.record(context, source, request)
            path = self.filepath  # type: ignore[attr-defined]
            return [(path, recording.markers.to_bytes(kind))], [recording.told(path), *recording.notices]

        return self.write(convert)


def _source(context: Context) -> Object | Sequence[Object]:
    """Return what is exported: the marker set or armature that the sidebar shows, else all selected objects."""
    return markers.set_of(context) or target.armature(context) or list(context.selected_objects)


class MOTION_THEATER_OT_export_c3d(bpy.types.Operator, _MarkerOptions, SpaceOptions, ExportHelper):  # type: ignore[misc]
    """Export a marker set, the joints of an armature, or the places of objects as a C3D file"""

    bl_idname = "motion_theater.export_c3d"
    bl_label = "Export C3D"
    bl_options = {"REGISTER", "PRESET"}

    filename_ext = ".c3d"
    filter_glob: StringProperty(default="*.c3d", options={"HIDDEN"})
    with_events: BoolProperty(
        name="Events", description="Write the markers of the timeline as events of the file", default=True
    )
    with_analog: BoolProperty(
        name="Analog Channels",
        description="Write the animated custom properties of a marker set as analog channels",
        default=True,
    )

    def execute(self, context: Context) -> set[str]:
        return self.carry_out(context, "c3d")


class MOTION_THEATER_OT_export_csm(bpy.types.Operator, _MarkerOptions, ExportHelper):  # type: ignore[misc]
    """Export a marker set, the joints of an armature, or the places of objects as a CSM file"""

    bl_idname = "motion_theater.export_csm"
    bl_label = "Export CSM"
    bl_options = {"REGISTER", "PRESET"}

    filename_ext = ".csm"
    filter_glob: StringProperty(default="*.csm", options={"HIDDEN"})

    def execute(self, context: Context) -> set[str]:
        return self.carry_out(context, "csm")


class MOTION_THEATER_OT_export_trc(bpy.types.Operator, _MarkerOptions, SpaceOptions, ExportHelper):  # type: ignore[misc]
    """Export a marker set, the joints of an armature, or the places of objects as a TRC file"""

    bl_idname = "motion_theater.export_trc"
    bl_label = "Export TRC"
    bl_options = {"REGISTER", "PRESET"}

    filename_ext = ".trc"
    filter_glob: StringProperty(default="*.trc", options={"HIDDEN"})

    def execute(self, context: Context) -> set[str]:
        return self.carry_out(context, "trc")


CLASSES = (MOTION_THEATER_OT_export_c3d, MOTION_THEATER_OT_export_csm, MOTION_THEATER_OT_export_trc)
