"""ZIP SKELETON: installs, disables, enables; imports a skeleton while the extension is there."""

from __future__ import annotations

import sys
from importlib import import_module
from typing import Any

import bpy
from session import finish, install, is_enabled, set_enabled


def traces() -> dict[str, Any]:
    """Return what the extension adds to Blender while it is enabled."""
    return {
        "loaded": is_enabled(),
        "operator": hasattr(bpy.types, "MOTION_THEATER_OT_import_skeleton"),
        "stack": "motion_theater" in bpy.types.Object.bl_rna.properties,
        "panels": sorted(name for name in dir(bpy.types) if name.startswith("MOTION_THEATER_PT_")),
        "import_menu": len(bpy.types.TOPBAR_MT_file_import.draw._draw_funcs),
    }


def bones_of_import(skeleton: str) -> int:
    """Import the skeleton into an empty file; return how many bones the armature has."""
    bpy.ops.wm.read_homefile(use_empty=True, use_factory_startup=True)
    bpy.ops.motion_theater.import_skeleton(filepath=skeleton)
    return len(bpy.context.object.data.bones)


package, skeleton = sys.argv[1:]
facts: dict[str, Any] = {"before": traces()}

install(package)
facts["installed"] = traces()
facts["bones"] = bones_of_import(skeleton)

set_enabled(enabled=False)
facts["disabled"] = traces()

set_enabled(enabled=True)
facts["enabled again"] = traces()
facts["bones again"] = bones_of_import(skeleton)

module = import_module("motion_theater")  # which the extension has brought by now
facts["module"] = module.__file__
facts["version"] = module.__version__
finish(facts)
