"""The armature of a marker set: one loose bone per marker, drawn as a small octahedron, with its name.

All bones have the axes of the armature, so that a location curve holds meters along X, Y and Z, away from the marker's
place in the rest pose. That pose is a moment of the recording: Edit Mode shows the figure, not a heap of points.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import bpy
from mathutils import Vector

from .. import scene

if TYPE_CHECKING:
    from bpy.types import Context, Object
    from numpy.typing import NDArray

SHAPE_NAME = "Marker Shape"
SHARE = 0.015  # of the size of the whole: how large a marker is drawn
SMALLEST = 1e-3  # of a bone in scene units; Blender takes away bones without length
CORNERS = ((1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, -1, 0), (0, 0, 1), (0, 0, -1))
FACES = ((0, 2, 4), (2, 1, 4), (1, 3, 4), (3, 0, 4), (2, 0, 5), (1, 2, 5), (3, 1, 5), (0, 3, 5))


def build(context: Context, name: str, names: Sequence[str], places: NDArray) -> tuple[Object, list[str]]:
    """Make the armature in its rest pose; return it with the names that Blender gave the bones.

    It stands at the world origin, in the active collection, selected and active.
    """
    armature = bpy.data.armatures.new(name)
    armature.show_names = True
    ob = bpy.data.objects.new(name, armature)
    scene.add_as_active(context, ob)
    size = float((places.max(axis=0) - places.min(axis=0)).max())
    length = Vector((0.0, max(size * SHARE, SMALLEST), 0.0))
    bones = []
    bpy.ops.object.mode_set(mode="EDIT")
    try:
        for number, (file_name, place) in enumerate(zip(names, places.tolist(), strict=True), 1):
            bone = armature.edit_bones.new(file_name or f"Marker {number}")
            bone.head = Vector(place)
            bone.tail = bone.head + length
            bones.append(bone.name)
    finally:
        bpy.ops.object.mode_set(mode="OBJECT")
    shape = _shape()
    for posed in ob.pose.bones:
        posed.custom_shape = shape
        posed.rotation_mode = "XYZ"
    return ob, bones


def _shape() -> Object:
    """Return the octahedron that stands for a marker; one for all sets of a file. It is in no scene."""
    known: Object | None = bpy.data.objects.get(SHAPE_NAME)
    if known is not None and known.type == "MESH" and known.library is None:
        return known
    mesh = bpy.data.meshes.new(SHAPE_NAME)
    mesh.from_pydata([[axis * 0.5 for axis in corner] for corner in CORNERS], [], FACES)
    return bpy.data.objects.new(SHAPE_NAME, mesh)
