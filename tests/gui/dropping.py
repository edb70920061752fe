"""A folder's worth of mixed files is dropped: the dialog, the name of each while it comes in, Esc, the summary."""

from __future__ import annotations

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2]))

import bpy
import drive

from tests.gui import hand, stage

DAMAGED = 2
LONGEST_S = 40.0


def drop(names: list[str], folder: str, shot: str) -> hand.Session:
    """Call the operator as a drop of files into the 3D View does, look at its dialog, and confirm it with Enter."""
    view = drive.region("WINDOW")
    with bpy.context.temp_override(window=drive.window(), area=drive.area(), region=view):
        bpy.ops.motion_theater.import_motion_capture(
            "INVOKE_DEFAULT", directory=folder, files=[{"name": name} for name in names]
        )
    yield 1.0
    drive.screenshot(shot)
    yield from hand.tap("RET")


def until(count: int) -> hand.Session:
    """Wait until so many objects are in the scene."""
    waited = 0.0
    while len(bpy.context.scene.objects) < count:
        yield 0.05
        waited += 0.05
        assert waited < LONGEST_S, f"{len(bpy.context.scene.objects)} objects after {waited} s"


def close_popup() -> hand.Session:
    """Press Esc while the summary is shown."""
    yield from hand.tap("ESC")
    yield 0.5


def session() -> hand.Session:
    """Drop all; undo; drop all and press Esc after the second file."""
    stage.install()
    from tests.gui import recordings  # needs the native module, which comes with the extension

    yield from stage.empty_scene()
    names = recordings.folder()
    stage.keep_step("Empty")
    yield from hand.open_tab()

    yield from drop(names, str(recordings.FOLDER), "dropping-dialog")
    yield from until(3)
    drive.screenshot("dropping-progress")
    expected = len(names) - DAMAGED - 1  # the skeleton came in with the motion
    yield from until(expected)
    yield 1.5
    drive.screenshot("dropping-summary")
    kinds = [ob.type for ob in bpy.context.scene.objects]
    assert kinds == ["ARMATURE"] * expected, kinds
    yield from close_popup()
    yield from stage.look_from_the_front()
    yield from hand.shot("dropping-done")
    yield from drive.key("Z", ctrl=True)
    yield 1.0
    assert not bpy.context.scene.objects, "one Ctrl+Z does not take everything back"

    yield from drop(names, str(recordings.FOLDER), "dropping-dialog-again")
    yield from until(2)
    yield from hand.tap("ESC")
    yield 1.5
    there = len(bpy.context.scene.objects)
    drive.screenshot("dropping-stopped")
    yield 1.0
    print(f"Esc stopped with {there} of {expected} in the scene", flush=True)
    assert 2 <= there < expected, there
    assert len(bpy.context.scene.objects) == there, "files went on coming in"


drive.run(session())
