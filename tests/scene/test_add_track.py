"""Which armature, which skeleton and which bones a new track takes, and what it says."""

from __future__ import annotations

import shutil
from pathlib import Path
from typing import Any

import bpy
import numpy as np
import pytest

from tests import harness

NO_BONES = "No bones are selected: select bones in Pose Mode or switch off Selected Bones Only"


def copies(folder: Path, **names: str) -> Path:
    """Copy files of the project's own clips into a folder, under other names."""
    folder.mkdir(parents=True, exist_ok=True)
    for source, name in names.items():
        shutil.copy(harness.TESTDATA / source.replace("_DOT_", "."), folder / name)
    return folder


def add_file(path: Path, **options: object) -> bpy.types.Object:
    bpy.ops.motion_theater.add_track(filepath=str(path), **options)
    return harness.armature()


def test_without_an_armature_the_skeleton_is_found_and_said(tmp_path: Path) -> None:
    copies(tmp_path, human_DOT_asf="02.asf", walk_DOT_amc="02_03.amc")
    copies(tmp_path, human_DOT_asf="05.asf")
    ob = add_file(tmp_path / "02_03.amc")
    assert ob.motion_theater.skeleton_source == str(tmp_path / "02.asf")
    assert "Took 02.asf, because it is of the same subject, 02" in ob.motion_theater.message
    assert "Added 02_03.amc to 31 bones" in ob.motion_theater.message


def test_the_skeleton_that_the_user_names_is_taken(tmp_path: Path) -> None:
    copies(tmp_path, walk_DOT_amc="walk.amc")
    elsewhere = copies(tmp_path / "skeletons", human_DOT_asf="any.asf")
    ob = add_file(tmp_path / "walk.amc", skeleton=str(elsewhere / "any.asf"))
    assert ob.motion_theater.skeleton_source == str(elsewhere / "any.asf")


def test_without_a_skeleton_the_default_one_is_imported_and_said(tmp_path: Path) -> None:
    copies(tmp_path, walk_DOT_amc="walk.amc")
    ob = add_file(tmp_path / "walk.amc")
    assert ob.name == "default"
    assert len(ob.data.bones) == 31
    assert ob.motion_theater.skeleton_source == ""
    message = ob.motion_theater.message
    assert "No skeleton was found; the built-in default skeleton is used: sizes are a guess" in message
    assert "Imported the default skeleton: 31 bones" in message
    assert "Added walk.amc to 31 bones" in message


def test_an_armature_that_does_not_fit_gives_no_way_to_a_guess(tmp_path: Path) -> None:
    skeleton = (harness.TESTDATA / "human.asf").read_text().replace("lfemur", "tail")
    (tmp_path / "skeletons").mkdir()
    (tmp_path / "skeletons" / "animal.asf").write_text(skeleton)
    bpy.ops.motion_theater.import_skeleton(filepath=str(tmp_path / "skeletons" / "animal.asf"))
    copies(tmp_path / "deep" / "er", walk_DOT_amc="walk.amc")
    before = harness.snapshot()
    assert "lfemur" in harness.refusal(lambda: add_file(tmp_path / "deep" / "er" / "walk.amc"))
    assert harness.snapshot() == before


def test_without_any_skeleton_that_fits_the_bones_are_named(tmp_path: Path) -> None:
    text = (harness.TESTDATA / "walk.amc").read_text().replace("lfemur", "tail")
    (tmp_path / "walk.amc").write_text(text)
    before = harness.snapshot()
    message = harness.refusal(lambda: add_file(tmp_path / "walk.amc"))
    assert "needs its skeleton" in message
    assert "lowerback" in message
    assert harness.snapshot() == before


def test_a_misfit_is_refused_with_the_names(tmp_path: Path) -> None:
    ob = harness.import_human()
    text = (harness.TESTDATA / "walk.amc").read_text().replace("lfemur", "tail").replace("rfemur", "wing")
    (tmp_path / "animal.amc").write_text(text)
    before = harness.snapshot()
    message = harness.refusal(lambda: add_file(tmp_path / "animal.amc"))
    assert "tail" in message
    assert "wing" in message
    assert harness.snapshot() == before
    assert harness.armature() == ob


def test_an_armature_that_lacks_bones_is_told_which() -> None:
    ob = harness.import_human()
    bpy.ops.object.mode_set(mode="EDIT")
    for name in ("lthumb", "rthumb"):
        ob.data.edit_bones.remove(ob.data.edit_bones[name])
    bpy.ops.object.mode_set(mode="OBJECT")
    harness.select(ob, ["lfemur"])
    message = harness.refusal(lambda: harness.add("walk.amc", selected_only=True))
    assert "lthumb" in message
    assert "rthumb" in message


def test_a_misfitting_armature_makes_room_for_the_motions_own(tmp_path: Path) -> None:
    copies(tmp_path, walk_DOT_amc="walk.amc", human_DOT_asf="human.asf")
    skeleton = (harness.TESTDATA / "human.asf").read_text().replace("lfemur", "tail")
    (tmp_path / "other").mkdir()
    (tmp_path / "other" / "animal.asf").write_text(skeleton)
    bpy.ops.motion_theater.import_skeleton(filepath=str(tmp_path / "other" / "animal.asf"))
    animal = harness.armature()
    ob = add_file(tmp_path / "walk.amc")
    assert ob != animal
    assert ob.motion_theater.skeleton_source == str(tmp_path / "human.asf")
    assert not animal.motion_theater.entries


@pytest.mark.parametrize("mode", ["OBJECT", "POSE"])
def test_selected_bones_count_in_both_modes(mode: Any) -> None:
    ob = harness.import_human()
    harness.select(ob, ["lfemur", "ltibia"])
    bpy.ops.object.mode_set(mode=mode)
    harness.add("walk.amc", selected_only=True)
    assert ob.motion_theater.entries[0].bones.split("\n") == ["lfemur", "ltibia"]
    assert all(harness.of_bones(["lfemur", "ltibia"])(path) for path, _ in harness.keys(ob))
    assert ob.motion_theater.message.startswith("Added walk.amc to 2 bones, frames ")
    assert bpy.context.mode == mode


def test_none_selected_is_told() -> None:
    def add() -> object:
        return harness.add("walk.amc", selected_only=True)

    assert harness.refusal(add) == NO_BONES
    ob = harness.import_human()
    harness.select(ob, [])
    before = harness.snapshot()
    assert harness.refusal(add) == NO_BONES
    assert harness.snapshot() == before


def test_bone_collections_are_a_selection_too() -> None:
    ob = harness.import_human()
    legs = ob.data.collections.new("Legs")
    shins = ob.data.collections.new("Shins", parent=legs)
    legs.assign(ob.data.bones["lfemur"])
    shins.assign(ob.data.bones["ltibia"])
    harness.add("walk.amc", bone_collection="Legs")
    assert set(ob.motion_theater.entries[0].bones.split("\n")) == {"lfemur", "ltibia"}
    assert "no bones in a collection" in harness.refusal(lambda: harness.add("walk.amc", bone_collection="Wings"))


def test_notices_are_part_of_the_one_message() -> None:
    ob = harness.import_human()
    harness.add("walk.amc", rate="SCENE", cut_start=1, cut_end=49)
    harness.add("walk.amc", rate="SCENE", cut_start=50, blend_depth=200)
    assert ob.motion_theater.message.startswith("Added walk.amc to 31 bones, frames 50-")
    assert "lend depth" in ob.motion_theater.message
    assert ob.motion_theater.entries[1].notices


def test_names_in_other_case_fit(tmp_path: Path) -> None:
    ob = harness.import_human()
    ob.data.bones["lfemur"].name = "LFemur"
    harness.add("walk.amc")
    assert harness.key_rows(ob, "LFemur", "rotation_quaternion").shape[0] > 10


def test_an_armature_of_other_origin_with_the_same_bones_is_taken() -> None:
    ours = harness.import_human(scale=2.0)
    harness.add("walk.amc")
    walked = [harness.pose(ours, frame) for frame in (1, 40, 90)]
    other = harness.import_human(scale=2.0, bone_style="AXES")
    other.property_unset("motion_theater")
    for bone in other.pose.bones:
        bone.rotation_mode = "QUATERNION"
    assert other.motion_theater.skeleton_text == ""
    harness.add("walk.amc")
    assert "Took human.asf" in other.motion_theater.message
    for frame, was in zip((1, 40, 90), walked, strict=True):
        assert np.abs(harness.pose(other, frame)[:, :3, 3] - was[:, :3, 3]).max() < 1e-4


def test_the_blend_of_the_worked_example_is_reported() -> None:
    ob = harness.import_human()
    harness.add("step_and_jump.amc", rate="SCENE", scale_start=48, scale_end=150)
    harness.add("step_and_jump.amc", cut_start=50, cut_end=113, scale_start=50, scale_end=140, blend_depth=5)
    rows = harness.key_rows(ob, "lfemur", "rotation_quaternion")
    assert (rows[0, 0], rows[-1, 0]) == (48, 150)
    assert "5" in ob.motion_theater.entries[1].notices


def test_a_linked_armature_is_refused_with_the_reason(tmp_path: Path) -> None:
    ob = harness.import_human()
    path = str(tmp_path / "library.blend")
    bpy.data.libraries.write(path, {ob})
    harness.empty_file()
    linked = harness.load_human(path, link=True)
    bpy.context.view_layer.objects.active = linked
    assert "library override" in harness.refusal(lambda: harness.add("walk.amc"))


def test_a_tweaked_nla_strip_is_refused_with_the_reason() -> None:
    ob = harness.import_human()
    harness.add("walk.amc")
    animation = ob.animation_data
    action = animation.action
    track = animation.nla_tracks.new()
    strip = track.strips.new("walk", 1, action)
    animation.nla_tracks.active = track
    track.select = strip.select = True
    animation.use_tweak_mode = True
    assert "tweak" in harness.refusal(lambda: harness.add("wave.amc"))
