"""What an armature does goes out as files that give it back."""

from __future__ import annotations

from pathlib import Path

import bpy
import numpy as np
import pytest

import motion_theater
from tests import harness
from tests.scene.test_bvh import OWN, extent, heads_in_file, looked_at

TOLERANCE = 1e-4
FILES = sorted((harness.SHARED / "bvh").glob("*.bvh"))
operators = bpy.ops.motion_theater


def import_clip(path: Path, **options: object) -> bpy.types.Object:
    operators.import_motion_capture(filepath=str(path), rate="SCENE", target="NEW", **options)
    return harness.armature()


def exported(folder: Path, format_: str, **options: object) -> motion_theater.Clip:
    """Export the active armature and read the file."""
    if format_ == "bvh":
        operators.export_bvh(filepath=str(folder / "out.bvh"), **options)
        return motion_theater.read(folder / "out.bvh")
    operators.export_acclaim(filepath=str(folder / "out.amc"), **options)
    skeleton = motion_theater.read(folder / "out.asf").skeleton
    return motion_theater.read(folder / "out.amc", skeleton=skeleton)


def assert_same_heads(clip: motion_theater.Clip, skeleton: motion_theater.Skeleton, ob: bpy.types.Object) -> None:
    """Compare a file that was written with what Blender shows, joint by joint in the armature's order."""
    names = {
        bone: name for name, bone in harness.module("logic.names").decode_pairs(ob.motion_theater.bone_names).items()
    }
    in_file = {name: number for number, name in enumerate(skeleton.names)}
    if "root" in in_file:  # as Acclaim calls it, whatever it was called before
        in_file[names[ob.pose.bones[0].name]] = in_file["root"]
    pairs = [
        (number, in_file[names[bone]]) for number, bone in enumerate(ob.pose.bones.keys()) if names[bone] in in_file
    ]
    assert pairs
    shown, written = (list(row) for row in zip(*pairs, strict=True))
    for frame in looked_at(clip.frames):
        heads, _, _ = clip.motion.pose(skeleton, clip.motion.first_frame + frame)
        expected = heads_in_file(ob, 1 + frame)
        assert np.abs(heads[written] - expected[shown]).max() <= TOLERANCE * extent(skeleton), frame


@pytest.mark.parametrize("style", ["POINT", "AXES"])
@pytest.mark.parametrize("format_", ["bvh", "amc"])
@pytest.mark.parametrize("path", FILES[::2], ids=lambda path: path.stem)
def test_a_bvh_comes_back_with_the_same_positions(path: Path, format_: str, style: str, tmp_path: Path) -> None:
    ob = import_clip(path, bone_style=style)
    clip = exported(tmp_path, format_)
    skeleton = clip.skeleton or motion_theater.read(tmp_path / "out.asf").skeleton
    assert clip.frames == motion_theater.read(path).frames
    assert_same_heads(clip, skeleton, ob)


@pytest.mark.parametrize("format_", ["bvh", "amc"])
@pytest.mark.parametrize("style", ["POINT", "AXES"])
def test_an_amc_comes_back_with_the_same_positions(format_: str, style: str, tmp_path: Path) -> None:
    ob = import_clip(harness.TESTDATA / "walk.amc", bone_style=style)
    clip = exported(tmp_path, format_)
    skeleton = clip.skeleton or motion_theater.read(tmp_path / "out.asf").skeleton
    assert_same_heads(clip, skeleton, ob)
    if format_ == "amc":
        assert skeleton.names[1:] == motion_theater.read(harness.TESTDATA / "human.asf").skeleton.names[1:]
        assert skeleton.unit_m == pytest.approx(0.0254 / 0.45)


def test_export_and_import_give_the_same_motion_in_the_scene(tmp_path: Path) -> None:
    source = tmp_path / "own.bvh"
    source.write_text(OWN)
    ob = import_clip(source)
    before = [harness.pose(ob, frame) for frame in range(1, 5)]
    exported(tmp_path, "bvh")
    again = import_clip(tmp_path / "out.bvh")
    assert again.motion_theater.up == ob.motion_theater.up
    for frame, expected in zip(range(1, 5), before, strict=True):
        assert np.abs(harness.pose(again, frame) - expected).max() < 1e-4


@pytest.fixture
def own(tmp_path: Path) -> bpy.types.Object:
    source = tmp_path / "own.bvh"
    source.write_text(OWN)
    return import_clip(source)


def test_the_file_keeps_names_channels_and_rate(own: bpy.types.Object, tmp_path: Path) -> None:
    clip = exported(tmp_path, "bvh")
    original = motion_theater.read(tmp_path / "own.bvh")
    assert clip.names == original.names
    assert clip.skeleton.dofs[1] == original.skeleton.dofs[1] == ["rx"]
    assert clip.rate_hz == pytest.approx(30.0)


@pytest.mark.parametrize(
    ("options", "frames"),
    [
        ({"range": "ACTION"}, 4),
        ({"range": "SCENE"}, 11),
        ({"range": "CUSTOM", "frame_start": 2, "frame_end": 3}, 2),
        ({"range": "CUSTOM", "frame_start": 1, "frame_end": 4, "rate_hz": 60.0}, 7),
        ({"range": "CUSTOM", "frame_start": 1, "frame_end": 4, "rate_hz": 10.0}, 2),
    ],
)
def test_range_and_rate_are_chosen(
    own: bpy.types.Object, tmp_path: Path, options: dict[str, object], frames: int
) -> None:
    bpy.context.scene.frame_start, bpy.context.scene.frame_end = 1, 11
    clip = exported(tmp_path, "bvh", **options)
    assert clip.frames == frames
    assert clip.rate_hz == pytest.approx(options.get("rate_hz", 30.0))


def test_a_range_that_ends_before_it_begins_is_refused(own: bpy.types.Object, tmp_path: Path) -> None:
    said = harness.refusal(lambda: exported(tmp_path, "bvh", range="CUSTOM", frame_start=5, frame_end=4))
    assert said == "The last frame comes before the first one"
    assert not (tmp_path / "out.bvh").exists()


def test_an_object_that_was_moved_and_scaled_goes_out_where_it_stands(own: bpy.types.Object, tmp_path: Path) -> None:
    own.location, own.scale = (1.0, 2.0, 3.0), (2.0, 2.0, 2.0)
    bpy.context.view_layer.update()
    world = np.array(own.matrix_world)
    clip = exported(tmp_path, "bvh", unit="1", up="Z")
    heads, _, _ = clip.motion.pose(clip.skeleton, 3)
    shown = harness.pose(own, 3) @ [0, 0, 0, 1] @ world.T
    assert np.abs(heads - shown[:, :3]).max() < 1e-4


def test_constraints_are_baked_and_the_current_frame_stays(own: bpy.types.Object, tmp_path: Path) -> None:
    constraint = own.pose.bones["Leg"].constraints.new("LIMIT_ROTATION")
    constraint.use_limit_x, constraint.owner_space = True, "LOCAL"
    bpy.context.scene.frame_set(3)
    clip = exported(tmp_path, "bvh")
    assert bpy.context.scene.frame_current == 3
    assert_same_heads(clip, clip.skeleton, own)
    assert not np.allclose(
        clip.motion.pose(clip.skeleton, 4)[0],
        motion_theater.read(tmp_path / "own.bvh").motion.pose(clip.skeleton, 4)[0],
    )


def test_an_armature_of_other_origin_goes_out_in_centimetres_with_y_up(tmp_path: Path) -> None:
    bpy.ops.object.armature_add()
    ob = harness.armature()
    bone = ob.pose.bones[0]
    bone.rotation_mode = "XYZ"
    for frame, angle in ((1, 0.0), (11, 1.0)):
        bone.rotation_euler.x = angle
        bone.keyframe_insert("rotation_euler", frame=frame)
    clip = exported(tmp_path, "bvh")
    assert clip.frames == 11
    tail = clip.motion.pose(clip.skeleton, 6)[1][0]
    bpy.context.scene.frame_set(6)
    shown = np.array(ob.pose.bones[0].tail)
    assert np.allclose(tail, shown[[0, 2, 1]] * (100.0, 100.0, -100.0), atol=1e-3)


def test_a_folder_that_is_not_there_is_said(own: bpy.types.Object, tmp_path: Path) -> None:
    said = harness.refusal(lambda: operators.export_bvh(filepath=str(tmp_path / "none" / "out.bvh")))
    assert "out.bvh cannot be written" in said
