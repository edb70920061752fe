"""Everything that differs between Blender versions, and nothing else.

Features are tested, not versions. Each branch names the release that brought the change and goes when the releases
before it are no longer supported.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Protocol, cast

import bpy

if TYPE_CHECKING:
    from bpy.types import ID, Action, PoseBone

SLOTTED = "slots" in bpy.types.Action.bl_rna.properties  # 4.4: an action has slots, one for each user


class Bag(Protocol):
    """The F-curves that animate one data-block in one action: a channelbag, or the whole action before 4.4."""

    fcurves: Any
    groups: Any


def bag_of(datablock: ID, action: Action | None, *, slot_name: str = "") -> Bag | None:
    """Return the F-curves of `datablock` in `action` without changing anything, or None if there are none.

    `slot_name` identifies the slot where the action is not the one assigned.
    """
    if action is None:
        return None
    if not SLOTTED:
        return cast("Bag", action)
    slot = action.slots.get(slot_name) if slot_name else None
    slot = slot or _fitting_slot(datablock, action)
    if slot is None or not action.layers or not action.layers[0].strips:
        return None
    return action.layers[0].strips[0].channelbag(slot)


def ensure_bag(datablock: ID, action: Action) -> Bag:
    """Return the F-curves of `datablock` in `action`, making slot, layer and strip where there are none."""
    if not SLOTTED:
        return cast("Bag", action)
    slot = _fitting_slot(datablock, action) or action.slots.new(id_type=datablock.id_type, name=datablock.name)
    layer = action.layers[0] if action.layers else action.layers.new("Layer")
    strip = layer.strips[0] if layer.strips else layer.strips.new(type="KEYFRAME")
    return strip.channelbag(slot, ensure=True)


def _fitting_slot(datablock: ID, action: Action) -> bpy.types.ActionSlot | None:
    """Return the slot that is assigned, else what Blender itself would take: one of the same name, or an unused one."""
    animation = datablock.animation_data
    if animation and animation.action == action and animation.action_slot is not None:
        return animation.action_slot
    slots = [slot for slot in action.slots if slot.target_id_type in (datablock.id_type, "UNSPECIFIED")]
    same_name = (slot for slot in slots if slot.name_display == datablock.name)
    unused = (slot for slot in slots if not slot.users())
    return next(same_name, None) or next(unused, None)


def slot_name(datablock: ID) -> str:
    """Return what identifies the slot of `datablock` in its action; empty before 4.4."""
    animation = datablock.animation_data
    if not SLOTTED or animation is None or animation.action_slot is None:
        return ""
    return animation.action_slot.identifier


def assign(datablock: ID, action: Action | None, slot_name: str = "") -> None:
    """Let `action` animate `datablock`, by the slot that is named or the fitting one.

    Assigning an action alone may leave the slot unset, and then nothing moves.
    """
    animation = datablock.animation_data or datablock.animation_data_create()
    animation.action = action
    if SLOTTED and action is not None:
        slot = (action.slots.get(slot_name) if slot_name else None) or _fitting_slot(datablock, action)
        if slot is not None and animation.action_slot != slot:
            animation.action_slot = slot


def used_by_others(datablock: ID, action: Action) -> bool:
    """Return whether another object is animated by the same curves."""
    for other in bpy.data.objects:
        animation = other.animation_data
        if other != datablock and animation is not None and animation.action == action:
            return True
    return False


def is_selected(bone: PoseBone) -> bool:
    """Return whether a bone is selected in Pose Mode (5.0 moved it from the bone to the pose bone)."""
    return bone.select if "select" in bone.bl_rna.properties else bone.bone.select


def select_bone(bone: PoseBone, state: bool) -> None:
    """Select a bone, or not, for Pose Mode."""
    if "select" in bone.bl_rna.properties:
        bone.select = state
    else:
        bone.bone.select = state


def is_hidden(bone: PoseBone) -> bool:
    """Return whether a bone is hidden in Pose Mode (5.0 moved it from the bone to the pose bone)."""
    return bone.hide if "hide" in bone.bl_rna.properties else bone.bone.hide


def only_bag(datablock: ID, action: Action, slot_name: str) -> Bag:
    """Return the F-curves of one slot of an action, after removing all other slots."""
    if not SLOTTED:
        return cast("Bag", action)
    for slot in [slot for slot in action.slots if slot.identifier != slot_name]:
        action.slots.remove(slot)
    bag = bag_of(datablock, action, slot_name=slot_name)
    return bag if bag is not None else ensure_bag(datablock, action)
