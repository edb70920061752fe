"""Rotation matrices over frames, and Euler angles as Acclaim files hold them.

Matrices are (..., 3, 3) for column vectors. Angles are radians. "XYZ" turns about X first, then Y, then Z, about
fixed axes: R = Rz * Ry * Rx.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

Floats = NDArray[np.float64]


def about(axis: int, angle: ArrayLike) -> Floats:
    """The rotation by `angle` about a coordinate axis (0, 1, 2), one matrix per angle."""
    angle = np.asarray(angle, dtype=float)
    cos, sin = np.cos(angle), np.sin(angle)
    matrix = np.zeros((*angle.shape, 3, 3))
    i, j = (axis + 1) % 3, (axis + 2) % 3
    matrix[..., axis, axis] = 1.0
    matrix[..., i, i] = cos
    matrix[..., j, j] = cos
    matrix[..., i, j] = -sin
    matrix[..., j, i] = sin
    return matrix


def from_euler(angles: ArrayLike) -> Floats:
    """Rz * Ry * Rx of angles (..., 3)."""
    angles = np.asarray(angles, dtype=float)
    return about(2, angles[..., 2]) @ about(1, angles[..., 1]) @ about(0, angles[..., 0])


def to_euler(matrix: Floats) -> Floats:
    """The angles (..., 3) of Rz * Ry * Rx, the second within a quarter turn, as recording systems write them."""
    x = np.arctan2(matrix[..., 2, 1], matrix[..., 2, 2])
    y = np.arctan2(-matrix[..., 2, 0], np.hypot(matrix[..., 0, 0], matrix[..., 1, 0]))
    z = np.arctan2(matrix[..., 1, 0], matrix[..., 0, 0])
    return np.stack([x, y, z], axis=-1)


def transposed(matrix: Floats) -> Floats:
    """The inverse of each rotation."""
    return np.swapaxes(matrix, -1, -2)


def rotate(matrix: Floats, vector: ArrayLike) -> Floats:
    """Each vector turned by its matrix."""
    turned: Floats = np.einsum("...ij,...j->...i", matrix, np.asarray(vector, dtype=float))
    return turned


def normalised(vector: ArrayLike) -> Floats:
    """Vectors of length 1."""
    vector = np.asarray(vector, dtype=float)
    unit: Floats = vector / np.linalg.norm(vector, axis=-1, keepdims=True)
    return unit


def frame_of(x: Floats, y: Floats) -> Floats:
    """The rotation whose first two columns are the perpendicular unit vectors `x` and `y`."""
    return np.stack([x, y, np.cross(x, y)], axis=-1)
