"""The core reads the clips and puts every bone where the generator meant it to be."""

from __future__ import annotations

import numpy as np
import pytest

import motion_theater
from testdata.generate.skeleton import UNIT_M

from . import acclaim
from .motions import CLIPS, recorded_pose

TOLERANCE_M = 1e-6


@pytest.mark.parametrize(("name", "frames"), CLIPS.items())
def test_the_core_finds_the_same_pose(name: str, frames: int) -> None:
    skeleton = motion_theater.read(acclaim.FOLDER / "human.asf").skeleton
    assert skeleton is not None
    clip = motion_theater.read(acclaim.FOLDER / f"{name}.amc", skeleton=skeleton)
    assert clip.motion is not None
    assert (clip.frames, clip.first_frame, clip.rate_hz) == (frames, 1, 60.0)
    assert skeleton.unit_m == pytest.approx(UNIT_M)
    meant = recorded_pose(name)
    for frame in range(0, frames, 7):
        heads, tails, _ = clip.motion.pose(skeleton, float(frame + 1))
        for bone, head, tail in zip(skeleton.names, heads, tails, strict=True):
            assert np.abs(head * UNIT_M - meant.heads[bone][frame]).max() < TOLERANCE_M
            assert np.abs(tail * UNIT_M - meant.tails[bone][frame]).max() < TOLERANCE_M
