"""What all exports have in common: which frames are written, at which rate, and in which axes and unit."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from bpy.props import EnumProperty, FloatProperty, IntProperty

from .. import exporting, properties
from ..logic.messages import explained, sentences

if TYPE_CHECKING:
    from bpy.types import Context, Object, UILayout

RANGES = (
    ("ACTION", "Action", "All frames of the action; those of the scene where there is none"),
    ("SCENE", "Scene", "The frame range of the scene"),
    ("CUSTOM", "Custom", "The frames given below"),
)
UNITS = (
    ("AUTO", "Automatic", "The unit of the file that this came from, else the usual one of the format"),
    ("0.01", "Centimeters", "One unit of the file is a centimeter"),
    ("1", "Meters", "One unit of the file is a meter"),
    ("0.001", "Millimeters", "One unit of the file is a millimeter"),
    ("0.0254", "Inches", "One unit of the file is an inch"),
)
UP_AXES = (
    ("AUTO", "Automatic", "The axis of the file that this came from, else the usual one of the format"),
    *properties.UP_AXES,
)


class FrameOptions:
    """Which frames are written."""

    range: EnumProperty(name="Range", description="Which frames are written", items=RANGES)
    frame_start: IntProperty(
        name="Start",
        description="The first frame of a custom range",
        default=1,
        min=-properties.FRAME_LIMIT,
        max=properties.FRAME_LIMIT,
    )
    frame_end: IntProperty(
        name="End",
        description="The last frame of a custom range",
        default=250,
        min=-properties.FRAME_LIMIT,
        max=properties.FRAME_LIMIT,
    )
    rate_hz: FloatProperty(
        name="Rate",
        description="Frames per second of the file. Zero takes the rate of the scene, or of a marker set's samples",
        min=0.0,
        soft_max=1000.0,
    )

    def draw_frames(self, layout: UILayout) -> None:
        """Draw these options as a block."""
        column = layout.column(align=True)
        column.prop(self, "range")
        if self.range == "CUSTOM":
            column.prop(self, "frame_start")
            column.prop(self, "frame_end")
        column.prop(self, "rate_hz")

    def span(self, context: Context, ob: Object | None) -> tuple[float, float]:
        """Return the first and the last scene frame that is meant."""
        scene = context.scene
        action = ob.animation_data.action if ob is not None and ob.animation_data else None
        if self.range == "CUSTOM":
            return float(self.frame_start), float(self.frame_end)
        if self.range == "ACTION" and action is not None:
            return float(action.frame_range[0]), float(action.frame_range[1])
        return float(scene.frame_start), float(scene.frame_end)

    def write(self, convert: Callable[[], tuple[list[tuple[str, bytes]], list[str]]]) -> set[str]:
        """Convert, write, and say what was written; on an error nothing is.

        `convert` returns files, each with its path, and the sentences of the message.
        """
        try:
            files, told = convert()
            exporting.write(files)
        except Exception as error:
            text = explained(error)
            if text is None:
                raise
            self.report({"ERROR"}, text)  # type: ignore[attr-defined]
            return {"CANCELLED"}
        self.report({"INFO"}, sentences(told))  # type: ignore[attr-defined]
        return {"FINISHED"}


class SpaceOptions:
    """In which axes and unit."""

    up: EnumProperty(name="Up", description="The axis of the file that points up", items=UP_AXES, default="AUTO")
    unit: EnumProperty(name="Length Unit", description="How long a unit of the file is", items=UNITS)

    def draw_space(self, layout: UILayout) -> None:
        """Draw these options as a block."""
        column = layout.column(align=True)
        column.prop(self, "up")
        column.prop(self, "unit")

    def unit_m(self) -> float:
        """Return meters per unit; 0 where it is left open."""
        return 0.0 if self.unit == "AUTO" else float(self.unit)
