"""Where files come in besides the sidebar: the menu File > Import, and files dropped into the 3D View."""

from __future__ import annotations

from typing import TYPE_CHECKING

import bpy
from bpy_extras.io_utils import poll_file_object_drop

if TYPE_CHECKING:
    from bpy.types import Context, Menu


class MOTION_THEATER_FH_skeleton(bpy.types.FileHandler):
    """An Acclaim skeleton dropped into the 3D View is imported"""

    bl_idname = "MOTION_THEATER_FH_skeleton"
    bl_label = "Acclaim Skeleton"
    bl_import_operator = "motion_theater.import_skeleton"
    bl_file_extensions = ".asf"

    @classmethod
    def poll_drop(cls, context: Context) -> bool:
        return poll_file_object_drop(context)


class MOTION_THEATER_FH_motion(bpy.types.FileHandler):
    """An Acclaim motion dropped into the 3D View becomes a track of the active armature"""

    bl_idname = "MOTION_THEATER_FH_motion"
    bl_label = "Acclaim Motion"
    bl_import_operator = "motion_theater.add_track"
    bl_file_extensions = ".amc"

    @classmethod
    def poll_drop(cls, context: Context) -> bool:
        return poll_file_object_drop(context)


def draw_import_menu(menu: Menu, context: Context) -> None:
    """Add the entries of File > Import."""
    menu.layout.operator("motion_theater.import_skeleton", text="Acclaim Skeleton (.asf)")
    menu.layout.operator("motion_theater.add_track", text="Acclaim Motion (.amc)")


CLASSES = (MOTION_THEATER_FH_skeleton, MOTION_THEATER_FH_motion)
