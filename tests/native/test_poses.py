"""Poses of the core against poses worked out a second time from the files (plain_pose.py)."""

from __future__ import annotations

import numpy as np
import pytest

from tests.bench.plain_amc import read_amc
from tests.native.files import OUR_PAIRS, REAL_PAIRS, Pair
from tests.native.plain_pose import plain_pose, read_asf

EVERY_NTH_FRAME = 25
ROUNDING = 1e-9
"""In heights of the skeleton: sums of some ten double numbers along a limb."""


@pytest.mark.parametrize("pair", OUR_PAIRS + REAL_PAIRS, ids=lambda pair: pair.name)
def test_heads_and_tails_of_every_bone_are_those_of_the_format_s_description(pair: Pair) -> None:
    skeleton, motion, clip = pair.read()
    plain, frames = read_asf(pair.asf), read_amc(pair.amc)
    assert len(frames) == motion.frames
    for index in range(0, motion.frames, EVERY_NTH_FRAME):
        heads, tails, _ = motion.pose(skeleton, clip.first_frame + index)
        expected = plain_pose(plain, frames[index])
        assert set(expected) == set(skeleton.names)
        for bone, name in enumerate(skeleton.names):
            np.testing.assert_allclose(heads[bone], expected[name][0], rtol=0, atol=ROUNDING * skeleton.height)
            np.testing.assert_allclose(tails[bone], expected[name][1], rtol=0, atol=ROUNDING * skeleton.height)
