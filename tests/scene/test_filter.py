"""Filters as entries of the stack."""

from __future__ import annotations

import bpy
import numpy as np
import pytest

import motion_theater
from tests import harness

stack = harness.module("stack")


@pytest.mark.parametrize("kind", ["MEDIAN", "AVERAGE", "WEIGHTED"])
@pytest.mark.parametrize("depth", [3, 5, 7, 11])
def test_positions_are_filtered_as_the_core_does(kind: str, depth: int) -> None:
    ob = harness.import_human()
    harness.add("walk.amc", rate="SCENE")
    before = harness.key_rows(ob, "root", "location")
    bpy.ops.motion_theater.filter(kind=kind, depth=depth)
    after = harness.key_rows(ob, "root", "location")
    values = np.ascontiguousarray(before[:, 1:].T.astype(np.float64))
    expected = motion_theater.filter_values(values, kind=kind, depth=depth).T  # type: ignore[arg-type]
    assert np.abs(after[:, 1:] - expected).max() < 1e-5
    assert np.array_equal(after[:, 0], before[:, 0])


@pytest.mark.parametrize("depth", [1, 2, 4, 8])
def test_a_depth_without_a_middle_is_refused_in_words(depth: int) -> None:
    harness.import_human()
    harness.add("walk.amc")
    before = harness.snapshot()
    message = harness.refusal(lambda: bpy.ops.motion_theater.filter(kind="MEDIAN", depth=depth))
    assert message == f"The depth of a filter is an odd number from 3 on, not {depth}"
    assert harness.snapshot() == before


def test_it_works_on_what_was_animated_by_hand() -> None:
    ob = harness.import_human()
    for frame, x in ((1, 0.0), (2, 0.0), (3, 9.0), (4, 0.0), (5, 0.0)):
        ob.pose.bones["root"].location.x = x
        ob.pose.bones["root"].keyframe_insert("location", frame=frame)
    action = ob.animation_data.action
    bpy.ops.motion_theater.filter(kind="MEDIAN", depth=3)
    assert np.array_equal(harness.key_rows(ob, "root", "location")[:, 1], [0, 0, 0, 0, 0])
    assert ob.motion_theater.base_action == action
    stack.remove_entry(ob, 0)
    assert np.array_equal(harness.key_rows(ob, "root", "location")[:, 1], [0, 0, 9, 0, 0])


def test_without_motion_there_is_nothing_to_filter() -> None:
    harness.import_human()
    assert "no motion to filter" in harness.refusal(lambda: bpy.ops.motion_theater.filter(kind="MEDIAN", depth=3))


def test_none_selected_is_told() -> None:
    ob = harness.import_human()
    harness.add("walk.amc")
    harness.select(ob, [])
    message = harness.refusal(lambda: bpy.ops.motion_theater.filter(kind="MEDIAN", depth=3, selected_only=True))
    assert message.startswith("No bones are selected")


def test_its_settings_can_be_changed_later() -> None:
    ob = harness.import_human()
    harness.add("walk.amc")
    bpy.ops.motion_theater.filter(kind="WEIGHTED", depth=7)
    expected = harness.keys(ob)
    stack.remove_entry(ob, 1)
    bpy.ops.motion_theater.filter(kind="MEDIAN", depth=3)
    entry = ob.motion_theater.entries[1]
    entry.filter_kind = "WEIGHTED"
    entry.depth = 7
    assert harness.same_keys(expected, harness.keys(ob))
    entry.depth = 8
    assert "odd number" in entry.error
    assert harness.same_keys(expected, harness.keys(ob))


def test_the_message_says_what_was_done() -> None:
    ob = harness.import_human()
    harness.add("walk.amc")
    harness.select(ob, ["lradius"])
    bpy.ops.motion_theater.filter(kind="WEIGHTED", depth=7, selected_only=True)
    assert ob.motion_theater.message == "Filtered 1 bone: weighted average, depth 7"
