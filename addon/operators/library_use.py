"""From the library into the scene: a clip as a track of the active armature, or with an armature of its own."""

from __future__ import annotations

from typing import TYPE_CHECKING

import bpy
from bpy.props import BoolProperty, EnumProperty, IntProperty

import motion_theater

from .. import capture, preferences, properties, rig, tracks
from ..library import notes, rows, session
from ..logic.library import facts
from ..logic.messages import UserError
from ..translations import text
from . import outcome, target

if TYPE_CHECKING:
    from bpy.types import Context, Event

CLIP = ("Clip", "The number of the clip in the library. Zero takes the selected one")


def clip_reason(clip: motion_theater.LibraryClip | None) -> str:
    """Return why a clip cannot be brought into the scene, or nothing."""
    if clip is None:
        return text("Select a clip in the library first")
    if clip.error:
        return text("This file cannot be read")
    if clip.is_missing:
        return text("The file of this clip is missing")
    return ""


def reason(context: Context, operator: str) -> str:
    """Return why one of these operators cannot be used with the selected clip, or nothing."""
    clip = rows.active()
    because = clip_reason(clip)
    if because or operator != "library_add_track":
        return because
    if clip.format in tracks.MARKER_FORMATS:
        return text("A clip of markers is no track: import it as new")
    ob = target.armature(context)
    if ob is None:
        return text("Select the armature that gets the track, or import as new")
    return rig.writable_reason(ob)


def _clip(clip_id: int) -> motion_theater.LibraryClip:
    """Return a clip by its number, the selected one by zero."""
    wanted = clip_id or session.state.active_id
    found = session.library().clips([wanted]) if wanted is not None else []
    clip = found[0] if found else None
    because = clip_reason(clip)
    if clip is None or because:
        raise UserError(because)
    return clip


def _used(clip: motion_theater.LibraryClip, message: str) -> str:
    session.say(message)
    session.change(lambda: session.library().mark_used(clip.id))
    return message


class MOTION_THEATER_OT_library_add_track(bpy.types.Operator):
    """Add a clip of the library as a track to the active armature, from its in mark to its out mark"""

    bl_idname = "motion_theater.library_add_track"
    bl_label = "Add as Track"
    bl_options = {"REGISTER", "UNDO"}

    clip: IntProperty(name=CLIP[0], description=CLIP[1], min=0, options={"HIDDEN", "SKIP_SAVE"})
    selected_only: BoolProperty(
        name="Selected Bones Only", description="Add motion to the selected bones only", options={"SKIP_SAVE"}
    )
    cut_start: IntProperty(name=properties.CUT_START[0], description=properties.CUT_START[1], options={"SKIP_SAVE"})
    cut_end: IntProperty(name=properties.CUT_END[0], description=properties.CUT_END[1], options={"SKIP_SAVE"})
    blend_depth: IntProperty(
        name=properties.BLEND_DEPTH[0], description=properties.BLEND_DEPTH[1], min=0, options={"SKIP_SAVE"}
    )
    rate: EnumProperty(
        name="Frame Rate", description="How the rate of the file meets that of the scene", items=properties.RATES
    )
    scene_range: EnumProperty(
        name="Scene Range", description="What becomes of the frame range of the scene", items=properties.SCENE_RANGES
    )

    @classmethod
    def poll(cls, context: Context) -> bool:
        return target.allowed(cls, reason(context, "library_add_track"))

    def invoke(self, context: Context, event: Event) -> set[str]:
        preferences.apply(self, context)
        if not (self.properties.is_property_set("cut_start") or self.properties.is_property_set("cut_end")):
            marks = session.state.marks.get(self.clip or session.state.active_id or 0)
            self.cut_start, self.cut_end = marks.cut() if marks is not None else (0, 0)
        return self.execute(context)

    def execute(self, context: Context) -> set[str]:
        def add() -> str:
            clip = _clip(self.clip)
            request = tracks.Request(
                path=clip.path,
                skeleton=clip.skeleton_path or "",
                selected_only=self.selected_only,
                rate=self.rate,
                scene_range=self.scene_range,
                settings={name: getattr(self, name) for name in ("cut_start", "cut_end", "blend_depth")},
            )
            return _used(clip, tracks.add_track(context, target.armature(context), request))

        return outcome.carry_out(self, context, add)


class MOTION_THEATER_OT_library_import(bpy.types.Operator):
    """Import a clip of the library as new: with an armature of its own, or as a marker set"""

    bl_idname = "motion_theater.library_import"
    bl_label = "Import as New"
    bl_options = {"REGISTER", "UNDO"}

    clip: IntProperty(name=CLIP[0], description=CLIP[1], min=0, options={"HIDDEN", "SKIP_SAVE"})
    bone_style: EnumProperty(name="Bones", description="How the bones are oriented", items=properties.BONE_STYLES)
    rate: EnumProperty(
        name="Frame Rate", description="How the rate of the file meets that of the scene", items=properties.RATES
    )
    scene_range: EnumProperty(
        name="Scene Range", description="What becomes of the frame range of the scene", items=properties.SCENE_RANGES
    )

    @classmethod
    def poll(cls, context: Context) -> bool:
        return target.allowed(cls, reason(context, "library_import"))

    def invoke(self, context: Context, event: Event) -> set[str]:
        preferences.apply(self, context)
        return self.execute(context)

    def execute(self, context: Context) -> set[str]:
        return outcome.carry_out(self, context, lambda: self._imported(context))

    def _imported(self, context: Context) -> str:
        clip = _clip(self.clip)
        if clip.skeleton_path:
            request = tracks.Request(
                path=clip.path,
                skeleton=clip.skeleton_path,
                rate=self.rate,
                scene_range=self.scene_range,
                import_options={"bone_style": self.bone_style},
            )
            return _used(clip, tracks.add_track(context, None, request))
        options = capture.Options(
            target="NEW", bone_style=self.bone_style, rate=self.rate, scene_range=self.scene_range
        )
        batch = capture.Batch([clip.path], options, None)
        batch.step(context)
        if not batch.verdicts.done:
            raise UserError(batch.verdicts.skipped[0])
        return _used(clip, batch.verdicts.summary())


class MOTION_THEATER_OT_library_mark_usable(bpy.types.Operator):
    """Note in the library that a piece of a clip is usable"""

    bl_idname = "motion_theater.library_mark_usable"
    bl_label = "Mark Usable"
    bl_options = {"REGISTER"}

    clip: IntProperty(name=CLIP[0], description=CLIP[1], min=0, options={"HIDDEN", "SKIP_SAVE"})
    first: IntProperty(name="First Frame", description="The first frame of the piece", options={"SKIP_SAVE"})
    last: IntProperty(name="Last Frame", description="The last frame of the piece", options={"SKIP_SAVE"})
    clear: BoolProperty(name="Clear", description="Forget all usable pieces of the clip instead", options={"SKIP_SAVE"})

    @classmethod
    def description(cls, context: Context, properties: bpy.types.OperatorProperties) -> str:
        if properties.clear:
            return text("Forget which pieces of this clip are usable")
        return text("Note in the library that a piece of a clip is usable")

    @classmethod
    def poll(cls, context: Context) -> bool:
        return target.allowed(cls, clip_reason(rows.active()))

    def execute(self, context: Context) -> set[str]:
        def note() -> str:
            clip = _clip(self.clip)
            if not self.clear and self.last < self.first:
                raise UserError(text("The last frame of a usable piece comes before its first"))
            if self.clear:
                said = text("Forgot the usable pieces of {name}", name=clip.name)
                notes.forget_usable(clip.id, said)
                return said
            piece = (self.first, self.last)
            said = text("Frames {span} of {name} are usable", span=facts.span(*piece), name=clip.name)
            notes.mark_usable(clip.id, piece, said)
            return said

        return outcome.carry_out(self, context, note)


CLASSES = (
    MOTION_THEATER_OT_library_add_track,
    MOTION_THEATER_OT_library_import,
    MOTION_THEATER_OT_library_mark_usable,
)
