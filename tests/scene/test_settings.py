"""Every setting of a track acts, and changing it later gives what adding it so would have given."""

from __future__ import annotations

from typing import Any

import bpy
import numpy as np
import pytest

from tests import harness

stack = harness.module("stack")

SETTINGS: list[dict[str, Any]] = [
    {"cut_start": 20},
    {"cut_end": 70},
    {"scale_start": 30},
    {"scale_end": 180},
    {"blend_depth": 6},
    {"preserve": True},
    {"preserve": True, "preserve_rotation": "FULL"},
    {"preserve": True, "preserve_height": True},
    {"discard": True},
    {"blend_depth": 6, "blend": "EULER"},
    {"scale_end": 200, "sampling": "SMOOTH"},
    {"rate_hz": 90.0},
]


def walking() -> bpy.types.Object:
    ob = harness.import_human()
    harness.add("walk.amc", rate="SCENE", scale_start=1, scale_end=300)
    return ob


@pytest.mark.parametrize("settings", SETTINGS, ids=lambda settings: " ".join(settings))
def test_changing_a_setting_equals_adding_with_it(settings: dict[str, Any]) -> None:
    around = {"cut_start": 10, "cut_end": 90, "scale_start": 40, "scale_end": 150}
    if "rate_hz" in settings:
        around = {"cut_start": 10}
    ob = walking()
    harness.add("turn.amc", **(around | settings))
    expected = harness.keys(ob)
    stack.remove_entry(ob, 1)
    harness.add("turn.amc", **around)
    plain = harness.keys(ob)
    entry = ob.motion_theater.entries[1]
    for name, value in settings.items():
        setattr(entry, name, value)
    assert entry.error == ""
    assert harness.same_keys(expected, harness.keys(ob))
    assert not harness.same_keys(plain, harness.keys(ob))
    for name in settings:
        setattr(entry, name, around.get(name, entry.bl_rna.properties[name].default))
    assert harness.same_keys(plain, harness.keys(ob))


def test_preserved_motion_goes_on_from_where_the_old_one_was() -> None:
    ob = walking()
    harness.add("turn.amc", scale_start=150, scale_end=250, preserve=True)

    def step(frame: int) -> float:
        root = ob.pose.bones.find("root")
        before, after = (harness.pose(ob, at)[root, :2, 3] for at in (frame, frame + 1))
        return float(np.linalg.norm(after - before))

    usual = max(step(frame) for frame in range(100, 140))
    assert step(149) <= 2 * usual
    assert step(250) <= 2 * usual


def test_preserving_excludes_blending_and_says_so() -> None:
    ob = walking()
    harness.add("turn.amc", scale_start=150, scale_end=250, preserve=True, blend_depth=5)
    assert "lend" in ob.motion_theater.entries[1].notices


def test_discarding_leaves_nothing_of_the_old_motion_on_these_bones() -> None:
    ob = walking()
    harness.select(ob, ["lradius"])
    harness.add("wave.amc", selected_only=True, scale_start=100, scale_end=120, discard=True)
    frames = harness.key_rows(ob, "lradius", "rotation_quaternion")[:, 0]
    assert (frames[0], frames[-1]) == (100, 120)
    assert harness.key_rows(ob, "lfemur", "rotation_quaternion")[-1, 0] == 300


def test_the_first_steps_of_the_tutorial() -> None:
    ob = harness.import_human()
    legs = ["root", *harness.below(ob, "lhipjoint", "rhipjoint")]
    harness.select(ob, legs)
    harness.add("step_and_jump.amc", rate="SCENE", selected_only=True)
    moved = {path.split('"')[1] for path, _ in harness.keys(ob)}
    assert moved <= set(legs)
    upper = harness.below(ob, "lowerback")
    harness.select(ob, upper)
    harness.add("wave.amc", selected_only=True, cut_start=1, cut_end=55, scale_start=1, scale_end=66)
    harness.add("step_and_jump.amc", selected_only=True, cut_start=67, cut_end=113, blend_depth=10)
    rows = harness.key_rows(ob, "rhumerus", "rotation_quaternion")
    assert np.array_equal(rows[:, 0], np.arange(1, 114))
    blend = ob.motion_theater.entries[2]
    blend.blend_depth = 0
    hard = harness.key_rows(ob, "rhumerus", "rotation_quaternion")
    blend.blend_depth = 10
    border = 65  # from frame 66 to frame 67
    assert np.abs(np.diff(rows, axis=0)[border, 1:]).max() < 0.5 * np.abs(np.diff(hard, axis=0)[border, 1:]).max()
    harness.select(ob, harness.below(ob, "lclavicle", "rclavicle"))
    bpy.ops.motion_theater.filter(kind="WEIGHTED", depth=7, selected_only=True)
    assert [entry.kind for entry in ob.motion_theater.entries] == ["TRACK", "TRACK", "TRACK", "FILTER"]
    smooth = harness.key_rows(ob, "rhumerus", "rotation_quaternion")
    assert np.abs(np.diff(smooth[:, 1:], 2, axis=0)).max() < np.abs(np.diff(rows[:, 1:], 2, axis=0)).max()
