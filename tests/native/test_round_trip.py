"""What is written is what was read: the same values, names and order."""

from __future__ import annotations

import numpy as np
import pytest

import motion_theater as mt
from tests.native.files import OUR_PAIRS, REAL_PAIRS, Pair

pairs = pytest.mark.parametrize("pair", OUR_PAIRS + REAL_PAIRS, ids=lambda pair: pair.name)


@pairs
def test_a_skeleton_written_and_read_is_the_same(pair: Pair) -> None:
    clip = mt.read(pair.asf)
    data = clip.to_bytes()
    again = mt.read_bytes(data, name="again.asf")
    assert clip.skeleton is not None
    assert again.skeleton is not None
    for field in ("name", "names", "parents", "orders", "dofs", "limits", "up", "unit_m", "height"):
        assert getattr(again.skeleton, field) == getattr(clip.skeleton, field)
    for field in ("heads", "tails", "axes"):
        np.testing.assert_array_equal(getattr(again.skeleton, field), getattr(clip.skeleton, field))
    assert again.to_bytes() == data


@pairs
def test_a_motion_written_and_read_is_the_same(pair: Pair) -> None:
    skeleton, motion, clip = pair.read()
    data = clip.to_bytes()
    again = mt.read_bytes(data, name="again.amc", skeleton=skeleton)
    assert again.motion is not None
    assert (again.names, again.first_frame, again.frames) == (clip.names, clip.first_frame, clip.frames)
    assert again.rate_hz == clip.rate_hz
    for bone in range(len(motion.names)):
        np.testing.assert_array_equal(again.motion.angles(bone), motion.angles(bone))
        np.testing.assert_array_equal(again.motion.translations(bone), motion.translations(bone))
    assert again.to_bytes() == data
