"""Importing a skeleton (ASF, BVH) as an armature in its setup pose."""

from __future__ import annotations

from typing import TYPE_CHECKING

import bpy
from bpy.props import BoolProperty, EnumProperty, StringProperty
from bpy_extras.io_utils import ImportHelper

from .. import skeletons, sources, stack
from ..logic.messages import sentences
from ..properties import BONE_STYLES, FORWARD_AXES, UP_AXES
from . import import_file, outcome

if TYPE_CHECKING:
    from bpy.types import Context, Event


class MOTION_THEATER_OT_import_skeleton(bpy.types.Operator, import_file.SizeOption, ImportHelper):
    """Import the skeleton of an ASF or BVH file as an armature in its setup pose"""

    bl_idname = "motion_theater.import_skeleton"
    bl_label = "Import Skeleton"
    bl_options = {"REGISTER", "UNDO", "PRESET"}

    filename_ext = ".asf"
    filepath: import_file.path()
    filter_glob: StringProperty(default="*.asf;*.bvh", options={"HIDDEN"})
    up: EnumProperty(
        name="Up",
        description="The axis of the file that points up",
        items=(("AUTO", "Automatic", "Take the axis along which the skeleton stands"), *UP_AXES),
        default="AUTO",
    )
    forward: EnumProperty(
        name="Forward",
        description="The axis of the file along which the figure looks, in its rest pose where it has one",
        items=FORWARD_AXES,
    )
    bone_style: EnumProperty(name="Bones", description="How the bones are oriented", items=BONE_STYLES)
    limits_as_constraints: BoolProperty(
        name="Limits as Constraints",
        description="Add the limits of the file as Limit Rotation constraints. Recorded motion beyond them is cut off",
        default=False,
    )

    def invoke(self, context: Context, event: Event) -> set[str]:
        return import_file.ask(self, context)

    def execute(self, context: Context) -> set[str]:
        def import_skeleton() -> str:
            ob, told = skeletons.import_skeleton(
                context,
                sources.read_file(self.filepath),
                scale=self.scale,
                up=self.up,
                forward=self.forward,
                bone_style=self.bone_style,
                limits_as_constraints=self.limits_as_constraints,
            )
            message = sentences(told)
            stack.of(ob).message = message
            return message

        return outcome.carry_out(self, context, import_skeleton)

    def draw(self, context: Context) -> None:
        layout = self.layout
        layout.use_property_split = True
        layout.use_property_decorate = False
        layout.prop(self, "scale")
        layout.prop(self, "up")
        layout.prop(self, "forward")
        layout.prop(self, "bone_style")
        limits = layout.column()
        limits.active = self.bone_style == "AXES"  # the limits are numbers about the file's axes
        limits.prop(self, "limits_as_constraints")


CLASSES = (MOTION_THEATER_OT_import_skeleton,)
