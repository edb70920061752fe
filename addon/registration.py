"""Everything the add-on makes known to Blender, as lists; `unregister` goes through them backwards."""

from __future__ import annotations

import bpy

from . import preferences, properties
from .library import closing
from .library import properties as library_properties
from .markers import properties as marker_properties
from .operators import (
    add_track,
    edits,
    entries,
    export_markers,
    export_motion,
    import_markers,
    import_motion_capture,
    import_skeleton,
    library_browse,
    library_folders,
    library_use,
    marker_edits,
    sidecar,
    sources,
    stack_files,
)
from .operators import filter as filter_operator
from .panels import combine, entry, files, filters, library, library_clip, markers, stack

# What a class refers to comes before it: an entry before the stack, a panel before its sub-panels.
CLASSES = (
    *properties.CLASSES,
    *marker_properties.CLASSES,
    *library_properties.CLASSES,
    *preferences.CLASSES,
    *import_skeleton.CLASSES,
    *add_track.CLASSES,
    *import_motion_capture.CLASSES,
    *export_motion.CLASSES,
    *export_markers.CLASSES,
    *filter_operator.CLASSES,
    *entries.CLASSES,
    *edits.CLASSES,
    *sources.CLASSES,
    *stack_files.CLASSES,
    *sidecar.CLASSES,
    *import_markers.CLASSES,
    *marker_edits.CLASSES,
    *library_browse.CLASSES,
    *library_folders.CLASSES,
    *library_use.CLASSES,
    *library.CLASSES,
    *library_clip.CLASSES,
    *stack.CLASSES,
    *entry.CLASSES,
    *combine.CLASSES,
    *filters.CLASSES,
    *markers.CLASSES,
    *files.CLASSES,
)
MENUS = (
    (bpy.types.TOPBAR_MT_file_import, files.draw_import_menu),
    (bpy.types.TOPBAR_MT_file_export, files.draw_export_menu),
)


def register() -> None:
    """Make everything known."""
    for cls in CLASSES:
        bpy.utils.register_class(cls)
    properties.register_pointers()
    marker_properties.register_pointers()
    library_properties.register_pointers()
    for menu, draw in MENUS:
        menu.append(draw)


def unregister() -> None:
    """Take everything back, last first."""
    for menu, draw in reversed(MENUS):
        menu.remove(draw)
    closing.close()
    library_properties.unregister_pointers()
    marker_properties.unregister_pointers()
    properties.unregister_pointers()
    for cls in reversed(CLASSES):
        bpy.utils.unregister_class(cls)
