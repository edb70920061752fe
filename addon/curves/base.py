"""What bones had before the first entry, as the native module takes it."""

from __future__ import annotations

from collections import OrderedDict
from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

import motion_theater

from ..logic.keys import LINEAR, frames
from . import digest, read

if TYPE_CHECKING:
    from bpy.types import FCurve
    from numpy.typing import NDArray

WIDEST_GAP = 1.0 + 1e-3  # frames between keys that count as dense
_REST = {"location": (0.0, 0.0, 0.0), "rotation_quaternion": (1.0, 0.0, 0.0, 0.0), "rotation_euler": (0.0, 0.0, 0.0)}
_CACHED_CHANNELS = 512

Samples = tuple["NDArray[np.float64]", "NDArray[np.float64]", "NDArray[np.bool_]"]
"""Frames, values (frames, components), and where a key stands."""

_sampled: OrderedDict[str, Samples] = OrderedDict()


def channels_of(mode: str) -> tuple[str, str]:
    """Return the channels that count for a bone in a rotation mode; other rotation curves have no effect."""
    return "location", "rotation_quaternion" if mode == "QUATERNION" else "rotation_euler"


def base_channel(curves: read.Index, number: int, bone: str, channel: str) -> motion_theater.BaseChannel | None:
    """Return the motion of one channel of a bone, or None where it has no keys.

    Dense linear keys are taken as they are. Anything else is sampled on its keys and on all whole frames between, as
    Blender itself evaluates it, so that what the animator sees is what is blended.
    """
    data_path = read.path(bone, channel)
    found = [curves.get((data_path, component)) for component in range(read.CHANNELS[channel])]
    with_keys = [curve for curve in found if curve is not None and len(curve.keyframe_points)]
    if not with_keys:
        return None
    dense = _dense(found)
    if dense is not None:
        return motion_theater.BaseChannel(number, channel, *dense)
    return motion_theater.BaseChannel(number, channel, *_cached_samples(found, _REST[channel]))


def _dense(curves: Sequence[FCurve | None]) -> tuple[NDArray[np.float64], NDArray[np.float64]] | None:
    """Return frames and values (frames, components) if all curves have the same, dense, linear keys."""
    if any(curve is None or curve.mute or len(curve.modifiers) for curve in curves):
        return None
    rows = [read.coordinates(curve) for curve in curves]
    at = frames(rows[0])
    if any(len(row) != len(rows[0]) or not np.array_equal(frames(row), at) for row in rows[1:]):
        return None
    if len(at) > 1 and float(np.diff(at).max()) > WIDEST_GAP:
        return None
    if any((read.field(curve, "interpolation") != LINEAR).any() for curve in curves if curve is not None):
        return None
    return at.astype(np.float64), np.ascontiguousarray(np.stack([row[1::2] for row in rows], 1), np.float64)


def _cached_samples(curves: Sequence[FCurve | None], rest: Sequence[float]) -> Samples:
    """Return `_samples`, kept for the next rebuild as long as the keys are the same."""
    if any(curve is not None and len(curve.modifiers) for curve in curves):
        return _samples(curves, rest)  # what a modifier does is not in the keys
    muted = "".join("m" if curve is not None and curve.mute else "." for curve in curves)
    key = digest.joined(digest.values([read.coordinates(curve) for curve in curves]), digest.shape(curves)) + muted
    if key not in _sampled:
        _sampled[key] = _samples(curves, rest)
        if len(_sampled) > _CACHED_CHANNELS:
            _sampled.popitem(last=False)
    _sampled.move_to_end(key)
    return _sampled[key]


def _samples(curves: Sequence[FCurve | None], rest: Sequence[float]) -> Samples:
    keyed = np.concatenate([frames(read.coordinates(curve)) for curve in curves]).astype(np.float64)
    first, last = float(keyed.min()), float(keyed.max())
    at = np.unique(np.concatenate((keyed, np.arange(np.ceil(first), np.floor(last) + 1.0))))
    values = np.empty((len(at), len(curves)))
    for component, curve in enumerate(curves):
        if curve is None or curve.mute or curve.is_empty:
            values[:, component] = rest[component]
        else:
            values[:, component] = [curve.evaluate(frame) for frame in at.tolist()]
    return at, values, np.isin(at, keyed)
