"""The selected marker set: what it holds, and what can be done with it."""

from __future__ import annotations

from typing import TYPE_CHECKING

import bpy

from .. import markers
from ..logic.messages import base_name
from ..operators.marker_edits import FILLS
from ..translations import text
from . import words

if TYPE_CHECKING:
    from bpy.types import Context, Object, UILayout


class MOTION_THEATER_PT_markers(bpy.types.Panel):
    """Recorded markers: their gaps, noise and lines, and what else was recorded"""

    bl_space_type = "VIEW_3D"
    bl_region_type = "UI"
    bl_category = "Motion"
    bl_label = "Markers"
    bl_order = -1

    @classmethod
    def poll(cls, context: Context) -> bool:
        return markers.set_of(context) is not None

    def draw(self, context: Context) -> None:
        layout = self.layout
        ob = markers.set_of(context)
        _draw_facts(layout, ob)
        remembered = ob.motion_theater_markers
        if remembered.message:
            words.sentence(layout, context, remembered.message, icon="INFO")
        in_pose_mode = context.mode == "POSE"
        _draw_gaps(layout, ob, selected_only=in_pose_mode)
        _draw_filters(layout, context, selected_only=in_pose_mode)
        column = layout.column(align=True)
        column.operator("motion_theater.marker_lines", icon="EDGESEL")
        column.operator("motion_theater.marker_events", icon="MARKER")
        column.operator("motion_theater.marker_analog", icon="GRAPH")


def _draw_facts(layout: UILayout, ob: Object) -> None:
    remembered = ob.motion_theater_markers
    column = layout.column(align=True)
    column.label(text=ob.name, icon="ARMATURE_DATA", translate=False)
    facts = text(
        "{count} markers at {rate} Hz from {name}",
        count=len(ob.data.bones),
        rate=f"{remembered.rate_hz:g}",
        name=base_name(remembered.source),
    )
    column.label(text=facts, icon="BLANK1", translate=False)
    column.prop(ob.data, "show_names", text="Show Names")


def _draw_gaps(layout: UILayout, ob: Object, *, selected_only: bool) -> None:
    """Draw one button for each way to fill gaps; in Pose Mode they act on the selected markers."""
    column = layout.column(align=True)
    column.label(text="Fill Gaps of Selected" if selected_only else "Fill Gaps")
    longest = ob.motion_theater_markers.longest_gap
    column.prop(ob.motion_theater_markers, "longest_gap")
    row = column.row(align=True)
    for how, label, _ in FILLS:
        button = row.operator("motion_theater.fill_gaps", text=label)
        button.how, button.longest, button.selected_only = how, longest, selected_only


def _draw_filters(layout: UILayout, context: Context, *, selected_only: bool) -> None:
    """Draw the form of the filter, which is that of the stack's filters."""
    options = context.window_manager.motion_theater
    column = layout.column(align=True)
    column.prop(options, "filter_kind", text="")
    column.row(align=True).prop(options, "depth", expand=True)
    if options.depth == "CUSTOM":
        column.prop(options, "custom_depth")
    button = column.operator("motion_theater.filter_markers", text="Filter Selected" if selected_only else "Filter All")
    button.kind = options.filter_kind
    button.depth = options.custom_depth if options.depth == "CUSTOM" else int(options.depth)
    button.selected_only = selected_only


CLASSES = (MOTION_THEATER_PT_markers,)
