"""Curves that an animator edited by hand are noticed and never silently lost."""

from __future__ import annotations

from collections.abc import Callable

import bpy
import numpy as np
import pytest

from tests import harness

stack = harness.module("stack")
UserError = harness.module("logic.messages").UserError
ARM = ("lhumerus", "lradius")
CURVE = ('pose.bones["lradius"].rotation_quaternion', 1)


def move_key(curve: bpy.types.FCurve) -> None:
    curve.keyframe_points[10].co.y += 0.3
    curve.update()


def insert_key(curve: bpy.types.FCurve) -> None:
    curve.keyframe_points.insert(500.0, 0.5)


def delete_key(curve: bpy.types.FCurve) -> None:
    curve.keyframe_points.remove(curve.keyframe_points[5])


def edited_walk(edit: Callable[[bpy.types.FCurve], None]) -> bpy.types.Object:
    ob = harness.import_human()
    harness.add("walk.amc")
    edit(harness.fcurves(ob)[CURVE])
    return ob


@pytest.mark.parametrize("edit", [move_key, insert_key, delete_key])
def test_an_edit_stops_the_rebuild_and_is_kept(edit: Callable[[bpy.types.FCurve], None]) -> None:
    ob = edited_walk(edit)
    edited = harness.keys(ob)
    ob.motion_theater.entries[0].cut_start = 20
    assert harness.same_keys(edited, harness.keys(ob))
    assert ob.motion_theater.hand_edited == "lradius"
    assert "lradius" in ob.motion_theater.message
    assert "edited by hand" in harness.refusal(lambda: bpy.ops.motion_theater.rebuild())
    assert harness.same_keys(edited, harness.keys(ob))


def test_a_deleted_curve_is_an_edit() -> None:
    ob = harness.import_human()
    harness.add("walk.amc")
    compat = harness.module("compat")
    bag = compat.bag_of(ob, ob.animation_data.action)
    bag.fcurves.remove(harness.fcurves(ob)[CURVE])
    with pytest.raises(UserError, match="lradius"):
        stack.rebuild(ob)


def test_a_changed_interpolation_is_never_lost() -> None:
    ob = harness.import_human()
    harness.add("walk.amc", scale_start=1, scale_end=100)
    harness.fcurves(ob)[CURVE].keyframe_points[3].interpolation = "CONSTANT"
    ob.motion_theater.entries[0].cut_start = 20  # only values are written, so the interpolation stays
    assert harness.fcurves(ob)[CURVE].keyframe_points[3].interpolation == "CONSTANT"
    assert ob.motion_theater.hand_edited == ""
    ob.motion_theater.entries[0].scale_end = 120  # keys would be made anew
    assert ob.motion_theater.hand_edited == "lradius"
    assert harness.fcurves(ob)[CURVE].keyframe_points[3].interpolation == "CONSTANT"


def test_keeping_makes_an_entry_that_holds_the_edit() -> None:
    ob = edited_walk(move_key)
    edited = harness.keys(ob)
    ob.motion_theater.entries[0].cut_start = 20
    bpy.ops.motion_theater.keep_edits()
    motion = ob.motion_theater
    assert [entry.kind for entry in motion.entries] == ["TRACK", "KEPT"]
    assert motion.hand_edited == ""
    now = harness.keys(ob)
    assert harness.same_keys(edited, now, of=harness.of_bones(["lradius"]))
    assert not harness.same_keys(edited, now, of=harness.of_bones(["lfemur"]))
    motion.entries[1].enabled = False
    assert not harness.same_keys(edited, harness.keys(ob), of=harness.of_bones(["lradius"]))
    motion.entries[1].enabled = True
    assert harness.same_keys(edited, harness.keys(ob), of=harness.of_bones(["lradius"]))
    stack.rebuild(ob)


def test_entries_above_kept_edits_work_on_them() -> None:
    ob = edited_walk(move_key)
    bpy.context.view_layer.update()
    with pytest.raises(UserError):
        stack.rebuild(ob)
    stack.keep_edits(ob)
    spike = harness.key_rows(ob, "lradius", "rotation_quaternion")
    bpy.ops.motion_theater.filter(kind="MEDIAN", depth=3)
    filtered = harness.key_rows(ob, "lradius", "rotation_quaternion")
    assert abs(filtered[10, 2] - spike[10, 2]) > 0.05


def test_kept_edits_go_with_their_entry() -> None:
    ob = edited_walk(move_key)
    before = len(bpy.data.actions)
    with pytest.raises(UserError, match="edited by hand"):
        stack.rebuild(ob)
    stack.keep_edits(ob)
    assert len(bpy.data.actions) == before + 1
    stack.remove_entry(ob, 1)
    assert len(bpy.data.actions) == before


def test_rebuilding_over_them_is_the_other_choice() -> None:
    ob = harness.import_human()
    harness.add("walk.amc")
    clean = harness.keys(ob)
    move_key(harness.fcurves(ob)[CURVE])
    harness.refusal(lambda: bpy.ops.motion_theater.rebuild())
    bpy.ops.motion_theater.rebuild(over_edits=True)
    assert harness.same_keys(clean, harness.keys(ob))
    assert ob.motion_theater.hand_edited == ""


def test_adding_a_track_over_edits_is_refused_with_nothing_changed() -> None:
    edited_walk(move_key)
    before = harness.snapshot()
    message = harness.refusal(lambda: harness.add("wave.amc"))
    assert "lradius" in message
    assert harness.snapshot() == before


def test_curves_of_bones_that_no_entry_touches_belong_to_the_animator() -> None:
    ob = harness.import_human()
    harness.select(ob, ARM)
    harness.add("wave.amc", selected_only=True)
    bone = ob.pose.bones["rfemur"]
    bone.rotation_quaternion = (0.8, 0.6, 0.0, 0.0)
    bone.keyframe_insert("rotation_quaternion", frame=7)
    ob.motion_theater.entries[0].cut_end = 50
    assert ob.motion_theater.hand_edited == ""
    assert harness.key_rows(ob, "rfemur", "rotation_quaternion")[0, 0] == 7
    stack.remove_entry(ob, 0)
    assert np.allclose(harness.key_rows(ob, "rfemur", "rotation_quaternion"), [[7, 0.8, 0.6, 0, 0]])
    assert not any(harness.of_bones(ARM)(path) for path, _ in harness.keys(ob))


def test_a_bone_that_is_newly_touched_is_compared_with_the_base() -> None:
    ob = harness.import_human()
    harness.select(ob, ARM)
    harness.add("wave.amc", selected_only=True)
    ob.pose.bones["rfemur"].keyframe_insert("rotation_quaternion", frame=7)
    message = harness.refusal(lambda: harness.add("walk.amc"))
    assert "rfemur" in message
    bpy.ops.motion_theater.keep_edits()
    harness.add("walk.amc", cut_start=40)
    rows = harness.key_rows(ob, "rfemur", "rotation_quaternion")
    assert rows[0, 0] == 7
    assert len(rows) > 2


def test_another_action_on_the_armature_is_not_overwritten() -> None:
    ob = harness.import_human()
    harness.add("walk.amc")
    ob.animation_data.action = None
    ob.pose.bones["lradius"].keyframe_insert("rotation_quaternion", frame=3)
    own, keys = ob.animation_data.action, harness.keys(ob)
    ob.motion_theater.entries[0].cut_end = 50
    assert harness.same_keys(keys, harness.keys(ob))
    assert ob.motion_theater.hand_edited == "lradius"
    bpy.ops.motion_theater.rebuild(over_edits=True)
    assert not harness.same_keys(keys, harness.keys(ob))
    assert ob.animation_data.action.name != own.name
    assert own in list(bpy.data.actions)
    assert own.use_fake_user


def test_locked_curves_are_left_alone_and_said() -> None:
    ob = harness.import_human()
    harness.add("walk.amc")
    before = harness.keys(ob)
    for path, curve in harness.fcurves(ob).items():
        curve.lock = path[0] == CURVE[0]
    ob.motion_theater.entries[0].cut_start = 20
    after = harness.keys(ob)
    assert harness.same_keys(before, after, of=harness.of_bones(["lradius"]))
    assert not harness.same_keys(before, after, of=harness.of_bones(["lfemur"]))
    assert "lradius" in ob.motion_theater.message
