"""Acclaim files as text, with six significant digits, as the public data sets have them."""

from __future__ import annotations

import json
from dataclasses import asdict

import numpy as np

from . import skeleton
from .clips import CLIPS, RATE_HZ, recorded_clip
from .kinematics import Dofs
from .rotations import Floats

SKELETON_FILE = "human.asf"

ARM = ("clavicle", "humerus", "radius", "wrist", "hand", "fingers", "thumb")
LEG = ("femur", "tibia", "foot", "toes")

FRAME_ORDER: tuple[str, ...] = (
    ("root", "lowerback", "upperback", "thorax", "lowerneck", "upperneck", "head")
    + tuple("r" + name for name in ARM)
    + tuple("l" + name for name in ARM)
    + tuple("r" + name for name in LEG)
    + tuple("l" + name for name in LEG)
)
"""The bones of an AMC frame, in the order in which such files usually have them."""


def number(value: float) -> str:
    """Six significant digits, and no minus before a zero."""
    text = f"{value:.6g}"
    return "0" if text == "-0" else text


def _numbers(values: Floats | tuple[float, ...]) -> str:
    return " ".join(number(value) for value in values)


def asf() -> str:
    """The skeleton file."""
    lines = [
        "# The usual Acclaim human with lengths of our own: 30 bones, Y up, facing +Z.",
        "# Made by testdata/generate of Motion Theater. Lengths are inches times 0.45.",
        ":version 1.10",
        ":name human",
        ":units",
        "  mass 1.0",
        f"  length {number(skeleton.LENGTH_UNIT)}",
        "  angle deg",
        ":documentation",
        "   A person of about 1.75 m for tests and the demo of Motion Theater.",
        "   Dedicated to the public domain (CC0 1.0).",
        ":root",
        "   order TX TY TZ RX RY RZ",
        "   axis XYZ",
        "   position 0 0 0",
        "   orientation 0 0 0",
        ":bonedata",
    ]
    for index, bone in enumerate(skeleton.BONES, start=1):
        lines += [
            "  begin",
            f"     id {index}",
            f"     name {bone.name}",
            f"     direction {_numbers(bone.direction)}",
            f"     length {number(bone.length)}",
            f"     axis {_numbers(bone.axis_deg)} XYZ",
        ]
        if bone.dofs:
            lines.append(f"    dof {' '.join(bone.dofs)}")
            limits = [f"({low:.1f} {high:.1f})" for low, high in bone.limits_deg]
            lines.append(f"    limits {limits[0]}")
            lines += [f"           {pair}" for pair in limits[1:]]
        lines.append("  end")
    lines += [":hierarchy", "  begin"]
    for parent in ("root", *skeleton.BY_NAME):
        children = [bone.name for bone in skeleton.BONES if bone.parent == parent]
        if children:
            lines.append(f"    {' '.join([parent, *children])}")
    lines.append("  end")
    return "\n".join(lines) + "\n"


def amc(name: str, dofs: Dofs) -> str:
    """A motion file: positions in file units, angles in degrees within half a turn."""
    lines = [
        f"#!OML:ASF {SKELETON_FILE}",
        f"# {name}: {CLIPS[name].about}. Made by testdata/generate of Motion Theater.",
        ":FULLY-SPECIFIED",
        ":DEGREES",
        f":SAMPLES-PER-SECOND {number(RATE_HZ)}",
    ]
    columns = {bone: _file_values(bone, dofs[bone]) for bone in FRAME_ORDER}
    for frame in range(len(dofs["root"])):
        lines.append(str(frame + 1))
        lines += [f"{bone} {_numbers(columns[bone][frame])}" for bone in FRAME_ORDER]
    return "\n".join(lines) + "\n"


def _file_values(name: str, values: Floats) -> Floats:
    """A bone's dofs as the file has them."""
    converted = np.empty_like(values)
    for column, dof in enumerate(skeleton.dofs_of(name)):
        if dof.startswith("t"):
            converted[:, column] = values[:, column] / skeleton.UNIT_M
        else:
            converted[:, column] = (np.degrees(values[:, column]) + 180.0) % 360.0 - 180.0
    return converted


def spikes() -> str:
    """The list of spikes of every clip, for tests."""
    table = {name: [asdict(spike) for spike in clip.spikes] for name, clip in CLIPS.items()}
    return json.dumps(table, indent=2) + "\n"


def files() -> dict[str, str]:
    """Every generated file: its name and its text."""
    texts = {SKELETON_FILE: asf(), "spikes.json": spikes()}
    for name in CLIPS:
        texts[f"{name}.amc"] = amc(name, recorded_clip(name))
    return texts
