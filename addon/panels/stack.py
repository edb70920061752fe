"""The stack of the active armature: its list, what can be done with it, and what the user must know about it."""

from __future__ import annotations

from typing import TYPE_CHECKING

import bpy

from .. import markers, rig, sources, stack
from ..logic import names
from ..logic.messages import listing
from ..operators import target
from ..translations import text
from . import words
from .combine import add_track_button

if TYPE_CHECKING:
    from bpy.types import Context, UILayout

    from ..properties import MotionEntry, MotionStack


class MOTION_THEATER_UL_entries(bpy.types.UIList):
    """The entries of the stack"""

    def draw_item(
        self,
        context: Context,
        layout: UILayout,
        data: MotionStack,
        item: MotionEntry,
        icon: int,
        active_data: MotionStack,
        active_property: str,
        index: int,
        flt_flag: int,
    ) -> None:
        """Draw one entry: kind, name, frames, whether something is wrong with it, on or off."""
        row = layout.row(align=True)
        shown = row.row(align=True)
        shown.active = item.enabled
        shown.prop(item, "name", text="", emboss=False, icon_value=layout.enum_item_icon(item, "kind", item.kind))
        facts = shown.row(align=True)
        facts.alignment = "RIGHT"
        facts.label(text=words.extent(item), translate=False)
        if item.error or sources.is_missing(item.id_data, item):
            row.label(text="", icon="ERROR")
        elif item.notices:
            row.label(text="", icon="INFO")
        row.prop(item, "enabled", text="", emboss=False, icon="HIDE_OFF" if item.enabled else "HIDE_ON")


class MOTION_THEATER_MT_stack_specials(bpy.types.Menu):
    """What is done less often with the stack"""

    bl_label = "Stack Specials"

    def draw(self, context: Context) -> None:
        layout = self.layout
        layout.operator("motion_theater.entry_select_bones", icon="RESTRICT_SELECT_OFF")
        layout.operator("motion_theater.entry_set_bones", icon="BONE_DATA")
        layout.separator()
        layout.operator("motion_theater.relink_source", icon="FILEBROWSER")
        layout.operator("motion_theater.pack_sources", icon="PACKAGE")
        layout.operator("motion_theater.unpack_sources", icon="UGLYPACKAGE")
        layout.operator("motion_theater.sidecar_edit", icon="TEXT")
        layout.separator()
        layout.operator("motion_theater.stack_export", icon="EXPORT")
        layout.operator("motion_theater.stack_import", icon="IMPORT")
        layout.separator()
        layout.operator("motion_theater.rebuild", icon="FILE_REFRESH")


class MOTION_THEATER_PT_stack(bpy.types.Panel):
    """The motion of the active armature as a stack of tracks and filters"""

    bl_space_type = "VIEW_3D"
    bl_region_type = "UI"
    bl_category = "Motion"
    bl_label = "Motion Theater"

    @classmethod
    def poll(cls, context: Context) -> bool:
        return markers.set_of(context) is None  # markers have their own panel, and no stack

    def draw(self, context: Context) -> None:
        layout = self.layout
        ob = target.armature(context)
        if ob is None:
            _draw_first_step(layout, context)
            return
        layout.label(text=ob.name, icon="ARMATURE_DATA", translate=False)
        motion = stack.of(ob)
        _draw_list(layout, context, motion)
        _draw_base(layout, motion)
        reason = rig.writable_reason(ob)
        if reason:
            words.sentence(layout.box(), context, reason, icon="LOCKED")
        if motion.hand_edited:
            _draw_hand_edits(layout, context, motion)
        _draw_message(layout, context, motion)
        if not motion.entries:
            hint = text("Select bones in Pose Mode, then add a motion track below")
            words.sentence(layout, context, hint, icon="INFO")


def _draw_first_step(layout: UILayout, context: Context) -> None:
    """Tell a newcomer what to begin with."""
    if any(ob.type == "ARMATURE" for ob in context.view_layer.objects):
        message = text("Select an armature to see its motion")
    else:
        message = text("Begin with a skeleton: import an .asf or .bvh file below, or drop any recording into the view")
    words.sentence(layout, context, message, icon="INFO")


def _draw_list(layout: UILayout, context: Context, motion: MotionStack) -> None:
    row = layout.row()
    row.template_list(
        "MOTION_THEATER_UL_entries",
        "",
        motion,
        "entries",
        motion,
        "active",
        rows=6 if motion.entries else 3,
        sort_reverse=True,  # as layers: what is applied last is on top
        sort_lock=True,
    )
    side = row.column(align=True)
    add_track_button(side, context, text="", icon="ADD")
    side.operator("motion_theater.entry_remove", text="", icon="REMOVE")
    side.operator("motion_theater.entry_duplicate", text="", icon="DUPLICATE")
    side.separator()
    side.menu("MOTION_THEATER_MT_stack_specials", text="", icon="DOWNARROW_HLT")
    if motion.entries:
        side.separator()
        side.operator("motion_theater.entry_move", text="", icon="TRIA_UP").direction = "UP"
        side.operator("motion_theater.entry_move", text="", icon="TRIA_DOWN").direction = "DOWN"


def _draw_base(layout: UILayout, motion: MotionStack) -> None:
    """Show what lies under the first entry."""
    base = motion.base_action
    message = text("Base: {name}", name=base.name) if base else text("Base: rest pose")
    row = layout.row()
    row.active = False
    row.label(text=message, icon="ACTION", translate=False)


def _draw_message(layout: UILayout, context: Context, motion: MotionStack) -> None:
    """Show the last message, unless an alert says the same already."""
    shown = motion.hand_edited or motion.message in {entry.error for entry in motion.entries}
    if motion.message and not shown:
        words.sentence(layout, context, motion.message, icon="INFO")


def _draw_hand_edits(layout: UILayout, context: Context, motion: MotionStack) -> None:
    """Say which curves were edited by hand, and let the user choose what becomes of them."""
    box = layout.box()
    bones = listing(names.split(motion.hand_edited))
    message = text("Edited by hand since the last rebuild: {bones}", bones=bones)
    words.sentence(box, context, message, icon="ERROR", alert=True)
    buttons = box.column(align=True)
    buttons.operator("motion_theater.keep_edits", icon="FCURVE")
    buttons.operator("motion_theater.rebuild", text="Rebuild Over Them", icon="FILE_REFRESH").over_edits = True


CLASSES = (MOTION_THEATER_UL_entries, MOTION_THEATER_MT_stack_specials, MOTION_THEATER_PT_stack)
