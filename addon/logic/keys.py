"""The keys of F-curves as arrays, and how those of two curves are put together."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

Array = NDArray[Any]
"""Of float32 or int32, as `FIELDS` says."""

Keys = dict[str, Array]
"""All keys of one curve: an array for each field, flat as `foreach_set` takes it."""

FIELDS: Mapping[str, tuple[type[np.float32] | type[np.int32], int]] = {
    "co": (np.float32, 2),
    "handle_left": (np.float32, 2),
    "handle_right": (np.float32, 2),
    "interpolation": (np.int32, 1),
    "handle_left_type": (np.int32, 1),
    "handle_right_type": (np.int32, 1),
    "easing": (np.int32, 1),
    "type": (np.int32, 1),
    "back": (np.float32, 1),
    "amplitude": (np.float32, 1),
    "period": (np.float32, 1),
}
"""Type and width of every field of a keyframe."""

LINEAR, BEZIER = 1, 2  # Blender's numbers of interpolations, which are not in the order of its menu
AUTO_CLAMPED = 4  # Blender's number of that handle type
NEAREST = 0.01  # keys nearer to each other than this many frames are one key to Blender
_DEFAULTS = {"back": 1.70158}


def count(keys: Keys) -> int:
    """Return how many keys there are."""
    return len(keys["interpolation"])


def frames(coordinates: Array) -> Array:
    """Return the frames of keys given as frame and value by turns."""
    return coordinates[0::2]


def are_apart(coordinates: NDArray[np.float32]) -> bool:
    """Return whether keys are in order, and so far from each other that Blender tells them apart."""
    return bool((np.diff(frames(coordinates)) > 2 * NEAREST).all())


def made(coordinates: NDArray[np.float32], interpolation: NDArray[np.int32] | None) -> Keys:
    """Return new keys at coordinates, with handles that Blender will compute; linear where nothing else is said."""
    number = len(coordinates) // 2
    keys: Keys = {name: np.full(number * width, _DEFAULTS.get(name, 0), kind) for name, (kind, width) in FIELDS.items()}
    for name in ("co", "handle_left", "handle_right"):
        keys[name] = coordinates.copy()
    keys["interpolation"] = (
        np.full(number, LINEAR, np.int32) if interpolation is None else interpolation.astype(np.int32)
    )
    for name in ("handle_left_type", "handle_right_type"):
        keys[name] = np.full(number, AUTO_CLAMPED, np.int32)
    return keys


def outside(keys: Keys, start: float, end: float) -> tuple[NDArray[np.bool_], NDArray[np.bool_]]:
    """Return which keys lie before a range, and which after it."""
    at = frames(keys["co"])
    return at < start - NEAREST / 2, at > end + NEAREST / 2


def spliced(old: Keys, new: Keys, start: float, end: float) -> Keys:
    """Return the keys of `old` outside a range, bit for bit, and those of `new` in between."""
    before, after = outside(old, start, end)
    if not before.any() and not after.any():
        return new
    return {
        name: np.concatenate((old[name][np.repeat(before, width)], new[name], old[name][np.repeat(after, width)]))
        for name, (_, width) in FIELDS.items()
    }
