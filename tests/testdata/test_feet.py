"""Feet stand still, on the floor, in every clip."""

from __future__ import annotations

import numpy as np
import pytest

from .motions import CLIPS, clean_pose, recorded_pose, soles

TOUCHING_M = 0.004
"""A point of the sole this near to the floor carries weight."""

FLIGHT = slice(65, 87)
"""The frames of the jump in which both feet are in the air, counted from 0."""


@pytest.mark.parametrize("name", CLIPS)
def test_soles_never_go_below_the_floor(name: str) -> None:
    assert soles(clean_pose(name))[..., 1].min() > -0.002


@pytest.mark.parametrize("name", CLIPS)
def test_something_always_touches_the_floor_except_in_flight(name: str) -> None:
    lowest = soles(clean_pose(name))[..., 1].min(axis=1)
    grounded = np.ones(len(lowest), dtype=bool)
    if name == "step_and_jump":
        grounded[FLIGHT] = False
        assert lowest[FLIGHT].max() > 0.1
    assert lowest[grounded].max() < TOUCHING_M


@pytest.mark.parametrize("name", CLIPS)
def test_a_standing_foot_stays_in_its_place(name: str) -> None:
    points = soles(clean_pose(name))
    for point in range(points.shape[1]):
        for start, end in _contacts(points[:, point, 1]):
            place = points[start:end, point][:, [0, 2]]
            assert np.linalg.norm(place - place[len(place) // 2], axis=-1).max() < 0.01


@pytest.mark.parametrize("name", CLIPS)
def test_noise_leaves_the_feet_near_the_floor(name: str) -> None:
    off = soles(recorded_pose(name)) - soles(clean_pose(name))
    # Half a centimetre of trembling per axis: five deviations, and a spike of 8 degrees in a knee.
    assert np.sqrt((off**2).mean()) < 0.008
    assert np.linalg.norm(off, axis=-1).max() < 0.09


def _contacts(height: np.ndarray) -> list[tuple[int, int]]:
    """Runs of at least three frames on the floor, without the frames of arrival and departure."""
    touching = np.concatenate([[False], height < TOUCHING_M, [False]])
    changes = np.flatnonzero(touching[1:] != touching[:-1])
    runs = [(int(start) + 1, int(end) - 1) for start, end in zip(changes[::2], changes[1::2], strict=True)]
    return [(start, end) for start, end in runs if end - start >= 3]
