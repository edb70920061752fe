"""Short hashes of a bone's curves, by which hand edits are noticed.

A hash has two parts. *Values* covers frame and value of every key and is compared at each rebuild. *Shape* covers
interpolation, and the handles of curves that are not linear throughout; it is compared where keys would be made anew,
since values alone can be written without touching it. A bone with nothing but linear keys has no shape part.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

import motion_theater

from ..logic.keys import LINEAR
from . import read

if TYPE_CHECKING:
    from bpy.types import FCurve
    from numpy.typing import NDArray


def values(coordinates: Sequence[NDArray[np.float32]]) -> str:
    """Return the hash of what `read.coordinates` gave for all curves of a bone, in their fixed order."""
    lengths = np.array([len(array) for array in coordinates], np.float32)
    return motion_theater.digest([lengths, *coordinates])


def shape(curves: Sequence[FCurve | None]) -> str:
    """Return the hash of interpolation and handles of all curves of a bone; empty where all keys are linear."""
    arrays: list[NDArray[np.float32]] = []
    is_linear = True
    for curve in curves:
        if curve is None or not len(curve.keyframe_points):
            arrays.append(np.empty(0, np.float32))
            continue
        interpolation = read.field(curve, "interpolation")
        arrays.append(interpolation.view(np.float32))
        if not (interpolation == LINEAR).all():
            is_linear = False
            arrays += [read.field(curve, "handle_left"), read.field(curve, "handle_right")]
    return "" if is_linear else motion_theater.digest(arrays)


def joined(values_part: str, shape_part: str) -> str:
    """Return the hash of a bone from its two parts."""
    return f"{values_part}.{shape_part}"


def parts(digest: str) -> tuple[str, str]:
    """Return the two parts of a hash."""
    values_part, _, shape_part = digest.partition(".")
    return values_part, shape_part
