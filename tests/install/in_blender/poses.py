"""save BLEND ZIP SKELETON CLIP CLIP: makes a file with the extension. open BLEND: opens it without. Gives its poses."""

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


def select(*tops: str, below: bool = True) -> None:
    """Select some bones and all below them, or all but those."""
    for bone in bpy.context.object.pose.bones:
        lineage = {bone.name, *(parent.name for parent in bone.parent_recursive)}
        chosen = bone if "select" in bone.bl_rna.properties else bone.bone  # the pose's own since Blender 5.0
        chosen.select = bool(lineage & set(tops)) == below


def tutorial(skeleton: str, jump: str, wave: str) -> None:
    """Build a stack as in the tutorial: a clip on the legs, two that blend on the upper body, a filter on the arms."""
    add_track = bpy.ops.motion_theater.add_track
    bpy.ops.motion_theater.import_skeleton(filepath=skeleton)
    select("lhipjoint", "rhipjoint")
    add_track(filepath=jump, selected_only=True)
    select("lhipjoint", "rhipjoint", below=False)
    add_track(filepath=wave, selected_only=True, cut_start=1, cut_end=55, scale_start=1, scale_end=66)
    add_track(filepath=jump, selected_only=True, cut_start=67, cut_end=113, blend_depth=10)
    select("lclavicle", "rclavicle")
    bpy.ops.motion_theater.filter(kind="WEIGHTED", depth=7, selected_only=True)


action, blend, *sources = sys.argv[1:]
if action == "save":
    package, *clips = sources
    install(package)
    bpy.ops.wm.read_homefile(use_empty=True, use_factory_startup=True)
    tutorial(*clips)
    bpy.ops.wm.save_as_mainfile(filepath=blend)
else:
    bpy.ops.wm.open_mainfile(filepath=blend)

try:
    has_module = find_spec("motion_theater") is not None
except ModuleNotFoundError:
    has_module = False
facts: dict[str, Any] = {"extension": is_enabled(), "module": has_module, "poses": poses()}
finish(facts)
