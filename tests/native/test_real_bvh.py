"""Every real BVH against what two independent readers say of it, and against the file's own words.

One of the readers (`bvh`) loses the last row of a file without a final newline: rows are counted in the file itself.
The other (`bvhio`) lets a position channel stand in for the offset of its joint, as all readers do; it does not know
channels in upper case and leaves the one file that has them in its rest pose.
"""

from __future__ import annotations

import json
import math
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import motion_theater as mt
from tests.native.files import SHARED

ROUNDED = 0.51e-6
"""Facts are rounded to six decimals."""

UPPER_CASE = "upper_case_channels_sample-walk"

FK_TOLERANCE = 1e-4
"""In sizes of the skeleton: that reader computes in 32 bits."""


@dataclass(frozen=True)
class Take:
    """A file and the facts about it, by tool."""

    path: Path
    facts: dict[str, Any]

    def of(self, tool: str) -> dict[str, Any]:
        """Return what a tool says."""
        facts = self.facts[tool]
        assert isinstance(facts, dict)
        return facts

    def words(self) -> tuple[float, list[float]]:
        """Return the frame time and all values as the file has them, worked out without the core."""
        _, motion = self.path.read_text(encoding="latin-1").split("MOTION")
        words = motion.replace(":", " ").split()
        assert [words[0], words[2], words[3]] == ["Frames", "Frame", "Time"]
        return float(words[4]), [float(word) for word in words[5:]]


def _takes() -> list[Take]:
    table = SHARED / "facts.json"
    if not table.is_file():
        return []
    files = json.loads(table.read_text(encoding="utf-8"))["files"]
    return [Take(SHARED / name, facts) for name, facts in files.items() if name.startswith("bvh/")]


takes = pytest.mark.parametrize("take", _takes(), ids=lambda take: take.path.stem)


def read(take: Take) -> tuple[mt.Clip, mt.Skeleton, mt.Motion]:
    """Read a file that holds a skeleton and a motion."""
    clip = mt.read(take.path)
    assert clip.format == "bvh"
    assert clip.skeleton is not None
    assert clip.motion is not None
    return clip, clip.skeleton, clip.motion


def values_of(skeleton: mt.Skeleton, motion: mt.Motion, joint: str, frame: int) -> list[float]:
    """Return a joint's values at a frame in the order of its channels, in degrees and file units."""
    bone = skeleton.names.index(joint)
    parent = skeleton.parents[bone]
    offset = skeleton.heads[bone] - (skeleton.heads[parent] if parent >= 0 else 0.0)
    channels = {"r": np.degrees(motion.angles(bone)), "t": motion.translations(bone) + offset}
    return [float(channels[dof[0]][frame]["xyz".index(dof[1])]) for dof in skeleton.dofs[bone]]


@takes
def test_counts_names_and_rate_are_those_of_the_facts(take: Take) -> None:
    clip, skeleton, motion = read(take)
    facts, plain = take.of("bvhio 1.5.4"), take.of("bvh 0.3 (20tab)")
    frame_time, values = take.words()
    assert (motion.frames, clip.frames) == (facts["frames"], plain["frames_declared"])
    assert clip.first_frame == motion.first_frame == 1
    assert clip.names == skeleton.names == facts["names"]
    assert sum(map(len, skeleton.dofs)) == facts["channels_total"]
    assert len(values) == facts["channels_total"] * motion.frames
    assert frame_time == pytest.approx(facts["frame_time"], abs=ROUNDED)
    assert clip.rate_hz == motion.rate_hz
    # Files round the frame time, some to five decimals: the rate is the usual one within that.
    assert clip.rate_hz == pytest.approx(1 / frame_time, rel=2e-4)


@takes
def test_offsets_and_channels_are_those_of_the_facts(take: Take) -> None:
    _, skeleton, _ = read(take)
    facts = take.of("bvhio 1.5.4")
    words = {"X": "x", "Y": "y", "Z": "z", "position": "t", "rotation": "r"}
    root = [words[channel[1:].lower()] + words[channel[0].upper()] for channel in facts["root_channels"]]
    assert skeleton.dofs[0] == root
    for joint, expected in facts["offsets"].items():
        bone = skeleton.names.index(joint)
        parent = skeleton.parents[bone]
        offset = skeleton.heads[bone] - (skeleton.heads[parent] if parent >= 0 else 0.0)
        np.testing.assert_allclose(offset, expected, atol=2 * ROUNDED)


@takes
def test_values_are_those_of_the_facts(take: Take) -> None:
    _, skeleton, motion = read(take)
    for fact in take.of("bvh 0.3 (20tab)")["samples"]:
        found = values_of(skeleton, motion, fact["joint"], fact["frame"])
        assert found == pytest.approx(fact["values"], abs=2 * ROUNDED, rel=1e-12)


@takes
def test_joints_are_where_the_facts_have_them(take: Take) -> None:
    _, skeleton, motion = read(take)
    size = float(np.ptp(skeleton.heads, axis=0).max())
    for fact in take.of("bvhio 1.5.4 forward kinematics")["samples"]:
        heads = skeleton.heads
        if take.path.stem != UPPER_CASE:
            heads, _, _ = motion.pose(skeleton, 1 + fact["frame"])
        distance = math.dist(heads[skeleton.names.index(fact["joint"])], fact["world_position"])
        assert distance <= FK_TOLERANCE * size, (fact, distance)


@takes
def test_a_file_written_anew_has_the_same_values_to_the_last_bit(take: Take, tmp_path: Path) -> None:
    clip, skeleton, _ = read(take)
    written = tmp_path / "again.bvh"
    written.write_bytes(clip.to_bytes())
    assert Take(written, {}).words() == take.words()
    again = mt.read(written).skeleton
    assert again is not None
    for field in ("names", "parents", "orders", "dofs", "up", "unit_m", "unit_reason"):
        assert getattr(again, field) == getattr(skeleton, field)
    for field in ("heads", "tails"):
        np.testing.assert_array_equal(getattr(again, field), getattr(skeleton, field))


@takes
def test_a_motion_written_as_a_bvh_has_the_same_places(take: Take) -> None:
    _, skeleton, motion = read(take)
    again = mt.read_bytes(motion.to_bvh(skeleton), name="again.bvh")
    assert again.skeleton is not None
    assert again.motion is not None
    assert (again.names, again.frames, again.rate_hz) == (skeleton.names, motion.frames, motion.rate_hz)
    size = float(np.ptp(skeleton.heads, axis=0).max())
    for frame in {1, 1 + motion.frames // 2, motion.frames}:
        heads, _, _ = motion.pose(skeleton, frame)
        found, _, _ = again.motion.pose(again.skeleton, frame)
        np.testing.assert_allclose(found, heads, atol=1e-9 * size)


@takes
def test_what_is_inferred_comes_with_a_reason(take: Take) -> None:
    clip, skeleton, motion = read(take)
    found = mt.infer(skeleton, motion)
    assert (found.unit_m, found.up) == (skeleton.unit_m, skeleton.up)
    assert found.unit_is_certain == skeleton.unit_is_certain
    for what, reason in (
        ("Length unit", found.unit_reason),
        ("Up axis", found.up_reason),
        ("Facing", found.facing_reason),
    ):
        assert f"{what}: {reason}" in clip.notices
    assert (found.rate_hz, found.rate_is_certain) == (motion.rate_hz, True)
    assert np.dot(found.up, found.facing) == 0
