"""Each action of the user is one undo step, and redo gives the same result bit for bit."""

from __future__ import annotations

from collections.abc import Callable

import bpy

from tests import harness

LEGS = ("root", "lfemur", "ltibia", "rfemur", "rtibia")
ARMS = ("lhumerus", "lradius", "rhumerus", "rradius")


def state() -> object:
    """Return everything that undo is to bring back, as plain values."""
    return harness.snapshot()


def import_skeleton() -> None:
    bpy.ops.motion_theater.import_skeleton("EXEC_DEFAULT", True, filepath=str(harness.TESTDATA / "human.asf"))


def select(names: tuple[str, ...]) -> None:
    harness.select(harness.armature(), names)
    bpy.ops.ed.undo_push(message="Select")


def track(clip: str, **options: object) -> None:
    path = str(harness.TESTDATA / clip)
    bpy.ops.motion_theater.add_track("EXEC_DEFAULT", True, filepath=path, selected_only=True, rate="SCENE", **options)


def edit() -> None:
    harness.armature().motion_theater.entries[1].scale_end = 70
    bpy.ops.ed.undo_push(message="Edit")


def filtered() -> None:
    bpy.ops.motion_theater.filter("EXEC_DEFAULT", True, kind="WEIGHTED", depth=7, selected_only=True)


def remove() -> None:
    bpy.ops.motion_theater.entry_remove("EXEC_DEFAULT", True)


TUTORIAL: tuple[Callable[[], None], ...] = (
    import_skeleton,
    lambda: select(LEGS),
    lambda: track("step_and_jump.amc"),
    lambda: select(ARMS),
    lambda: track("wave.amc", cut_start=1, cut_end=55, scale_start=1, scale_end=66),
    lambda: track("step_and_jump.amc", cut_start=67, cut_end=113, blend_depth=10),
    filtered,
    edit,
    remove,
)


def test_the_tutorial_can_be_undone_to_the_empty_scene_and_redone_to_the_end() -> None:
    bpy.ops.ed.undo_push(message="Start")
    states = [state()]
    for action in TUTORIAL:
        action()
        states.append(state())
    for expected in reversed(states[:-1]):
        bpy.ops.ed.undo()
        assert state() == expected
    assert len(bpy.data.objects) == 0
    for expected in states[1:]:
        bpy.ops.ed.redo()
        assert state() == expected


def test_adjusting_the_last_operation_leaves_one_entry() -> None:
    bpy.ops.ed.undo_push(message="Start")
    import_skeleton()
    select(LEGS)
    track("walk.amc")
    bpy.ops.ed.undo()  # what the redo panel does: undo, then the operator again with other settings
    track("walk.amc", cut_start=20)
    entries = harness.armature().motion_theater.entries
    assert [(entry.name, entry.cut_start) for entry in entries] == [("walk", 20)]


def test_the_stack_goes_on_after_an_undo() -> None:
    bpy.ops.ed.undo_push(message="Start")
    import_skeleton()
    select(LEGS)
    track("walk.amc")
    expected = harness.keys(harness.armature())
    edited = harness.armature()
    edited.motion_theater.entries[0].cut_start = 30
    bpy.ops.ed.undo_push(message="Edit")
    bpy.ops.ed.undo()
    ob = harness.armature()
    assert harness.same_keys(expected, harness.keys(ob))
    ob.motion_theater.entries[0].cut_start = 10
    assert ob.motion_theater.hand_edited == ""
    assert not harness.same_keys(expected, harness.keys(ob))
