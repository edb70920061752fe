"""What holds for every stack: what an entry does not mean stays bit for bit, and a recipe has one result."""

from __future__ import annotations

from typing import Any

import bpy
import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from tests import harness

ARM = ("lhumerus", "lradius", "lwrist", "lhand", "lfingers", "lthumb")
KEYED = ("root", "lhumerus", "lradius", "rfemur")
stack = harness.module("stack")


def human_with_base() -> bpy.types.Object:
    """Return an armature whose animator keyed three poses by hand before any track: sparse Bezier keys."""
    ob = harness.import_human()
    for frame, angle in ((-10, 0.0), (30, 0.8), (200, -0.4)):
        for name in KEYED:
            bone = ob.pose.bones[name]
            bone.rotation_quaternion = (np.cos(angle / 2), np.sin(angle / 2), 0.0, 0.0)
            bone.keyframe_insert("rotation_quaternion", frame=frame)
        ob.pose.bones["root"].location = (angle, 0.0, angle)
        ob.pose.bones["root"].keyframe_insert("location", frame=frame)
    return ob


def others(ob: bpy.types.Object) -> list[str]:
    return [bone.name for bone in ob.data.bones if bone.name not in ARM]


def test_bones_not_chosen_are_bit_identical() -> None:
    ob = human_with_base()
    before = harness.keys(ob)
    harness.select(ob, ARM)
    harness.add("wave.amc", selected_only=True)
    after = harness.keys(ob)
    assert harness.same_keys(before, after, of=harness.of_bones(others(ob)))
    assert not harness.same_keys(before, after, of=harness.of_bones(ARM))
    before = harness.keys(ob)
    bpy.ops.motion_theater.filter(kind="AVERAGE", depth=5, selected_only=True)
    assert harness.same_keys(before, harness.keys(ob), of=harness.of_bones(others(ob)))


def test_keys_outside_the_range_keep_every_field() -> None:
    ob = human_with_base()
    before = harness.keys(ob)
    harness.add("wave.amc", scale_start=29, scale_end=31)
    after = harness.keys(ob)
    path = ('pose.bones["rfemur"].rotation_quaternion', 1)
    at_before, at_after = (keys[path]["co"][0::2] for keys in (before, after))
    assert list(at_before) == [-10, 30, 200]
    assert at_after[-1] == 200
    assert len(at_after) > len(at_before)
    for name, values in before[path].items():
        width = len(values) // 3
        assert values[-width:].tobytes() == after[path][name][-width:].tobytes(), name


def test_what_is_seen_outside_the_range_stays() -> None:
    ob = human_with_base()
    frames = [-20, -10, 0, 15, 27, 33, 60, 130, 200, 240]
    before = [harness.pose(ob, frame) for frame in frames]
    harness.select(ob, KEYED)
    harness.add("wave.amc", selected_only=True, scale_start=29, scale_end=31)
    for frame, was in zip(frames, before, strict=True):
        assert np.abs(harness.pose(ob, frame) - was).max() < 2e-5, frame


def test_rebuilding_twice_changes_nothing() -> None:
    ob = human_with_base()
    harness.add("wave.amc", blend_depth=5, cut_start=20)
    bpy.ops.motion_theater.filter(kind="WEIGHTED", depth=7)
    before = harness.keys(ob)
    stack.rebuild(ob)
    assert harness.same_keys(before, harness.keys(ob))


@pytest.mark.parametrize("make", [harness.import_human, human_with_base])
def test_a_muted_entry_leaves_no_trace(make: Any) -> None:
    ob = make()
    harness.add("walk.amc", blend_depth=4)
    before, shown = harness.keys(ob), harness.pose(ob, 40)
    harness.add("wave.amc", cut_start=30, blend_depth=6)
    entry = ob.motion_theater.entries[1]
    entry.enabled = False
    assert harness.same_keys(before, harness.keys(ob))
    assert np.array_equal(harness.pose(ob, 40), shown)
    entry.enabled = True
    assert not harness.same_keys(before, harness.keys(ob))
    stack.remove_entry(ob, 1)
    assert harness.same_keys(before, harness.keys(ob))


@pytest.mark.parametrize("make", [harness.import_human, human_with_base])
def test_removing_the_last_entry_gives_the_armature_back_as_it_was(make: Any) -> None:
    ob = make()
    ob.pose.bones["head"].rotation_quaternion = (0.8, 0.6, 0.0, 0.0)
    ob.pose.bones["lhumerus"].location = (0.0, 0.1, 0.0)
    base = ob.animation_data.action if ob.animation_data else None
    before, keys = harness.snapshot(), harness.keys(ob)
    pose = {bone.name: (*bone.rotation_quaternion, *bone.location) for bone in ob.pose.bones}
    harness.add("wave.amc", scene_range="KEEP")
    assert ob.animation_data.action != base
    bpy.context.scene.frame_set(20)
    bpy.context.scene.frame_set(1)
    stack.remove_entry(ob, 0)
    assert harness.snapshot() == before
    assert harness.same_keys(keys, harness.keys(ob))
    if base is None:
        assert {bone.name: (*bone.rotation_quaternion, *bone.location) for bone in ob.pose.bones} == pose
        assert ob.animation_data is None
    else:
        assert ob.animation_data.action == base


def test_the_base_is_never_written() -> None:
    ob = human_with_base()
    base = ob.animation_data.action
    before = harness.keys(ob)
    harness.add("wave.amc")
    assert ob.motion_theater.base_action == base != ob.animation_data.action
    ob.motion_theater.entries[0].cut_end = 40
    stack.remove_entry(ob, 0)
    assert ob.animation_data.action == base
    assert harness.same_keys(before, harness.keys(ob))


def test_reordering_and_back_is_the_identity() -> None:
    ob = harness.import_human()
    harness.add("walk.amc")
    harness.add("wave.amc", cut_start=20, cut_end=100, blend_depth=8)
    before = harness.keys(ob)
    stack.move_entry(ob, 1, -1)
    assert [entry.name for entry in ob.motion_theater.entries] == ["wave", "walk"]
    assert not harness.same_keys(before, harness.keys(ob))
    stack.move_entry(ob, 0, 1)
    assert harness.same_keys(before, harness.keys(ob))


def test_a_duplicate_has_all_settings_and_lies_above() -> None:
    ob = harness.import_human()
    harness.select(ob, ARM)
    harness.add("wave.amc", selected_only=True, cut_start=10, scale_end=90)
    harness.add("walk.amc")
    stack.duplicate_entry(ob, 0)
    entries = ob.motion_theater.entries
    assert [entry.name for entry in entries] == ["wave", "wave", "walk"]
    assert harness.settings(entries[0]) == harness.settings(entries[1])
    assert ob.motion_theater.active == 1


@pytest.mark.parametrize("make", [harness.import_human, human_with_base])
def test_an_edit_writes_only_the_curves_that_change(monkeypatch: pytest.MonkeyPatch, make: Any) -> None:
    ob = make()
    harness.add("walk.amc", scale_start=20, scale_end=60)
    harness.select(ob, ARM)
    harness.add("wave.amc", selected_only=True)
    write = harness.module("curves.write")
    written: list[str] = []
    for name in ("write_values", "write_keys"):
        original = getattr(write, name)

        def noted(curve: bpy.types.FCurve, wanted: object, original: Any = original) -> None:
            written.append(curve.data_path)
            original(curve, wanted)

        monkeypatch.setattr(write, name, noted)
    stack.rebuild(ob)
    assert written == []
    ob.motion_theater.entries[1].cut_end = 60
    assert written
    assert all(harness.of_bones(ARM)(path) for path in written)


def test_frames_that_stay_get_values_only(monkeypatch: pytest.MonkeyPatch) -> None:
    ob = harness.import_human()
    harness.add("walk.amc", scale_start=1, scale_end=100)
    write = harness.module("curves.write")
    monkeypatch.setattr(write, "write_keys", lambda *_: pytest.fail("keys were made anew"))
    ob.motion_theater.entries[0].cut_start = 30
    fresh = harness.keys(ob)
    monkeypatch.undo()
    stack.remove_entry(ob, 0)
    harness.add("walk.amc", scale_start=1, scale_end=100, cut_start=30)
    assert harness.same_keys(fresh, harness.keys(ob))


def test_handles_are_valid_after_values_were_written() -> None:
    ob = harness.import_human()
    harness.add("walk.amc", scale_start=1, scale_end=100)
    ob.motion_theater.entries[0].cut_start = 30
    before = harness.keys(ob)
    for curve in harness.fcurves(ob).values():
        curve.update()
    assert harness.same_keys(before, harness.keys(ob))


@settings(max_examples=12, deadline=None, suppress_health_check=list(HealthCheck))
@given(
    st.lists(
        st.tuples(
            st.sampled_from(["wave.amc", "walk.amc", "turn.amc"]),
            st.sampled_from([(), ARM, ("root", "lfemur", "head")]),
            st.integers(0, 60),
            st.integers(0, 12),
            st.booleans(),
        ),
        min_size=1,
        max_size=3,
    ),
    st.integers(0, 2),
)
def test_muting_or_removing_any_entry_equals_never_having_added_it(tracks: list[tuple], which: int) -> None:
    which %= len(tracks)

    def built(parts: list[tuple]) -> bpy.types.Object:
        harness.empty_file()
        ob = harness.import_human()
        for clip, bones, cut_start, blend_depth, preserve in parts:
            harness.select(ob, bones)
            options = {"cut_start": cut_start, "blend_depth": blend_depth, "preserve": preserve}
            harness.add(clip, selected_only=bool(bones), **options)
        return ob

    without = built(tracks[:which] + tracks[which + 1 :])
    expected = harness.keys(without)
    ob = built(tracks)
    ob.motion_theater.entries[which].enabled = False
    assert harness.same_keys(expected, harness.keys(ob))
    stack.remove_entry(ob, which)
    assert harness.same_keys(expected, harness.keys(ob))


def test_an_edit_is_seen_at_once_at_the_current_frame() -> None:
    ob = harness.import_human()
    harness.add("walk.amc", scale_start=1, scale_end=100)
    bpy.context.scene.frame_set(40)
    before = ob.pose.bones["ltibia"].matrix.copy()
    ob.motion_theater.entries[0].cut_start = 35
    bpy.context.view_layer.update()
    shown = ob.pose.bones["ltibia"].matrix.copy()
    assert shown != before
    bpy.context.scene.frame_set(40)
    assert shown == ob.pose.bones["ltibia"].matrix


def test_two_armatures_have_stacks_of_their_own() -> None:
    first = harness.import_human()
    harness.add("walk.amc")
    before = harness.keys(first)
    second = harness.import_human()
    harness.add("wave.amc")
    assert harness.same_keys(before, harness.keys(first))
    assert first.animation_data.action != second.animation_data.action
    assert [entry.name for entry in second.motion_theater.entries] == ["wave"]
