"""What a .blend file remembers of a stack: the recipe on the armature object, and the form of the next track.

The names of these properties are read by scripts and by saved files: they change only together with a migration.
"""

from __future__ import annotations

from typing import Any

import bpy
from bpy.props import (
    BoolProperty,
    CollectionProperty,
    EnumProperty,
    FloatProperty,
    IntProperty,
    PointerProperty,
    StringProperty,
)
from bpy.types import Action, PropertyGroup

OVERRIDABLE: set[Any] = {"LIBRARY_OVERRIDABLE"}
OVERRIDABLE_COLLECTION: set[Any] = {"LIBRARY_OVERRIDABLE", "USE_INSERTION"}
FRAME_LIMIT = 1_048_574  # Blender's own limit of frame numbers

KINDS = (
    ("TRACK", "Motion Track", "A clip on some bones, with its cut, scale and blend", "ACTION", 0),
    ("FILTER", "Filter", "A filter on the motion of some bones", "SMOOTHCURVE", 1),
    ("KEPT", "Kept Edits", "F-curves edited by hand, which replace what lies below", "GREASEPENCIL", 2),
)
ROTATION_ALIGNMENTS = (
    ("HEADING", "Heading", "Turn the new motion about the up axis only, so that it continues in the old direction"),
    ("FULL", "Full Rotation", "Turn the new motion about all axes, so that it continues with exactly the old rotation"),
)
BLENDS = (
    ("SLERP", "Rotations", "Blend rotations along the shorter arc"),
    ("EULER", "Linear (Euler)", "Blend every Euler angle by itself, as the classic Motion Combiner did"),
)
SAMPLINGS = (
    ("LINEAR", "Linear", "Take values between two frames of the file along the straight way between them"),
    ("SMOOTH", "Smooth", "Take values between two frames of the file along a smooth curve through their neighbors"),
)
KEYS = (
    ("FRAMES", "Whole Frames", "Set keys on whole frames of the scene"),
    ("SAMPLES", "Every Sample", "Keep every sample of the file, with keys on sub-frames where the rates differ"),
)
FILTER_KINDS = (
    ("MEDIAN", "Median", "Take the middle of the sorted values: removes spikes, keeps edges, makes no new values"),
    ("AVERAGE", "Average", "Take the mean of the values: removes noise and softens"),
    (
        "WEIGHTED",
        "Weighted Average",
        "Take the mean with weights from Pascal's triangle: softens less than the average",
    ),
)
FILTER_CHANNELS = (
    ("ROTATION", "Rotations", "Filter rotations as a whole, which is safe where angles pass 180 degrees"),
    ("CHANNELS", "Single Channels", "Filter every F-curve by itself, as the classic filters did"),
)
DEPTHS = (
    ("3", "3", "Consider three values for each result"),
    ("5", "5", "Consider five values for each result"),
    ("7", "7", "Consider seven values for each result"),
    ("CUSTOM", "Any", "Consider any odd number of values for each result"),
)
RATES = (
    ("RESAMPLE", "Resample to Scene", "Play at the recorded speed with keys on whole frames of the scene"),
    ("SCENE", "Set Scene Rate", "Set the frame rate of the scene to the rate of the file"),
    ("SAMPLES", "Keep Every Sample", "Play at the recorded speed and keep every sample, with keys on sub-frames"),
)
SCENE_RANGES = (
    ("EXTEND", "Extend", "Extend the frame range of the scene where the new motion reaches beyond it"),
    ("FIT", "Fit", "Set the frame range of the scene to that of the motion"),
    ("KEEP", "Keep", "Leave the frame range of the scene as it is"),
)
UP_AXES = (
    ("X", "X", "The X axis of the file points up"),
    ("Y", "Y", "The Y axis of the file points up"),
    ("Z", "Z", "The Z axis of the file points up"),
    ("-X", "-X", "The X axis of the file points down"),
    ("-Y", "-Y", "The Y axis of the file points down"),
    ("-Z", "-Z", "The Z axis of the file points down"),
)
FORWARD_AXES = (
    ("FILE", "As in the File", "Leave the figure turned as it is in the file"),
    ("X", "X", "The figure looks along the X axis of the file, and comes to face the viewer"),
    ("Y", "Y", "The figure looks along the Y axis of the file, and comes to face the viewer"),
    ("Z", "Z", "The figure looks along the Z axis of the file, and comes to face the viewer"),
    ("-X", "-X", "The figure looks against the X axis of the file, and comes to face the viewer"),
    ("-Y", "-Y", "The figure looks against the Y axis of the file, and comes to face the viewer"),
    ("-Z", "-Z", "The figure looks against the Z axis of the file, and comes to face the viewer"),
)
BONE_STYLES = (
    ("POINT", "Point to Child", "Let each bone point to its child and key rotations as quaternions"),
    (
        "AXES",
        "File's Axes",
        "Give each bone the axes of the file, so that its Euler channels hold the file's own numbers",
    ),
)


def _rebuild(properties: PropertyGroup, context: bpy.types.Context) -> None:
    from . import stack  # imports the native module, without which properties can be defined all the same

    stack.on_edit(properties, context)


def _frame(name: str, description: str, *, low: int = -FRAME_LIMIT, rebuild: bool = True) -> object:
    options: dict[str, Any] = {"name": name, "description": description, "min": low, "max": FRAME_LIMIT}
    if rebuild:
        options |= {"update": _rebuild, "override": OVERRIDABLE}
    return IntProperty(**options)


CUT_START = ("Cut Start", "First frame of the file to take. Zero takes the file from its beginning")
CUT_END = ("Cut End", "Last frame of the file to take. Zero takes the file to its end")
SCALE_START = ("Scale Start", "Scene frame at which the motion is to start. Zero keeps the frame of the file")
SCALE_END = ("Scale End", "Scene frame at which the motion is to end. Zero keeps the length of the file")
BLEND_DEPTH = ("Blend Depth", "Frames on each side of a border over which old and new motion pass into each other")

# What entries, the form for new ones and operators say alike.
Words = dict[str, Any]
PRESERVE: Words = {
    "name": "Preserve Position",
    "description": "Continue from where the old motion left the root. Excludes blending",
}
PRESERVE_ROTATION: Words = {
    "name": "Rotation",
    "description": "How far the new motion is turned to continue the old one",
    "items": ROTATION_ALIGNMENTS,
}
PRESERVE_HEIGHT: Words = {
    "name": "Height",
    "description": "Continue at the old height of the root as well, not only at its place on the ground",
}
DISCARD: Words = {
    "name": "Discard Old Motion",
    "description": "Remove the old motion of these bones before the new one is added",
}
BLEND: Words = {"name": "Blend", "description": "How rotations are blended", "items": BLENDS}
SAMPLING: Words = {
    "name": "Sampling",
    "description": "How values between two frames of the file are found",
    "items": SAMPLINGS,
}
FILTER_KIND: Words = {"name": "Filter", "description": "The kind of filter", "items": FILTER_KINDS}
FILTER_ON: Words = {
    "name": "Filter On",
    "description": "What the filter takes as one value",
    "items": FILTER_CHANNELS,
}
DEPTH: Words = {
    "description": "How many values are considered for each result. An odd number",
    "soft_max": 31,
    "max": 9999,
    "step": 2,
}
LONGEST_GAP: Words = {
    "name": "Longest Gap",
    "description": "How many samples may be missing in a gap that is filled",
    "default": 10,
    "min": 1,
    "soft_max": 1000,
}
EDITED: Words = {"update": _rebuild, "override": OVERRIDABLE}


class PackedSource(PropertyGroup):
    """A motion file kept inside the .blend file."""

    name: StringProperty(name="Key", override=OVERRIDABLE)
    filename: StringProperty(name="File Name", override=OVERRIDABLE)
    data: StringProperty(name="Data", description="The file's bytes, compressed", override=OVERRIDABLE)


class MotionEntry(PropertyGroup):
    """One entry of the stack: a track, a filter, or edits that were kept."""

    name: StringProperty(name="Name", description="The name of this entry in the stack", override=OVERRIDABLE)
    kind: EnumProperty(name="Kind", items=KINDS, override=OVERRIDABLE)
    enabled: BoolProperty(
        name="Enabled",
        description="Let this entry take part in the result",
        default=True,
        update=_rebuild,
        override=OVERRIDABLE,
    )
    source: StringProperty(
        name="Source",
        description="The motion file of this track",
        subtype="FILE_PATH",
        update=_rebuild,
        override=OVERRIDABLE,
    )
    packed_key: StringProperty(
        name="Packed As", description="Which packed file holds the motion of this track", override=OVERRIDABLE
    )
    skeleton_text: StringProperty(
        name="Skeleton",
        description="The skeleton of this track, where it is not that of the armature",
        override=OVERRIDABLE,
    )
    all_bones: BoolProperty(
        name="All Bones",
        description="Act on every bone of the armature",
        default=True,
        update=_rebuild,
        override=OVERRIDABLE,
    )
    bones: StringProperty(
        name="Bones",
        description="The bones on which this entry acts, one a line",
        update=_rebuild,
        override=OVERRIDABLE,
    )
    rate_hz: FloatProperty(
        name="Rate",
        description="Samples per second, where those of the file are missing or wrong. Zero takes the rate of the file",
        min=0.0,
        soft_max=1000.0,
        update=_rebuild,
        override=OVERRIDABLE,
    )
    cut_start: _frame(*CUT_START)
    cut_end: _frame(*CUT_END)
    scale_start: _frame(*SCALE_START)
    scale_end: _frame(*SCALE_END)
    blend_depth: _frame(*BLEND_DEPTH, low=0)
    preserve: BoolProperty(**PRESERVE, **EDITED)
    preserve_rotation: EnumProperty(**PRESERVE_ROTATION, **EDITED)
    preserve_height: BoolProperty(**PRESERVE_HEIGHT, **EDITED)
    discard: BoolProperty(**DISCARD, **EDITED)
    blend: EnumProperty(**BLEND, **EDITED)
    sampling: EnumProperty(**SAMPLING, **EDITED)
    keys: EnumProperty(name="Keys", description="Where keys are set", items=KEYS, update=_rebuild, override=OVERRIDABLE)
    filter_kind: EnumProperty(**FILTER_KIND, **EDITED)
    depth: IntProperty(name="Depth", default=3, min=3, **DEPTH, **EDITED)
    filter_channels: EnumProperty(**FILTER_ON, **EDITED)
    action: PointerProperty(
        name="Action", description="The kept F-curves", type=Action, update=_rebuild, override=OVERRIDABLE
    )
    # What the last rebuild found out, for the panel to show.
    notices: StringProperty(name="Notices", override=OVERRIDABLE)
    error: StringProperty(name="Error", override=OVERRIDABLE)
    clip_frames: IntProperty(name="Frames", override=OVERRIDABLE)
    clip_first: IntProperty(name="First Frame", override=OVERRIDABLE)
    clip_rate_hz: FloatProperty(name="Rate of the File", override=OVERRIDABLE)
    result_start: FloatProperty(name="Start", override=OVERRIDABLE)
    result_end: FloatProperty(name="End", override=OVERRIDABLE)


class MotionStack(PropertyGroup):
    """The recipe of an armature: base, entries from bottom to top, and where its skeleton came from."""

    entries: CollectionProperty(type=MotionEntry, override=OVERRIDABLE_COLLECTION)
    active: IntProperty(name="Active Entry", min=0, override=OVERRIDABLE)
    base_action: PointerProperty(
        name="Base",
        description="The action that was on the armature before the first entry. It is left unchanged",
        type=Action,
        override=OVERRIDABLE,
    )
    base_slot: StringProperty(name="Base Slot", override=OVERRIDABLE)
    unkeyed: StringProperty(
        name="Unkeyed Values",
        description="Values of channels that had no F-curves before the first entry, to be put back with them",
        override=OVERRIDABLE,
    )
    skeleton_source: StringProperty(
        name="Skeleton",
        description="The file from which the armature was made",
        subtype="FILE_PATH",
        override=OVERRIDABLE,
    )
    skeleton_text: StringProperty(name="Skeleton Text", override=OVERRIDABLE)
    unit_m: FloatProperty(
        name="Length Unit", description="Scene units per unit of length of the file", override=OVERRIDABLE
    )
    up: EnumProperty(
        name="Up", description="The axis of the file that points up", items=UP_AXES, default="Y", override=OVERRIDABLE
    )
    forward: EnumProperty(
        name="Forward",
        description="The axis of the file along which the figure looks, in its rest pose where it has one",
        items=FORWARD_AXES,
        override=OVERRIDABLE,
    )
    bone_style: EnumProperty(
        name="Bone Style", description="How the bones are oriented", items=BONE_STYLES, override=OVERRIDABLE
    )
    bone_names: StringProperty(
        name="Bone Names", description="Names in the file and in Blender, as JSON pairs", override=OVERRIDABLE
    )
    hand_edited: StringProperty(
        name="Edited Bones",
        description="Bones whose F-curves were edited by hand since the last rebuild, one a line",
        override=OVERRIDABLE,
    )
    message: StringProperty(name="Message", override=OVERRIDABLE)
    packed: CollectionProperty(type=PackedSource, override=OVERRIDABLE_COLLECTION)


class NewTrackOptions(PropertyGroup):
    """The form of the next track and the next filter; it lasts as long as the session."""

    selected_only: BoolProperty(name="Selected Bones Only", description="Act on the selected bones only", default=False)
    bone_collection: StringProperty(
        name="Bone Collection", description="Act on the bones of this collection instead of the selected ones"
    )
    cut_start: _frame(*CUT_START, rebuild=False)
    cut_end: _frame(*CUT_END, rebuild=False)
    scale_start: _frame(*SCALE_START, rebuild=False)
    scale_end: _frame(*SCALE_END, rebuild=False)
    blend_depth: _frame(*BLEND_DEPTH, low=0, rebuild=False)
    preserve: BoolProperty(**PRESERVE)
    preserve_rotation: EnumProperty(**PRESERVE_ROTATION)
    preserve_height: BoolProperty(**PRESERVE_HEIGHT)
    discard: BoolProperty(**DISCARD)
    blend: EnumProperty(**BLEND)
    sampling: EnumProperty(**SAMPLING)
    filter_kind: EnumProperty(**FILTER_KIND)
    depth: EnumProperty(name="Depth", description="How many values are considered for each result", items=DEPTHS)
    custom_depth: IntProperty(name="Custom Depth", default=9, min=3, **DEPTH)


CLASSES = (PackedSource, MotionEntry, MotionStack, NewTrackOptions)
"""In the order in which they refer to each other."""


def register_pointers() -> None:
    """Attach the stack to objects and the form to the window manager."""
    bpy.types.Object.motion_theater = PointerProperty(type=MotionStack, override=OVERRIDABLE)
    bpy.types.WindowManager.motion_theater = PointerProperty(type=NewTrackOptions)


def unregister_pointers() -> None:
    """Detach what `register_pointers` attached."""
    del bpy.types.WindowManager.motion_theater
    del bpy.types.Object.motion_theater
