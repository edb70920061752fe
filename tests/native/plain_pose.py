"""Poses worked out a second time, from the files' own words and section by section as the format is described.

A bone turns by C M C^-1 in its parent's frame: C is its `axis`, M its values in dof order, each about a fixed axis,
the first listed applied first. It starts where its parent ends. No code is shared with the core.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

if TYPE_CHECKING:
    from pathlib import Path

    from tests.bench.plain_amc import Frame

Array = NDArray[np.float64]


@dataclass
class PlainBone:
    """One bone as the ASF describes it; angles in degrees."""

    name: str = "root"
    offset: Array = field(default_factory=lambda: np.zeros(3))
    axes: Array = field(default_factory=lambda: np.eye(3))
    dofs: list[str] = field(default_factory=list)


@dataclass
class PlainSkeleton:
    """Bones by name, `root` among them, and the name of each bone's parent, parents first."""

    bones: dict[str, PlainBone]
    parents: dict[str, str]
    position: Array


def turn(axis: str, degrees: float) -> Array:
    """Return the matrix of a turn about one fixed axis."""
    angle = math.radians(degrees)
    matrix = np.eye(3)
    first, second = [(1, 2), (2, 0), (0, 1)]["XYZ".index(axis.upper())]
    matrix[first, first] = matrix[second, second] = math.cos(angle)
    matrix[second, first] = math.sin(angle)
    matrix[first, second] = -math.sin(angle)
    return matrix


def turns(axes: list[str], degrees: list[float]) -> Array:
    """Return the matrix of several turns about fixed axes, the first listed applied first."""
    matrix = np.eye(3)
    for axis, angle in zip(axes, degrees, strict=True):
        matrix = turn(axis, angle) @ matrix
    return matrix


def read_asf(path: Path) -> PlainSkeleton:
    """Read what poses need: root, offsets, axes, dofs, hierarchy. The file's angles are degrees."""
    skeleton = PlainSkeleton({"root": PlainBone()}, {}, np.zeros(3))
    section, length, bone = "", 1.0, skeleton.bones["root"]
    order, orientation = list("XYZ"), [0.0, 0.0, 0.0]
    for line in path.read_text(encoding="utf-8").splitlines():
        words = line.split("#")[0].split()
        if not words:
            continue
        if words[0].startswith(":"):
            section = words[0].lower()
        elif section == ":root":
            if words[0] == "order":
                bone.dofs = [word.lower() for word in words[1:]]
            elif words[0] == "axis":
                order = list(words[1])
            elif words[0] == "position":
                skeleton.position = np.array(words[1:4], float)
            elif words[0] == "orientation":
                orientation = [float(word) for word in words[1:4]]
        elif section == ":bonedata":
            if words[0] == "begin":
                bone, direction = PlainBone(), np.zeros(3)
            elif words[0] == "name":
                bone.name = words[1]
                skeleton.bones[bone.name] = bone
            elif words[0] == "direction":
                direction = np.array(words[1:4], float)
            elif words[0] == "length":
                length = float(words[1])
            elif words[0] == "axis":
                bone.axes = turns(list(words[4]), [float(word) for word in words[1:4]])
            elif words[0] == "dof":
                bone.dofs = [word.lower() for word in words[1:]]
            elif words[0] == "end":
                bone.offset = direction * length
        elif section == ":hierarchy" and len(words) > 1:
            skeleton.parents.update(dict.fromkeys(words[1:], words[0]))
    skeleton.bones["root"].axes = turns(order, orientation)
    return skeleton


def plain_pose(skeleton: PlainSkeleton, frame: Frame) -> dict[str, tuple[Array, Array, Array]]:
    """Return per bone its start, its end and its rotation in the file's frame. Names in `frame` count as written."""
    root = dict(zip(skeleton.bones["root"].dofs, frame["root"], strict=True))
    start = skeleton.position + [root["tx"], root["ty"], root["tz"]]
    found = {"root": (start, start, _rotation(skeleton.bones["root"], frame["root"]))}
    waiting = list(skeleton.parents.items())
    while waiting:
        name, parent = waiting.pop(0)
        if parent not in found:
            waiting.append((name, parent))
            continue
        bone = skeleton.bones[name]
        _, start, around = found[parent]
        rotation = around @ _rotation(bone, frame.get(name, []))
        found[name] = (start, start + rotation @ bone.offset, rotation)
    return found


def _rotation(bone: PlainBone, values: list[float]) -> Array:
    used = [(dof[1], value) for dof, value in zip(bone.dofs, values, strict=False) if dof[0] == "r"]
    own = turns([axis for axis, _ in used], [value for _, value in used])
    return bone.axes @ own @ bone.axes.T
