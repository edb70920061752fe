"""Motion plays at the speed at which it was recorded, and the scene changes only as the user chose."""

from __future__ import annotations

import bpy
import numpy as np
import pytest

import motion_theater
from tests import harness

stack = harness.module("stack")


def scene_rate() -> float:
    render = bpy.context.scene.render
    return render.fps / render.fps_base


def walk() -> motion_theater.Motion:
    skeleton = motion_theater.read(harness.TESTDATA / "human.asf").skeleton
    motion = motion_theater.read(harness.TESTDATA / "walk.amc", skeleton=skeleton).motion
    assert motion is not None
    return motion


def test_resampling_is_the_default_and_leaves_the_rate_of_the_scene() -> None:
    ob = harness.import_human()
    rate = scene_rate()
    harness.add("walk.amc")
    motion = walk()
    assert motion.rate_hz is not None
    assert scene_rate() == rate
    frames = harness.key_rows(ob, "lfemur", "rotation_quaternion")[:, 0]
    assert np.array_equal(frames, np.round(frames))
    seconds = (motion.frames - 1) / motion.rate_hz
    assert abs((frames[-1] - frames[0]) / rate - seconds) < 1 / rate


def test_setting_the_rate_of_the_scene_keeps_every_frame() -> None:
    ob = harness.import_human()
    harness.add("walk.amc", rate="SCENE")
    motion = walk()
    assert scene_rate() == motion.rate_hz
    frames = harness.key_rows(ob, "lfemur", "rotation_quaternion")[:, 0]
    assert np.array_equal(frames, np.arange(motion.frames) + motion.first_frame)


def test_keeping_every_sample_sets_keys_on_sub_frames() -> None:
    ob = harness.import_human()
    rate = scene_rate()
    harness.add("walk.amc", rate="SAMPLES")
    motion = walk()
    assert motion.rate_hz is not None
    assert scene_rate() == rate
    frames = harness.key_rows(ob, "lfemur", "rotation_quaternion")[:, 0]
    expected = motion.first_frame + np.arange(motion.frames) * rate / motion.rate_hz
    assert len(frames) == motion.frames
    assert np.abs(frames - expected).max() < 1e-3


@pytest.mark.parametrize(
    ("rate_hz", "fps", "fps_base"), [(120.0, 120, 1.0), (29.97, 30, 1.001), (59.94, 60, 1.001), (12.5, 13, 1.04)]
)
def test_the_rate_that_the_user_gives_goes_before_that_of_the_file(rate_hz: float, fps: int, fps_base: float) -> None:
    harness.import_human()
    harness.add("walk.amc", rate="SCENE", rate_hz=rate_hz)
    render = bpy.context.scene.render
    assert render.fps == fps
    assert render.fps_base == pytest.approx(fps_base, rel=1e-6)


@pytest.mark.parametrize(
    ("choice", "before", "after"),
    [("EXTEND", (10, 50), (1, 113)), ("FIT", (-0, 500), (1, 113)), ("KEEP", (10, 50), (10, 50))],
)
def test_the_frame_range_follows_the_choice(choice: str, before: tuple[int, int], after: tuple[int, int]) -> None:
    scene = bpy.context.scene
    scene.frame_start, scene.frame_end = before
    harness.import_human()
    harness.add("step_and_jump.amc", rate="SCENE", scene_range=choice)
    assert (scene.frame_start, scene.frame_end) == after


def test_the_current_frame_stays() -> None:
    harness.import_human()
    bpy.context.scene.frame_set(33)
    harness.add("walk.amc")
    assert bpy.context.scene.frame_current == 33


def test_a_cut_in_another_rate_stays_at_its_moment() -> None:
    ob = harness.import_human()
    rate = scene_rate()
    motion = walk()
    assert motion.rate_hz is not None
    harness.add("walk.amc", cut_start=121, cut_end=241)
    entry = ob.motion_theater.entries[0]
    first = motion.first_frame
    assert entry.result_start == np.ceil(first + (121 - first) * rate / motion.rate_hz)
    frames = harness.key_rows(ob, "lfemur", "rotation_quaternion")[:, 0]
    assert (frames[0], frames[-1]) == (entry.result_start, entry.result_end)


def test_a_new_scene_rate_counts_at_the_next_rebuild() -> None:
    ob = harness.import_human()
    harness.add("walk.amc")
    before = len(harness.key_rows(ob, "lfemur", "rotation_quaternion"))
    bpy.context.scene.render.fps *= 2
    stack.rebuild(ob)
    after = len(harness.key_rows(ob, "lfemur", "rotation_quaternion"))
    assert abs(after - 2 * before) <= 1
