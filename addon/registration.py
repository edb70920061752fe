"""Everything the add-on makes known to Blender, as lists; `unregister` goes through them backwards."""

from __future__ import annotations

import bpy

from . import properties
from .operators.add_track import MOTION_THEATER_OT_add_track
from .operators.edits import MOTION_THEATER_OT_keep_edits, MOTION_THEATER_OT_rebuild
from .operators.entries import (
    MOTION_THEATER_OT_entry_duplicate,
    MOTION_THEATER_OT_entry_move,
    MOTION_THEATER_OT_entry_remove,
    MOTION_THEATER_OT_entry_select_bones,
    MOTION_THEATER_OT_entry_set_bones,
)
from .operators.filter import MOTION_THEATER_OT_filter
from .operators.import_skeleton import MOTION_THEATER_OT_import_skeleton
from .operators.sources import (
    MOTION_THEATER_OT_pack_sources,
    MOTION_THEATER_OT_relink_source,
    MOTION_THEATER_OT_unpack_sources,
)
from .panels.combine import MOTION_THEATER_PT_combine
from .panels.entry import MOTION_THEATER_PT_entry
from .panels.files import MOTION_THEATER_FH_motion, MOTION_THEATER_FH_skeleton, draw_import_menu
from .panels.filters import MOTION_THEATER_PT_filters
from .panels.stack import MOTION_THEATER_MT_stack_specials, MOTION_THEATER_PT_stack, MOTION_THEATER_UL_entries
from .preferences import MotionTheaterPreferences

# What a class refers to comes before it: an entry before the stack, a panel before its sub-panels.
CLASSES = (
    *properties.CLASSES,
    MotionTheaterPreferences,
    MOTION_THEATER_OT_import_skeleton,
    MOTION_THEATER_OT_add_track,
    MOTION_THEATER_OT_filter,
    MOTION_THEATER_OT_entry_duplicate,
    MOTION_THEATER_OT_entry_remove,
    MOTION_THEATER_OT_entry_move,
    MOTION_THEATER_OT_entry_select_bones,
    MOTION_THEATER_OT_entry_set_bones,
    MOTION_THEATER_OT_rebuild,
    MOTION_THEATER_OT_keep_edits,
    MOTION_THEATER_OT_relink_source,
    MOTION_THEATER_OT_pack_sources,
    MOTION_THEATER_OT_unpack_sources,
    MOTION_THEATER_UL_entries,
    MOTION_THEATER_MT_stack_specials,
    MOTION_THEATER_PT_stack,
    MOTION_THEATER_PT_entry,
    MOTION_THEATER_PT_combine,
    MOTION_THEATER_PT_filters,
    MOTION_THEATER_FH_skeleton,
    MOTION_THEATER_FH_motion,
)

MENUS = ((bpy.types.TOPBAR_MT_file_import, draw_import_menu),)


def register() -> None:
    """Make everything known."""
    for cls in CLASSES:
        bpy.utils.register_class(cls)
    properties.register_pointers()
    for menu, draw in MENUS:
        menu.append(draw)


def unregister() -> None:
    """Take everything back, last first."""
    for menu, draw in reversed(MENUS):
        menu.remove(draw)
    properties.unregister_pointers()
    for cls in reversed(CLASSES):
        bpy.utils.unregister_class(cls)
