"""The action that a stack is built into: what is in it now, whether it was edited by hand, and writing it."""

from __future__ import annotations

import json
from collections.abc import Iterable, Mapping, Sequence
from typing import TYPE_CHECKING

import bpy
import numpy as np

from .. import compat
from ..logic import record
from . import digest, read, write

if TYPE_CHECKING:
    from bpy.types import Action, FCurve, Object, PoseBone
    from numpy.typing import NDArray

    from ..properties import MotionStack

Coordinates = list["NDArray[np.float32]"]


class Result:
    """The result action of an armature, as it is before a rebuild."""

    def __init__(self, ob: Object) -> None:
        self._ob = ob
        animation = ob.animation_data
        self.assigned: Action | None = animation.action if animation is not None else None
        self.is_ours = _is_result(self.assigned) and self.assigned != ob.motion_theater.base_action
        self.digests = record.decode(self.assigned[record.KEY]) if self.is_ours and self.assigned else {}
        self._curves = read.index(compat.bag_of(ob, self.assigned))
        self._now: dict[str, Coordinates] = {}
        self._values_only: set[str] = set()  # bones whose keys are linear and stay on their frames

    def prefetch(self, bones: Iterable[str]) -> None:
        """Read the keys of these bones, and keep them for what follows."""
        for bone in bones:
            self._read(bone)

    def _read(self, bone: str) -> Coordinates:
        if bone not in self._now:
            self._now[bone] = [read.coordinates(curve) for curve in read.of_bone(self._curves, bone)]
        return self._now[bone]

    def edited(self, wanted: Mapping[str, Sequence[write.Wanted | None]], base: read.Index) -> list[str]:
        """Return those of the wanted bones whose curves are not as the last rebuild, or the base, left them."""
        if self.assigned is None:
            return []
        return [bone for bone, row in wanted.items() if self._is_edited(bone, row, base)]

    def _is_edited(self, bone: str, row: Sequence[write.Wanted | None], base: read.Index) -> bool:
        now = self._read(bone)
        recorded = self.digests.get(bone)
        if recorded is None:
            before = read.of_bone(base, bone)
            expected = [read.coordinates(curve) for curve in before]
            if not all(np.array_equal(a, b) for a, b in zip(now, expected, strict=True)):
                return True
            return digest.shape(read.of_bone(self._curves, bone)) != digest.shape(before)
        values, shape = digest.parts(recorded)
        if digest.values(now) != values:
            return True
        if self._gets_values_only(row, now, shape):
            self._values_only.add(bone)
            return False
        return digest.shape(read.of_bone(self._curves, bone)) != shape

    @staticmethod
    def _gets_values_only(row: Sequence[write.Wanted | None], now: Coordinates, shape: str) -> bool:
        """Return whether a rebuild touches nothing of a bone's keys but their values."""
        return not shape and all(
            not len(current) if wanted is None else wanted.is_plain and write.same_frames(wanted, current)
            for wanted, current in zip(row, now, strict=True)
        )

    def update(
        self, wanted: Mapping[str, Sequence[write.Wanted | None]], touched: set[str], motion: MotionStack
    ) -> list[str]:
        """Write what differs, into a result action that is this armature's own; return bones left out as locked."""
        action = self._own_action(motion)
        bag = compat.ensure_bag(self._ob, action)
        compat.assign(self._ob, action, compat.slot_name(self._ob))
        self._curves = read.index(bag)
        unkeyed = _decode_unkeyed(motion.unkeyed)
        digests, locked = {}, []
        for bone, row in wanted.items():
            curves = read.of_bone(self._curves, bone)
            if any(_is_locked(curve) for curve in curves):
                locked.append(bone)
                written = self.digests.get(bone)
            else:
                changes = _changes(curves, row)
                _note_unkeyed(self._ob.pose.bones[bone], changes, unkeyed)
                written = self._write_bone(bag, bone, curves, row)
                _restore_unkeyed(self._ob.pose.bones[bone], changes, unkeyed)
            if bone in touched and written is not None:
                digests[bone] = written
        motion.unkeyed = json.dumps(unkeyed) if unkeyed else ""
        action[record.KEY] = record.encode(digests)
        action.update_tag()
        return locked

    def _own_action(self, motion: MotionStack) -> Action:
        """Return the action to write: the one assigned if it is ours alone, else a copy of it or of the base."""
        ob = self._ob
        if self.is_ours and self.assigned is not None:
            if self.assigned.is_editable and not compat.used_by_others(ob, self.assigned):
                return self.assigned
            origin: Action | None = self.assigned
            slot = compat.slot_name(ob)
        else:
            origin, slot = motion.base_action, motion.base_slot
            if self.assigned is not None and self.assigned != origin and self.assigned.is_editable:
                self.assigned.use_fake_user = True  # the animator's own action must not vanish with its last user
            self._now.clear()  # what was read is of an action that stays as it is
            self.digests = {}
        name = f"{ob.name} Motion"
        if origin is not None:
            action = origin.copy()
            action.name = name
        else:
            action = bpy.data.actions.new(name)
        compat.assign(ob, action, slot)
        return action

    def _write_bone(
        self, bag: compat.Bag, bone: str, curves: Sequence[FCurve | None], row: Sequence[write.Wanted | None]
    ) -> str:
        """Write the curves of a bone that differ; return the hash of what it has then."""
        before = self._now.get(bone) or [read.coordinates(curve) for curve in curves]
        values_only = bone in self._values_only
        after: Coordinates = []
        for slot, curve, wanted, current in zip(read.slots(bone), curves, row, before, strict=True):
            if wanted is None:
                if curve is not None:
                    write.remove_curve(bag, self._curves, slot)
                after.append(current[:0])
                continue
            after.append(wanted.coordinates)
            if curve and (values_only or write.is_same_but_values(curve, wanted, current)):
                if not np.array_equal(wanted.coordinates, current):
                    write.write_values(curve, wanted)
                continue
            curve = curve or write.new_curve(bag, self._curves, bone, slot)
            write.write_keys(curve, wanted)
            if 2 * len(curve.keyframe_points) != len(wanted.coordinates):
                after[-1] = read.coordinates(curve)  # keys nearer than Blender tells apart were merged
        all_plain = all(wanted is None or wanted.is_plain for wanted in row)
        return digest.joined(digest.values(after), "" if all_plain else digest.shape(read.of_bone(self._curves, bone)))

    def detach(self, motion: MotionStack) -> None:
        """Leave the armature with the base after the last entry went.

        Bones that no entry touched may have been animated in the result meanwhile; then it stays as the armature's own
        action.
        """
        ob = self._ob
        animation = ob.animation_data
        action = animation.action if animation is not None else None
        if _is_result(action) and action is not None and action != motion.base_action:
            now = read.index(compat.bag_of(ob, action))
            before = read.index(compat.bag_of(ob, motion.base_action, slot_name=motion.base_slot))
            if read.same(now, before):
                compat.assign(ob, motion.base_action, motion.base_slot)
                if not action.users and action.is_editable:
                    bpy.data.actions.remove(action)
                if motion.base_action is None and not animation.drivers and not animation.nla_tracks:
                    ob.animation_data_clear()
            else:
                del action[record.KEY]
        motion.base_action = None
        motion.base_slot = ""


Unkeyed = dict[str, dict[str, list[float]]]
"""By bone and channel the values that a channel had before it got its first curve."""


def _changes(curves: Sequence[FCurve | None], row: Sequence[write.Wanted | None]) -> list[tuple[str, bool, bool]]:
    """Return for each channel of a bone whether it has a curve now, and whether it is to have one."""
    changes, position = [], 0
    for channel, components in read.CHANNELS.items():
        there = slice(position, position + components)
        has_curve = any(curve is not None for curve in curves[there])
        changes.append((channel, has_curve, any(wanted is not None for wanted in row[there])))
        position += components
    return changes


def _note_unkeyed(bone: PoseBone, changes: Iterable[tuple[str, bool, bool]], unkeyed: Unkeyed) -> None:
    """Remember the values of channels that get their first curve."""
    for channel, has_curve, gets_curve in changes:
        if gets_curve and not has_curve:
            unkeyed.setdefault(bone.name, {}).setdefault(channel, list(getattr(bone, channel)))


def _restore_unkeyed(bone: PoseBone, changes: Iterable[tuple[str, bool, bool]], unkeyed: Unkeyed) -> None:
    """Put the values of channels back that have no curve any more."""
    of_bone = unkeyed.get(bone.name, {})
    for channel, _, gets_curve in changes:
        if not gets_curve and channel in of_bone:
            setattr(bone, channel, of_bone.pop(channel))
            if not of_bone:
                del unkeyed[bone.name]


def _is_result(action: Action | None) -> bool:
    return action is not None and action.get(record.KEY) is not None


def _is_locked(curve: FCurve | None) -> bool:
    return curve is not None and (curve.lock or (curve.group is not None and curve.group.lock))


def _decode_unkeyed(text: str) -> Unkeyed:
    decoded = json.loads(text) if text else {}
    return decoded if isinstance(decoded, dict) else {}
