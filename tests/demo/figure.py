"""The mannequin: round cones for the bones of the usual Acclaim human, plain ones for any other bone."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Set

import numpy as np

from .camera import Colour, Floats
from .cones import RoundCone

LIMBS: dict[str, tuple[float, float]] = {
    "femur": (0.088, 0.056),
    "tibia": (0.055, 0.036),
    "foot": (0.040, 0.036),
    "toes": (0.035, 0.024),
    "humerus": (0.055, 0.038),
    "radius": (0.039, 0.031),
    "wrist": (0.031, 0.025),
    "hand": (0.033, 0.030),
    "fingers": (0.029, 0.018),
    "thumb": (0.017, 0.012),
}
"""Radii at start and end, for both sides."""

COLUMN: dict[str, tuple[float, float]] = {
    "lowerback": (0.108, 0.112),
    "upperback": (0.112, 0.118),
    "lowerneck": (0.060, 0.054),
    "upperneck": (0.054, 0.054),
}

UNDRAWN = frozenset({"root", "lhipjoint", "rhipjoint", "thorax", "lclavicle", "rclavicle", "head"})
"""Bones whose place the pelvis, the chest and the head take."""


def mannequin(
    heads: Mapping[str, Floats], tails: Mapping[str, Floats], tinted: Set[str], tint: Colour, plain: Colour
) -> list[RoundCone]:
    """The body for one frame; bones in `tinted` have the colour `tint`."""

    def colour(bone: str) -> Colour:
        return tint if bone in tinted else plain

    cones = []
    for name in heads:
        radii = LIMBS.get(name[1:]) or COLUMN.get(name)
        if radii is None and name not in UNDRAWN:
            thickness = max(0.1 * float(np.linalg.norm(tails[name] - heads[name])), 0.01)
            radii = (thickness, thickness)
        if radii is not None:
            cones.append(RoundCone(heads[name], tails[name], *radii, colour(name)))
    if {"lfemur", "rfemur", "lowerback"} <= heads.keys():
        cones += _pelvis(heads, colour("root"))
    if {"lhumerus", "rhumerus", "thorax"} <= heads.keys():
        cones += _chest(heads, tails, colour)
    if "head" in heads:
        cones += _head(heads, tails, colour)
    return cones


def _pelvis(heads: Mapping[str, Floats], colour: Colour) -> list[RoundCone]:
    left, right = heads["lfemur"], heads["rfemur"]
    middle = (left + right) / 2
    waist = heads["lowerback"]
    return [
        RoundCone(left + 0.25 * (middle - left), waist, 0.098, 0.106, colour),
        RoundCone(right + 0.25 * (middle - right), waist, 0.098, 0.106, colour),
    ]


def _chest(
    heads: Mapping[str, Floats], tails: Mapping[str, Floats], colour: Callable[[str], Colour]
) -> list[RoundCone]:
    base, neck = heads["thorax"], tails["thorax"]
    breast = neck - 0.30 * (neck - base)
    cones = [RoundCone(base, breast, 0.118, 0.108, colour("thorax"))]
    for side in ("l", "r"):
        shoulder = heads[side + "humerus"]
        inner = breast + 0.50 * (shoulder - neck)
        cones.append(RoundCone(base, inner, 0.116, 0.098, colour("thorax")))
        cones.append(RoundCone(inner, shoulder, 0.092, 0.060, colour(side + "clavicle")))
        cones.append(RoundCone(neck + 0.25 * (neck - base), shoulder, 0.056, 0.058, colour(side + "clavicle")))
    return cones


def _head(heads: Mapping[str, Floats], tails: Mapping[str, Floats], colour: Callable[[str], Colour]) -> list[RoundCone]:
    """A head with a visor, so that one sees where it looks."""
    base, top = heads["head"], tails["head"]
    up = top - base
    across = heads["lhumerus"] - heads["rhumerus"] if "lhumerus" in heads else np.array([1.0, 0.0, 0.0])
    ahead = np.cross(across, up)
    ahead /= np.linalg.norm(ahead)
    sideways = np.cross(up, ahead) / np.linalg.norm(up)
    shade = tuple(int(part * 0.42) for part in colour("head"))
    eyes = base + 0.72 * up + 0.047 * ahead
    return [
        RoundCone(base + 0.1 * up + 0.012 * ahead, top + 0.22 * up, 0.074, 0.094, colour("head")),
        RoundCone(eyes + 0.034 * sideways, eyes - 0.034 * sideways, 0.050, 0.050, (shade[0], shade[1], shade[2])),
    ]
