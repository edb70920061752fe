"""Quaternions (w, x, y, z) as rows of arrays, and the way from a file's axes to Blender's."""

from __future__ import annotations

from typing import Literal

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]
UpAxis = Literal["X", "Y", "Z", "-X", "-Y", "-Z"]

AS_IN_FILE = "FILE"
_HALF = float(np.sqrt(0.5))
TO_BLENDER: dict[str, tuple[float, float, float, float]] = {
    "X": (_HALF, 0.0, -_HALF, 0.0),  # (x, y, z) -> (-z, y, x)
    "Y": (_HALF, _HALF, 0.0, 0.0),  # (x, y, z) -> (x, -z, y)
    "Z": (1.0, 0.0, 0.0, 0.0),
    "-X": (_HALF, 0.0, _HALF, 0.0),  # (x, y, z) -> (z, y, -x)
    "-Y": (_HALF, -_HALF, 0.0, 0.0),  # (x, y, z) -> (x, z, -y)
    "-Z": (0.0, 1.0, 0.0, 0.0),  # (x, y, z) -> (x, -y, -z)
}
"""The rotation that brings the named axis to Blender's Z. With Y up, a figure that faces +Z then faces the viewer."""


def nearest_axis(direction: tuple[float, float, float]) -> UpAxis:
    """Return the name of the axis that is nearest to a direction."""
    axes: tuple[UpAxis, ...] = ("X", "Y", "Z", "-X", "-Y", "-Z")
    return axes[int(np.argmax((*direction, *(-component for component in direction))))]


def to_blender(up: str, forward: str = AS_IN_FILE) -> Floats:
    """Return the rotation that brings the axis `up` of a file to Blender's Z.

    Where an axis is given that points forward, it comes to -Y, so that the figure looks at the viewer.
    """
    upright = np.array(TO_BLENDER[up])
    if forward == AS_IN_FILE or forward.removeprefix("-") == up.removeprefix("-"):
        return upright
    axis = np.eye(3)["XYZ".index(forward[-1])] * (-1.0 if forward.startswith("-") else 1.0)
    x, y, _ = rotate(upright, axis)
    half = 0.5 * (-0.5 * np.pi - float(np.arctan2(y, x)))
    return multiply(np.array((np.cos(half), 0.0, 0.0, np.sin(half))), upright)


def multiply(a: Floats, b: Floats) -> Floats:
    """Return the rotation by `b` followed by that of `a`, row by row."""
    aw, ax, ay, az = np.moveaxis(np.asarray(a, np.float64), -1, 0)
    bw, bx, by, bz = np.moveaxis(np.asarray(b, np.float64), -1, 0)
    return np.stack(
        (
            aw * bw - ax * bx - ay * by - az * bz,
            aw * bx + ax * bw + ay * bz - az * by,
            aw * by - ax * bz + ay * bw + az * bx,
            aw * bz + ax * by - ay * bx + az * bw,
        ),
        axis=-1,
    )


def inverse(q: Floats) -> Floats:
    """Return the opposite rotations of unit quaternions."""
    return np.asarray(q, np.float64) * (1.0, -1.0, -1.0, -1.0)


def rotate(q: Floats, v: Floats) -> Floats:
    """Return vectors turned by unit quaternions, row by row."""
    q, v = np.asarray(q, np.float64), np.asarray(v, np.float64)
    t = 2.0 * np.cross(q[..., 1:], v)
    turned: Floats = v + q[..., :1] * t + np.cross(q[..., 1:], t)
    return turned


def from_euler(angles: Floats, order: str) -> Floats:
    """Return the unit quaternions of (n, 3) Euler angles, indexed x, y, z, which turn in `order` about fixed axes."""
    turned = np.tile((1.0, 0.0, 0.0, 0.0), (len(angles), 1))
    for name in order:
        axis = "XYZ".index(name)
        turn = np.zeros_like(turned)
        turn[:, 0] = np.cos(0.5 * angles[:, axis])
        turn[:, 1 + axis] = np.sin(0.5 * angles[:, axis])
        turned = multiply(turn, turned)
    return turned


def from_matrices(matrices: Floats) -> Floats:
    """Return the unit quaternions of (n, 3, 3) rotation matrices.

    Each of the four components could be the divisor; the largest is taken. Matrices that Blender rounded to float32
    give the same quaternion as their nearest rotation, to rounding.
    """
    m = np.asarray(matrices, np.float64)
    xx, yy, zz = m[:, 0, 0], m[:, 1, 1], m[:, 2, 2]
    x, y, z = m[:, 2, 1] - m[:, 1, 2], m[:, 0, 2] - m[:, 2, 0], m[:, 1, 0] - m[:, 0, 1]
    xy, xz, yz = m[:, 0, 1] + m[:, 1, 0], m[:, 0, 2] + m[:, 2, 0], m[:, 1, 2] + m[:, 2, 1]
    candidates = np.stack(
        (
            np.stack((1 + xx + yy + zz, x, y, z), -1),
            np.stack((x, 1 + xx - yy - zz, xy, xz), -1),
            np.stack((y, xy, 1 - xx + yy - zz, yz), -1),
            np.stack((z, xz, yz, 1 - xx - yy + zz), -1),
        ),
        axis=1,
    )
    best = candidates[np.arange(len(m)), np.argmax(np.einsum("nii->ni", candidates), axis=1)]
    quaternions: Floats = best / np.linalg.norm(best, axis=1, keepdims=True)
    return quaternions
