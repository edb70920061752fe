"""The rest pose of any armature as numbers, and how a file's axes relate to it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

import motion_theater

from ..logic import axes

if TYPE_CHECKING:
    from bpy.types import Object

    from ..logic.axes import Floats

IDENTITY = (1.0, 0.0, 0.0, 0.0)


@dataclass(frozen=True)
class Rest:
    """Bones in the armature's order, parents before children, and their rest pose in armature space."""

    names: tuple[str, ...]
    parents: tuple[int, ...]
    rotations: Floats
    """(bones, 4)"""
    heads: Floats
    """(bones, 3)"""
    modes: tuple[str, ...]
    """Rotation modes of the pose bones, as Blender names them."""

    @property
    def key(self) -> tuple[object, ...]:
        """What tells two rest poses apart, for caches."""
        return self.names, self.modes, self.rotations.tobytes()


def read_rest(ob: Object) -> Rest:
    """Return the rest pose of an armature."""
    bones = ob.data.bones
    index = {bone.name: number for number, bone in enumerate(bones)}
    matrices = np.empty(16 * len(bones), np.float32)
    bones.foreach_get("matrix_local", matrices)
    columns = matrices.reshape(-1, 4, 4).astype(np.float64)  # Blender hands matrices out column by column
    pose = ob.pose.bones
    return Rest(
        names=tuple(index),
        parents=tuple(index[bone.parent.name] if bone.parent else -1 for bone in bones),
        rotations=axes.from_matrices(columns[:, :3, :3].transpose(0, 2, 1)),
        heads=np.ascontiguousarray(columns[:, 3, :3]),
        modes=tuple(pose[name].rotation_mode for name in index),
    )


def axes_from_file(rest: Rest, to_blender: Floats) -> Floats:
    """Return for each bone the rotation from the file's axes into its rest axes, `inverse(B) * K`."""
    return np.ascontiguousarray(axes.multiply(axes.inverse(rest.rotations), to_blender))


def file_frame(
    rest: Rest, skeleton: motion_theater.Skeleton, file_names: Mapping[str, str], to_blender: Floats
) -> tuple[Floats, list[str]]:
    """Return for each bone the rotation from the axes that the file gives it into its rest axes, and the file's order.

    Bones that the file does not know keep their own axes.
    """
    frame = np.tile(np.array(IDENTITY), (len(rest.names), 1))
    orders = ["XYZ"] * len(rest.names)
    into_rest = axes_from_file(rest, to_blender)
    bone_of = {file_names[name]: number for number, name in enumerate(skeleton.names) if name in file_names}
    for number, name in enumerate(rest.names):
        source = bone_of.get(name)
        if source is not None:
            frame[number] = axes.multiply(into_rest[number], np.asarray(skeleton.axes)[source])
            orders[number] = skeleton.orders[source]
    return frame, orders


def native_rig(
    rest: Rest, *, rate_hz: float, file_axes: Floats | None = None, file_orders: list[str] | None = None
) -> motion_theater.Rig:
    """Return the armature as the native module takes it.

    Bones in axis-angle mode count as quaternions here; the caller sees to it that they are never written.
    """
    return motion_theater.Rig(
        list(rest.names),
        rest_rotations=rest.rotations,
        rest_heads=rest.heads,
        parents=list(rest.parents),
        modes=["QUATERNION" if mode == "AXIS_ANGLE" else mode for mode in rest.modes],
        up=(0.0, 0.0, 1.0),
        rate_hz=rate_hz,
        file_axes=file_axes,
        file_orders=file_orders,
    )


def scale_from_rest(rest: Rest, skeleton: motion_theater.Skeleton, file_names: Mapping[str, str]) -> float:
    """Return scene units per file unit, from how large an armature of other origin is in comparison with the file.

    The mean distance of the bones from their middle is compared, over the bones that both have.
    """
    at = {name: number for number, name in enumerate(rest.names)}
    pairs = [(number, at[file_names[name]]) for number, name in enumerate(skeleton.names) if name in file_names]
    if not pairs:
        return skeleton.unit_m
    file_bones, scene_bones = (list(which) for which in zip(*pairs, strict=True))
    extent_file = _extent(np.asarray(skeleton.heads)[file_bones])
    extent_scene = _extent(rest.heads[scene_bones])
    if extent_file <= 0.0 or extent_scene <= 0.0:
        return skeleton.unit_m
    return extent_scene / extent_file


def _extent(points: Floats) -> float:
    """Return the mean distance of points from their middle."""
    return float(np.linalg.norm(points - points.mean(axis=0), axis=1).mean())
