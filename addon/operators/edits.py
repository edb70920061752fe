"""Operators for curves that were edited by hand, and for building the motion anew."""

from __future__ import annotations

from typing import TYPE_CHECKING

import bpy

from .. import stack
from ..logic import names
from ..logic.messages import listing, sentences
from ..translations import text
from . import target

if TYPE_CHECKING:
    from bpy.types import Context, Object


class MOTION_THEATER_OT_rebuild(bpy.types.Operator):
    """Build the motion of the armature anew from its stack"""

    bl_idname = "motion_theater.rebuild"
    bl_label = "Rebuild Motion"
    bl_options = {"REGISTER", "UNDO"}

    over_edits: bpy.props.BoolProperty(
        name="Over Hand Edits",
        description="Replace curves that were edited by hand. Their edits are lost, except to undo",
        default=False,
    )

    @classmethod
    def description(cls, context: Context, properties: bpy.types.OperatorProperties) -> str:
        if properties.over_edits:
            return text("Build the motion anew from the stack, over the curves that were edited by hand")
        return text("Build the motion of the armature anew from its stack")

    @classmethod
    def poll(cls, context: Context) -> bool:
        return target.allowed(cls, target.stack_reason(context))

    def execute(self, context: Context) -> set[str]:
        def rebuild(ob: Object) -> str:
            notices = stack.rebuild(ob, over_edits=self.over_edits)
            return sentences([text("Rebuilt the motion of “{name}”", name=ob.name), *notices])

        return target.carry_out(self, context, rebuild)


class MOTION_THEATER_OT_keep_edits(bpy.types.Operator):
    """Keep the curves that were edited by hand: they become an entry on top of the stack"""

    bl_idname = "motion_theater.keep_edits"
    bl_label = "Keep Edits"
    bl_options = {"REGISTER", "UNDO"}

    @classmethod
    def poll(cls, context: Context) -> bool:
        reason = target.stack_reason(context)
        if not reason and not stack.of(target.armature(context)).hand_edited:
            reason = text("No curves were edited by hand since the last rebuild")
        return target.allowed(cls, reason)

    def execute(self, context: Context) -> set[str]:
        def keep(ob: Object) -> str:
            edited = names.split(stack.of(ob).hand_edited)
            stack.keep_edits(ob)
            return text("Kept the edits of {bones} as an entry on top of the stack", bones=listing(edited))

        return target.carry_out(self, context, keep)


CLASSES = (MOTION_THEATER_OT_rebuild, MOTION_THEATER_OT_keep_edits)
