"""Importing a skeleton: from a file to an armature that remembers where it came from."""

from __future__ import annotations

from pathlib import PurePath
from typing import TYPE_CHECKING

from . import rig, sources, stack
from .logic import axes, names
from .logic.messages import UserError, base_name, bones

if TYPE_CHECKING:
    from bpy.types import Context, Object

MOST_BONES = 2048  # ten times what the largest captured skeletons have; Blender's Edit Mode takes minutes for more


def import_skeleton(
    context: Context,
    path: str,
    *,
    scale: float = 1.0,
    up: str = "AUTO",
    bone_style: str = "POINT",
    limits_as_constraints: bool = False,
) -> tuple[Object, list[str]]:
    """Make an armature from a skeleton file; return it with what is to be said about it, the result first."""
    loaded = sources.read_file(path)
    skeleton = sources.as_skeleton(loaded)
    if len(skeleton.names) > MOST_BONES:
        raise UserError(f"{base_name(path)} has {len(skeleton.names)} bones: more than {MOST_BONES} are not imported")
    chosen_up = axes.up_axis(skeleton.up) if up == "AUTO" else up
    unit = skeleton.unit_m * scale / context.scene.unit_settings.scale_length
    ob, bone_names = rig.build_armature(
        context,
        skeleton,
        scale=unit,
        up=chosen_up,
        bone_style=bone_style,
        limits_as_constraints=limits_as_constraints,
        name=skeleton.name or PurePath(base_name(path)).stem,
    )
    motion = stack.of(ob)
    with stack.quietly():
        motion.skeleton_source = sources.full_path(path)
        motion.skeleton_text = sources.text_of(loaded)
        motion.unit_m = unit
        motion.up = chosen_up
        motion.bone_style = bone_style
        motion.bone_names = names.encode_pairs(bone_names.items())
    told = [f"Imported {base_name(path)}: {bones(len(bone_names))}, {chosen_up} up"]
    if scale != 1.0:
        told.append(f"Scaled to {skeleton.height * skeleton.unit_m * scale:.2f} m")
    if not skeleton.unit_is_certain:
        told.append(f"Length unit: {skeleton.unit_reason}")
    renamed = [name for name, bone in bone_names.items() if name != bone]
    if renamed:
        told.append(f"Renamed for Blender: {', '.join(renamed[:3])}")
    return ob, told + list(loaded.clip.notices)
