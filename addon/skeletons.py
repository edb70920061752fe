"""Importing a skeleton: from a file to an armature that remembers where it came from."""

from __future__ import annotations

from pathlib import PurePath
from typing import TYPE_CHECKING

import motion_theater

from . import rig, sources, stack
from .logic import axes, names
from .logic.messages import UserError, base_name, bones

if TYPE_CHECKING:
    from bpy.types import Context, Object

MOST_BONES = 2048  # ten times what the largest captured skeletons have; Blender's Edit Mode takes minutes for more


def import_skeleton(
    context: Context,
    loaded: sources.Loaded,
    *,
    scale: float = 1.0,
    up: str = "AUTO",
    forward: str = axes.AS_IN_FILE,
    bone_style: str = "POINT",
    limits_as_constraints: bool = False,
) -> tuple[Object, list[str]]:
    """Make an armature from a skeleton file; return it with what is to be said about it, the result first."""
    path = loaded.clip.path
    skeleton = sources.as_skeleton(loaded)
    if len(skeleton.names) > MOST_BONES:
        raise UserError(f"{base_name(path)} has {len(skeleton.names)} bones: more than {MOST_BONES} are not imported")
    chosen_up = axes.nearest_axis(skeleton.up) if up == "AUTO" else up
    unit = skeleton.unit_m * scale / context.scene.unit_settings.scale_length
    ob, bone_names = rig.build_armature(
        context,
        skeleton,
        scale=unit,
        to_blender=axes.to_blender(chosen_up, forward),
        bone_style=bone_style,
        limits_as_constraints=limits_as_constraints,
        name=skeleton.name or PurePath(base_name(path)).stem,
    )
    motion = stack.of(ob)
    with stack.quietly():
        motion.skeleton_source = sources.full_path(path) if path else ""
        motion.skeleton_text = sources.text_of(loaded)
        motion.unit_m = unit
        motion.up = chosen_up
        motion.forward = forward
        motion.bone_style = bone_style
        motion.bone_names = names.encode_pairs(bone_names.items())
    told = [_described(loaded, skeleton, len(bone_names), chosen_up)]
    if scale != 1.0:
        told.append(f"Scaled to {skeleton.height * skeleton.unit_m * scale:.2f} m")
    if not skeleton.unit_is_certain:
        told.append(f"Length unit: {skeleton.unit_reason}")
    renamed = [name for name, bone in bone_names.items() if name != bone]
    if renamed:
        told.append(f"Renamed for Blender: {', '.join(renamed[:3])}")
    return ob, list(dict.fromkeys(told + list(loaded.clip.notices)))


def _described(loaded: sources.Loaded, skeleton: motion_theater.Skeleton, count: int, up: str) -> str:
    """Return what was imported, in one line: bones, axes, and the rate of a motion."""
    name = base_name(loaded.clip.path) or "the default skeleton"
    parts = [f"Imported {name}: {bones(count)}", f"{up} up"]
    facing = motion_theater.infer(skeleton, loaded.clip.motion).facing
    parts.append(f"{'' if facing.is_certain else 'probably '}facing {axes.nearest_axis(facing.value)}")
    if sources.has_own_skeleton(loaded):
        parts.append(f"{loaded.clip.rate_hz:.6g} Hz" if loaded.clip.rate_hz else "rate not known")
    return ", ".join(parts)
