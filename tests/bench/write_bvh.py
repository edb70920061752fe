"""A motion as BVH, where the take that is measured has no such file of its own."""

from __future__ import annotations

from pathlib import Path

import numpy as np
from scipy.spatial.transform import Rotation

import motion_theater as mt
from tests.bench.files import Take

FRAME_TIME_S = 1 / 120


def write_bvh(take: Take, path: Path) -> Path:
    """Write the same poses: six channels for the root, three for every other joint."""
    skeleton = mt.read(take.asf).skeleton
    assert skeleton is not None
    motion = mt.read(take.amc, skeleton=skeleton).motion
    assert motion is not None
    order: list[int] = []
    lines = ["HIERARCHY", *_joint(skeleton, 0, order), "MOTION", f"Frames: {motion.frames}"]
    lines.append(f"Frame Time: {FRAME_TIME_S:.7f}")
    rest = Rotation.from_quat(skeleton.axes, scalar_first=True)
    parents = np.array([skeleton.parents[bone] for bone in order[1:]])
    for frame in range(motion.first_frame, motion.first_frame + motion.frames):
        heads, _, rotations = motion.pose(skeleton, float(frame))
        turned = Rotation.from_quat(rotations, scalar_first=True) * rest.inv()
        local = turned[parents].inv() * turned[np.array(order[1:])]
        angles = np.vstack([turned[0].as_euler("ZYX", degrees=True), local.as_euler("ZYX", degrees=True)])
        lines.append(" ".join(f"{value:.6g}" for value in (*heads[0], *angles.ravel())))
    path.write_text("\n".join(lines) + "\n", encoding="ascii")
    return path


def _joint(skeleton: mt.Skeleton, bone: int, order: list[int]) -> list[str]:
    """Return the lines of a joint and all below it, and note the order in which their channels come."""
    order.append(bone)
    parent = skeleton.parents[bone]
    offset = skeleton.heads[bone] - (skeleton.heads[parent] if parent >= 0 else 0)
    position = "" if parent >= 0 else "Xposition Yposition Zposition "
    lines = [
        f"{'JOINT' if parent >= 0 else 'ROOT'} {skeleton.names[bone]}",
        "{",
        _offset(offset),
        f"CHANNELS {3 if parent >= 0 else 6} {position}Zrotation Yrotation Xrotation",
    ]
    children = [child for child, up in enumerate(skeleton.parents) if up == bone]
    for child in children:
        lines += _joint(skeleton, child, order)
    if not children:
        lines += ["End Site", "{", _offset(skeleton.tails[bone] - skeleton.heads[bone]), "}"]
    return [*lines, "}"]


def _offset(vector: mt.Floats) -> str:
    return "OFFSET " + " ".join(f"{value:.6g}" for value in vector)
