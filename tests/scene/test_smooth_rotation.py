"""A joint that turns through 180 degrees stays smooth, whatever its rotation mode."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import bpy
import numpy as np
import pytest

from tests import harness

SKELETON = """:version 1.10
:name top
:units
  mass 1.0
  length 0.45
  angle deg
:documentation
  spins
:root
  order TX TY TZ RX RY RZ
  axis XYZ
  position 0 0 0
  orientation 0 0 0
:bonedata
  begin
    id 1
    name arm
    direction 0 1 0
    length 10
    axis 30 20 10 XYZ
    dof rx ry rz
  end
:hierarchy
  begin
    root arm
  end
"""
JUMP = np.radians(60.0)  # a wrapped angle jumps by 180 or 360 degrees; 7 degrees a frame stay below this in any mode
MODES = ("QUATERNION", "XYZ", "ZYX", "YXZ")


def spinning(folder: Path) -> bpy.types.Object:
    """Return a bone that turns through -180 degrees and on, as angles that jump from 180 to -180."""
    (folder / "top.asf").write_text(SKELETON)
    lines = [":FULLY-SPECIFIED", ":DEGREES", ":SAMPLES-PER-SECOND 24"]
    for frame in range(1, 121):
        angle = (frame * 7.0 + 180.0) % 360.0 - 180.0
        lines += [f"{frame}", f"root 0 0 0 0 {angle:.6f} 0", f"arm 10 {angle:.6f} -5"]
    (folder / "top.amc").write_text("\n".join(lines) + "\n")
    bpy.ops.motion_theater.import_skeleton(filepath=str(folder / "top.asf"))
    return harness.armature()


def steps(ob: bpy.types.Object, bone: str, mode: str) -> np.ndarray:
    """Return by how much the values of the rotation curves change from key to key."""
    channel = "rotation_quaternion" if mode == "QUATERNION" else "rotation_euler"
    return np.abs(np.diff(harness.key_rows(ob, bone, channel)[:, 1:], axis=0)).max(axis=1)


@pytest.mark.parametrize("mode", MODES)
def test_curves_have_no_jump(tmp_path: Path, mode: Any) -> None:
    ob = spinning(tmp_path)
    for bone in ob.pose.bones:
        bone.rotation_mode = mode
    bpy.ops.motion_theater.add_track(filepath=str(tmp_path / "top.amc"))
    for name in ("root", "arm"):
        assert steps(ob, name, mode).max() < JUMP


@pytest.mark.parametrize("kind", ["MEDIAN", "AVERAGE", "WEIGHTED"])
@pytest.mark.parametrize("mode", MODES)
def test_a_filter_shows_no_spike(tmp_path: Path, mode: Any, kind: str) -> None:
    ob = spinning(tmp_path)
    for bone in ob.pose.bones:
        bone.rotation_mode = mode
    bpy.ops.motion_theater.add_track(filepath=str(tmp_path / "top.amc"))
    unfiltered = [harness.pose(ob, frame) for frame in range(10, 110)]
    bpy.ops.motion_theater.filter(kind=kind, depth=5)
    assert steps(ob, "arm", mode).max() < JUMP
    for frame, was in zip(range(10, 110), unfiltered, strict=True):
        turned = was[1, :3, :3].T @ harness.pose(ob, frame)[1, :3, :3]
        assert np.degrees(np.arccos(np.clip((np.trace(turned) - 1) / 2, -1, 1))) < 5.0


def test_both_rotation_modes_show_the_same_pose(tmp_path: Path) -> None:
    ob = spinning(tmp_path)
    bpy.ops.motion_theater.add_track(filepath=str(tmp_path / "top.amc"))
    as_quaternions = [harness.pose(ob, frame) for frame in range(1, 121)]
    harness.module("stack").remove_entry(ob, 0)
    for bone in ob.pose.bones:
        bone.rotation_mode = "ZXY"
    bpy.ops.motion_theater.add_track(filepath=str(tmp_path / "top.amc"))
    for frame, was in zip(range(1, 121), as_quaternions, strict=True):
        assert np.abs(harness.pose(ob, frame) - was).max() < 1e-5


def test_changing_the_mode_moves_the_motion_to_the_channels_that_count(tmp_path: Path) -> None:
    ob = spinning(tmp_path)
    bpy.ops.motion_theater.add_track(filepath=str(tmp_path / "top.amc"))
    for bone in ob.pose.bones:
        bone.rotation_mode = "XYZ"
    harness.module("stack").rebuild(ob)
    assert {path.rpartition(".")[2] for path, _ in harness.keys(ob)} == {"location", "rotation_euler"}


def test_axis_angle_is_refused_in_words(tmp_path: Path) -> None:
    ob = spinning(tmp_path)
    ob.pose.bones["arm"].rotation_mode = "AXIS_ANGLE"
    before = harness.snapshot()
    message = harness.refusal(lambda: bpy.ops.motion_theater.add_track(filepath=str(tmp_path / "top.amc")))
    assert "arm" in message
    assert "Axis Angle" in message
    assert harness.snapshot() == before


def test_euler_channels_of_the_files_axes_are_the_files_own_numbers(tmp_path: Path) -> None:
    spinning(tmp_path)
    bpy.ops.motion_theater.import_skeleton(filepath=str(tmp_path / "top.asf"), bone_style="AXES")
    ob = harness.armature()
    bpy.ops.motion_theater.add_track(filepath=str(tmp_path / "top.amc"))
    angles = np.degrees(harness.key_rows(ob, "arm", "rotation_euler"))[:, 1:]
    frame = np.arange(1, 121)
    turns = np.round((angles[:, 1] - frame * 7.0) / 360.0)
    assert np.abs(angles[:, 0] - 10).max() < 1e-3
    assert np.abs(angles[:, 1] - frame * 7.0 - 360.0 * turns).max() < 1e-3
    assert np.abs(angles[:, 2] + 5).max() < 1e-3
    assert len(np.unique(turns)) == 1
