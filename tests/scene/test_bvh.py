"""A BVH is a setup pose and a track, and plays as the core and as Blender's own importer have it."""

from __future__ import annotations

from pathlib import Path

import addon_utils
import bpy
import numpy as np
import pytest

import motion_theater
from tests import harness

TOLERANCE = 1e-4  # of the skeleton's size
FRAMES = 12
FILES = sorted((harness.SHARED / "bvh").glob("*.bvh"))
OWN = """HIERARCHY
ROOT Hips
{
 OFFSET 0 90 0
 CHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation
 JOINT Leg
 {
  OFFSET 10 0 0
  CHANNELS 1 Xrotation
  JOINT Foot
  {
   OFFSET 0 -45 0
   End Site
   {
    OFFSET 0 -45 10
   }
  }
 }
}
MOTION
Frames: 4
Frame Time: 0.0333333
0 90 0 0 0 0 0
1 91 2 10 20 30 40
2 92 4 20 40 60 80
3 93 6 30 60 90 120
"""
axes = harness.module("logic.axes")


@pytest.fixture
def own(tmp_path: Path) -> Path:
    path = tmp_path / "own.bvh"
    path.write_text(OWN)
    return path


def extent(skeleton: motion_theater.Skeleton) -> float:
    """Return the size of a rest pose that may lie on the ground."""
    return float(np.ptp(np.concatenate((skeleton.heads, skeleton.tails)), axis=0).max())


def heads_in_file(ob: bpy.types.Object, frame: int) -> np.ndarray:
    """Return the heads of an imported armature in the axes and units of its file."""
    stack = ob.motion_theater
    back = axes.inverse(axes.to_blender(stack.up, stack.forward))
    return axes.rotate(back, harness.pose(ob, frame)[:, :3, 3]) / stack.unit_m


def looked_at(frames: int) -> list[int]:
    return sorted({round(frame) for frame in np.linspace(0, frames - 1, min(FRAMES, frames))})


def assert_as_the_core_has_it(path: Path, style: str) -> None:
    bpy.ops.motion_theater.import_motion_capture(filepath=str(path), rate="SCENE", bone_style=style)
    ob, clip = harness.armature(), motion_theater.read(path)
    skeleton, motion = clip.skeleton, clip.motion
    bones = harness.module("logic.names").decode_pairs(ob.motion_theater.bone_names)
    order = [ob.pose.bones.find(bones[name]) for name in skeleton.names]
    for frame in looked_at(motion.frames):
        heads, _, _ = motion.pose(skeleton, motion.first_frame + frame)
        shown = heads_in_file(ob, motion.first_frame + frame)[order]
        assert np.abs(shown - heads).max() <= TOLERANCE * extent(skeleton)


@pytest.mark.parametrize("style", ["POINT", "AXES"])
@pytest.mark.parametrize("path", FILES, ids=lambda path: path.stem)
def test_heads_are_those_of_the_core(path: Path, style: str) -> None:
    assert_as_the_core_has_it(path, style)


@pytest.mark.parametrize("style", ["POINT", "AXES"])
def test_joints_with_one_rotation_channel_or_none_turn_too(own: Path, style: str) -> None:
    assert_as_the_core_has_it(own, style)


def blenders_own(path: Path) -> bpy.types.Object | None:
    """Return what Blender's own importer makes of a file, in the file's units; None where it cannot read it."""
    addon_utils.enable("io_anim_bvh")
    try:
        bpy.ops.import_anim.bvh(filepath=str(path), axis_forward="-Z", axis_up="Y", use_fps_scale=False, frame_start=1)
    except (RuntimeError, UnicodeDecodeError):
        return None
    return harness.armature()


@pytest.mark.filterwarnings("ignore::pytest.PytestUnraisableExceptionWarning")  # it leaves its file open
@pytest.mark.parametrize("path", FILES, ids=lambda path: path.stem)
def test_heads_are_those_of_blenders_own_importer_where_it_reads_the_file(path: Path) -> None:
    other = blenders_own(path)
    bpy.ops.motion_theater.import_motion_capture(filepath=str(path), rate="SCENE")
    ob, clip = harness.armature(), motion_theater.read(path)
    assert ob.animation_data.action
    if other is None:
        return  # that it cannot be read there is what this add-on is for
    names = [name for name in ob.pose.bones.keys() if name in other.pose.bones]  # noqa: SIM118
    assert len(names) > len(ob.pose.bones) // 2
    mine, theirs = ([one.pose.bones.find(name) for name in names] for one in (ob, other))
    from_blender = axes.inverse(axes.to_blender("Y"))
    for frame in looked_at(clip.frames):
        expected = axes.rotate(from_blender, harness.pose(other, 1 + frame)[theirs, :3, 3])
        shown = heads_in_file(ob, 1 + frame)[mine]
        assert np.abs(shown - expected).max() <= TOLERANCE * extent(clip.skeleton), frame


def test_the_stack_keeps_the_hierarchy_and_not_the_motion(own: Path) -> None:
    bpy.ops.motion_theater.import_motion_capture(filepath=str(own))
    stack = harness.armature().motion_theater
    assert stack.skeleton_text.startswith("HIERARCHY")
    assert "MOTION" not in stack.skeleton_text
    assert not stack.entries[0].skeleton_text


def test_a_bvh_is_imported_as_a_skeleton_and_added_as_a_track(own: Path) -> None:
    bpy.ops.motion_theater.import_skeleton(filepath=str(own))
    ob = harness.armature()
    assert ob.animation_data is None or ob.animation_data.action is None
    bpy.ops.motion_theater.add_track(filepath=str(own))
    assert harness.armature() == ob
    assert len(ob.motion_theater.entries) == 1
    bpy.ops.motion_theater.import_motion_capture(filepath=str(own), target="ACTIVE")
    assert harness.armature() == ob
    assert len(ob.motion_theater.entries) == 2


def test_a_bvh_of_the_same_names_in_another_unit_and_up_axis_moves_alike(own: Path, tmp_path: Path) -> None:
    bpy.ops.motion_theater.import_motion_capture(filepath=str(own), scale=2.0)
    ob = harness.armature()
    before = harness.pose(ob, 3)
    other = tmp_path / "named.bvh"
    other.write_text(OWN.replace("OFFSET 0 -45 10", "OFFSET 0 -45 11"))
    bpy.ops.motion_theater.import_motion_capture(filepath=str(other), target="ACTIVE")
    entry = ob.motion_theater.entries[1]
    assert "11" in entry.skeleton_text
    assert np.abs(harness.pose(ob, 3) - before).max() < 1e-5


def test_a_bvh_of_other_names_is_refused_as_a_track_on_chosen_bones(own: Path, tmp_path: Path) -> None:
    bpy.ops.motion_theater.import_skeleton(filepath=str(own))
    ob = harness.armature()
    harness.select(ob, ["Leg"])
    other = tmp_path / "other.bvh"
    other.write_text(OWN.replace("Leg", "Arm"))
    said = harness.refusal(lambda: bpy.ops.motion_theater.add_track(filepath=str(other), selected_only=True))
    assert "Arm is missing" in said


def test_a_file_that_changed_its_place_is_relinked_with_its_own_hierarchy(own: Path, tmp_path: Path) -> None:
    bpy.ops.motion_theater.import_motion_capture(filepath=str(own))
    ob = harness.armature()
    keys = harness.keys(ob)
    moved = tmp_path / "moved.bvh"
    moved.write_text(OWN)
    own.unlink()
    bpy.ops.motion_theater.relink_source(filepath=str(moved))
    assert harness.same_keys(harness.keys(ob), keys)


@pytest.mark.parametrize("up", ["X", "Y", "Z", "-X", "-Y", "-Z"])
@pytest.mark.parametrize("forward", ["FILE", "X", "Y", "Z", "-Z"])
def test_up_comes_to_z_and_forward_to_the_viewer(own: Path, up: str, forward: str) -> None:
    if up[-1] == forward[-1]:
        forward = "FILE"
    bpy.ops.motion_theater.import_motion_capture(filepath=str(own), up=up, forward=forward)
    ob = harness.armature()
    unit = {
        name: np.eye(3)["XYZ".index(name[-1])] * (-1 if "-" in name else 1) for name in (up, forward) if name != "FILE"
    }
    turn = axes.to_blender(up, forward)
    assert np.allclose(axes.rotate(turn, unit[up]), (0, 0, 1), atol=1e-12)
    if forward != "FILE":
        assert np.allclose(axes.rotate(turn, unit[forward]), (0, -1, 0), atol=1e-12)
    clip = motion_theater.read(own)
    heads, _, _ = clip.motion.pose(clip.skeleton, 2)
    stack = ob.motion_theater
    scene = bpy.context.scene
    moment = 1 + scene.render.fps / scene.render.fps_base / clip.rate_hz
    assert (stack.up, stack.forward) == (up, forward)
    assert moment < 2  # 24 frames per second see file frame 2 between two keys
    scene.render.fps, scene.render.fps_base = 30, 1.0
    bpy.ops.motion_theater.rebuild()
    assert np.abs(heads_in_file(ob, 2) - heads).max() < 1e-2


@pytest.mark.parametrize("scene_rate", [(24, 1.0), (24, 1.001), (30, 1.0), (60, 1.0)], ids=str)
@pytest.mark.parametrize("rate", ["RESAMPLE", "SCENE", "SAMPLES"])
@pytest.mark.parametrize("file_hz", [24, 25, 29.97, 30, 50, 59.94, 60, 90, 100, 119.88, 120, 240])
def test_a_clip_lasts_as_long_as_it_was_recorded(
    tmp_path: Path, file_hz: float, rate: str, scene_rate: tuple[int, float]
) -> None:
    count = 481
    rows = "\n".join(f"0 90 0 {frame % 90} 0 0 0" for frame in range(count))
    head = OWN[: OWN.index("MOTION")]
    path = tmp_path / "clip.bvh"
    path.write_text(f"{head}MOTION\nFrames: {count}\nFrame Time: {1 / file_hz:.7f}\n{rows}\n")
    render = bpy.context.scene.render
    render.fps, render.fps_base = scene_rate
    before = render.fps / render.fps_base
    bpy.ops.motion_theater.import_motion_capture(filepath=str(path), rate=rate)
    after = render.fps / render.fps_base
    frames = harness.key_rows(harness.armature(), "Hips", "rotation_quaternion")[:, 0]
    lasts = (frames[-1] - frames[0]) / after
    assert abs(lasts - (count - 1) / file_hz) <= (0.5 + 1e-3) / after
    assert after == pytest.approx(file_hz if rate == "SCENE" else before, rel=1e-5)
    assert len(frames) == count or rate == "RESAMPLE"
