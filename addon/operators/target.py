"""What the operators of the stack act on, and why one cannot be used right now."""

from __future__ import annotations

from typing import TYPE_CHECKING

from .. import rig, stack
from ..translations import text
from . import outcome

if TYPE_CHECKING:
    from collections.abc import Callable

    from bpy.types import Context, Object, Operator

    from ..properties import MotionEntry


def armature(context: Context) -> Object | None:
    """Return the armature that the sidebar shows: the active object, or the one posed while weights are painted."""
    ob = context.pose_object or context.object
    return ob if ob is not None and ob.type == "ARMATURE" else None


def entry(ob: Object | None) -> MotionEntry | None:
    """Return the active entry of an armature's stack."""
    if ob is None:
        return None
    motion = stack.of(ob)
    return motion.entries[motion.active] if 0 <= motion.active < len(motion.entries) else None


def armature_reason(context: Context) -> str:
    """Return why there is no armature whose motion can be edited, or nothing."""
    ob = armature(context)
    return rig.writable_reason(ob) if ob else text("Select an armature first")


def stack_reason(context: Context) -> str:
    """Return why there is no stack that can be edited, or nothing."""
    reason = armature_reason(context)
    if not reason and not stack.of(armature(context)).entries:
        return text("Add a motion track first")
    return reason


def entry_reason(context: Context) -> str:
    """Return why there is no active entry that can be edited, or nothing."""
    reason = stack_reason(context)
    if not reason and entry(armature(context)) is None:
        return text("Choose an entry in the list first")
    return reason


def track_reason(context: Context) -> str:
    """Return why the active entry is not a track that can be edited, or nothing."""
    reason = entry_reason(context)
    if not reason and entry(armature(context)).kind != "TRACK":
        return text("Choose a track in the list; filters and kept edits have no source file")
    return reason


def allowed(cls: type[Operator], reason: str) -> bool:
    """Answer a `poll`, leaving the reason of a refusal for the tooltip."""
    if reason:
        cls.poll_message_set(reason)
    return not reason


def carry_out(operator: Operator, context: Context, action: Callable[[Object], str]) -> set[str]:
    """Run an action on the active armature that returns its message; report it and leave it in the panel."""
    ob = armature(context)

    def told() -> str:
        message = action(ob)
        stack.of(ob).message = message
        return message

    return outcome.carry_out(operator, context, told)
