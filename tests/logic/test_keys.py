"""Keys as arrays, and putting those of two curves together."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from addon.logic import keys

FRAMES = st.lists(st.integers(-50, 50), unique=True, max_size=20).map(sorted)


def curve(frames: list[int], value: float) -> keys.Keys:
    coordinates = np.array([(frame, value) for frame in frames], np.float32).reshape(-1)
    return keys.made(coordinates, None)


def test_new_keys_are_linear_with_handles_for_blender_to_compute() -> None:
    made = curve([1, 2], 5.0)
    assert keys.count(made) == 2
    assert set(made) == set(keys.FIELDS)
    assert list(made["interpolation"]) == [keys.LINEAR] * 2
    assert list(made["handle_left_type"]) == [keys.AUTO_CLAMPED] * 2
    for name, (kind, width) in keys.FIELDS.items():
        assert made[name].dtype == kind
        assert made[name].shape == (2 * width,)


@given(FRAMES, FRAMES, st.integers(-60, 60), st.integers(0, 40))
def test_old_keys_stay_outside_and_new_ones_stand_inside(
    old_frames: list[int], new_frames: list[int], start: int, length: int
) -> None:
    end = start + length
    inside = [frame for frame in new_frames if start <= frame <= end]
    old, new = curve(old_frames, 1.0), curve(inside, 2.0)
    old["back"] = np.arange(len(old_frames), dtype=np.float32)
    result = keys.spliced(old, new, start, end)
    expected = sorted([(frame, 1.0) for frame in old_frames if not start <= frame <= end] + [(f, 2.0) for f in inside])
    assert result["co"].reshape(-1, 2).tolist() == [list(pair) for pair in expected]
    kept = [index for index, frame in enumerate(old_frames) if not start <= frame <= end]
    is_old = result["co"][1::2] == 1.0
    assert result["back"][is_old].tolist() == kept


@pytest.mark.parametrize(("frame", "before", "after"), [(9.9, True, False), (10, False, False), (20.1, False, True)])
def test_a_key_on_the_border_lies_inside(frame: float, before: bool, after: bool) -> None:
    made = keys.made(np.array([frame, 0.0], np.float32), None)
    is_before, is_after = keys.outside(made, 10.0, 20.0)
    assert (is_before.tolist(), is_after.tolist()) == ([before], [after])


@pytest.mark.parametrize(
    ("frames", "apart"),
    [
        ([], True),
        ([3.0], True),
        ([1.0, 2.0, 3.0], True),
        ([1.0, 1.5], True),
        ([1.0, 1.005], False),
        ([2.0, 1.0], False),
    ],
)
def test_keys_in_order_and_not_too_near_need_no_sorting_and_no_merging(frames: list[float], apart: bool) -> None:
    coordinates = np.array([(frame, 0.0) for frame in frames], np.float32).reshape(-1)
    assert keys.are_apart(coordinates) is apart
