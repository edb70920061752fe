"""Writing keys: whole arrays, and only where something changes.

Keys whose frames stay need only their values written; Blender keeps everything else of a key. Handles are recomputed
by Blender afterwards, so that a curve can be edited at once.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from ..logic import keys as key_arrays
from ..logic.keys import LINEAR
from . import read

if TYPE_CHECKING:
    import bpy
    from bpy.types import FCurve
    from numpy.typing import NDArray

    from ..compat import Bag
    from ..logic.keys import Keys


HANDLES = ("handle_left", "handle_right")


@dataclass(frozen=True)
class Wanted:
    """What one F-curve is to be."""

    coordinates: NDArray[np.float32]
    """Frame and value by turns."""
    keys: Keys | None = None
    """All fields, where some are to be kept bit for bit; None for linear keys with handles that Blender computes."""
    kept_before: float = -np.inf
    kept_after: float = np.inf
    """Keys before and after these frames keep their very handles."""

    @property
    def is_plain(self) -> bool:
        """Whether all keys are linear and nothing else is to be kept."""
        return self.keys is None


def same_frames(wanted: Wanted, current: NDArray[np.float32]) -> bool:
    """Return whether a curve has its keys on the wanted frames already."""
    return len(wanted.coordinates) == len(current) and np.array_equal(
        key_arrays.frames(wanted.coordinates), key_arrays.frames(current)
    )


def new_curve(bag: Bag, curves: read.Index, bone: str, slot: tuple[str, int]) -> FCurve:
    """Return a new F-curve in the group of its bone.

    Its automatic handles depend on the neighboring keys alone ("None" smoothing): an edit in one place then never moves
    handles elsewhere, and dense keys need no more.
    """
    curve = bag.fcurves.new(slot[0], index=slot[1])
    curve.group = bag.groups.get(bone) or bag.groups.new(bone)
    curve.auto_smoothing = "NONE"
    curves[slot] = curve
    return curve


def is_same_but_values(curve: FCurve, wanted: Wanted, current: NDArray[np.float32]) -> bool:
    """Return whether a curve differs from what is wanted in the values of its keys at most."""
    if not same_frames(wanted, current):
        return False
    keys = key_arrays.made(wanted.coordinates, None) if wanted.keys is None else wanted.keys
    kept = _kept(keys, wanted)
    for name, values in keys.items():
        if name in HANDLES:
            if kept.any() and not np.array_equal(read.field(curve, name)[kept], values[kept]):
                return False
        elif name != "co" and not np.array_equal(read.field(curve, name), values):
            return False
    return True


def write_values(curve: FCurve, wanted: Wanted) -> None:
    """Write the values of keys whose frames stay."""
    points = curve.keyframe_points
    points.foreach_set("co", wanted.coordinates)
    points.handles_recalc()
    _restore_handles(curve, wanted)


def write_keys(curve: FCurve, wanted: Wanted) -> None:
    """Make all keys of a curve anew."""
    points = curve.keyframe_points
    points.clear()
    points.add(len(wanted.coordinates) // 2)
    if wanted.keys is None:
        points.foreach_set("co", wanted.coordinates)
        # The type that Blender stores it as: ten times as fast as any other.
        points.foreach_set("interpolation", np.full(len(points), LINEAR, np.uint8))
        if key_arrays.are_apart(wanted.coordinates):
            # All that is left for `update` to do, at a third of its time.
            points.handles_recalc()
            curve.id_data.update_tag()
            return
    else:
        for name, values in wanted.keys.items():
            points.foreach_set(name, values)
    curve.update()
    _restore_handles(curve, wanted)


def _restore_handles(curve: FCurve, wanted: Wanted) -> None:
    """Give kept keys the handles back that Blender recomputed because they have a new neighbor."""
    if wanted.keys is None or len(curve.keyframe_points) != key_arrays.count(wanted.keys):
        return  # nothing is kept; or keys nearer than Blender tells apart were merged
    kept = _kept(wanted.keys, wanted)
    for name in HANDLES:
        now, then = read.field(curve, name), wanted.keys[name]
        if not np.array_equal(now[kept], then[kept]):
            curve.keyframe_points.foreach_set(name, np.where(kept, then, now))


def _kept(keys: Keys, wanted: Wanted) -> NDArray[np.bool_]:
    """Return which numbers of the handles belong to keys that are kept bit for bit."""
    before, after = key_arrays.outside(keys, wanted.kept_before, wanted.kept_after)
    return np.repeat(before | after, 2)


def remove_curve(bag: Bag, curves: read.Index, slot: tuple[str, int]) -> None:
    """Remove an F-curve, and the group of its bone if that was its last one, as some versions of Blender do."""
    curve = curves.pop(slot)
    group_name = curve.group.name if curve.group is not None else ""
    bag.fcurves.remove(curve)
    group: bpy.types.ActionGroup | None = bag.groups.get(group_name)
    if group is not None and not len(group.channels):
        bag.groups.remove(group)
