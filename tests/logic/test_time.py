"""Rates, frame ranges and where a track lies on the timeline."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from addon.logic.extent import extent
from addon.logic.ranges import scene_range
from addon.logic.rates import settings, usual


@pytest.mark.parametrize(
    ("rate", "fps", "base"),
    [
        (120.0, 120, 1.0),
        (24.0, 24, 1.0),
        (30 / 1.001, 30, 1.001),
        (24 / 1.001, 24, 1.001),
        (120 / 1.001, 120, 1.001),
        (99.7, 100, 100 / 99.7),
        (0.5, 1, 2.0),
        (32767.0, 32767, 1.0),
    ],
)
def test_a_rate_is_kept_exactly(rate: float, fps: int, base: float) -> None:
    assert settings(rate) == (fps, pytest.approx(base, rel=1e-12))


@given(st.floats(0.1, 30000.0))
def test_any_rate_survives_in_the_digits_that_blender_keeps(rate: float) -> None:
    fps, base = settings(rate)
    assert 1 <= fps <= 32767
    assert fps / float(np.float32(base)) == pytest.approx(rate, rel=1e-6)


@pytest.mark.parametrize(
    ("rate", "meant"),
    [(1 / 0.0083333, 120.0), (30.0003, 30.0), (29.97, 30 / 1.001), (23.976, 24 / 1.001), (99.7, 99.7), (125.0, 125.0)],
)
def test_a_rate_near_a_usual_one_is_meant_to_be_it(rate: float, meant: float) -> None:
    assert usual(rate) == meant


@pytest.mark.parametrize(
    ("choice", "motion", "expected"),
    [
        ("EXTEND", (1.0, 113.0), (1, 250)),
        ("EXTEND", (-20.0, 300.4), (0, 301)),
        ("FIT", (10.5, 113.0), (10, 113)),
        ("FIT", (-20.0, -10.0), (0, 0)),
        ("KEEP", (-20.0, 900.0), (1, 250)),
    ],
)
def test_the_frame_range_of_the_scene(choice: str, motion: tuple[float, float], expected: tuple[int, int]) -> None:
    assert scene_range(choice, (1, 250), motion) == expected  # type: ignore[arg-type]


@pytest.mark.parametrize(
    ("options", "expected"),
    [
        ({}, (1, 113)),
        ({"cut": (50, None)}, (50, 113)),
        ({"cut": (50, 100)}, (50, 100)),
        ({"cut": (50, 900)}, (50, 113)),
        ({"scale": (50, 140)}, (50, 140)),
        ({"cut": (50, 113), "scale": (50, 140)}, (50, 140)),
        ({"scale": (10, None)}, (10, 113)),
        ({"file_hz": 120.0}, (1, 23)),
        ({"file_hz": 120.0, "cut": (11, 111)}, (3, 23)),
        ({"file_hz": 120.0, "on_whole_frames": False}, (1, 23.4)),
    ],
)
def test_where_a_track_lies(options: dict[str, object], expected: tuple[float, float]) -> None:
    found = extent(**{"first": 1, "frames": 113, "file_hz": 24.0, "scene_hz": 24.0, **options})  # type: ignore[arg-type]
    assert found == pytest.approx(expected)
