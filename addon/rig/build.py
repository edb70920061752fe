"""From a skeleton to an armature in its rest pose.

Everything is baked into the bones, so that the object's own transform stays free: positions are `K * p * s` with `K`
the rotation that brings the file's up axis to Z and `s` scene units per file unit.

Two bone styles. *Point to child*: a bone runs from its start to its end along the limb. Its roll is such that its X
axis is as near as it can be to the file's own X axis for that bone, so that a hinge (`dof rx`: knee, elbow, toes) turns
about the bone's own X. *File's axes*: the rest axes are `K * C`, with `C` the file's axes for that bone, and its Euler
channels hold the file's own numbers.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import bpy
import numpy as np
from mathutils import Vector

from .. import scene
from ..logic import axes

if TYPE_CHECKING:
    from bpy.types import Armature, Context, EditBone, Object

    import motion_theater

    from ..logic.axes import Floats

POINT_LENGTH = 1e-5  # of the skeleton's height: what is shorter is a point without a direction of its own
DISPLAY_SHARE = 0.05  # of the median bone: how long a point is drawn
DISPLAY_MINIMUM_M = 0.01  # shorter bones lose precision in Blender's head, tail and roll
PARALLEL = 1e-3  # below this sine two directions give no roll
CONNECT_TOLERANCE = 1e-6  # metres between a head and the parent's tail


@dataclass(frozen=True)
class Layout:
    """Where the bones of the armature lie, in armature space."""

    heads: Floats
    tails: Floats
    rolls: Floats
    """Directions to which the Z axes are rolled."""
    is_point: list[bool]


def build_armature(
    context: Context,
    skeleton: motion_theater.Skeleton,
    *,
    scale: float,
    to_blender: Floats,
    bone_style: str,
    limits_as_constraints: bool,
    name: str,
) -> tuple[Object, dict[str, str]]:
    """Make an armature in the rest pose of a skeleton; return it with its bone names by file name.

    `scale` is scene units per file unit, `to_blender` the rotation from the file's axes. The armature stands at the
    world origin, in the active collection, selected and active. On an error the caller takes away what was begun: see
    `scene.unchanged_on_error`.
    """
    layout = _layout(skeleton, scale=scale, to_blender=to_blender, bone_style=bone_style)
    armature = bpy.data.armatures.new(name)
    ob = bpy.data.objects.new(name, armature)
    scene.add_as_active(context, ob)
    bpy.ops.object.mode_set(mode="EDIT")
    try:
        bone_names = _add_bones(armature, skeleton, layout, may_connect=bone_style == "POINT")
    finally:
        bpy.ops.object.mode_set(mode="OBJECT")
    for number, file_name in enumerate(skeleton.names):
        bone = ob.pose.bones[bone_names[file_name]]
        mode: Any = skeleton.orders[number] if bone_style == "AXES" else "QUATERNION"
        bone.rotation_mode = mode
        if limits_as_constraints and bone_style == "AXES":
            _add_limits(bone, skeleton.dofs[number], skeleton.limits[number])
    return ob, bone_names


def _layout(skeleton: motion_theater.Skeleton, *, scale: float, to_blender: Floats, bone_style: str) -> Layout:
    heads = axes.rotate(to_blender, np.asarray(skeleton.heads)) * scale
    ends = axes.rotate(to_blender, np.asarray(skeleton.tails)) * scale
    file_axes = axes.multiply(to_blender, np.asarray(skeleton.axes))
    vectors = ends - heads
    lengths = np.linalg.norm(vectors, axis=1)
    is_point = lengths <= POINT_LENGTH * max(abs(skeleton.height * scale), float(lengths.max(initial=0.0)))
    limbs = lengths[~is_point]
    display = max(DISPLAY_SHARE * float(np.median(limbs)) if limbs.size else 0.0, DISPLAY_MINIMUM_M)
    own_x, own_y, own_z = (axes.rotate(file_axes, np.array(unit)) for unit in np.eye(3))
    if bone_style == "AXES":
        drawn = np.where(is_point, display, np.maximum(lengths, DISPLAY_MINIMUM_M))
        return Layout(heads, heads + own_y * drawn[:, None], own_z, list(is_point))
    tails = np.where(is_point[:, None], heads + np.array((0.0, 0.0, display)), ends)
    along = tails - heads
    along /= np.linalg.norm(along, axis=1, keepdims=True)
    rolls = np.cross(own_x, along)
    parallel = np.linalg.norm(rolls, axis=1) < PARALLEL
    return Layout(heads, tails, np.where(parallel[:, None], own_z, rolls), list(is_point))


def _add_bones(
    armature: Armature, skeleton: motion_theater.Skeleton, layout: Layout, *, may_connect: bool
) -> dict[str, str]:
    """Make the bones in Edit Mode; return the names that Blender gave them: unique, and at most 63 bytes long."""
    made: list[EditBone] = []
    for number, file_name in enumerate(skeleton.names):
        bone = armature.edit_bones.new(file_name)
        bone.head = Vector(layout.heads[number])
        bone.tail = Vector(layout.tails[number])
        bone.align_roll(Vector(layout.rolls[number]))  # keeps more digits than setting roll or matrix
        parent = skeleton.parents[number]
        if parent >= 0:
            bone.parent = made[parent]
            moves = any(dof.startswith("t") for dof in skeleton.dofs[number])
            meets = np.linalg.norm(layout.heads[number] - layout.tails[parent]) <= CONNECT_TOLERANCE
            bone.use_connect = bool(may_connect and meets and not moves and not layout.is_point[parent])
        made.append(bone)
    return {file_name: bone.name for file_name, bone in zip(skeleton.names, made, strict=True)}


def _add_limits(bone: bpy.types.PoseBone, dofs: list[str], limits: list[tuple[float, float]]) -> None:
    """Add the file's limits as a Limit Rotation constraint, in the file's own numbers."""
    rotations = {
        dof[1]: limit
        for dof, limit in zip(dofs, limits, strict=False)  # a file may give none
        if dof.startswith("r") and any(math.isfinite(bound) for bound in limit)
    }
    if not rotations:
        return
    constraint = bone.constraints.new("LIMIT_ROTATION")
    constraint.owner_space = "LOCAL"
    for axis, (low, high) in rotations.items():
        setattr(constraint, f"use_limit_{axis}", True)
        setattr(constraint, f"min_{axis}", max(low, -math.tau))
        setattr(constraint, f"max_{axis}", min(high, math.tau))
