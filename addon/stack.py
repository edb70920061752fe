"""The stack of an armature: adding, removing, moving and editing its entries, each followed by a rebuild.

Whatever fails leaves entries, action and everything else as they were, and raises UserError with one sentence.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from typing import TYPE_CHECKING, Any

import bpy

from . import compat
from . import rebuild as rebuilding
from .curves import read
from .curves.result import Result
from .logic import names
from .logic.messages import UserError, explained, sentences

if TYPE_CHECKING:
    from bpy.types import Context, Object, PropertyGroup

    from .properties import MotionEntry, MotionStack

_quiet_depth = 0


def of(ob: Object) -> MotionStack:
    """Return the stack of an armature; every object has one, most are empty."""
    return ob.motion_theater


@contextmanager
def quietly() -> Iterator[None]:
    """Set properties without the rebuild that an edit by the user brings."""
    global _quiet_depth
    _quiet_depth += 1
    try:
        yield
    finally:
        _quiet_depth -= 1


def rebuild(ob: Object, *, over_edits: bool = False) -> list[str]:
    """Build the motion of an armature anew from its stack; return what the user should know."""
    motion = of(ob)
    with quietly():
        try:
            notices = rebuilding.rebuild(ob, bpy.context.scene, over_edits=over_edits)
        except rebuilding.EntryError as error:
            motion.entries[error.entry].error = str(error)
            raise
        if not motion.entries:
            Result(ob).detach(motion)
    return notices


def on_edit(properties: PropertyGroup, context: Context) -> None:
    """Rebuild after the user changed a setting. What goes wrong is shown in the panel: a property cannot refuse."""
    if _quiet_depth:
        return
    ob = properties.id_data
    if not isinstance(ob, bpy.types.Object) or ob.type != "ARMATURE":
        return
    try:
        of(ob).message = sentences(rebuild(ob))
    except BaseException as error:
        text = explained(error)
        if text is None:
            raise
        of(ob).message = text


def add_entry(ob: Object, kind: str, **settings: object) -> MotionEntry:
    """Put a new entry on top of the stack, with these settings, and rebuild."""
    motion = of(ob)
    add_entries(ob, [{"kind": kind, **settings}])
    return motion.entries[motion.active]


def add_entries(ob: Object, entries: Sequence[Mapping[str, object]], *, instead: bool = False) -> list[str]:
    """Put entries with these settings on top of the stack, or in place of all others, and rebuild once.

    Return what the user should know. What an override has from its library stays.
    """
    motion = of(ob)
    kept = [entry.action for entry in motion.entries if entry.action is not None] if instead else []
    with _restored_on_error(ob):
        if not motion.entries:
            _take_base(ob)
        if instead:
            _cut_down(ob)
        for settings in entries:
            entry = motion.entries.add()
            with quietly():
                for name, value in settings.items():
                    setattr(entry, name, value)
        motion.active = len(motion.entries) - 1
        notices = rebuild(ob)
    for action in kept:
        if not action.users:
            bpy.data.actions.remove(action)
    return notices


def remove_entry(ob: Object, index: int) -> None:
    """Take an entry out of the stack, and rebuild."""
    motion = of(ob)
    kept = motion.entries[index].action
    _refuse_library_entries(ob, index)
    with _restored_on_error(ob):
        motion.entries.remove(index)
        motion.active = max(0, min(motion.active, len(motion.entries) - 1))
        rebuild(ob)
    if kept is not None and not kept.users:
        bpy.data.actions.remove(kept)


def move_entry(ob: Object, index: int, offset: int) -> None:
    """Move an entry up (positive) or down in the stack, and rebuild."""
    motion = of(ob)
    target = max(0, min(index + offset, len(motion.entries) - 1))
    _refuse_library_entries(ob, min(index, target))
    with _restored_on_error(ob):
        motion.entries.move(index, target)
        motion.active = target
        rebuild(ob)


def duplicate_entry(ob: Object, index: int) -> None:
    """Put a copy of an entry above it, and rebuild. In a library override it comes above what the library has."""
    motion = of(ob)
    target = max(index + 1, _library_count(ob))
    with _restored_on_error(ob):
        settings = _settings(motion.entries[index])
        _apply(motion.entries.add(), settings)
        motion.entries.move(len(motion.entries) - 1, target)
        motion.active = target
        rebuild(ob)


def set_bones(ob: Object, index: int, bones: Sequence[str]) -> None:
    """Let an entry act on these bones, and rebuild."""
    entry = of(ob).entries[index]
    with _restored_on_error(ob):
        with quietly():
            entry.all_bones = False
            entry.bones = names.join(bones)
        rebuild(ob)


def keep_edits(ob: Object) -> None:
    """Make an entry of the curves that were edited by hand, on top of the stack, and rebuild."""
    motion = of(ob)
    edited = names.split(motion.hand_edited)
    animation = ob.animation_data
    if not edited or animation is None or animation.action is None:
        raise UserError("No F-curves were edited by hand since the last rebuild")
    action = _copy_of_curves(ob, edited)
    try:
        with _restored_on_error(ob):
            entry = motion.entries.add()
            with quietly():
                entry.kind, entry.name, entry.action = "KEPT", "Kept Edits", action
                entry.all_bones, entry.bones = False, motion.hand_edited
                motion.active = len(motion.entries) - 1
            rebuild(ob, over_edits=True)
    except UserError:
        bpy.data.actions.remove(action)
        raise


def _copy_of_curves(ob: Object, bones: Sequence[str]) -> bpy.types.Action:
    """Return a new action with nothing but the curves of these bones that a stack may write."""
    source = read.index(compat.bag_of(ob, ob.animation_data.action))
    wanted = {path for bone in bones for path in (read.path(bone, channel) for channel in read.CHANNELS)}
    action = ob.animation_data.action.copy()
    action.name = f"{ob.name} Kept Edits"
    bag = compat.only_bag(ob, action, compat.slot_name(ob))
    for (path, component), curve in read.index(bag).items():
        if path not in wanted or (path, component) not in source:
            bag.fcurves.remove(curve)
    return action


def _library_count(ob: Object) -> int:
    """Return how many entries an override has from its library: they can be edited and muted, but stay in place."""
    if ob.override_library is None:
        return 0
    linked: Any = ob.override_library.reference
    return len(of(linked).entries)


def _cut_down(ob: Object) -> int:
    """Take away all entries that can be; return how many are left."""
    motion, fixed = of(ob), _library_count(ob)
    while len(motion.entries) > fixed:
        motion.entries.remove(len(motion.entries) - 1)
    return fixed


def _refuse_library_entries(ob: Object, index: int) -> None:
    if index < _library_count(ob):
        raise UserError(f"“{of(ob).entries[index].name}” comes from a linked file and must stay: switch it off instead")


def _take_base(ob: Object) -> None:
    """Note what is on the armature as the base of its stack."""
    motion = of(ob)
    animation = ob.animation_data
    motion.base_action = animation.action if animation is not None else None
    motion.base_slot = compat.slot_name(ob)


def _settings(entry: MotionEntry) -> dict[str, object]:
    return {
        definition.identifier: getattr(entry, definition.identifier)
        for definition in entry.bl_rna.properties
        if not definition.is_readonly
    }


def _apply(entry: MotionEntry, settings: dict[str, object]) -> None:
    with quietly():
        for name, value in settings.items():
            if getattr(entry, name) != value:  # in an override every assignment would be noted
                setattr(entry, name, value)


@contextmanager
def _restored_on_error(ob: Object) -> Iterator[None]:
    """Put the entries and the base back if the body raises. The alert about hand edits stays."""
    motion = of(ob)
    before = [_settings(entry) for entry in motion.entries]
    active, base = motion.active, (motion.base_action, motion.base_slot)
    try:
        yield
    except BaseException:
        fixed = _cut_down(ob)
        for index, settings in enumerate(before):
            _apply(motion.entries[index] if index < fixed else motion.entries.add(), settings)
        motion.active = active
        motion.base_action, motion.base_slot = base
        raise
