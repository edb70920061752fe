"""The motion of an armature at given frames, however it comes about.

Where F-curves alone move the bones they are evaluated, which leaves the current frame alone. Constraints, drivers, the
NLA and whatever else decides over a pose need Blender to go through the frames; afterwards the frame is what it was.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from .. import compat, rig, scene
from ..logic import axes
from ..logic.keys import LINEAR
from . import read

if TYPE_CHECKING:
    from bpy.types import FCurve, Object, PoseBone, Scene

    from ..logic.axes import Floats

STILL = 1e-6  # below this share of the armature's size an offset is rounding


@dataclass(frozen=True)
class Sampled:
    """By bone, in the order of the rest pose: rotation and offset from it, in armature axes."""

    rotations: list[Floats]
    """(frames, 4) each: a bone's global rotation is that of its parent times this one."""
    offsets: list[Floats]
    """(frames, 3) each, in the axes of the parent's global rotation."""
    is_from_curves: bool


def sample(ob: Object, current: Scene, rest: rig.Rest, frames: Floats) -> Sampled:
    """Return the motion of an armature at these scene frames."""
    return _from_curves(ob, rest, frames) if moved_by_curves_alone(ob) else _from_poses(ob, current, rest, frames)


def moved_by_curves_alone(ob: Object) -> bool:
    """Return whether the pose is nothing but the values of the F-curves of one action."""
    curves = read.index(compat.bag_of(ob, ob.animation_data.action if ob.animation_data else None))
    scaled = {path for path, _ in curves if path.endswith(".scale")}
    return shows_one_action(ob) and all(
        _follows_its_channels(bone) and read.path(bone.name, "scale") not in scaled for bone in ob.pose.bones
    )


def shows_one_action(ob: Object) -> bool:
    """Return whether the channels of an armature have the values of one action, and these decide over the pose."""
    for owner in (ob, ob.data):
        animation = owner.animation_data
        if animation is None:
            continue
        uses_nla = animation.use_nla and any(not track.mute for track in animation.nla_tracks)
        is_mixed = animation.action_influence != 1.0 or animation.action_blend_type != "REPLACE"
        if uses_nla or is_mixed or len(animation.drivers):
            return False
    return bool(ob.data.pose_position == "POSE")


def _follows_its_channels(bone: PoseBone) -> bool:
    is_constrained = any(not one.mute and one.influence > 0.0 for one in bone.constraints)
    is_plain = bone.bone.use_inherit_rotation and bone.bone.use_local_location and bone.rotation_mode != "AXIS_ANGLE"
    return is_plain and not is_constrained and all(scale == 1.0 for scale in bone.scale)


def _from_curves(ob: Object, rest: rig.Rest, frames: Floats) -> Sampled:
    action = ob.animation_data.action if ob.animation_data else None
    curves = read.index(compat.bag_of(ob, action))
    rotations, offsets = [], []
    for number, name in enumerate(rest.names):
        bone, mode = ob.pose.bones[name], rest.modes[number]
        own = rest.rotations[number]
        channel = "rotation_quaternion" if mode == "QUATERNION" else "rotation_euler"
        values = _values(curves, bone, channel, frames)
        basis = values if mode == "QUATERNION" else axes.from_euler(values, mode)
        length = np.linalg.norm(basis, axis=1, keepdims=True)
        basis = np.where(length > 0.0, basis / np.where(length > 0.0, length, 1.0), (1.0, 0.0, 0.0, 0.0))
        rotations.append(axes.multiply(axes.multiply(own, basis), axes.inverse(own)))
        is_free = not (bone.bone.use_connect and bone.parent)
        offset = axes.rotate(own, _values(curves, bone, "location", frames)) if is_free else np.zeros((len(frames), 3))
        offsets.append(offset)
    return Sampled(rotations, offsets, is_from_curves=True)


def _values(curves: read.Index, bone: PoseBone, channel: str, frames: Floats) -> Floats:
    still = getattr(bone, channel)
    columns = [
        _column(curves.get((read.path(bone.name, channel), at)), still[at], frames)
        for at in range(read.CHANNELS[channel])
    ]
    return np.stack(columns, axis=1)


def _column(curve: FCurve | None, still: float, frames: Floats) -> Floats:
    if curve is None or curve.mute or curve.is_empty:
        return np.full(len(frames), still, np.float64)
    is_linear = (
        len(curve.keyframe_points)
        and not len(curve.modifiers)
        and curve.extrapolation == "CONSTANT"
        and (read.field(curve, "interpolation") == LINEAR).all()
    )
    if is_linear:
        keys = read.coordinates(curve).astype(np.float64)
        return np.interp(frames, keys[0::2], keys[1::2])
    return np.array([curve.evaluate(frame) for frame in frames.tolist()])


def matrices(ob: Object, current: Scene, frames: Floats) -> Floats:
    """Return (frames, bones, 4, 4): the pose matrices at scene frames, each with its columns as rows."""
    rows = np.empty((len(frames), 16 * len(ob.pose.bones)), np.float32)
    with scene.same_frame(current):
        for row, frame in zip(rows, frames.tolist(), strict=True):
            scene.go_to(current, frame)
            ob.pose.bones.foreach_get("matrix", row)
    return rows.reshape(len(frames), -1, 4, 4).astype(np.float64)


def _from_poses(ob: Object, current: Scene, rest: rig.Rest, frames: Floats) -> Sampled:
    columns = matrices(ob, current, frames)
    turned = columns[:, :, :3, :3].transpose(0, 1, 3, 2)
    turned = turned / np.linalg.norm(turned, axis=2, keepdims=True)
    heads = columns[:, :, 3, :3]
    whole_turn = [
        axes.multiply(axes.from_matrices(turned[:, at]), axes.inverse(rest.rotations[at]))
        for at in range(len(rest.names))
    ]
    size = float(np.ptp(rest.heads, axis=0).max(initial=0.0))
    rotations, offsets = [], []
    for number, parent in enumerate(rest.parents):
        if parent < 0:
            rotation, offset = whole_turn[number], heads[:, number] - rest.heads[number]
        else:
            back = axes.inverse(whole_turn[parent])
            rotation = axes.multiply(back, whole_turn[number])
            apart = axes.rotate(back, heads[:, number] - heads[:, parent])
            offset = apart - (rest.heads[number] - rest.heads[parent])
        rotations.append(rotation)
        offsets.append(offset if np.abs(offset).max(initial=0.0) > STILL * size else np.zeros_like(offset))
    return Sampled(rotations, offsets, is_from_curves=False)
