"""The action that a stack is built into: what is in it now, whether it was edited by hand, and writing it."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING

import bpy
import numpy as np

from .. import compat
from ..logic import record
from . import digest, read, write

if TYPE_CHECKING:
    from bpy.types import Action, FCurve, Object
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

    def _read(self, bone: str) -> Coordinates:
        """Return the coordinates of all curves of a bone, read once."""
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
            before = list(read.of_bone(base, bone))
            expected = [read.coordinates(curve) for curve in before]
            if not all(np.array_equal(a, b) for a, b in zip(now, expected)):
                return True
            return digest.shape(list(read.of_bone(self._curves, bone))) != digest.shape(before)
        values, shape = digest.parts(recorded)
        if digest.values(now) != values:
            return True
        if self._writes_values_only(row, now, shape):
            return False
        return digest.shape(list(read.of_bone(self._curves, bone))) != shape

    @staticmethod
    def _writes_values_only(row: Sequence[write.Wanted | None], now: Coordinates, shape: str) -> bool:
        """Return whether a rebuild touches nothing of a bone's keys but their values."""
        return not shape and all(
            not len(current) if wanted is None else wanted.is_plain and write.same_frames(wanted, current)
            for wanted, current in zip(row, now)
        )

    def write(
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
            curves = list(read.of_bone(self._curves, bone))
            if any(_is_locked(curve) for curve in curves):
                locked.append(bone)
                written = self.digests.get(bone)
            else:
                self._note_unkeyed(bone, row, unkeyed)
                written = self._write_bone(bag, bone, row)
                self._restore_unkeyed(bone, row, unkeyed)
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
            if not compat.used_by_others(ob, self.assigned):
                return self.assigned
            origin: Action | None = self.assigned
            slot = compat.slot_name(ob)
        else:
            origin, slot = motion.base_action, motion.base_slot
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

    def _write_bone(self, bag: compat.Bag, bone: str, row: Sequence[write.Wanted | None]) -> str:
        """Write the curves of a bone that differ; return the hash of what it has then."""
        before = self._now.get(bone) or [read.coordinates(curve) for curve in read.of_bone(self._curves, bone)]
        plain = not digest.parts(self.digests.get(bone, "."))[1] and bone in self.digests
        after: Coordinates = []
        position = 0
        for channel, components in read.CHANNELS.items():
            for component in range(components):
                wanted, current = row[position], before[position]
                position += 1
                if wanted is None:
                    write.remove_curve(bag, self._curves, bone, channel, component)
                    after.append(current[:0])
                    continue
                after.append(wanted.coordinates)
                curve = write.ensure_curve(bag, self._curves, bone, channel, component)
                if not (plain and wanted.is_plain and write.same_frames(wanted, current)):
                    write.write_keys(curve, wanted)
                    if 2 * len(curve.keyframe_points) != len(wanted.coordinates):
                        after[-1] = read.coordinates(curve)  # keys nearer than Blender tells apart were merged
                elif not np.array_equal(wanted.coordinates, current):
                    write.write_values(curve, wanted.coordinates)
        is_plain = all(wanted is None or wanted.is_plain for wanted in row)
        shape = "" if is_plain else digest.shape(list(read.of_bone(self._curves, bone)))
        return digest.joined(digest.values(after), shape)

    def _note_unkeyed(
        self, bone: str, row: Sequence[write.Wanted | None], unkeyed: dict[str, dict[str, list[float]]]
    ) -> None:
        """Remember the values of channels that get their first curve."""
        pose_bone = self._ob.pose.bones[bone]
        for channel, has_curve, gets_curve in self._changes(bone, row):
            if gets_curve and not has_curve:
                unkeyed.setdefault(bone, {}).setdefault(channel, list(getattr(pose_bone, channel)))

    def _restore_unkeyed(
        self, bone: str, row: Sequence[write.Wanted | None], unkeyed: dict[str, dict[str, list[float]]]
    ) -> None:
        """Put the values of channels back that have no curve any more."""
        pose_bone = self._ob.pose.bones[bone]
        for channel, _, gets_curve in self._changes(bone, row):
            if not gets_curve and channel in unkeyed.get(bone, {}):
                setattr(pose_bone, channel, unkeyed[bone].pop(channel))
                if not unkeyed[bone]:
                    del unkeyed[bone]

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
                if not action.users:
                    bpy.data.actions.remove(action)
                if motion.base_action is None and not animation.drivers and not animation.nla_tracks:
                    ob.animation_data_clear()
            else:
                del action[record.KEY]
        motion.base_action = None
        motion.base_slot = ""

    def _changes(self, bone: str, row: Sequence[write.Wanted | None]) -> list[tuple[str, bool, bool]]:
        """Return for each channel whether it has a curve now, and whether it is to have one."""
        changes, position = [], 0
        curves = list(read.of_bone(self._curves, bone))
        for channel, components in read.CHANNELS.items():
            there = slice(position, position + components)
            has_curve = any(curve is not None for curve in curves[there])
            changes.append((channel, has_curve, any(wanted is not None for wanted in row[there])))
            position += components
        return changes


def _is_result(action: Action | None) -> bool:
    return action is not None and action.library is None and record.KEY in action


def _is_locked(curve: FCurve | None) -> bool:
    return curve is not None and (curve.lock or (curve.group is not None and curve.group.lock))


def _decode_unkeyed(text: str) -> dict[str, dict[str, list[float]]]:
    decoded = json.loads(text) if text else {}
    return decoded if isinstance(decoded, dict) else {}
