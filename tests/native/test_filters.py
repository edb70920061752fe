"""The filters against scipy's where the window is full, and against the documented rule at the ends."""

from __future__ import annotations

from collections.abc import Callable
from math import comb

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays
from numpy.typing import NDArray
from scipy import ndimage
from scipy.spatial.transform import Rotation

import motion_theater as mt

Array = NDArray[np.float64]
KINDS: tuple[mt.FilterKind, ...] = ("MEDIAN", "AVERAGE", "WEIGHTED")
DEPTHS = (3, 5, 7, 9, 31)


def pascal(depth: int) -> Array:
    """Return the weights of a weighted average."""
    row = np.array([float(comb(depth - 1, k)) for k in range(depth)])
    return row / row.sum()


SCIPY: dict[str, Callable[[Array, int], Array]] = {
    "MEDIAN": lambda values, depth: ndimage.median_filter(values, size=(1, depth)),
    "AVERAGE": lambda values, depth: ndimage.uniform_filter1d(values, depth, axis=-1),
    "WEIGHTED": lambda values, depth: ndimage.convolve1d(values, pascal(depth), axis=-1),
}


def of_one_window(kind: str, window: Array) -> float:
    """Return what a filter makes of one centred window."""
    if kind == "MEDIAN":
        return float(np.median(window))
    return float(window.mean() if kind == "AVERAGE" else pascal(len(window)) @ window)


@pytest.mark.parametrize("depth", DEPTHS)
@pytest.mark.parametrize("kind", KINDS)
def test_full_windows_give_what_scipy_gives(kind: mt.FilterKind, depth: int) -> None:
    values = np.random.default_rng(depth).normal(size=(7, 1000))
    found = mt.filter_values(values, kind=kind, depth=depth)
    reach = depth // 2
    expected = SCIPY[kind](values, depth)
    np.testing.assert_allclose(found[:, reach:-reach], expected[:, reach:-reach], rtol=0, atol=1e-12)


@pytest.mark.parametrize("depth", DEPTHS)
@pytest.mark.parametrize("kind", KINDS)
def test_near_the_ends_the_window_shrinks_so_that_it_stays_centred(kind: mt.FilterKind, depth: int) -> None:
    values = np.random.default_rng(depth).normal(size=(3, 40))
    found = mt.filter_values(values, kind=kind, depth=depth)
    for frame in [*range(depth // 2), *range(40 - depth // 2, 40)]:
        reach = min(frame, 39 - frame, depth // 2)
        expected = [of_one_window(kind, channel[frame - reach : frame + reach + 1]) for channel in values]
        np.testing.assert_allclose(found[:, frame], expected, rtol=0, atol=1e-12)
    np.testing.assert_array_equal(found[:, [0, -1]], values[:, [0, -1]])


@given(arrays(np.float64, (2, 12), elements=st.floats(-1e6, 1e6)), st.sampled_from(KINDS), st.sampled_from(DEPTHS))
def test_a_filter_stays_within_the_values_of_its_window(values: Array, kind: mt.FilterKind, depth: int) -> None:
    before = values.copy()
    found = mt.filter_values(values, kind=kind, depth=depth)
    slack = 1e-12 * np.abs(values).max()
    assert np.all(found >= values.min(axis=1, keepdims=True) - slack)
    assert np.all(found <= values.max(axis=1, keepdims=True) + slack)
    np.testing.assert_array_equal(values, before)


@pytest.mark.parametrize("depth", (3, 5, 7))
@pytest.mark.parametrize("kind", KINDS)
def test_a_steady_turn_through_half_a_circle_is_left_as_it_is(kind: mt.FilterKind, depth: int) -> None:
    """Each quaternion is given with either sign by turns, as files and F-curves do: the rotations are what counts."""
    angles = np.radians(np.arange(90.0, 270.0, 2.0))
    turning = Rotation.from_rotvec(angles[:, None] * [0.6, 0.0, 0.8])
    values = turning.as_quat(scalar_first=True)
    values[1::2] *= -1
    found = mt.filter_rotations(values[None], kind=kind, depth=depth)[0]
    apart = (Rotation.from_quat(found, scalar_first=True) * turning.inv()).magnitude()
    assert apart.max() < 1e-7  # arccos near 1: the square root of double precision
    np.testing.assert_allclose(np.linalg.norm(found, axis=1), 1.0, rtol=0, atol=1e-12)


def test_the_median_of_rotations_removes_a_spike_whole() -> None:
    angles = np.radians(np.linspace(0.0, 40.0, 41))
    turning = Rotation.from_rotvec(angles[:, None] * [0.0, 0.0, 1.0])
    values = turning.as_quat(scalar_first=True)
    values[20] = Rotation.from_rotvec([1.2, 0.0, 0.0]).as_quat(scalar_first=True)
    found = Rotation.from_quat(mt.filter_rotations(values[None], kind="MEDIAN", depth=3)[0], scalar_first=True)
    assert np.degrees((found * turning.inv()).magnitude()).max() < 1.0 + 1e-6


@pytest.mark.parametrize("depth", (-3, 0, 1, 2, 4, 100))
def test_a_depth_that_is_even_or_too_small_is_refused(depth: int) -> None:
    with pytest.raises((mt.ParameterError, OverflowError)):
        mt.filter_values(np.zeros((1, 5)), kind="MEDIAN", depth=depth)
