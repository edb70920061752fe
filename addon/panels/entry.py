"""The settings of the active entry. Each change rebuilds the motion at once."""

from __future__ import annotations

from typing import TYPE_CHECKING

import bpy

from .. import sources
from ..operators import target
from ..translations import text
from . import track, words

if TYPE_CHECKING:
    from bpy.types import Context, UILayout

    from ..properties import MotionEntry


class MOTION_THEATER_PT_entry(bpy.types.Panel):
    """Settings of the active entry of the stack"""

    bl_space_type = "VIEW_3D"
    bl_region_type = "UI"
    bl_category = "Motion"
    bl_parent_id = "MOTION_THEATER_PT_stack"
    bl_label = ""
    bl_order = 0

    @classmethod
    def poll(cls, context: Context) -> bool:
        return target.entry(target.armature(context)) is not None

    def draw_header(self, context: Context) -> None:
        entry = target.entry(target.armature(context))
        icon = self.layout.enum_item_icon(entry, "kind", entry.kind)
        self.layout.label(text=entry.name, icon_value=icon, translate=False)

    def draw(self, context: Context) -> None:
        layout = self.layout
        layout.use_property_split = True
        layout.use_property_decorate = False
        entry = target.entry(target.armature(context))
        _draw_troubles(layout, context, entry)
        body = layout.column()
        body.active = entry.enabled
        if entry.kind == "TRACK":
            _draw_track(body, entry)
        elif entry.kind == "FILTER":
            _draw_filter(body, entry)
        else:
            _draw_kept(body, context, entry)


def _draw_troubles(layout: UILayout, context: Context, entry: MotionEntry) -> None:
    """Say what is wrong with the entry, and what was done other than asked."""
    missing = sources.is_missing(entry.id_data, entry)
    if missing or entry.error:
        box = layout.box()
        words.sentence(box, context, entry.error or text("The source file is missing"), icon="ERROR", alert=True)
        if missing:
            box.operator("motion_theater.relink_source", icon="FILEBROWSER")
    if entry.notices:
        words.sentences(layout, context, entry.notices, icon="INFO")


def _draw_bones(layout: UILayout, entry: MotionEntry) -> None:
    """Which bones the entry works on, and how to change them."""
    layout.column(heading="Bones").prop(entry, "all_bones")
    if not entry.all_bones:
        row = words.labelled(layout, "")
        row.label(text=words.bone_count(entry), translate=False)
        row.operator("motion_theater.entry_select_bones", text="", icon="RESTRICT_SELECT_OFF")
        row.operator("motion_theater.entry_set_bones", text="", icon="BONE_DATA")


def _draw_track(layout: UILayout, entry: MotionEntry) -> None:
    layout.prop(entry, "source", icon="PACKAGE" if entry.packed_key else "NONE")
    if entry.clip_frames:
        facts = words.labelled(layout, "")
        facts.active = False
        facts.label(text=words.clip_facts(entry), translate=False)
    _draw_bones(layout, entry)
    track.draw_timing(layout, entry)
    track.draw_joining(layout, entry)
    header, body = layout.panel("motion_theater_track_details", default_closed=True)
    header.label(text="Details")
    if body is not None:
        track.draw_details(body, entry)
        body.prop(entry, "keys")
        body.prop(entry, "rate_hz")


def _draw_filter(layout: UILayout, entry: MotionEntry) -> None:
    layout.prop(entry, "filter_kind")
    layout.prop(entry, "depth")
    layout.prop(entry, "filter_channels")
    _draw_bones(layout, entry)


def _draw_kept(layout: UILayout, context: Context, entry: MotionEntry) -> None:
    words.sentence(
        layout, context, text("Curves edited by hand, in place of what the entries below make of these bones")
    )
    layout.prop(entry, "action")
    _draw_bones(layout, entry)


CLASSES = (MOTION_THEATER_PT_entry,)
