"""The tab *Import / Combine* of the original: a skeleton, and new tracks for it."""

from __future__ import annotations

from typing import TYPE_CHECKING

import bpy

from .. import preferences, rig
from ..logic.messages import NO_BONES_SELECTED
from ..operators import target
from ..operators.add_track import SETTINGS
from ..translations import text
from . import track, words

if TYPE_CHECKING:
    from bpy.types import Context, Object, OperatorProperties, UILayout

    from ..properties import NewTrackOptions

# Options of the operator that the form holds for the session, and those that are kept in the preferences.
FORM = ("selected_only", "bone_collection", *(name for name in SETTINGS if name != "rate_hz"))
KEPT_FORM = ("rate", "scene_range")


class MOTION_THEATER_PT_combine(bpy.types.Panel):
    """Import a skeleton, and add motion to its bones"""

    bl_space_type = "VIEW_3D"
    bl_region_type = "UI"
    bl_category = "Motion"
    bl_parent_id = "MOTION_THEATER_PT_stack"
    bl_label = "Import / Combine"
    bl_order = 1

    def draw(self, context: Context) -> None:
        layout = self.layout
        layout.operator("motion_theater.import_skeleton", text="Import Skeleton (.asf/.bvh)", icon="ARMATURE_DATA")
        options = context.window_manager.motion_theater
        ob = target.armature(context)
        form = layout.column()
        form.use_property_split = True
        form.use_property_decorate = False
        _draw_bones(form, options, ob)
        track.draw_timing(form, options)
        track.draw_joining(form, options)
        header, body = form.panel("motion_theater_form_details", default_closed=True)
        header.label(text="Details")
        if body is not None:
            _draw_details(body, context, options)
        hint = _hint(options, ob)
        if hint:
            words.sentence(layout, context, hint, icon="INFO")
        button = layout.column()
        button.scale_y = 1.4
        button.enabled = not hint
        add_track_button(button, context, text="Add Motion Track (.amc/.bvh)", icon="ADD")


def _draw_bones(form: UILayout, options: NewTrackOptions, ob: Object | None) -> None:
    """Which bones a new track moves."""
    column = form.column(heading="Bones")
    column.prop(options, "selected_only", text="Selected Only")
    if ob is not None:
        row = form.row()
        row.active = not options.selected_only
        row.prop_search(options, "bone_collection", ob.data, "collections_all", text="Collection")


def _draw_details(layout: UILayout, context: Context, options: NewTrackOptions) -> None:
    """What is seldom changed; the choices about the scene are remembered as preferences."""
    track.draw_details(layout, options)
    kept = preferences.get(context)
    if kept is not None:
        for name in KEPT_FORM:
            layout.prop(kept, name)


def _hint(options: NewTrackOptions, ob: Object | None) -> str:
    """Return why no track can be added as the form stands, or nothing."""
    if ob is not None and options.selected_only and not rig.selected_bones(ob):
        return text(NO_BONES_SELECTED)
    return ""


def add_track_button(layout: UILayout, context: Context, **look: str) -> OperatorProperties:
    """Draw the button that adds a track with the options of the form."""
    options = context.window_manager.motion_theater
    properties = layout.operator("motion_theater.add_track", **look)
    for name in FORM:
        setattr(properties, name, getattr(options, name))
    kept = preferences.get(context)
    if kept is not None:
        for name in KEPT_FORM:
            setattr(properties, name, getattr(kept, name))
    return properties


CLASSES = (MOTION_THEATER_PT_combine,)
