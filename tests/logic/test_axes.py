"""Quaternions as arrays, checked against matrices written out."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from addon.logic import axes

COMPONENT = st.floats(-1.0, 1.0)
QUATERNIONS = (
    st.tuples(COMPONENT, COMPONENT, COMPONENT, COMPONENT)
    .filter(lambda q: np.linalg.norm(q) > 0.1)
    .map(lambda q: np.array(q) / np.linalg.norm(q))
)
EXACT = 1e-12  # a few roundings of numbers of size 1


def matrix(q: axes.Floats) -> axes.Floats:
    w, x, y, z = q
    return np.array(
        [
            [1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
            [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
            [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)],
        ]
    )


@given(QUATERNIONS, QUATERNIONS)
def test_products_and_inverses_are_those_of_matrices(a: axes.Floats, b: axes.Floats) -> None:
    assert np.abs(matrix(axes.multiply(a, b)) - matrix(a) @ matrix(b)).max() < EXACT
    assert np.abs(matrix(axes.inverse(a)) - matrix(a).T).max() < EXACT


@given(QUATERNIONS)
def test_vectors_turn_as_by_the_matrix(q: axes.Floats) -> None:
    vectors = np.array([[1.0, 0.0, 0.0], [0.3, -2.0, 5.0]])
    assert np.abs(axes.rotate(q, vectors) - vectors @ matrix(q).T).max() < 10 * EXACT


@given(QUATERNIONS)
def test_a_matrix_gives_its_quaternion_back(q: axes.Floats) -> None:
    (found,) = axes.from_matrices(matrix(q)[None])
    assert min(np.abs(found - q).max(), np.abs(found + q).max()) < EXACT


@pytest.mark.parametrize("half_turn", np.eye(4)[1:])
def test_half_turns_have_quaternions_too(half_turn: axes.Floats) -> None:
    (found,) = axes.from_matrices(matrix(half_turn)[None])
    assert np.abs(np.abs(found) - half_turn).max() < EXACT


@pytest.mark.parametrize(
    ("up", "point", "expected"),
    [("Y", (1, 2, 3), (1, -3, 2)), ("Z", (1, 2, 3), (1, 2, 3)), ("X", (1, 2, 3), (-3, 2, 1))],
)
def test_the_up_axis_becomes_z(up: str, point: tuple[float, ...], expected: tuple[float, ...]) -> None:
    turned = axes.rotate(np.array(axes.TO_BLENDER[up]), np.array(point, np.float64))
    assert np.abs(turned - expected).max() < EXACT


@pytest.mark.parametrize(
    ("up", "name"), [((0, 1, 0), "Y"), ((0.1, 0.2, 0.9), "Z"), ((-1, 0, 0), "-X"), ((0, 0.99, 0.1), "Y")]
)
def test_the_nearest_axis_is_named(up: tuple[float, float, float], name: str) -> None:
    assert axes.nearest_axis(up) == name
