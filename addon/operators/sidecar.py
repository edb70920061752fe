"""The operator for what people say of a clip: the eleven lines of its sidecar in a dialog."""

from __future__ import annotations

from typing import TYPE_CHECKING

import bpy
from bpy.props import IntProperty, StringProperty

from .. import sidecars, sources
from ..library import notes, session
from ..logic.messages import UserError, base_name
from ..translations import text
from . import target

if TYPE_CHECKING:
    from bpy.types import Context, Event, UILayout

    from motion_theater import Sidecar

DIALOG_WIDTH = 420
SHOWN_LINES = 3


def _field(name: str, description: str) -> object:
    """Return the property of one line; what was typed for another clip is not remembered."""
    return StringProperty(name=name, description=description, options={"SKIP_SAVE"})


class MOTION_THEATER_OT_sidecar_edit(bpy.types.Operator):
    """Write what is to be said of a clip into the text file (.i3d) beside it; a new one has what the clip tells"""

    bl_idname = "motion_theater.sidecar_edit"
    bl_label = "Edit Sidecar"
    bl_options = {"REGISTER"}

    filepath: StringProperty(
        name="Clip",
        description="The clip whose sidecar is edited. Empty for that of the active track",
        subtype="FILE_PATH",
        options={"HIDDEN", "SKIP_SAVE"},
    )
    clip: IntProperty(
        name="Number",
        description="The number of the clip in the library, which then knows what is saved. Zero for any file",
        min=0,
        options={"HIDDEN", "SKIP_SAVE"},
    )
    date: _field("Date", "When the clip was recorded")
    group: _field("Group", "The session, or another group of clips that belong together")
    subject: _field("Subject", "Who was recorded")
    duration: _field("Duration", "How long the clip is, in seconds")
    frame_rate: _field("Frame Rate", "Frames per second")
    cleaned: _field("Cleaned", "Whether the capture was cleaned: empty, or J, Ja, Y, Yes, N, Nein or No")
    last_change: _field("Last Changed On", "When this was changed the last time. Left alone, it becomes today")
    modified_by: _field("Modified By", "Who changed this. Left alone, it becomes your name")
    usable_segments: _field("Usable Segments", "First and last frames of what can be used, such as 20-180, 200-316")
    asf_file: _field("ASF File", "The skeleton of the clip, as a file name or a path from its folder")
    comment: _field("Comment", "What else is to be said")

    def invoke(self, context: Context, event: Event) -> set[str]:
        try:
            self._sidecar = self._opened(context)
        except UserError as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        self._found = dict(self._sidecar.fields)
        for name, value in self._found.items():
            if not self.properties.is_property_set(name):
                setattr(self, name, value)
        dialog = context.window_manager.invoke_props_dialog
        return set(dialog(self, width=DIALOG_WIDTH, confirm_text=text("Save")))

    def execute(self, context: Context) -> set[str]:
        given = {name: getattr(self, name) for name in _NAMES if self.properties.is_property_set(name)}
        try:
            # What was opened is what is saved: what someone else wrote meanwhile is not lost unseen.
            sidecar = getattr(self, "_sidecar", None) or self._opened(context)
            before = dict(sidecar.fields)
            is_written = sidecars.save(sidecar, given)
        except UserError as error:
            self.report({"ERROR"}, str(error))
            if hasattr(self, "_found"):
                # The dialog is gone, what was typed is not: it opens again with that over what the file says now.
                typed = {name: value for name, value in given.items() if value != self._found[name]}
                bpy.ops.motion_theater.sidecar_edit("INVOKE_DEFAULT", filepath=self.filepath, clip=self.clip, **typed)
            return {"CANCELLED"}
        if is_written and self.clip:
            notes.sidecar_saved(self.clip, [name for name, value in given.items() if value.strip() != before[name]])
        name = base_name(sidecar.path)
        self.report({"INFO"}, text("Saved {name}", name=name) if is_written else text("{name} is as it was", name=name))
        return {"FINISHED"}

    def draw(self, context: Context) -> None:
        layout = self.layout
        layout.use_property_split = True
        layout.use_property_decorate = False
        name = base_name(self._sidecar.path)
        layout.label(
            text=name if self._sidecar.is_on_disk else text("{name} is new: saving makes it", name=name),
            icon="TEXT" if self._sidecar.is_on_disk else "FILE_NEW",
            translate=False,
        )
        for field in _NAMES:
            row = layout.row()
            row.alert = field == "cleaned" and not sidecars.is_cleaned_word(self.cleaned)
            row.prop(self, field)
            if row.alert:
                row.label(icon="ERROR")
        _draw_unknown(layout, self._sidecar.unknown)

    def _opened(self, context: Context) -> Sidecar:
        if self.clip:
            return sidecars.opened(lambda: session.library().sidecar(self.clip))
        path = self.filepath
        if path:
            return sidecars.beside(bpy.path.abspath(path))
        ob = target.armature(context)
        entry = target.entry(ob)
        if entry is None or not entry.source:
            raise UserError(text("Choose a clip, or a track that comes from a file"))
        return sidecars.beside(sources.absolute(ob, entry.source))


def _draw_unknown(layout: UILayout, lines: list[str]) -> None:
    """Show that lines which no field means are there, and stay."""
    if not lines:
        return
    column = layout.column(align=True)
    column.active = False
    column.label(text="Also in the File")
    for line in lines[:SHOWN_LINES]:
        column.label(text=line, translate=False)
    if len(lines) > SHOWN_LINES:
        column.label(text=text("and {count} more lines", count=len(lines) - SHOWN_LINES), translate=False)


_NAMES = (
    "date",
    "group",
    "subject",
    "duration",
    "frame_rate",
    "cleaned",
    "last_change",
    "modified_by",
    "usable_segments",
    "asf_file",
    "comment",
)

CLASSES = (MOTION_THEATER_OT_sidecar_edit,)
