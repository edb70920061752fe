"""The panel in its states, as pictures to look at: lists, alerts, greyed buttons, tooltips, redo panel, error texts."""

from __future__ import annotations

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2]))

import bpy
import drive

from tests.gui import hand, stage


def tooltip(command: str, name: str, **where: float) -> hand.Session:
    """Rest the mouse on a button until its tooltip shows."""
    x, y = yield from hand.find_operator(command, **where)
    drive.move(x - 6, y)
    yield 0.2
    drive.move(x, y)
    yield 2.0
    drive.screenshot(name)


def hand_edits() -> hand.Session:
    """Move a key, change a setting in the panel, and keep the edits."""
    ob = stage.armature()
    action = ob.animation_data.action
    curves = action.layers[0].strips[0].channelbags[0].fcurves
    curve = next(curve for curve in curves if "lhumerus" in curve.data_path)
    curve.keyframe_points[10].co.y += 0.3
    curve.update()
    edited = stage.state()
    yield from hand.enter_number("entries[1].blend_depth", 5)
    assert ob.motion_theater.hand_edited == "lhumerus"
    assert stage.state() == edited, "hand edits were overwritten"
    yield from hand.scroll("WHEELUPMOUSE", notches=40)
    yield from hand.shot("panels-hand-edits")
    yield from hand.press("motion_theater.keep_edits")
    assert ob.motion_theater.entries[-1].kind == "KEPT"
    yield from hand.shot("panels-kept")


def redo_panel() -> hand.Session:
    """Filter everything, then look at the options under F9."""
    yield from hand.press("motion_theater.filter(", column=0.75)
    assert stage.armature().motion_theater.entries[-1].kind == "FILTER"
    yield from drive.key("F9")
    yield 1.0
    drive.screenshot("panels-redo")
    yield from drive.key("ESC")


def missing_source() -> hand.Session:
    """Let the file of a track vanish."""
    motion = stage.armature().motion_theater
    motion.active = 1
    motion.entries[1].source = "/project/testdata/moved_away.amc"
    yield from hand.scroll("WHEELUPMOUSE", notches=40)
    yield from hand.shot("panels-missing-source")
    yield from hand.press("motion_theater.relink_source")
    yield from hand.choose_file(stage.TESTDATA, "wave.amc")
    assert not motion.entries[1].error
    yield from hand.shot("panels-relinked")


def bad_file() -> hand.Session:
    """Choose a file that is none: the message says what is wrong, and nothing changes."""
    broken = Path("/tmp/broken.amc")
    broken.write_text(":FULLY-SPECIFIED\n:DEGREES\n1\nroot 1 2 three 4 5 6\n")
    before = stage.state()
    yield from hand.press("motion_theater.add_track(")
    yield from hand.choose_file("/tmp", broken.name)
    drive.screenshot("panels-bad-file")
    yield from drive.key("ESC")
    yield 0.5
    assert stage.state() == before


def dropped_file() -> hand.Session:
    """Call the operator as a drop into the 3D View does: a dialog asks for the options, Enter confirms it."""
    motion = stage.armature().motion_theater
    count = len(motion.entries)
    view = drive.region("WINDOW")
    with bpy.context.temp_override(window=drive.window(), area=drive.area(), region=view):
        bpy.ops.motion_theater.add_track("INVOKE_DEFAULT", filepath=f"{stage.TESTDATA}/turn.amc")
    yield 1.0
    drive.screenshot("panels-drop")
    yield from hand.tap("RET")
    yield 1.0
    assert len(motion.entries) == count + 1, "the dialog was not confirmed"


def session() -> hand.Session:
    """All states, one after the other."""
    stage.install()
    yield from stage.empty_scene()
    yield from hand.open_tab()
    yield from hand.shot("panels-nothing")
    yield from tooltip("motion_theater.import_skeleton", "panels-tooltip")
    yield from tooltip("motion_theater.filter(", "panels-greyed", column=0.25)

    yield from stage.prepared()
    yield from hand.shot("panels-tracks")
    yield from hand_edits()
    yield from redo_panel()
    yield from missing_source()
    yield from bad_file()
    yield from dropped_file()


drive.run(session())
