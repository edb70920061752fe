"""F-curves of bones, and their keys as arrays."""

from __future__ import annotations

from functools import lru_cache
from typing import TYPE_CHECKING

import bpy
import numpy as np

from ..logic.keys import FIELDS
from . import memory

if TYPE_CHECKING:
    from bpy.types import FCurve
    from numpy.typing import NDArray

    from ..compat import Bag
    from ..logic.keys import Array, Keys

CHANNELS = {"location": 3, "rotation_quaternion": 4, "rotation_euler": 3}
"""The channels of a bone that a stack may write, and how many F-curves each has."""

Index = dict[tuple[str, int], "FCurve"]
"""F-curves by data path and array index: looking them up one by one in Blender is slow."""


def index(bag: Bag | None) -> Index:
    """Return all F-curves of a bag by path. Valid only until one is removed, or to the next undo."""
    return {} if bag is None else {(curve.data_path, curve.array_index): curve for curve in bag.fcurves}


@lru_cache(maxsize=4096)
def path(bone: str, channel: str) -> str:
    """Return the data path of a channel of a bone."""
    return f'pose.bones["{bpy.utils.escape_identifier(bone)}"].{channel}'


def slots(bone: str) -> list[tuple[str, int]]:
    """Return path and index of all F-curves of a bone that a stack may write, in a fixed order."""
    return [
        (data_path, component)
        for channel, components in CHANNELS.items()
        for data_path in (path(bone, channel),)
        for component in range(components)
    ]


def of_bone(curves: Index, bone: str) -> list[FCurve | None]:
    """Return the F-curves of a bone in the order of `slots`; None where there is none."""
    return [curves.get(slot) for slot in slots(bone)]


def coordinates(curve: FCurve | None) -> NDArray[np.float32]:
    """Return frame and value of all keys by turns; nothing where there is no curve."""
    if curve is None:
        return np.empty(0, np.float32)
    seen = memory.coordinates(curve.keyframe_points)
    return field(curve, "co") if seen is None else seen


def field(curve: FCurve, name: str) -> Array:
    """Return one field of all keys."""
    kind, width = FIELDS[name]
    values: Array = np.empty(width * len(curve.keyframe_points), kind)
    curve.keyframe_points.foreach_get(name, values)
    return values


def keys(curve: FCurve) -> Keys:
    """Return all fields of all keys."""
    return {name: field(curve, name) for name in FIELDS}


def same(some: Index, others: Index) -> bool:
    """Return whether two sets of F-curves hold the same keys."""
    if some.keys() != others.keys():
        return False
    return all(
        np.array_equal(values, other)
        for key, curve in some.items()
        for values, other in zip(keys(curve).values(), keys(others[key]).values(), strict=True)
    )
