"""Trajectories <-> F-curves.

A marker has location keys on the samples on which it was seen, and none in its gaps, so that gaps show in the Dope
Sheet. Scale curves, kept constant between keys and written only for markers with gaps, are zero while a marker is
dropped out: it is then drawn nowhere, nor is what was attached to it. (The `hide` of a bone could be animated only in
another data-block before 5.0, and does not hide what is attached.)
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from .. import compat
from ..curves import read, write
from ..logic import trajectories
from ..logic.keys import NEAREST
from . import properties

if TYPE_CHECKING:
    from bpy.types import Object
    from numpy.typing import NDArray

    from ..compat import Bag
    from ..logic.trajectories import Flags, Floats

CONSTANT = 0  # Blender's number of that interpolation
SHOWN, DROPPED_OUT = 1.0, 0.0


def write_trajectory(
    bag: Bag,
    curves: read.Index,
    bone: str,
    frames: NDArray[np.float64],
    axis: Callable[[int], Floats],
    seen: Flags,
) -> None:
    """Write the keys of one marker; `axis` returns its location along X, Y or Z on all frames."""
    is_whole = bool(seen.all())
    on = frames if is_whole else frames[seen]
    if len(on):
        keys = np.empty(2 * len(on), np.float32)
        keys[0::2] = on
        for component in range(3):
            values = axis(component)
            keys[1::2] = values if is_whole else values[seen]
            slot = (read.path(bone, "location"), component)
            curve = curves.get(slot) or write.new_curve(bag, curves, bone, slot)
            write.write_keys(curve, write.Wanted(keys))
    _write_dropouts(bag, curves, bone, frames, seen)


def _write_dropouts(bag: Bag, curves: read.Index, bone: str, frames: NDArray[np.float64], seen: Flags) -> None:
    """Let a marker be shown only while it is seen."""
    slots = [(read.path(bone, "scale"), component) for component in range(3)]
    if seen.all():
        for slot in slots:
            if slot in curves:
                write.remove_curve(bag, curves, slot)
        return
    at = np.unique([0, *trajectories.changes(seen), len(seen) - 1])  # the last tells how long the recording is
    keys = np.empty(2 * len(at), np.float32)
    keys[0::2], keys[1::2] = frames[at], np.where(seen[at], SHOWN, DROPPED_OUT)
    for slot in slots:
        points = (curves.get(slot) or write.new_curve(bag, curves, bone, slot)).keyframe_points
        points.clear()
        points.add(len(at))
        points.foreach_set("co", keys)
        points.foreach_set("interpolation", np.full(len(at), CONSTANT, np.int32))
        curves[slot].update()


@dataclass(frozen=True)
class Recorded:
    """The trajectories of some bones, as their curves hold them now."""

    bag: Bag
    curves: read.Index
    frames: NDArray[np.float64]
    """(keys,) every frame on which one of them has a key, or would have if it were seen."""
    positions: NDArray[np.float64]
    """(bones, keys, 3) in armature space, NaN while dropped out."""
    places: NDArray[np.float64]
    """(bones, 3) the rest pose."""


def read_trajectories(ob: Object, bones: Sequence[str]) -> Recorded | None:
    """Return the trajectories of some bones; None where none of them has keys."""
    animation = ob.animation_data
    bag = compat.bag_of(ob, animation.action) if animation is not None else None
    curves = read.index(bag)
    rows = {slot: read.coordinates(curves.get(slot)) for bone in bones for slot in slots(bone)}
    frames = _all_frames(rows.values(), properties.of(ob).key_step)
    if bag is None or not len(frames):
        return None
    places = np.array([ob.data.bones[bone].head_local for bone in bones], np.float64)
    positions = np.empty((len(bones), len(frames), 3))
    for number, bone in enumerate(bones):
        positions[number] = _values(curves, rows, bone, frames) + places[number]
        positions[number, ~_seen(curves, bone, frames)] = np.nan
    return Recorded(bag, curves, frames, positions, places)


def sample_trajectories(ob: Object, bones: Sequence[str], frames: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return (bones, frames, 3): where markers are at any scene frames, in armature space, NaN while dropped out.

    Between two samples a marker is seen only if it was seen on both, and only its F-curves decide where it is.
    """
    curves = curves_of(ob)
    rows = {slot: read.coordinates(curves.get(slot)) for bone in bones for slot in slots(bone)}
    dropouts = [read.coordinates(curves.get((read.path(bone, "scale"), 0))) for bone in bones]
    samples = _all_frames([*rows.values(), *dropouts], properties.of(ob).key_step)
    at = trajectories.snapped(frames, samples)
    before, after = trajectories.around(at, samples)
    positions = np.empty((len(bones), len(frames), 3))
    for number, bone in enumerate(bones):
        still = np.array(ob.pose.bones[bone].location) * [slot not in curves for slot in slots(bone)]
        positions[number] = _values(curves, rows, bone, at) + still + np.array(ob.data.bones[bone].head_local)
        positions[number, ~(_seen(curves, bone, before) & _seen(curves, bone, after))] = np.nan
    return positions


def curves_of(ob: Object) -> read.Index:
    """Return the F-curves that animate an object."""
    animation = ob.animation_data
    return read.index(compat.bag_of(ob, animation.action) if animation is not None else None)


def slots(bone: str) -> list[tuple[str, int]]:
    """Return path and index of the three F-curves that hold the location of a marker."""
    return [(read.path(bone, "location"), component) for component in range(3)]


def _all_frames(rows: Iterable[NDArray[np.float32]], step: float) -> NDArray[np.float64]:
    """Return all frames with keys, and those that are missing among them because no marker was seen there.

    Most curves have the same frames, which are looked at once.
    """
    different: dict[bytes, NDArray[np.float32]] = {}
    for row in rows:
        different.setdefault(row[0::2].tobytes(), row[0::2])
    keyed = np.unique(np.concatenate([*different.values(), np.empty(0, np.float32)])).astype(np.float64)
    return trajectories.without_holes(keyed, step)


def _values(
    curves: read.Index, rows: Mapping[tuple[str, int], NDArray[np.float32]], bone: str, frames: NDArray[np.float64]
) -> Floats:
    """Return (frames, 3) values of a bone's curves: those of its keys, and between them what Blender itself evaluates.

    Where there is no curve they are 0.
    """
    values = np.zeros((len(frames), 3))
    for component, slot in enumerate(slots(bone)):
        curve, row = curves.get(slot), rows[slot]
        if curve is None or not len(row):
            continue
        at = row[0::2].astype(np.float64)
        column = np.interp(frames, at, row[1::2])
        if bool((read.field(curve, "interpolation") != write.LINEAR).any()):
            for number in np.flatnonzero(~np.isin(frames, at)):
                column[number] = curve.evaluate(float(frames[number]))
        values[:, component] = column
    return values


def _seen(curves: read.Index, bone: str, frames: NDArray[np.float64]) -> Flags:
    """Return on which frames a marker is shown, as its scale says."""
    row = read.coordinates(curves.get((read.path(bone, "scale"), 0)))
    if not len(row):
        return np.ones(len(frames), np.bool_)
    key = np.searchsorted(row[0::2].astype(np.float64), frames + NEAREST / 2, "right") - 1
    shown: Flags = row[1::2][np.maximum(key, 0)] != DROPPED_OUT
    return shown


def write_back(recorded: Recorded, bones: Sequence[str], positions: NDArray[np.float64], changed: Flags) -> None:
    """Write the trajectories that changed."""
    for number in np.flatnonzero(changed).tolist():
        location = positions[number] - recorded.places[number]
        seen = ~np.isnan(location[:, 0])
        axes = location.T
        write_trajectory(recorded.bag, recorded.curves, bones[number], recorded.frames, axes.__getitem__, seen)
