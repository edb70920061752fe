"""Filtering the motion of an armature, as an entry of its stack."""

from __future__ import annotations

from typing import TYPE_CHECKING

import bpy
from bpy.props import BoolProperty, EnumProperty, IntProperty, StringProperty

from .. import markers, properties, stack, tracks
from ..logic import names, plan
from ..logic.messages import UserError, filter_added, sentences
from ..translations import text
from . import outcome, target

if TYPE_CHECKING:
    from bpy.types import Context

LABELS = {identifier: label for identifier, label, _ in properties.FILTER_KINDS}


class MOTION_THEATER_OT_filter(bpy.types.Operator):
    """Filter the motion of the active armature. The filter becomes an entry of the stack, to be changed at any time"""

    bl_idname = "motion_theater.filter"
    bl_label = "Filter Motion"
    bl_options = {"REGISTER", "UNDO"}

    kind: EnumProperty(**properties.FILTER_KIND)
    depth: IntProperty(name="Depth", default=3, min=1, soft_min=3, **properties.DEPTH)
    channels: EnumProperty(**properties.FILTER_ON)
    selected_only: BoolProperty(name="Selected Bones Only", description="Filter the selected bones only")
    bone_collection: StringProperty(
        name="Bone Collection", description="Filter the bones of this collection only", options={"SKIP_SAVE"}
    )

    @classmethod
    def poll(cls, context: Context) -> bool:
        reason = target.armature_reason(context)
        if not reason and markers.is_set(target.armature(context)):
            reason = text("A marker set has gaps: use the filter of the panel Markers, which keeps them")
        return target.allowed(cls, reason)

    def execute(self, context: Context) -> set[str]:
        ob = target.armature(context)

        def add_filter() -> str:
            plan.check_depth(self.depth)
            animation = ob.animation_data
            if not stack.of(ob).entries and (animation is None or animation.action is None):
                raise UserError(f"“{ob.name}” has no motion to filter: add a motion track first")
            bones = tracks.chosen_bones(ob, selected_only=self.selected_only, bone_collection=self.bone_collection)
            entry = stack.add_entry(
                ob,
                "FILTER",
                name=LABELS[self.kind],
                all_bones=bones is None,
                bones=names.join(bones or ()),
                filter_kind=self.kind,
                filter_channels=self.channels,
                depth=self.depth,
            )
            count = len(ob.data.bones) if bones is None else len(bones)
            message = sentences([filter_added(LABELS[self.kind], self.depth, count), *names.split(entry.notices)])
            stack.of(ob).message = message
            return message

        return outcome.carry_out(self, context, add_filter)


CLASSES = (MOTION_THEATER_OT_filter,)
