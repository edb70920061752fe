"""Filling gaps and filtering: on the curves as they are now, hand edits and all."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Literal

import numpy as np

import motion_theater

from .. import rig
from ..curves import read
from ..logic.messages import NO_BONES_SELECTED, UserError, counted
from . import keys

if TYPE_CHECKING:
    from bpy.types import Object

FillKind = Literal["LINEAR", "CUBIC", "RIGID"]


def chosen(ob: Object, *, selected_only: bool) -> list[str]:
    """Return the markers that the user means."""
    if not selected_only:
        return [bone.name for bone in ob.data.bones]
    found = rig.selected_bones(ob)
    if not found:
        raise UserError(NO_BONES_SELECTED)
    return found


def current(ob: Object) -> tuple[list[str], keys.Recorded, motion_theater.Markers]:
    """Return the names of all markers of a set, and their trajectories as Blender and as the core have them."""
    bones = [bone.name for bone in ob.data.bones]
    recorded = keys.read_trajectories(ob, bones)
    if recorded is None:
        raise UserError(f"The markers of “{ob.name}” have no keys")
    return bones, recorded, motion_theater.Markers(bones, recorded.positions)


def fill_gaps(ob: Object, *, how: FillKind, longest: int, selected_only: bool) -> str:
    """Fill the gaps of the markers that the user means; return the message.

    All markers count as neighbors of a rigid cluster, whichever are chosen.
    """
    names = chosen(ob, selected_only=selected_only)
    bones, recorded, markers = current(ob)
    wanted = set(names)
    there = sum(bones[marker] in wanted for marker, _, _ in markers.gaps())
    if not there:
        return "There are no gaps between samples"
    filled, gaps = markers.filled(how=how, longest=longest, markers=names)
    _write(ob, recorded, bones, filled, {marker for marker, _, _ in gaps})
    samples = sum(end - start for _, start, end in gaps)
    left = there - len(gaps)
    rest = f"; {left} left: longer than {longest} samples" if left else ""
    if left and how == "RIGID":
        rest += ", or without three neighbors that keep their distance"
    return f"Filled {len(gaps)} of {there} gaps, {samples} samples{rest}"


def filter_markers(ob: Object, *, kind: motion_theater.FilterKind, depth: int, selected_only: bool) -> str:
    """Filter the markers that the user means; no window reaches over a gap. Return the message."""
    names = chosen(ob, selected_only=selected_only)
    bones, recorded, markers = current(ob)
    filtered = markers.filtered(kind=kind, depth=depth, markers=names)
    wanted = set(names)
    _write(ob, recorded, bones, filtered, {number for number, name in enumerate(bones) if name in wanted})
    count = counted(len(names), "marker")
    return f"Filtered {count}: {kind.lower()}, depth {depth}"


def _write(
    ob: Object, recorded: keys.Recorded, bones: Sequence[str], markers: motion_theater.Markers, changed: set[int]
) -> None:
    flags = np.zeros(len(bones), np.bool_)
    flags[list(changed)] = True
    keys.write_back(recorded, bones, markers.positions.astype(np.float64, copy=False), flags)
    curves = keys.curves_of(ob)
    for bone in (bones[number] for number in changed):
        if (read.path(bone, "scale"), 0) not in curves:  # what hid it is gone, but not what it was hidden by just now
            ob.pose.bones[bone].scale = (keys.SHOWN,) * 3
