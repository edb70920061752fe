"""What Blender shows = the core's forward kinematics = what independent readers report, for real files."""

from __future__ import annotations

import json
from pathlib import Path

import bpy
import numpy as np
import pytest

import motion_theater
from tests import harness

TOLERANCE = 1e-4  # of the skeleton's height: float32 keys and rest poses, over ten bones in a row
EVERY = 25
FOLDER = harness.SHARED / "asf_amc"
PAIRS = (
    [
        (folder / asf, folder / amc)
        for folder, asf, amc in (
            (FOLDER / "cmu01", "01.asf", "01_01.amc"),
            (FOLDER / "cmu02", "02.asf", "02_03.amc"),
            (FOLDER / "cmu02", "02.asf", "02_04.amc"),
            (FOLDER / "cmu09", "09-run.asf", "09_06-run.amc"),
            (FOLDER / "cmu135", "135-martialArts.asf", "135_06-martialArts.amc"),
            (FOLDER / "cmu135", "135-martialArts.asf", "135_06-martialArts-le-N40.amc"),
            (FOLDER / "endorphin", "skeleton.asf", "walking.amc"),
        )
    ]
    if FOLDER.is_dir()
    else []
)
OWN = [(harness.TESTDATA / "human.asf", path) for path in sorted(harness.TESTDATA.glob("*.amc"))]
STYLES = ("POINT", "AXES")


def converted(points: np.ndarray, motion_up: str, scale: float) -> np.ndarray:
    """Return points of the file in Blender's axes and units, worked out here by hand."""
    x, y, z = np.asarray(points, np.float64).T
    assert motion_up in {"Y", "Z"}
    return scale * (np.column_stack([x, -z, y]) if motion_up == "Y" else np.column_stack([x, y, z]))


@pytest.mark.parametrize("style", STYLES)
@pytest.mark.parametrize("pair", [*OWN, *PAIRS], ids=lambda pair: pair[1].stem)
def test_heads_and_tails_are_those_of_the_core(pair: tuple[Path, Path], style: str) -> None:
    asf, amc = pair
    bpy.ops.motion_theater.import_skeleton(filepath=str(asf), bone_style=style)
    ob = harness.armature()
    bpy.ops.motion_theater.add_track(filepath=str(amc), rate="SCENE")
    skeleton = motion_theater.read(asf).skeleton
    motion = motion_theater.read(amc, skeleton=skeleton).motion
    stack = ob.motion_theater
    limit = TOLERANCE * skeleton.height * stack.unit_m
    bones = [ob.pose.bones.find(name) for name in skeleton.names]
    rest = np.array([np.array(ob.data.bones[name].matrix_local) for name in skeleton.names])
    rest_tails = converted(skeleton.tails, stack.up, stack.unit_m)
    tails_in_bone = np.einsum("nij,nj->ni", np.linalg.inv(rest), np.column_stack([rest_tails, np.ones(len(rest))]))
    points = np.linalg.norm(np.asarray(skeleton.tails) - skeleton.heads, axis=1) < 1e-9
    worst = 0.0
    for frame in range(motion.first_frame, motion.first_frame + motion.frames, EVERY):
        heads, tails, _ = motion.pose(skeleton, frame)
        matrices = harness.pose(ob, frame)[bones]
        shown = np.einsum("nij,nj->ni", matrices, tails_in_bone)[:, :3]
        worst = max(
            worst,
            np.abs(matrices[:, :3, 3] - converted(heads, stack.up, stack.unit_m)).max(),
            np.abs(shown - converted(tails, stack.up, stack.unit_m)).max(),
        )
        if style == "POINT":
            drawn = np.array([ob.pose.bones[bone].tail for bone in bones])
            worst = max(worst, np.abs(drawn - converted(tails, stack.up, stack.unit_m))[~points].max())
    assert worst <= limit


def reported() -> list[tuple[Path, Path, list[dict[str, object]]]]:
    """Return the positions that an independent reader reports, for the files that it reads rightly."""
    path = harness.SHARED / "facts.json"
    if not path.is_file():
        return []
    rows = []
    for name, facts in json.loads(path.read_text())["files"].items():
        for tool, fact in facts.items():
            trusted = "AMCParser" in tool and "N40" not in name and "endorphin" not in name
            if trusted and "forward_kinematics" in fact:
                amc = harness.SHARED / name
                rows.append((amc.parent / facts["skeleton"], amc, fact["forward_kinematics"]))
    return rows


@pytest.mark.parametrize("style", STYLES)
@pytest.mark.parametrize("case", reported(), ids=lambda case: case[1].stem)
def test_tails_are_those_of_an_independent_reader(case: tuple[Path, Path, list[dict]], style: str) -> None:
    asf, amc, facts = case
    bpy.ops.motion_theater.import_skeleton(filepath=str(asf), bone_style=style)
    ob = harness.armature()
    bpy.ops.motion_theater.add_track(filepath=str(amc), rate="SCENE")
    skeleton, stack = motion_theater.read(asf).skeleton, ob.motion_theater
    first = ob.motion_theater.entries[0].clip_first
    rest = {name: np.array(ob.data.bones[name].matrix_local) for name in skeleton.names}
    tails = dict(zip(skeleton.names, converted(skeleton.tails, stack.up, stack.unit_m), strict=True))
    assert facts
    for fact in facts:
        bone = fact["bone"]
        matrices = harness.pose(ob, first + fact["frame_index"])
        end = matrices[ob.pose.bones.find(bone)] @ np.linalg.inv(rest[bone]) @ [*tails[bone], 1.0]
        expected = converted(np.array([fact["end_position_asf_units"]]), stack.up, stack.unit_m)[0]
        assert np.abs(end[:3] - expected).max() <= TOLERANCE * skeleton.height * stack.unit_m, fact
