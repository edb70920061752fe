"""Every real ASF/AMC pair against what an independent reader (AMCParser) says of it.

Two of its answers come with a caution. It takes `:FORCE-ALL-JOINTS-BE-3DOF` files as ordinary ones, the first values
of a bone being those of its own dofs; the take that such a file here was made from shows that this is right (the last
test). And it reads "(-inf inf)" as three free angles: the bones of that file have three, so its answer stands too.
"""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest

import motion_theater as mt
from tests.native.files import REAL_PAIRS, SHARED, Pair

FACTS_TOLERANCE = 1e-4
"""In heights of the skeleton: that reader's numbers are rounded to six decimals."""

pairs = pytest.mark.parametrize("pair", REAL_PAIRS, ids=lambda pair: pair.name)


def the_files_own_values(skeleton: mt.Skeleton, motion: mt.Motion, name: str, frame: int) -> list[float]:
    """Return a bone's values in dof order and in the file's units (degrees)."""
    bone, channel = skeleton.names.index(name), motion.names.index(name)
    columns = {"r": np.degrees(motion.angles(channel)), "t": motion.translations(channel)}
    return [float(columns[dof[0]][frame]["xyz".index(dof[1])]) for dof in skeleton.dofs[bone]]


@pairs
def test_bones_and_frames_are_those_of_the_facts(pair: Pair) -> None:
    skeleton, motion, clip = pair.read()
    assert set(skeleton.names) == set(pair.facts["bone_names"])
    assert (motion.frames, clip.frames) == (pair.facts["frames"], pair.facts["frames"])
    assert clip.names == list(pair.facts["first_frame_values"])


@pairs
def test_the_first_frame_has_the_values_of_the_facts(pair: Pair) -> None:
    skeleton, motion, _ = pair.read()
    for name, expected in pair.facts["first_frame_values"].items():
        found = the_files_own_values(skeleton, motion, name, 0)
        # A file that forces 3 values per bone fills up with zeros behind the bone's own.
        assert expected[len(found) :] == [0.0] * (len(expected) - len(found))
        assert found == pytest.approx(expected[: len(found)], abs=1e-6)


@pairs
def test_ends_of_bones_are_where_the_facts_have_them(pair: Pair) -> None:
    skeleton, motion, clip = pair.read()
    for fact in pair.facts["forward_kinematics"]:
        _, tails, _ = motion.pose(skeleton, clip.first_frame + fact["frame_index"])
        distance = math.dist(tails[skeleton.names.index(fact["bone"])], fact["end_position_asf_units"])
        assert distance <= FACTS_TOLERANCE * skeleton.height, (fact, distance)


@pytest.mark.parametrize("folder", [SHARED / "asf_amc/cmu135"] if SHARED.is_dir() else [], ids=lambda path: path.name)
def test_a_file_with_three_values_per_bone_has_the_poses_of_the_take_it_was_made_from(folder: Path) -> None:
    """Its name says linear interpolation with 40 frames left out: every 41st frame is the original's."""
    skeleton = mt.read(folder / "135-martialArts.asf").skeleton
    assert skeleton is not None
    original = mt.read(folder / "135_06-martialArts.amc", skeleton=skeleton).motion
    interpolated = mt.read(folder / "135_06-martialArts-le-N40.amc", skeleton=skeleton).motion
    assert original is not None
    assert interpolated is not None
    for frame in range(1, original.frames - 41, 41):
        for expected, found in zip(original.pose(skeleton, frame), interpolated.pose(skeleton, frame), strict=True):
            np.testing.assert_allclose(found, expected, atol=1e-9)
