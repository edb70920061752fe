"""The settings of a track, the same in the form for a new one and in the entry of one that is there."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from bpy.types import UILayout

    from ..properties import MotionEntry, NewTrackOptions


def draw_timing(layout: UILayout, settings: MotionEntry | NewTrackOptions) -> None:
    """Which frames of the file, and onto which frames of the scene."""
    cut = layout.column(align=True)
    cut.prop(settings, "cut_start", text="Cut From")
    cut.prop(settings, "cut_end", text="To")
    scale = layout.column(align=True)
    scale.prop(settings, "scale_start", text="Scale From")
    scale.prop(settings, "scale_end", text="To")


def draw_joining(layout: UILayout, settings: MotionEntry | NewTrackOptions) -> None:
    """How the new motion joins what is there already."""
    depth = layout.column()
    depth.active = not settings.preserve  # preserving excludes blending
    depth.prop(settings, "blend_depth")
    column = layout.column(heading="Old Motion")
    column.prop(settings, "preserve")
    column.prop(settings, "discard", text="Discard")


def draw_details(layout: UILayout, settings: MotionEntry | NewTrackOptions) -> None:
    """The finer points of preserving, blending and sampling."""
    preserving = layout.column()
    preserving.active = settings.preserve
    preserving.prop(settings, "preserve_rotation", text="Preserve")
    preserving.prop(settings, "preserve_height")
    blending = layout.column()
    blending.active = bool(settings.blend_depth) and not settings.preserve
    blending.prop(settings, "blend")
    layout.prop(settings, "sampling")
