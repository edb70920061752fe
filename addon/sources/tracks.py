"""The motion of a track in the armature's rest axes: bones matched, unit and up axis accounted for."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING

import motion_theater

from .. import rig
from ..logic import axes, names
from ..logic.messages import UserError, misfit
from .cache import Cache
from .files import Loaded, as_skeleton, bind, has_own_skeleton, skeleton_from_text, text_of
from .packing import load

if TYPE_CHECKING:
    from bpy.types import Object

    from ..properties import MotionEntry, MotionStack

_motions: Cache[motion_theater.Motion] = Cache(64)


def skeleton_of(ob: Object, entry: MotionEntry, loaded: Loaded) -> tuple[motion_theater.Skeleton, str]:
    """Return the skeleton with which a track's file is understood, and its text."""
    if has_own_skeleton(loaded):
        return as_skeleton(loaded), text_of(loaded)
    text = entry.skeleton_text or ob.motion_theater.skeleton_text
    if not text:
        raise UserError(f"The skeleton file of “{entry.name}” is not known: add the track anew")
    return skeleton_from_text(text), text


def matched_bones(
    motion: MotionStack, skeleton: motion_theater.Skeleton, bones: tuple[str, ...] | list[str]
) -> dict[str, str]:
    """Return for each bone of a skeleton file the armature's bone that it means, as far as there is one."""
    return names.match(skeleton.names, bones, names.decode_pairs(motion.bone_names))


def missing_bones(loaded: Loaded, matched: Mapping[str, str]) -> list[str]:
    """Return the bones that have motion in a file and are not among the matched ones."""
    return [name for name in loaded.clip.names if name not in matched]


def rest_motion(ob: Object, entry: MotionEntry, rest: rig.Rest) -> tuple[motion_theater.Motion, Loaded]:
    """Return the motion of a track as channels of the armature's bones, and the clip that it comes from."""
    loaded = load(ob, entry)
    skeleton, text = skeleton_of(ob, entry, loaded)
    motion = ob.motion_theater
    matched = matched_bones(motion, skeleton, rest.names)
    missing = missing_bones(loaded, matched)
    if missing:
        raise UserError(misfit(loaded.clip.path, missing, ob.name))
    scale = file_scale(motion, text, rest, skeleton, matched)
    up = file_up(motion, text, skeleton)
    key = (loaded.key, text, rest.key, up, motion.forward, scale, tuple(matched.items()))
    known = _motions.get(key)
    if known is None:
        file_name = {bone: name for name, bone in matched.items()}
        known = bind(loaded, text).in_rest_axes(
            [file_name.get(bone) for bone in rest.names],
            rig.axes_from_file(rest, axes.to_blender(up, motion.forward)),
            scale,
            orders=[None if mode in {"QUATERNION", "AXIS_ANGLE"} else mode for mode in rest.modes],
        )
        _motions.keep(key, known)
    return known, loaded


def file_scale(
    motion: MotionStack,
    skeleton_text: str,
    rest: rig.Rest,
    skeleton: motion_theater.Skeleton,
    matched: Mapping[str, str],
) -> float:
    """Return scene units per unit of a track's file, whose skeleton is that text.

    An armature that was imported keeps its own scale; a track with a skeleton of its own is scaled by the ratio of the
    two units, and on an armature of other origin sizes are compared.
    """
    if motion.unit_m <= 0.0:
        return rig.scale_from_rest(rest, skeleton, matched)
    if motion.skeleton_text and skeleton_text != motion.skeleton_text:
        return motion.unit_m * skeleton.unit_m / skeleton_from_text(motion.skeleton_text).unit_m
    return motion.unit_m


def file_up(motion: MotionStack, skeleton_text: str, skeleton: motion_theater.Skeleton) -> str:
    """Return the axis of a track's file that points up.

    The armature's own file is understood as it was when it was imported; so is another that stands like it.
    """
    if skeleton_text == motion.skeleton_text:
        return motion.up
    own = axes.nearest_axis(skeleton.up)
    stands_alike = motion.skeleton_text and own == axes.nearest_axis(skeleton_from_text(motion.skeleton_text).up)
    return motion.up if stands_alike else own
