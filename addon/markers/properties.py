"""What a .blend file remembers of a marker set."""

from __future__ import annotations

from typing import TYPE_CHECKING

import bpy
from bpy.props import FloatProperty, IntProperty, PointerProperty, StringProperty
from bpy.types import PropertyGroup

from ..logic.axes import AS_IN_FILE
from ..properties import LONGEST_GAP, OVERRIDABLE

if TYPE_CHECKING:
    from bpy.types import Context, Object


def _is_mesh(_: PropertyGroup, ob: Object) -> bool:
    return ob.type == "MESH"


class MarkerSet(PropertyGroup):
    """Where the markers of an armature came from, and how the file's samples lie on the timeline."""

    source: StringProperty(
        name="Source",
        description="The file from which the markers were read",
        subtype="FILE_PATH",
        override=OVERRIDABLE,
    )
    names: StringProperty(
        name="Names", description="Names in the file and in Blender, as JSON pairs in file order", override=OVERRIDABLE
    )
    unit_m: FloatProperty(
        name="Length Unit", description="Scene units per unit of length of the file", override=OVERRIDABLE
    )
    up: StringProperty(name="Up", description="The axis of the file that points up", override=OVERRIDABLE)
    forward: StringProperty(
        name="Forward",
        description="The axis of the file that was turned to the viewer",
        default=AS_IN_FILE,
        override=OVERRIDABLE,
    )
    rate_hz: FloatProperty(name="Rate", description="Samples of the markers per second", override=OVERRIDABLE)
    first_frame: IntProperty(
        name="First Frame",
        description="The frame of the file, and of the scene, of the first sample",
        override=OVERRIDABLE,
    )
    frame_step: FloatProperty(
        name="Frame Step", description="Scene frames from one sample to the next", default=1.0, override=OVERRIDABLE
    )
    key_step: FloatProperty(
        name="Key Step", description="Scene frames from one key to the next", default=1.0, override=OVERRIDABLE
    )
    longest_gap: IntProperty(**LONGEST_GAP, override=OVERRIDABLE)
    lines: PointerProperty(
        name="Lines",
        description="The mesh whose edges join neighboring markers",
        type=bpy.types.Object,
        poll=_is_mesh,
        override=OVERRIDABLE,
    )
    message: StringProperty(name="Message", override=OVERRIDABLE)


def of(ob: Object) -> MarkerSet:
    """Return what an object remembers of a marker set."""
    return ob.motion_theater_markers


def is_set(ob: Object | None) -> bool:
    """Return whether an object is a marker set."""
    return ob is not None and ob.type == "ARMATURE" and bool(of(ob).source)


def set_of(context: Context) -> Object | None:
    """Return the marker set that the sidebar shows: the active object, or the one whose lines are active."""
    ob = context.pose_object or context.object
    if is_set(ob):
        return ob
    return ob.parent if ob is not None and is_set(ob.parent) else None


CLASSES = (MarkerSet,)


def register_pointers() -> None:
    """Attach the marker set to objects."""
    bpy.types.Object.motion_theater_markers = PointerProperty(type=MarkerSet, override=OVERRIDABLE)


def unregister_pointers() -> None:
    """Detach what `register_pointers` attached."""
    del bpy.types.Object.motion_theater_markers
