"""The library in the sidebar: search, list, and the ways to look at clips and to bring them in."""

from __future__ import annotations

from typing import TYPE_CHECKING

import bpy

from ..library import pictures, properties, rows, scanning, session
from ..logic.library import facts, views
from ..translations import text
from . import words

if TYPE_CHECKING:
    from bpy.types import Context, UILayout

    from ..library.properties import LibraryOptions, LibraryRow


class MOTION_THEATER_UL_library(bpy.types.UIList):
    """The clips that were found"""

    def draw_item(
        self,
        context: Context,
        layout: UILayout,
        data: LibraryOptions,
        item: LibraryRow,
        icon: int,
        active_data: LibraryOptions,
        active_property: str,
        index: int,
        flt_flag: int,
    ) -> None:
        """Draw one clip: picture, name, length, whether something is wrong with it."""
        found = session.state.ids
        clip = rows.get(int(found[index])) if index < len(found) else None
        if clip is None:
            layout.label(text="…", translate=False)
            return
        row = layout.row(align=True)
        row.active = not clip.is_missing
        shown = 0 if clip.error else pictures.icon(clip.id)
        if shown:
            row.label(text=clip.name, icon_value=shown, translate=False)
        else:
            row.label(text=clip.name, icon="ERROR" if clip.error else "ARMATURE_DATA", translate=False)
        side = row.row(align=True)
        side.alignment = "RIGHT"
        side.active = False
        side.label(text="" if clip.error else facts.duration(clip.duration_s), translate=False)
        if clip.is_favourite:
            row.label(text="", icon="SOLO_ON")


class MOTION_THEATER_PT_library(bpy.types.Panel):
    """Look through thousands of clips, see them move, and bring in the one"""

    bl_space_type = "VIEW_3D"
    bl_region_type = "UI"
    bl_category = "Motion"
    bl_label = "Library"
    bl_order = -2

    def draw(self, context: Context) -> None:
        layout = self.layout
        session.ensure_open()
        state = session.state
        if state.trouble:
            words.sentence(layout.box(), context, state.trouble, icon="ERROR", alert=True)
            return
        if not state.folders and not state.total:
            _draw_first_step(layout, context)
            return
        fields = context.window_manager.motion_theater_library
        _draw_search(layout, context, fields)
        _draw_list(layout, fields)
        if not len(state.ids) and not state.misunderstood and not session.is_searching():
            words.sentence(layout, context, nothing_words(), icon="INFO")
        column = layout.column(align=True)
        row = column.row(align=True)
        row.scale_y = 1.4
        row.operator("motion_theater.library_browse", text="Browse", icon="IMGDISPLAY")
        row.operator("motion_theater.library_play", text="Play Four", icon="PLAY").at_a_time = "FOUR"
        row = column.row(align=True)
        row.operator("motion_theater.library_add_track", icon="ADD")
        row.operator("motion_theater.library_import", icon="IMPORT")
        if state.message and state.is_alarming:
            if state.about is None or state.about != state.active_id:  # else its panel says it, where it was typed
                words.sentence(layout.box(), context, state.message, icon="ERROR", alert=True)
        elif state.message and not scanning.is_running():
            words.sentence(layout, context, state.message, icon="INFO")
        draw_progress(layout)


class MOTION_THEATER_PT_library_folders(bpy.types.Panel):
    """Where the library looks for clips"""

    bl_space_type = "VIEW_3D"
    bl_region_type = "UI"
    bl_category = "Motion"
    bl_parent_id = "MOTION_THEATER_PT_library"
    bl_label = "Folders"
    bl_order = 2
    bl_options = {"DEFAULT_CLOSED"}

    @classmethod
    def poll(cls, context: Context) -> bool:
        return bool(session.state.folders)

    def draw(self, context: Context) -> None:
        layout = self.layout
        for folder in session.state.folders:
            box = layout.box()
            row = box.row(align=True)
            row.label(text=folder.path, icon="FILE_FOLDER", translate=False)
            row.operator("motion_theater.library_scan", text="", icon="FILE_REFRESH", emboss=False).folder = folder.path
            row.operator("motion_theater.library_folder_remove", text="", icon="X", emboss=False).folder = folder.path
            facts_row = box.row()
            facts_row.active = False
            facts_row.label(text=folder_facts(folder), icon="BLANK1", translate=False)
        row = layout.row(align=True)
        row.operator("motion_theater.library_folder_add", icon="ADD")
        row.operator("motion_theater.library_scan", text="Rescan All", icon="FILE_REFRESH")


class MOTION_THEATER_PT_library_filter(bpy.types.Panel):
    """Which clips are shown"""

    bl_space_type = "VIEW_3D"
    bl_region_type = "HEADER"
    bl_label = "Filter Clips"
    bl_ui_units_x = 13

    def draw(self, context: Context) -> None:
        layout = self.layout
        layout.use_property_split = True
        layout.use_property_decorate = False
        fields = context.window_manager.motion_theater_library
        layout.prop(fields, "show")
        layout.separator()
        layout.label(text="Only Clips Of")
        for name in ("filter_format", "filter_tag", "filter_subject", "filter_group"):
            layout.prop(fields, name)
        for name in ("filter_cleaned", "filter_favourite", "filter_used", "filter_broken", "filter_missing"):
            layout.row().prop(fields, name, expand=False)


class MOTION_THEATER_MT_library_sort(bpy.types.Menu):
    """The order of the clips"""

    bl_label = "Sort By"

    def draw(self, context: Context) -> None:
        fields = context.window_manager.motion_theater_library
        for name, _, _ in properties.SORTS:
            self.layout.prop_enum(fields, "sort", name)
        self.layout.separator()
        self.layout.prop(fields, "descending")


def _draw_first_step(layout: UILayout, context: Context) -> None:
    """Tell a newcomer what the library is for and what to begin with."""
    hint = text("See thousands of motion capture files move, and bring in the one you want. Begin with a folder")
    words.sentence(layout, context, hint, icon="INFO")
    row = layout.row()
    row.scale_y = 1.4
    row.operator("motion_theater.library_folder_add", icon="FILE_FOLDER")
    draw_progress(layout)


def _draw_search(layout: UILayout, context: Context, fields: LibraryOptions) -> None:
    state = session.state
    row = layout.row(align=True)
    row.alert = bool(state.misunderstood)
    row.prop(fields, "search", text="", icon="VIEWZOOM")
    is_filtered = any(state.filters.values())
    row = row.row(align=True)
    row.alert = False
    row.menu("MOTION_THEATER_MT_library_sort", text="", icon="SORTSIZE")
    row.popover("MOTION_THEATER_PT_library_filter", text="", icon="FILTER")
    if state.misunderstood:
        words.sentence(layout, context, state.misunderstood, icon="ERROR", alert=True)
    split = layout.split(factor=0.6)
    split.prop(fields, "show", text="")
    side = split.row()
    side.active = False
    side.label(text=found_words(is_filtered=is_filtered), translate=False)


def _draw_list(layout: UILayout, fields: LibraryOptions) -> None:
    layout.template_list(
        "MOTION_THEATER_UL_library",
        "",
        fields,
        "rows",
        fields,
        "active",
        rows=8,
        sort_lock=True,
    )
    hidden = len(session.state.ids) - properties.SHOWN_AT_MOST
    if hidden > 0:
        row = layout.row()
        row.active = False
        row.label(text=text("{count} more: Browse shows all", count=f"{hidden:,}"), translate=False)


def draw_progress(layout: UILayout) -> None:
    """Show how far a scan is, with a button that stops it."""
    if not scanning.is_running():
        return
    share, doing = scanning.progress()
    row = layout.row(align=True)
    row.progress(factor=share, text=doing)
    row.operator("motion_theater.library_scan_stop", text="", icon="X")


def found_words(*, is_filtered: bool) -> str:
    """Return how many clips are shown."""
    state = session.state
    if len(state.ids) == state.total and not is_filtered:
        return facts.count(state.total, "clip", "clips")
    return text("{found} of {total}", found=f"{len(state.ids):,}", total=f"{state.total:,}")


def nothing_words() -> str:
    """Return what to do where no clip is shown."""
    state = session.state
    if not state.total:
        return text("Looking for clips…") if scanning.is_running() else text("There are no clips in these folders")
    if state.words or len(state.filters) > 1:
        return text("No clip is like that: change the search, or what is shown and filtered")
    return {
        "FAVOURITES": text("There are no favorites yet: the star beside Open makes a clip one"),
        "RECENT": text("Nothing was brought into a scene in the last 30 days"),
        "BROKEN": text("There is no file that cannot be read"),
        "MISSING": text("No file is missing"),
    }.get(views.of(state.filters), text("No clip is like that: change the filter"))


def folder_facts(folder: object) -> str:
    """Return what a folder holds."""
    parts = [facts.count(folder.clips, "clip", "clips")]
    if folder.broken:
        parts.append(text("{count} not readable", count=f"{folder.broken:,}"))
    if folder.missing:
        parts.append(text("{count} missing", count=f"{folder.missing:,}"))
    return ", ".join(parts)


CLASSES = (
    MOTION_THEATER_UL_library,
    MOTION_THEATER_PT_library,
    MOTION_THEATER_PT_library_folders,
    MOTION_THEATER_PT_library_filter,
    MOTION_THEATER_MT_library_sort,
)
