"""A skeleton becomes an armature in its setup pose, in metres, Z up, and remembers where it came from."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import bpy
import numpy as np
import pytest
from mathutils import Vector

import motion_theater
from tests import harness

ASF = harness.TESTDATA / "human.asf"


def head(ob: bpy.types.Object) -> np.ndarray:
    """Return where the head begins in the rest pose."""
    return np.array(ob.data.bones["head"].head_local)


def test_the_setup_pose_stands_in_metres_with_z_up_facing_the_viewer() -> None:
    ob = harness.import_human()
    heads = {bone.name: bone.head_local for bone in ob.data.bones}
    assert heads["head"].z > heads["root"].z > heads["ltoes"].z
    heights = [point.z for bone in ob.data.bones for point in (bone.head_local, bone.tail_local)]
    assert 1.4 < max(heights) - min(heights) < 2.0
    toes = ob.data.bones["ltoes"]
    assert (toes.tail_local - toes.head_local).y < 0  # towards the viewer of the front view
    assert heads["lhumerus"].x > heads["rhumerus"].x  # the left hand on the viewer's right


def test_it_stands_at_the_origin_selected_and_active_alone() -> None:
    bpy.context.scene.cursor.location = (5.0, 5.0, 5.0)
    first = harness.import_human()
    second = harness.import_human()
    assert first != second
    assert np.array_equal(np.array(second.matrix_world), np.eye(4))
    assert [ob for ob in bpy.context.view_layer.objects if ob.select_get()] == [second]
    assert bpy.context.mode == "OBJECT"


def test_it_goes_into_the_active_collection() -> None:
    collection = bpy.data.collections.new("Actors")
    bpy.context.scene.collection.children.link(collection)
    layer = bpy.context.view_layer.layer_collection.children["Actors"]
    bpy.context.view_layer.active_layer_collection = layer
    assert harness.import_human().users_collection == (collection,)
    layer.exclude = True
    assert harness.import_human().users_collection == (bpy.context.scene.collection,)


@pytest.mark.parametrize("mode", ["EDIT", "POSE"])
def test_it_can_be_imported_while_another_armature_is_worked_on(mode: Any) -> None:
    first = harness.import_human()
    bpy.ops.object.mode_set(mode=mode)
    second = harness.import_human()
    assert (first.mode, second.mode) == ("OBJECT", "OBJECT")


def test_point_style_points_to_the_child_and_connects() -> None:
    bones = harness.import_human().data.bones
    for parent, child in (("lfemur", "ltibia"), ("ltibia", "lfoot"), ("lhumerus", "lradius"), ("thorax", "lowerneck")):
        assert (bones[parent].tail_local - bones[child].head_local).length < 1e-6
        assert bones[child].use_connect
    assert not bones["root"].use_connect
    assert not bones["lhipjoint"].use_connect  # the root is a point: its tail is only drawn
    assert (bones["root"].tail_local - bones["root"].head_local).normalized().dot(Vector((0, 0, 1))) > 0.999
    assert bones["root"].length == pytest.approx(0.01, rel=0.5)


def test_hinges_turn_about_the_bones_own_x() -> None:
    ob = harness.import_human()
    harness.add("walk.amc")
    skeleton = motion_theater.read(ASF).skeleton
    hinges = [name for name, dofs in zip(skeleton.names, skeleton.dofs, strict=True) if dofs == ["rx"]]
    assert "ltibia" in hinges
    for name in hinges:
        rows = harness.key_rows(ob, name, "rotation_quaternion")
        assert np.abs(rows[:, 3:]).max() < 0.01, name  # y and z of the quaternion


def test_axes_style_has_the_files_axes() -> None:
    ob = harness.import_human(bone_style="AXES")
    skeleton = motion_theater.read(ASF).skeleton
    for name, order, dofs in zip(skeleton.names, skeleton.orders, skeleton.dofs, strict=True):
        assert ob.pose.bones[name].rotation_mode == order
        assert not ob.data.bones[name].use_connect or not dofs
    femur = np.array(ob.data.bones["lfemur"].matrix_local)[:3, :3]
    tilt = np.radians(20.0)  # `axis 0 0 20 XYZ`, then Y up to Z up
    expected = np.array([[np.cos(tilt), -np.sin(tilt), 0], [0, 0, -1], [np.sin(tilt), np.cos(tilt), 0]])
    assert np.abs(femur - expected).max() < 1e-5


def test_limits_become_constraints_where_they_are_asked_for() -> None:
    ob = harness.import_human(bone_style="AXES", limits_as_constraints=True)
    skeleton = motion_theater.read(ASF).skeleton
    tibia = skeleton.names.index("ltibia")
    (constraint,) = ob.pose.bones["ltibia"].constraints
    low, high = skeleton.limits[tibia][0]
    assert (constraint.type, constraint.owner_space) == ("LIMIT_ROTATION", "LOCAL")
    assert (constraint.use_limit_x, constraint.use_limit_y, constraint.use_limit_z) == (True, False, False)
    assert np.allclose((constraint.min_x, constraint.max_x), (low, high), atol=1e-6)
    ob = harness.import_human(bone_style="POINT", limits_as_constraints=True)
    assert not any(len(bone.constraints) for bone in ob.pose.bones)


def test_scale_and_the_units_of_the_scene_count() -> None:
    plain = head(harness.import_human())
    assert np.allclose(head(harness.import_human(scale=2.0)), plain * 2.0, rtol=1e-5)
    bpy.context.scene.unit_settings.scale_length = 0.01
    assert np.allclose(head(harness.import_human()), plain * 100.0, rtol=1e-5)


def test_the_up_axis_can_be_chosen() -> None:
    by_y = head(harness.import_human(up="Y"))
    x, y, z = head(harness.import_human(up="Z"))
    assert np.allclose(by_y, (x, -z, y), atol=1e-6)


def test_the_path_of_the_last_import_is_not_remembered() -> None:
    for operator in (bpy.ops.motion_theater.import_skeleton, bpy.ops.motion_theater.add_track):
        properties = operator.get_rna_type().properties
        assert properties["filepath"].is_skip_save
        assert not properties["scene_range" if "scene_range" in properties else "scale"].is_skip_save


def test_long_and_foreign_names_are_mapped(tmp_path: Path) -> None:
    long, foreign = "left_femur_" * 8, "schl\u00fcsselbein"
    path = tmp_path / "names.asf"
    path.write_text(ASF.read_text().replace("lfemur", long).replace("rclavicle", foreign), encoding="utf-8")
    motion = tmp_path / "names.amc"
    clip = (harness.TESTDATA / "walk.amc").read_text()
    motion.write_text(clip.replace("lfemur", long).replace("rclavicle", foreign), encoding="utf-8")
    bpy.ops.motion_theater.import_skeleton(filepath=str(path))
    ob = harness.armature()
    assert foreign in ob.data.bones
    (short,) = (bone.name for bone in ob.data.bones if bone.name.startswith("left_femur_"))
    assert len(short.encode()) <= 63
    bpy.ops.motion_theater.add_track(filepath=str(motion))
    assert harness.key_rows(ob, short, "rotation_quaternion").shape[0] > 10


def test_it_remembers_its_file() -> None:
    motion = harness.import_human().motion_theater
    assert motion.skeleton_source == str(ASF)
    text = motion_theater.read_bytes(motion.skeleton_text.encode("latin-1"), name="stored.asf").skeleton
    assert text.names == motion_theater.read(ASF).skeleton.names
    assert motion.unit_m == pytest.approx(0.0254 / 0.45)
    assert (motion.up, motion.bone_style) == ("Y", "POINT")


def test_a_z_up_file_stands_too(tmp_path: Path) -> None:
    lines = []
    for line in ASF.read_text().splitlines():
        word, *numbers = line.split() or [""]
        if word == "direction":
            x, y, z = (float(number) for number in numbers)
            line = f"     direction {x} {-z} {y}"
        lines.append(line)
    path = tmp_path / "zup.asf"
    path.write_text("\n".join(lines) + "\n")
    expected = head(harness.import_human())
    bpy.ops.motion_theater.import_skeleton(filepath=str(path))
    ob = harness.armature()
    assert ob.motion_theater.up == "Z"
    assert np.allclose(head(ob), expected, atol=1e-5)
