"""The states of an armature in which the panels are shown."""

from __future__ import annotations

from pathlib import Path

from bpy.types import Object

from tests import harness

stack = harness.module("stack")

ARM = ("lhumerus", "lradius", "lwrist")


def jumping_human() -> Object:
    """Return an armature with one track on all its bones."""
    harness.import_human()
    return harness.add("step_and_jump.amc")


def edit_by_hand(ob: Object, bone: str) -> None:
    """Move a key of a bone, as an animator does in the Graph Editor, and change a setting, which notices it."""
    curve = harness.fcurves(ob)[f'pose.bones["{bone}"].rotation_quaternion', 0]
    curve.keyframe_points[10].co.y += 0.25
    curve.update()
    stack.of(ob).entries[0].cut_end = 100


def missing_source(ob: Object, folder: Path) -> None:
    """Let the active track name a file that is not there."""
    motion = stack.of(ob)
    motion.entries[motion.active].source = str(folder / "moved_away.amc")
