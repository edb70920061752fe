"""Importing a recording of markers as a marker set."""

from __future__ import annotations

from typing import TYPE_CHECKING

import bpy
from bpy.props import BoolProperty, EnumProperty, StringProperty
from bpy_extras.io_utils import ImportHelper

from .. import markers, properties, sources
from . import import_file, outcome

if TYPE_CHECKING:
    from bpy.types import Context, Event

UP_AXES = (
    ("AUTO", "Automatic", "Take what the file says, or the axis along which the figure stands"),
    *properties.UP_AXES,
    ("-X", "-X", "The X axis of the file points down"),
    ("-Y", "-Y", "The Y axis of the file points down"),
    ("-Z", "-Z", "The Z axis of the file points down"),
)
GROUPS = (("scale", "up", "forward"), ("rate", "rate_hz", "scene_range"), ("with_lines", "with_events", "with_analog"))
"""What stands together in the dialog."""


class MOTION_THEATER_OT_import_markers(
    bpy.types.Operator, import_file.SizeOption, import_file.RateOptions, ImportHelper
):
    """Import recorded markers as one armature with a bone for each marker"""

    bl_idname = "motion_theater.import_markers"
    bl_label = "Import Markers"
    bl_options = {"REGISTER", "UNDO", "PRESET"}

    filename_ext = ".c3d"
    filepath: import_file.path()
    filter_glob: StringProperty(default="*.c3d;*.csm;*.trc", options={"HIDDEN"})
    up: EnumProperty(name="Up", description="The axis of the file that points up", items=UP_AXES, default="AUTO")
    forward: EnumProperty(
        name="Forward",
        description="The axis of the file along which the figure looks",
        items=properties.FORWARD_AXES,
    )
    with_lines: BoolProperty(
        name="Lines", description="Draw lines between neighboring markers that keep their distance", default=False
    )
    with_events: BoolProperty(
        name="Events", description="Add the events of the file to the timeline as markers", default=False
    )
    with_analog: BoolProperty(
        name="Analog Channels",
        description="Add the analog channels of the file as animated custom properties",
        default=False,
    )

    def invoke(self, context: Context, event: Event) -> set[str]:
        return import_file.ask(self, context)

    def execute(self, context: Context) -> set[str]:
        def import_markers() -> str:
            return markers.import_markers(
                context,
                sources.read_file(self.filepath).clip,
                rate=self.rate,
                rate_hz=self.rate_hz,
                scene_range=self.scene_range,
                scale=self.scale,
                up=self.up,
                forward=self.forward,
                with_lines=self.with_lines,
                with_events=self.with_events,
                with_analog=self.with_analog,
            )

        return outcome.carry_out(self, context, import_markers)

    def draw(self, context: Context) -> None:
        layout = self.layout
        layout.use_property_split = True
        layout.use_property_decorate = False
        for names in GROUPS:
            column = layout.column(align=True)
            for name in names:
                column.prop(self, name)


CLASSES = (MOTION_THEATER_OT_import_markers,)
