"""Which bones the user means, and whether their motion can be edited at all."""

from __future__ import annotations

from typing import TYPE_CHECKING

from .. import compat

if TYPE_CHECKING:
    from bpy.types import Object


def selected_bones(ob: Object) -> list[str]:
    """Return the names of the bones selected in Pose Mode; their selection outlasts the mode."""
    return [bone.name for bone in ob.pose.bones if compat.is_selected(bone) and not compat.is_hidden(bone)]


def bones_of_collection(ob: Object, name: str) -> list[str]:
    """Return the names of the bones of a bone collection and of the collections inside it."""
    collection = ob.data.collections_all.get(name)
    return [] if collection is None else [bone.name for bone in collection.bones_recursive]


def writable_reason(ob: Object) -> str:
    """Return why the motion of an armature cannot be edited, or nothing."""
    if ob.type != "ARMATURE":
        return "The active object is no armature"
    if ob.library is not None:
        return "The armature is linked from another file: make a library override first"
    if ob.override_library is not None and ob.override_library.is_system_override:
        return "The library override of this armature is not editable: make it editable first"
    animation = ob.animation_data
    if animation is not None and animation.use_tweak_mode:
        return "An NLA strip is being tweaked: leave tweak mode first"
    return ""
