"""The selected clip of the library: its picture, everything known of it, and the fields that can be edited."""

from __future__ import annotations

from datetime import datetime
from pathlib import PurePath
from typing import TYPE_CHECKING

import bpy

from ..library import pictures, rows, session
from ..logic.library import facts
from ..translations import text
from . import words

if TYPE_CHECKING:
    from bpy.types import Context, UILayout

    import motion_theater

PICTURE_SCALE = 7.0


class MOTION_THEATER_PT_library_clip(bpy.types.Panel):
    """What is known of the selected clip"""

    bl_space_type = "VIEW_3D"
    bl_region_type = "UI"
    bl_category = "Motion"
    bl_parent_id = "MOTION_THEATER_PT_library"
    bl_label = ""
    bl_order = 1

    @classmethod
    def poll(cls, context: Context) -> bool:
        return rows.active() is not None

    def draw_header(self, context: Context) -> None:
        clip = rows.active()
        self.layout.label(text=clip.name if clip is not None else "", translate=False)

    def draw(self, context: Context) -> None:
        layout = self.layout
        clip = rows.active()
        if clip is None:
            return
        _draw_picture(layout, clip)
        if clip.error:
            words.sentence(layout.box(), context, clip.error, icon="ERROR", alert=True)
        if clip.is_missing:
            words.sentence(layout.box(), context, text("The file is not where it was"), icon="ERROR", alert=True)
        header, body = layout.panel("motion_theater_library_facts")
        header.label(text="File")
        if body is not None:
            _draw_facts(body, context, clip)
        header, body = layout.panel("motion_theater_library_notes")
        header.label(text="Notes")
        if body is not None:
            _draw_fields(body, context, clip)
        if session.state.is_alarming and session.state.about == clip.id:
            words.sentence(layout.box(), context, session.state.message, icon="ERROR", alert=True)
        for notice in clip.notices:
            words.sentence(layout, context, notice, icon="INFO")


class MOTION_THEATER_MT_library_clip(bpy.types.Menu):
    """What can be done with the clip under the mouse"""

    bl_label = "Clip"

    def draw(self, context: Context) -> None:
        layout = self.layout
        clip = rows.active()
        if clip is None:
            return
        layout.label(text=clip.name, translate=False)
        layout.separator()
        layout.operator_context = "INVOKE_DEFAULT"
        layout.operator("motion_theater.library_add_track", icon="ADD").clip = clip.id
        layout.operator("motion_theater.library_import", icon="IMPORT").clip = clip.id
        layout.separator()
        layout.operator("motion_theater.library_play", text="Open", icon="PLAY").at_a_time = "ONE"
        layout.operator("motion_theater.library_play", text="Play Four", icon="IMGDISPLAY").at_a_time = "FOUR"
        layout.separator()
        fields = context.window_manager.motion_theater_library
        layout.prop(fields, "is_favourite")
        layout.prop(fields, "rating")
        layout.operator("motion_theater.sidecar_edit", icon="TEXT").clip = clip.id
        if clip.segments:
            forget = layout.operator("motion_theater.library_mark_usable", text="Forget Usable Pieces", icon="X")
            forget.clip, forget.clear = clip.id, True
        layout.operator("wm.path_open", text="Open Folder", icon="FILE_FOLDER").filepath = str(
            PurePath(clip.path).parent
        )


def _draw_picture(layout: UILayout, clip: motion_theater.LibraryClip) -> None:
    shown = 0 if clip.error else pictures.icon(clip.id)
    if shown:
        layout.template_icon(icon_value=shown, scale=PICTURE_SCALE)
    row = layout.row(align=True)
    row.operator("motion_theater.library_play", text="Open", icon="PLAY").at_a_time = "ONE"
    fields = bpy.context.window_manager.motion_theater_library
    row.prop(fields, "is_favourite", text="", icon="SOLO_ON" if clip.is_favourite else "SOLO_OFF")


def _draw_facts(layout: UILayout, context: Context, clip: motion_theater.LibraryClip) -> None:
    """Show everything that the file tells, one fact a line."""
    column = layout.column(align=True)
    for name, value in known(clip):
        row = words.labelled(column, name)
        row.label(text=value, translate=False)
    if clip.skeleton_path:
        reason = clip.skeleton_reason or text("it was found")
        message = text("Skeleton: {name}, because {reason}", name=PurePath(clip.skeleton_path).name, reason=reason)
        words.sentence(layout, context, message, icon="ARMATURE_DATA")
    words.sentence(layout, context, clip.path, icon="FILE_FOLDER")


def known(clip: motion_theater.LibraryClip) -> list[tuple[str, str]]:
    """Return names and values of what is known of a file, without what is not known."""
    changed = datetime.fromtimestamp(clip.modified_ns / 1e9) if clip.modified_ns else None
    pairs = (
        (text("Format"), (clip.format or "").upper()),
        (text("Length"), facts.duration(clip.duration_s)),
        (text("Frames"), _frames(clip)),
        (text("Rate"), facts.rate(clip.rate_hz) if clip.frames else ""),
        (text("Joints"), str(clip.joints) if clip.joints else ""),
        (text("Markers"), str(clip.markers) if clip.markers else ""),
        (text("Height"), f"{clip.height_m:.2f} m" if clip.height_m else ""),
        (text("Up"), clip.up or ""),
        (text("Size"), facts.size(clip.size)),
        (text("Changed"), changed.strftime("%Y-%m-%d %H:%M") if changed else ""),
        (text("Usable"), ", ".join(facts.span(first, last) for first, last in clip.segments)),
    )
    return [(name, value) for name, value in pairs if value]


def _frames(clip: motion_theater.LibraryClip) -> str:
    if not clip.frames:
        return ""
    first = clip.first_frame or 0
    return f"{clip.frames:,} ({facts.span(first, first + clip.frames - 1)})"


def _draw_fields(layout: UILayout, context: Context, clip: motion_theater.LibraryClip) -> None:
    """Draw the fields of the selected clip; what is typed is kept at once. A sidecar has lines for the first ones."""
    fields = context.window_manager.motion_theater_library
    layout.use_property_split = True
    layout.use_property_decorate = False
    column = layout.column(align=True)
    for name in ("subject", "recorded_on", "session_group", "description"):
        column.prop(fields, name)
    column.prop(fields, "cleaned")
    column = layout.column(align=True)
    column.prop(fields, "also_sidecar")
    row = column.row()
    row.enabled = not clip.is_missing
    row.operator("motion_theater.sidecar_edit", icon="TEXT").clip = clip.id
    column = layout.column(align=True)
    column.prop(fields, "tags")
    column.prop(fields, "rating", slider=True)


CLASSES = (MOTION_THEATER_PT_library_clip, MOTION_THEATER_MT_library_clip)
