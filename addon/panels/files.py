"""Where files come in and go out besides the sidebar: the menus of File, and files dropped into the 3D View."""

from __future__ import annotations

from typing import TYPE_CHECKING

import bpy
from bpy_extras.io_utils import poll_file_object_drop

if TYPE_CHECKING:
    from bpy.types import Context, Menu


class MOTION_THEATER_FH_motion_capture(bpy.types.FileHandler):
    """Motion capture files dropped into the 3D View are imported, whatever kinds they are"""

    bl_idname = "MOTION_THEATER_FH_motion_capture"
    bl_label = "Motion Capture"
    bl_import_operator = "motion_theater.import_motion_capture"
    bl_file_extensions = ".bvh;.asf;.amc;.c3d;.csm;.trc"

    @classmethod
    def poll_drop(cls, context: Context) -> bool:
        return poll_file_object_drop(context)


def draw_import_menu(menu: Menu, context: Context) -> None:
    """Add the entries of File > Import."""
    menu.layout.operator("motion_theater.import_motion_capture", text="Motion Capture (.bvh/.asf/.amc/.c3d/.csm/.trc)")


def draw_export_menu(menu: Menu, context: Context) -> None:
    """Add the entries of File > Export."""
    menu.layout.operator("motion_theater.export_bvh", text="Motion Capture as BVH (.bvh)")
    menu.layout.operator("motion_theater.export_acclaim", text="Motion Capture as Acclaim (.asf + .amc)")
    menu.layout.operator("motion_theater.export_c3d", text="Markers as C3D (.c3d)")
    menu.layout.operator("motion_theater.export_csm", text="Markers as CSM (.csm)")
    menu.layout.operator("motion_theater.export_trc", text="Markers as TRC (.trc)")


CLASSES = (MOTION_THEATER_FH_motion_capture,)
