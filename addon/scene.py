"""Rate and frame range of the scene, and putting everything back when an action fails."""

from __future__ import annotations

import math
from collections.abc import Iterator
from contextlib import contextmanager
from typing import TYPE_CHECKING

import bpy

from .logic import ranges, rates

if TYPE_CHECKING:
    from bpy.types import Context, Object, Scene

CREATED_KINDS = ("objects", "armatures", "meshes", "actions")  # in the order in which users go before what they use


def rate_hz(scene: Scene) -> float:
    """Return the frames per second of a scene."""
    return scene.render.fps / scene.render.fps_base


def set_rate(scene: Scene, rate: float) -> None:
    """Set the frames per second of a scene, exactly for whole and broadcast rates."""
    scene.render.fps, scene.render.fps_base = rates.settings(rates.usual(rate))


def go_to(scene: Scene, frame: float) -> None:
    """Make a frame the current one, which need not be whole."""
    whole = math.floor(frame)
    scene.frame_set(whole, subframe=frame - whole)


@contextmanager
def same_frame(scene: Scene) -> Iterator[None]:
    """Put the current frame back after the body."""
    before = scene.frame_current_final
    try:
        yield
    finally:
        go_to(scene, before)


def apply_range(scene: Scene, choice: ranges.Choice, start: float, end: float) -> None:
    """Let the frame range of the scene meet that of a motion, as the user chose."""
    _set_range(scene, *ranges.scene_range(choice, (scene.frame_start, scene.frame_end), (start, end)))


def _set_range(scene: Scene, start: int, end: int) -> None:
    """Set the frame range; a start above the end would drag the end along, so the end comes first."""
    if (scene.frame_start, scene.frame_end) != (start, end):
        scene.frame_end = end
        scene.frame_start = start


def add_as_active(context: Context, ob: Object) -> None:
    """Put a new object into the active collection, or the scene's own where the active one cannot show it.

    It is then the only one selected, and active, in Object Mode.
    """
    if context.view_layer.objects.active is not None and context.mode != "OBJECT":
        bpy.ops.object.mode_set(mode="OBJECT")
    context.collection.objects.link(ob)
    if not ob.visible_get(view_layer=context.view_layer):
        context.collection.objects.unlink(ob)
        context.scene.collection.objects.link(ob)
    for other in context.selected_objects:
        other.select_set(False)
    ob.select_set(True)
    context.view_layer.objects.active = ob


@contextmanager
def unchanged_on_error(context: Context) -> Iterator[None]:
    """Put mode, selection, active object, rate, range and data-blocks back if the body raises."""
    scene, layer = context.scene, context.view_layer
    active = layer.objects.active
    mode = active.mode if active is not None else "OBJECT"
    selected = [ob for ob in layer.objects if ob.select_get(view_layer=layer)]
    settings = (scene.render.fps, scene.render.fps_base)
    frames = (scene.frame_start, scene.frame_end)
    before = {kind: {block.session_uid for block in getattr(bpy.data, kind)} for kind in CREATED_KINDS}
    try:
        yield
    except BaseException:
        if layer.objects.active is not None and layer.objects.active.mode != "OBJECT":
            bpy.ops.object.mode_set(mode="OBJECT")
        for kind, uids in before.items():
            blocks = getattr(bpy.data, kind)
            for block in [block for block in blocks if block.session_uid not in uids]:
                blocks.remove(block)
        for ob in layer.objects:
            ob.select_set(ob in selected, view_layer=layer)
        layer.objects.active = active
        if active is not None and active.mode != mode:
            bpy.ops.object.mode_set(mode=mode)
        scene.render.fps, scene.render.fps_base = settings
        _set_range(scene, *frames)
        raise
