"""Operators on the entries of the stack: duplicate, remove, move, and the bones of one entry."""

from __future__ import annotations

from typing import TYPE_CHECKING

import bpy

from .. import compat, rig, stack
from ..logic import names
from ..logic.messages import bones
from ..translations import text
from . import target

if TYPE_CHECKING:
    from bpy.types import Context, Object


class MOTION_THEATER_OT_entry_duplicate(bpy.types.Operator):
    """Put a copy of the active entry above it in the stack"""

    bl_idname = "motion_theater.entry_duplicate"
    bl_label = "Duplicate Entry"
    bl_options = {"REGISTER", "UNDO"}

    @classmethod
    def poll(cls, context: Context) -> bool:
        return target.allowed(cls, target.entry_reason(context))

    def execute(self, context: Context) -> set[str]:
        def duplicate(ob: Object) -> str:
            name = target.entry(ob).name
            stack.duplicate_entry(ob, stack.of(ob).active)
            return text("Duplicated “{name}”", name=name)

        return target.carry_out(self, context, duplicate)


class MOTION_THEATER_OT_entry_remove(bpy.types.Operator):
    """Take the active entry out of the stack. The motion becomes what it would be without it"""

    bl_idname = "motion_theater.entry_remove"
    bl_label = "Remove Entry"
    bl_options = {"REGISTER", "UNDO"}

    @classmethod
    def poll(cls, context: Context) -> bool:
        return target.allowed(cls, target.entry_reason(context))

    def execute(self, context: Context) -> set[str]:
        def remove(ob: Object) -> str:
            name = target.entry(ob).name
            stack.remove_entry(ob, stack.of(ob).active)
            return text("Removed “{name}”", name=name)

        return target.carry_out(self, context, remove)


class MOTION_THEATER_OT_entry_move(bpy.types.Operator):
    """Move the active entry in the stack. Entries are applied from the bottom to the top"""

    bl_idname = "motion_theater.entry_move"
    bl_label = "Move Entry"
    bl_options = {"REGISTER", "UNDO"}

    direction: bpy.props.EnumProperty(
        name="Direction",
        description="Where to move the entry",
        items=(
            ("UP", "Up", "Apply the entry one place later"),
            ("DOWN", "Down", "Apply the entry one place earlier"),
        ),
    )

    @classmethod
    def poll(cls, context: Context) -> bool:
        reason = target.entry_reason(context)
        if not reason and len(stack.of(target.armature(context)).entries) < 2:
            reason = text("The stack has one entry only")
        return target.allowed(cls, reason)

    def execute(self, context: Context) -> set[str]:
        ob = target.armature(context)
        motion = stack.of(ob)
        offset = 1 if self.direction == "UP" else -1
        if not 0 <= motion.active + offset < len(motion.entries):
            return {"CANCELLED"}  # already at that end: nothing to say

        def move(ob: Object) -> str:
            name = target.entry(ob).name
            stack.move_entry(ob, motion.active, offset)
            if offset > 0:
                return text("Moved “{name}” up: it is applied later", name=name)
            return text("Moved “{name}” down: it is applied earlier", name=name)

        return target.carry_out(self, context, move)


class MOTION_THEATER_OT_entry_select_bones(bpy.types.Operator):
    """Select the bones that the active entry acts on"""

    bl_idname = "motion_theater.entry_select_bones"
    bl_label = "Select Bones"
    bl_options = {"REGISTER", "UNDO"}

    extend: bpy.props.BoolProperty(
        name="Extend",
        description="Keep the bones selected that already are",
        default=False,
    )

    @classmethod
    def poll(cls, context: Context) -> bool:
        ob = target.armature(context)
        reason = text("Choose an entry in the list first") if target.entry(ob) is None else ""
        return target.allowed(cls, reason)

    def execute(self, context: Context) -> set[str]:
        ob = target.armature(context)
        chosen = target.entry(ob)
        wanted = set(ob.data.bones.keys() if chosen.all_bones else names.split(chosen.bones))
        for bone in ob.pose.bones:
            if bone.name in wanted or not self.extend:
                compat.select_bone(bone, bone.name in wanted)
        count = sum(bone.name in wanted for bone in ob.pose.bones)
        self.report({"INFO"}, text("Selected {bones} of “{name}”", bones=bones(count), name=chosen.name))
        return {"FINISHED"}


class MOTION_THEATER_OT_entry_set_bones(bpy.types.Operator):
    """Let the active entry act on the selected bones instead of those it has now"""

    bl_idname = "motion_theater.entry_set_bones"
    bl_label = "Use Selected Bones"
    bl_options = {"REGISTER", "UNDO"}

    @classmethod
    def poll(cls, context: Context) -> bool:
        reason = target.entry_reason(context)
        if not reason and not rig.selected_bones(target.armature(context)):
            reason = text("Select the bones first, in Pose Mode")
        return target.allowed(cls, reason)

    def execute(self, context: Context) -> set[str]:
        def set_bones(ob: Object) -> str:
            chosen = rig.selected_bones(ob)
            stack.set_bones(ob, stack.of(ob).active, chosen)
            return text("“{name}” now acts on {bones}", name=target.entry(ob).name, bones=bones(len(chosen)))

        return target.carry_out(self, context, set_bones)


CLASSES = (
    MOTION_THEATER_OT_entry_duplicate,
    MOTION_THEATER_OT_entry_remove,
    MOTION_THEATER_OT_entry_move,
    MOTION_THEATER_OT_entry_select_bones,
    MOTION_THEATER_OT_entry_set_bones,
)
