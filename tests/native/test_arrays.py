"""Arrays across the border: what fits is taken as it is, what does not fit is refused, never read as something else."""

from __future__ import annotations

import threading
import time
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

import motion_theater as mt
from tests.native.files import TESTDATA

READ_ONLY = np.random.default_rng(1).normal(size=(3, 50))
READ_ONLY.flags.writeable = False

# What is handed over instead of C-contiguous float64 (channels, frames).
MISUSES: dict[str, Any] = {
    "single precision": np.zeros((3, 50), np.float32),
    "whole numbers": np.zeros((3, 50), np.int64),
    "complex numbers": np.zeros((3, 50), np.complex128),
    "text": np.full((3, 50), "1"),
    "one dimension": np.zeros(50),
    "three dimensions": np.zeros((3, 50, 1)),
    "every second value": np.zeros((3, 100))[:, ::2],
    "backwards": np.zeros((3, 50))[:, ::-1],
    "columns first": np.zeros((50, 3)).T,
    "swapped bytes": np.zeros((3, 50), np.dtype(np.float64).newbyteorder()),
    "a list": [[0.0] * 50],
    "nothing": None,
}


@pytest.mark.parametrize("what", MISUSES)
def test_an_array_of_another_kind_is_refused(what: str) -> None:
    with pytest.raises((TypeError, ValueError)):
        mt.filter_values(MISUSES[what], kind="MEDIAN", depth=3)


@pytest.mark.parametrize("shape", [(3, 50), (3, 50, 3), (3, 50, 5), (50, 4)])
def test_quaternions_have_four_components(shape: tuple[int, ...]) -> None:
    with pytest.raises((TypeError, ValueError)):
        mt.filter_rotations(np.ones(shape), kind="MEDIAN", depth=3)


def test_a_read_only_array_is_read() -> None:
    found = mt.filter_values(READ_ONLY, kind="AVERAGE", depth=3)
    assert found.shape == READ_ONLY.shape
    assert not np.shares_memory(found, READ_ONLY)


@pytest.mark.parametrize("shape", [(0, 0), (0, 5), (5, 0), (1, 1)])
def test_an_empty_or_tiny_array_comes_back_as_it_is(shape: tuple[int, int]) -> None:
    found = mt.filter_values(np.ones(shape), kind="WEIGHTED", depth=7)
    np.testing.assert_array_equal(found, np.ones(shape))


def test_an_unknown_filter_is_refused_by_name() -> None:
    with pytest.raises((mt.ParameterError, ValueError), match="BLUR"):
        mt.filter_values(np.zeros((1, 5)), kind="BLUR", depth=3)  # type: ignore[arg-type]


@pytest.fixture(scope="module")
def clip() -> mt.Clip:
    """Return a motion on its skeleton."""
    skeleton = mt.read(TESTDATA / "human.asf").skeleton
    return mt.read(TESTDATA / "step_and_jump.amc", skeleton=skeleton)


def test_results_are_contiguous_doubles_of_the_documented_shape(clip: mt.Clip) -> None:
    skeleton = mt.read(TESTDATA / "human.asf").skeleton
    assert skeleton is not None
    assert clip.motion is not None
    bones, frames = len(skeleton.names), clip.motion.frames
    root = clip.motion.names.index("root")
    shapes: list[tuple[Any, tuple[int, ...]]] = [
        (skeleton.heads, (bones, 3)),
        (skeleton.tails, (bones, 3)),
        (skeleton.axes, (bones, 4)),
        (clip.motion.rotations(root), (frames, 4)),
        (clip.motion.angles(root), (frames, 3)),
        (clip.motion.translations(root), (frames, 3)),
    ]
    for array, shape in shapes:
        assert (array.dtype, array.shape, array.flags.c_contiguous) == (np.float64, shape, True)


def test_a_bone_without_data_gives_arrays_without_frames(clip: mt.Clip) -> None:
    assert clip.motion is not None
    names = clip.motion.names
    translated = [name for bone, name in enumerate(names) if clip.motion.has_translation(bone)]
    assert translated == ["root"]
    assert clip.motion.translations(names.index("lfemur")).shape == (0, 3)


@pytest.mark.parametrize("bone", [-1, 31, 10**9, 2**70])
def test_a_bone_that_is_not_there_is_an_error(clip: mt.Clip, bone: int) -> None:
    assert clip.motion is not None
    calls: list[Callable[[int], object]] = [
        clip.motion.rotations,
        clip.motion.angles,
        clip.motion.translations,
        clip.motion.has_rotation,
        clip.motion.has_translation,
    ]
    for call in calls:
        with pytest.raises((IndexError, OverflowError, ValueError)):
            call(bone)


@pytest.mark.parametrize("frame", [float("nan"), float("inf"), -1e300, 1e300])
def test_a_frame_far_outside_gives_finite_poses_or_an_error(clip: mt.Clip, frame: float) -> None:
    skeleton = mt.read(TESTDATA / "human.asf").skeleton
    assert skeleton is not None
    assert clip.motion is not None
    try:
        heads, tails, rotations = clip.motion.pose(skeleton, frame)
    except (ValueError, mt.MotionTheaterError):
        return
    assert all(np.isfinite(array).all() for array in (heads, tails, rotations))


@pytest.mark.parametrize("rate_hz", [0.0, -1.0, float("nan"), float("inf")])
def test_a_rate_that_is_none_is_refused(clip: mt.Clip, rate_hz: float) -> None:
    assert clip.motion is not None
    with pytest.raises((mt.ParameterError, ValueError)):
        clip.motion.resampled(rate_hz)


def test_other_threads_run_while_the_core_works() -> None:
    """One call keeps the core busy; meanwhile this thread gets its turns, which it would not with the lock held."""
    values = np.random.default_rng(2).normal(size=(40, 100_000))
    begun = threading.Event()

    def work() -> None:
        begun.set()
        mt.filter_values(values, kind="MEDIAN", depth=301)

    worker = threading.Thread(target=work)
    worker.start()
    begun.wait()
    turns = 0
    while worker.is_alive():
        turns += 1
        time.sleep(0.001)
    assert turns > 20
