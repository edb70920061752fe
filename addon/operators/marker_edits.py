"""What is done with a marker set: filling gaps, filtering, and adding what else its file holds."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

import bpy
from bpy.props import BoolProperty, EnumProperty, IntProperty

from .. import markers, properties, rig, sources
from ..logic import plan
from ..logic.messages import UserError, base_name, sentences
from ..markers import analog, edit, events, lines
from ..translations import text
from . import outcome, target

if TYPE_CHECKING:
    from bpy.types import Context, Object

    import motion_theater

FILLS = (
    ("LINEAR", "Linear", "Fill gaps along the straight way"),
    ("CUBIC", "Cubic", "Fill gaps along a smooth curve that continues the motion on both sides"),
    ("RIGID", "Rigid Cluster", "Let the neighbors that keep their distance carry the marker through the gap"),
)


class OnMarkerSet:
    """What all these operators share: they act on the marker set that the sidebar shows."""

    @classmethod
    def poll(cls, context: Context) -> bool:
        ob = markers.set_of(context)
        reason = rig.writable_reason(ob) if ob is not None else text("Select a marker set first")
        return target.allowed(cls, reason)

    def carry_out(self, context: Context, action: Callable[[Object], str]) -> set[str]:
        """Run an action on the marker set that returns its message; report it and leave it in the panel."""
        ob = markers.set_of(context)

        def told() -> str:
            message = sentences([action(ob)])
            ob.motion_theater_markers.message = message
            return message

        return outcome.carry_out(self, context, told)


class MOTION_THEATER_OT_fill_gaps(OnMarkerSet, bpy.types.Operator):
    """Fill the gaps of markers that dropped out, never before the first or after the last sample"""

    bl_idname = "motion_theater.fill_gaps"
    bl_label = "Fill Gaps"
    bl_options = {"REGISTER", "UNDO"}

    how: EnumProperty(name="Fill", description="How gaps are filled", items=FILLS)
    longest: IntProperty(**properties.LONGEST_GAP)
    selected_only: BoolProperty(name="Selected Markers Only", description="Fill the gaps of the selected markers only")

    def execute(self, context: Context) -> set[str]:
        return self.carry_out(
            context,
            lambda ob: edit.fill_gaps(ob, how=self.how, longest=self.longest, selected_only=self.selected_only),
        )


class MOTION_THEATER_OT_filter_markers(OnMarkerSet, bpy.types.Operator):
    """Filter the trajectories of markers. No window reaches over a gap, and gaps stay"""

    bl_idname = "motion_theater.filter_markers"
    bl_label = "Filter Markers"
    bl_options = {"REGISTER", "UNDO"}

    kind: EnumProperty(**properties.FILTER_KIND)
    depth: IntProperty(name="Depth", default=3, min=1, soft_min=3, **properties.DEPTH)
    selected_only: BoolProperty(name="Selected Markers Only", description="Filter the selected markers only")

    def execute(self, context: Context) -> set[str]:
        def filter_markers(ob: Object) -> str:
            plan.check_depth(self.depth)
            return edit.filter_markers(ob, kind=self.kind, depth=self.depth, selected_only=self.selected_only)

        return self.carry_out(context, filter_markers)


class MOTION_THEATER_OT_marker_lines(OnMarkerSet, bpy.types.Operator):
    """Draw lines between neighboring markers whose distance stays nearly constant, as a mesh to be edited"""

    bl_idname = "motion_theater.marker_lines"
    bl_label = "Draw Lines"
    bl_options = {"REGISTER", "UNDO"}

    def execute(self, context: Context) -> set[str]:
        def draw_lines(ob: Object) -> str:
            lines.check_none(ob)
            bones, _, recorded = edit.current(ob)
            return lines.add(context, ob, bones, recorded.neighbours())

        return self.carry_out(context, draw_lines)


class MOTION_THEATER_OT_marker_events(OnMarkerSet, bpy.types.Operator):
    """Add the events of the file to the timeline as markers"""

    bl_idname = "motion_theater.marker_events"
    bl_label = "Add Events"
    bl_options = {"REGISTER", "UNDO"}

    def execute(self, context: Context) -> set[str]:
        return self.carry_out(context, lambda ob: events.add(context.scene, ob, _recorded(ob)))


class MOTION_THEATER_OT_marker_analog(OnMarkerSet, bpy.types.Operator):
    """Add the analog channels of the file as animated custom properties of the marker set"""

    bl_idname = "motion_theater.marker_analog"
    bl_label = "Add Analog Channels"
    bl_options = {"REGISTER", "UNDO"}

    def execute(self, context: Context) -> set[str]:
        return self.carry_out(context, lambda ob: analog.add(ob, _recorded(ob)))


def _recorded(ob: Object) -> motion_theater.Markers:
    """Return what the file of a marker set holds."""
    path = sources.absolute(ob, ob.motion_theater_markers.source)
    recorded = sources.read_file(path).clip.markers
    if recorded is None:
        raise UserError(f"{base_name(path)} holds no markers any more")
    return recorded


CLASSES = (
    MOTION_THEATER_OT_fill_gaps,
    MOTION_THEATER_OT_filter_markers,
    MOTION_THEATER_OT_marker_lines,
    MOTION_THEATER_OT_marker_events,
    MOTION_THEATER_OT_marker_analog,
)
