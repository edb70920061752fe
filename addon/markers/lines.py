"""Lines between markers: a mesh whose vertices follow the bones, to be edited like any other.

Each marker has one vertex, bound to its bone by an Armature modifier, so that edges can be added and removed in Edit
Mode. While a marker is dropped out, a Mask modifier hides its vertex and with it its lines; a driver on the marker's
scale switches it.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import bpy

from ..curves import read
from ..logic.messages import UserError
from . import keys

if TYPE_CHECKING:
    from bpy.types import Context, Modifier, Object


def add(context: Context, ob: Object, bones: Sequence[str], pairs: Sequence[tuple[int, int]]) -> str:
    """Make the lines of a marker set; return what is to be said about it."""
    if not pairs:
        return "No neighboring markers keep their distance: no lines were drawn"
    name = f"{ob.name} Lines"
    mesh = bpy.data.meshes.new(name)
    mesh.from_pydata([ob.data.bones[bone].head_local for bone in bones], pairs, [])
    drawn = bpy.data.objects.new(name, mesh)
    drawn.parent = ob
    for collection in ob.users_collection or [context.scene.collection]:
        collection.objects.link(drawn)
    for number, bone in enumerate(bones):
        drawn.vertex_groups.new(name=bone).add([number], 1.0, "REPLACE")
    follow = drawn.modifiers.new("Markers", "ARMATURE")
    follow.object = ob
    follow.use_bone_envelopes = False
    for bone in _with_dropouts(ob, bones):
        mask = drawn.modifiers.new(bone, "MASK")
        mask.vertex_group = bone
        mask.invert_vertex_group = True
        mask.show_expanded = False
        for visibility in ("show_viewport", "show_render"):
            _while_dropped_out(mask, visibility, ob, bone)
    ob.motion_theater_markers.lines = drawn
    return f"{len(pairs)} lines between neighboring markers"


def check_none(ob: Object) -> None:
    """Refuse where a marker set has its lines already: they may have been edited."""
    known = ob.motion_theater_markers.lines
    if known is not None and known.users_collection:
        raise UserError(f"“{ob.name}” has its lines, “{known.name}”: edit them, or delete them to find them anew")


def _with_dropouts(ob: Object, bones: Sequence[str]) -> list[str]:
    curves = keys.curves_of(ob)
    return [bone for bone in bones if (read.path(bone, "scale"), 0) in curves]


def _while_dropped_out(mask: Modifier, visibility: str, ob: Object, bone: str) -> None:
    """Switch a modifier on while the scale of a bone is zero."""
    driver = mask.driver_add(visibility).driver
    driver.type = "SCRIPTED"
    variable = driver.variables.new()
    variable.name = "scale"
    variable.targets[0].id = ob
    variable.targets[0].data_path = read.path(bone, "scale") + "[0]"
    driver.expression = "scale == 0"
