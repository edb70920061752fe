"""The usual Acclaim human: root and 30 bones, with lengths and directions of our own.

Directions, axes and offsets are those of the rest pose: Y up, facing +Z, the left side at +X, arms held out, legs
20 degrees apart. Lengths are file units.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import cos, radians, sin

import numpy as np

from .rotations import Floats, from_euler

LENGTH_UNIT = 0.45
"""The number behind `length` in the file: a length in inches times this is the number in the file."""

UNIT_M = 0.0254 / LENGTH_UNIT
"""Metres per file unit."""

LEG_SPREAD_DEG = 20.0
FOOT_SLOPE_DEG = 20.0
"""How steeply the foot bone falls from ankle to toes while the sole is flat."""

SIDES = ("l", "r")
"""Left and right, as the names of bones begin."""


def sign(side: str) -> int:
    """+1 for the left side, -1 for the right: the direction of X that leads outwards."""
    return 1 if side == "l" else -1


@dataclass(frozen=True)
class Bone:
    """One bone as the file states it."""

    name: str
    parent: str
    direction: tuple[float, float, float]
    length: float
    axis_deg: tuple[float, float, float] = (0.0, 0.0, 0.0)
    dofs: tuple[str, ...] = ()
    limits_deg: tuple[tuple[float, float], ...] = ()
    mass: float = 0.0
    """Share of the body's mass, thought of as lying in the middle of the bone."""

    @property
    def axes(self) -> Floats:
        """The bone's rotation axes in the rest pose, as a matrix of columns."""
        return from_euler(np.radians(self.axis_deg))

    @property
    def offset_m(self) -> Floats:
        """From the bone's start to its end in the rest pose, in metres."""
        return np.array(self.direction) * self.length * UNIT_M


def _unit(x: float, y: float, z: float) -> tuple[float, float, float]:
    length = (x * x + y * y + z * z) ** 0.5
    return (round(x / length, 6), round(y / length, 6), round(z / length, 6))


def _mirrored_limits(dofs: tuple[str, ...], left: tuple[tuple[float, float], ...]) -> tuple[tuple[float, float], ...]:
    """Limits of the right side: turns about Y and Z change their sign in the mirror, turns about X do not."""
    return tuple(pair if dof == "rx" else (-pair[1], -pair[0]) for dof, pair in zip(dofs, left, strict=True))


def _limb(side: str) -> list[Bone]:
    """Leg and arm of one side."""
    s = sign(side)
    spread, slope = radians(LEG_SPREAD_DEG), radians(FOOT_SLOPE_DEG)
    down = _unit(s * sin(spread), -cos(spread), 0.0)
    forward_down = _unit(s * sin(spread) * sin(slope), -cos(spread) * sin(slope), cos(slope))
    leg_axis = (0.0, 0.0, s * LEG_SPREAD_DEG)
    foot_axis = (-90.0, 0.0, s * LEG_SPREAD_DEG)
    arm_axis = (180.0, s * -30.0, s * -90.0)
    hand_axis = (0.0, s * 90.0, s * 90.0)
    outwards = (float(s), 0.0, 0.0)

    def bone(
        name: str,
        parent: str,
        direction: tuple[float, float, float],
        length: float,
        axis: tuple[float, float, float],
        dofs: str,
        limits: tuple[tuple[float, float], ...],
        mass: float,
    ) -> Bone:
        parent = parent if parent in ("root", "thorax") else side + parent
        words = tuple(dofs.split())
        bounds = limits if side == "l" else _mirrored_limits(words, limits)
        return Bone(side + name, parent, direction, length, axis, words, bounds, mass)

    none = (0.0, 0.0, 0.0)
    return [
        bone("hipjoint", "root", _unit(s * 0.56, -0.76, 0.33), 2.5, none, "", (), 0.03),
        bone("femur", "hipjoint", down, 7.5, leg_axis, "rx ry rz", ((-160, 40), (-70, 70), (-60, 70)), 0.1),
        bone("tibia", "femur", down, 7.7, leg_axis, "rx", ((-10, 170),), 0.045),
        bone("foot", "tibia", forward_down, 2.2, foot_axis, "rx rz", ((-60, 90), (-70, 70)), 0.013),
        bone("toes", "foot", (0.0, 0.0, 1.0), 1.1, foot_axis, "rx", ((-90, 40),), 0.002),
        bone("clavicle", "thorax", _unit(s * 0.93, 0.35, -0.08), 3.5, none, "ry rz", ((-30, 30), (-20, 40)), 0.02),
        bone("humerus", "clavicle", outwards, 5.6, arm_axis, "rx ry rz", ((-120, 120), (-90, 90), (-90, 150)), 0.028),
        bone("radius", "humerus", outwards, 3.6, arm_axis, "rx", ((-10, 170),), 0.012),
        bone("wrist", "radius", outwards, 1.8, hand_axis, "ry", ((-180, 180),), 0.004),
        bone("hand", "wrist", outwards, 0.6, hand_axis, "rx rz", ((-90, 90), (-60, 60)), 0.004),
        bone("fingers", "hand", outwards, 0.5, hand_axis, "rx", ((-30, 90),), 0.001),
        bone("thumb", "wrist", _unit(s, 0.0, 1.0), 0.7, (-90.0, s * 45.0, 0.0), "rx rz", ((-60, 60), (-60, 60)), 0.001),
    ]


def _column() -> list[Bone]:
    """From the lower back to the head."""
    dofs = ("rx", "ry", "rz")
    limits = ((-40.0, 60.0), (-60.0, 60.0), (-45.0, 45.0))
    none = (0.0, 0.0, 0.0)
    return [
        Bone("lowerback", "root", _unit(0.0, 0.996, -0.09), 2.0, none, dofs, limits, 0.15),
        Bone("upperback", "lowerback", _unit(0.0, 1.0, -0.02), 2.0, none, dofs, limits, 0.12),
        Bone("thorax", "upperback", _unit(0.0, 0.999, 0.03), 2.0, none, dofs, limits, 0.13),
        Bone("lowerneck", "thorax", _unit(0.0, 0.995, 0.1), 1.75, none, dofs, limits, 0.01),
        Bone("upperneck", "lowerneck", _unit(0.0, 0.998, -0.06), 1.75, none, dofs, limits, 0.02),
        Bone("head", "upperneck", _unit(0.0, 1.0, -0.03), 1.8, none, dofs, limits, 0.05),
    ]


def _human() -> tuple[Bone, ...]:
    left, right = _limb("l"), _limb("r")
    return tuple(left[:5] + right[:5] + _column() + left[5:] + right[5:])


BONES: tuple[Bone, ...] = _human()
"""All bones but the root, parents before children."""

BY_NAME: dict[str, Bone] = {bone.name: bone for bone in BONES}

ROOT_DOFS = ("tx", "ty", "tz", "rx", "ry", "rz")


def dofs_of(name: str) -> tuple[str, ...]:
    """The degrees of freedom of a bone or of the root, in file order."""
    return ROOT_DOFS if name == "root" else BY_NAME[name].dofs
