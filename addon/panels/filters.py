"""The tab *Filters* of the original: remove spikes and noise from the motion."""

from __future__ import annotations

from typing import TYPE_CHECKING

import bpy

from .. import rig
from ..operators import target

if TYPE_CHECKING:
    from bpy.types import Context, UILayout

    from ..properties import NewTrackOptions


class MOTION_THEATER_PT_filters(bpy.types.Panel):
    """Remove spikes and noise from the motion of the selected bones, or of all"""

    bl_space_type = "VIEW_3D"
    bl_region_type = "UI"
    bl_category = "Motion"
    bl_parent_id = "MOTION_THEATER_PT_stack"
    bl_label = "Filters"
    bl_order = 2

    def draw(self, context: Context) -> None:
        options = context.window_manager.motion_theater
        form = self.layout.column()
        form.use_property_split = True
        form.use_property_decorate = False
        form.column().prop(options, "filter_kind", expand=True)
        form.row().prop(options, "depth", expand=True)
        if options.depth == "CUSTOM":
            form.prop(options, "custom_depth")
        row = self.layout.row(align=True)
        row.scale_y = 1.4
        selected = row.row(align=True)
        ob = target.armature(context)
        selected.enabled = ob is None or bool(rig.selected_bones(ob))
        _button(selected, options, text="Filter Selected", selected_only=True)
        _button(row, options, text="Filter All", selected_only=False)


def _button(layout: UILayout, options: NewTrackOptions, *, text: str, selected_only: bool) -> None:
    properties = layout.operator("motion_theater.filter", text=text)
    properties.kind = options.filter_kind
    properties.depth = options.custom_depth if options.depth == "CUSTOM" else int(options.depth)
    properties.selected_only = selected_only


CLASSES = (MOTION_THEATER_PT_filters,)
