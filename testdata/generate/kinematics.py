"""Forward kinematics of the skeleton, and the inverse: dof values that bring limbs where they are wanted.

Angles are radians, positions metres. A bone turns by `C * M * C^-1` in its parent's frame, where `C` are its own
axes in the rest pose and `M` its dof values about them.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from . import skeleton
from .rotations import Floats, frame_of, from_euler, normalised, rotate, to_euler, transposed

Dofs = dict[str, Floats]
"""Per bone with degrees of freedom (and "root": tx ty tz in metres, rx ry rz) an array (frames, dofs)."""

LONGEST_REACH = 0.9995
"""A leg is never quite straight: beyond this share of its length the knee would lock and snap."""


@dataclass(frozen=True)
class Pose:
    """Where every bone is, over frames: heads and tails (frames, 3), rotations (frames, 3, 3)."""

    heads: dict[str, Floats]
    tails: dict[str, Floats]
    rotations: dict[str, Floats]


def local_rotation(bone: skeleton.Bone, values: Floats) -> Floats:
    """The bone's rotation in its parent's frame for dof values (frames, dofs)."""
    angles = np.zeros((len(values), 3))
    for column, dof in enumerate(bone.dofs):
        angles[:, "xyz".index(dof[1])] = values[:, column]
    axes = bone.axes
    return axes @ from_euler(angles) @ axes.T


def forward(dofs: Dofs) -> Pose:
    """The pose of each frame."""
    root = dofs["root"]
    heads = {"root": root[:, :3]}
    tails = {"root": root[:, :3]}
    rotations = {"root": from_euler(root[:, 3:])}
    for bone in skeleton.BONES:
        rotation = rotations[bone.parent]
        if bone.dofs:
            rotation = rotation @ local_rotation(bone, dofs[bone.name])
        heads[bone.name] = tails[bone.parent]
        tails[bone.name] = heads[bone.name] + rotate(rotation, bone.offset_m)
        rotations[bone.name] = rotation
    return Pose(heads, tails, rotations)


def centre_of_mass(pose: Pose) -> Floats:
    """The body's centre of mass (frames, 3)."""
    masses = np.array([bone.mass for bone in skeleton.BONES])
    middles = np.stack([(pose.heads[bone.name] + pose.tails[bone.name]) / 2 for bone in skeleton.BONES])
    return np.average(middles, axis=0, weights=masses)


def euler_dofs(bone: skeleton.Bone, parent: Floats, rotation: Floats) -> Floats:
    """The three angles that turn a bone to `rotation` (global) under a parent turned by `parent`."""
    axes = bone.axes
    return to_euler(axes.T @ transposed(parent) @ rotation @ axes)


def turn_in_plane(vector: Floats, rest: Floats) -> Floats:
    """The angle about X that brings `rest` above or below `vector`, both seen along X."""
    angle: Floats = np.arctan2(vector[..., 2], vector[..., 1]) - np.arctan2(rest[2], rest[1])
    return (angle + np.pi) % (2 * np.pi) - np.pi


def solve_leg(
    side: str, pelvis: Floats, hip: Floats, ankle: Floats, knee_forward: Floats, foot_direction: Floats, toes: Floats
) -> Dofs:
    """Dofs of a leg whose ankle, foot direction and toe direction are given.

    `pelvis` is the global rotation of the hips, `knee_forward` the side to which the knee bends. The foot has no
    roll of its own, so the toes reach the given direction but for what the shin leans sideways.
    """
    femur, tibia, foot, toe = (skeleton.BY_NAME[side + name] for name in ("femur", "tibia", "foot", "toes"))
    upper, lower = (float(np.linalg.norm(bone.offset_m)) for bone in (femur, tibia))
    line = ankle - hip
    reach = np.linalg.norm(line, axis=-1)
    distance = np.minimum(reach, (upper + lower) * LONGEST_REACH)
    along = line / reach[:, None]
    across = knee_forward - np.sum(knee_forward * along, axis=-1, keepdims=True) * along
    across = normalised(across)
    cos_hip = (upper**2 + distance**2 - lower**2) / (2 * upper * distance)
    sin_hip = np.sqrt(1 - cos_hip**2)
    knee = hip + upper * (cos_hip[:, None] * along + sin_hip[:, None] * across)
    end = hip + distance[:, None] * along

    hinge = normalised(np.cross(-along, across))
    thigh_rotation = frame_of(hinge, -normalised(knee - hip)) @ femur.axes.T
    shin_rotation = frame_of(hinge, -normalised(end - knee)) @ tibia.axes.T
    shin = euler_dofs(tibia, thigh_rotation, shin_rotation)[:, :1]

    local = rotate(foot.axes.T @ transposed(shin_rotation), foot_direction)
    yaw = np.arctan2(local[:, 0], -local[:, 1])
    flat = np.stack([np.zeros(len(local)), -np.hypot(local[:, 0], local[:, 1]), local[:, 2]], axis=-1)
    pitch = turn_in_plane(flat, foot.axes.T @ np.array(foot.direction))
    foot_dofs = np.stack([pitch, yaw], axis=-1)
    foot_rotation = shin_rotation @ local_rotation(foot, foot_dofs)
    toe_local = rotate(toe.axes.T @ transposed(foot_rotation), toes)
    toe_pitch = turn_in_plane(toe_local, toe.axes.T @ np.array(toe.direction))
    return {
        femur.name: euler_dofs(femur, pelvis, thigh_rotation),
        tibia.name: shin,
        foot.name: foot_dofs,
        toe.name: toe_pitch[:, None],
    }


def solve_upper_arm(side: str, flexion: Floats, abduction: Floats, inward: Floats) -> Floats:
    """The three humerus dofs for an arm that hangs at zero, relative to the shoulder.

    `flexion` lifts it forwards, `abduction` outwards; `inward` turns the side to which the elbow bends from straight
    ahead towards the other arm.
    """
    bone = skeleton.BY_NAME[side + "humerus"]
    s = skeleton.sign(side)
    cos_f, sin_f, cos_a, sin_a = np.cos(flexion), np.sin(flexion), np.cos(abduction), np.sin(abduction)
    arm = np.stack([s * sin_a, -cos_a * cos_f, cos_a * sin_f], axis=-1)
    ahead = np.stack([np.zeros_like(cos_f), sin_f, cos_f], axis=-1)
    outward = np.stack([s * cos_a, sin_a * cos_f, -sin_a * sin_f], axis=-1)
    bend = np.cos(inward)[:, None] * ahead - np.sin(inward)[:, None] * outward
    rest_arm = np.array(bone.direction)
    rest_bend = np.cross(bone.axes[:, 0], rest_arm)
    rotation = frame_of(arm, bend) @ frame_of(rest_arm, rest_bend).T
    return to_euler(bone.axes.T @ rotation @ bone.axes)
