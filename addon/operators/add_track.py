"""Adding a motion file to an armature, as a track on top of its stack."""

from __future__ import annotations

from typing import TYPE_CHECKING

import bpy
from bpy.props import BoolProperty, EnumProperty, IntProperty, StringProperty
from bpy_extras.io_utils import ImportHelper

from .. import properties, tracks
from ..logic import recipes
from . import import_file, outcome, target

if TYPE_CHECKING:
    from bpy.types import Context, Event, UILayout

SETTINGS = tuple(name for name in recipes.TRACK_SETTINGS if name != "keys")  # which follow from the rate
"""Options that become settings of the entry, under the same names."""


def _frame(texts: tuple[str, str], low: int = -properties.FRAME_LIMIT) -> object:
    name, description = texts
    return IntProperty(name=name, description=description, min=low, max=properties.FRAME_LIMIT)


class MOTION_THEATER_OT_add_track(bpy.types.Operator, import_file.RateOptions, ImportHelper):
    """Add a motion file as a track to the active armature. Without a fitting armature its skeleton is imported first"""

    bl_idname = "motion_theater.add_track"
    bl_label = "Add Motion Track"
    bl_options = {"REGISTER", "UNDO", "PRESET"}

    filename_ext = ".amc"
    filepath: import_file.path()
    filter_glob: StringProperty(default="*.amc;*.bvh", options={"HIDDEN"})
    skeleton: StringProperty(
        name="Skeleton",
        description="The skeleton file of this motion, where it is not that of the armature. Empty looks for it",
        subtype="FILE_PATH",
        options={"SKIP_SAVE"},
    )
    selected_only: BoolProperty(name="Selected Bones Only", description="Add motion to the selected bones only")
    bone_collection: StringProperty(
        name="Bone Collection", description="Add motion to the bones of this collection only", options={"SKIP_SAVE"}
    )
    cut_start: _frame(properties.CUT_START)
    cut_end: _frame(properties.CUT_END)
    scale_start: _frame(properties.SCALE_START)
    scale_end: _frame(properties.SCALE_END)
    blend_depth: _frame(properties.BLEND_DEPTH, low=0)
    preserve: BoolProperty(**properties.PRESERVE)
    preserve_rotation: EnumProperty(**properties.PRESERVE_ROTATION)
    preserve_height: BoolProperty(**properties.PRESERVE_HEIGHT)
    discard: BoolProperty(**properties.DISCARD)
    blend: EnumProperty(**properties.BLEND)
    sampling: EnumProperty(**properties.SAMPLING)

    def invoke(self, context: Context, event: Event) -> set[str]:
        return import_file.ask(self, context)

    def execute(self, context: Context) -> set[str]:
        request = tracks.Request(
            path=self.filepath,
            skeleton=bpy.path.abspath(self.skeleton) if self.skeleton else "",
            selected_only=self.selected_only,
            bone_collection=self.bone_collection,
            rate=self.rate,
            scene_range=self.scene_range,
            settings={name: getattr(self, name) for name in SETTINGS},
        )
        ob = target.armature(context)
        return outcome.carry_out(self, context, lambda: tracks.add_track(context, ob, request))

    def draw(self, context: Context) -> None:
        layout = self.layout
        layout.use_property_split = True
        layout.use_property_decorate = False
        layout.prop(self, "selected_only")
        _draw_group(layout, self, "cut_start", "cut_end")
        _draw_group(layout, self, "scale_start", "scale_end")
        _draw_group(layout, self, "blend_depth", "blend", "discard")
        _draw_group(layout, self, "preserve")
        if self.preserve:
            _draw_group(layout, self, "preserve_rotation", "preserve_height")
        _draw_group(layout, self, "rate", "rate_hz", "sampling", "scene_range")


def _draw_group(layout: UILayout, operator: bpy.types.Operator, *names: str) -> None:
    column = layout.column(align=True)
    for name in names:
        column.prop(operator, name)


CLASSES = (MOTION_THEATER_OT_add_track,)
