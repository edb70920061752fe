"""save BLEND ZIP SKELETON MOTION: makes a file with the extension. open BLEND: opens it without. Gives its poses."""

from __future__ import annotations

import sys
from importlib.util import find_spec
from typing import Any

import bpy
from session import finish, install, is_enabled

EVERY_NTH_FRAME = 10


def poses() -> dict[str, dict[str, list[float]]]:
    """Return the matrix of every pose bone of the armature, in world space, frame by frame."""
    scene = bpy.context.scene
    (armature,) = (ob for ob in scene.objects if ob.type == "ARMATURE")
    found: dict[str, dict[str, list[float]]] = {}
    for frame in range(scene.frame_start, scene.frame_end + 1, EVERY_NTH_FRAME):
        scene.frame_set(frame)
        matrices = {bone.name: armature.matrix_world @ bone.matrix for bone in armature.pose.bones}
        found[str(frame)] = {name: [number for row in matrix for number in row] for name, matrix in matrices.items()}
    return found


action, blend, *sources = sys.argv[1:]
if action == "save":
    package, skeleton, motion = sources
    install(package)
    bpy.ops.wm.read_homefile(use_empty=True, use_factory_startup=True)
    bpy.ops.motion_theater.import_skeleton(filepath=skeleton)
    bpy.ops.motion_theater.add_track(filepath=motion)
    bpy.ops.wm.save_as_mainfile(filepath=blend)
else:
    bpy.ops.wm.open_mainfile(filepath=blend)

try:
    has_module = find_spec("motion_theater") is not None
except ModuleNotFoundError:
    has_module = False
facts: dict[str, Any] = {"extension": is_enabled(), "module": has_module, "poses": poses()}
finish(facts)
