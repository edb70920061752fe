"""The tutorial in the window, with mouse and keys, then all the way back with Ctrl+Z and forward with Shift+Ctrl+Z.

By hand: everything pressed, typed, dragged and chosen, the file browser included. By script: the installation, the
scene's rate, the frame that a picture shows, and rest position while the arms are picked with a box.
"""

from __future__ import annotations

import sys
import time
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2]))

import bpy
import drive

from tests.gui import hand, stage

LEGS = {"root"} | {
    f"{side}{bone}" for side in "lr" for bone in ("hipjoint", "femur", "tibia", "foot", "toes")
}  # what tracks move; hip joints have no data of their own
ARMS = {f"{side}{bone}" for side in "lr" for bone in ("humerus", "radius", "wrist", "hand", "fingers", "thumb")}

began = time.monotonic()
states: list[stage.State] = []


def note_state() -> None:
    """Keep the motion as it is now, for the way back and forth."""
    now = stage.state()
    assert not states or now != states[-1], "the step changed nothing"
    states.append(now)


def box(left: int, bottom: int, right: int, top: int, **modifiers: bool) -> hand.Session:
    """Press B and drag a box over the 3D View, in pixels of it: it adds to the selection, with Shift it takes away."""
    yield from drive.key("B")
    view = drive.region("WINDOW")
    window = drive.window()
    x, y = view.x + left, view.y + bottom
    drive.move(x - 4, y - 4)
    yield 0.1
    drive.move(x, y)
    yield 0.1
    window.event_simulate(type="LEFTMOUSE", value="PRESS", x=x, y=y, **modifiers)
    for share in range(1, 13):
        yield 0.03
        x, y = view.x + left + (right - left) * share // 12, view.y + bottom + (top - bottom) * share // 12
        window.event_simulate(type="MOUSEMOVE", value="NOTHING", x=x, y=y, **modifiers)
    window.event_simulate(type="LEFTMOUSE", value="RELEASE", x=x, y=y, **modifiers)
    yield 0.4


def add_track(filename: str) -> hand.Session:
    """Press Add Motion Track and choose the file."""
    yield from hand.press("motion_theater.add_track(")
    yield from hand.choose_file(stage.TESTDATA, filename)


def picture(name: str, frame: int) -> hand.Session:
    """Take a picture of the window at a frame of the motion."""
    print(f"{time.monotonic() - began:6.1f} s  {name}", flush=True)
    bpy.context.scene.frame_set(frame)
    yield from drive.key("HOME")
    yield 0.6
    yield from hand.scroll("WHEELUPMOUSE", notches=40)
    yield from hand.shot(name)


def import_skeleton() -> hand.Session:
    """Step 1: the setup pose."""
    yield from hand.press("motion_theater.import_skeleton")
    yield from hand.settle()
    drive.screenshot("tutorial-1-file-browser")
    yield from hand.choose_file(stage.TESTDATA, "human.asf")
    assert len(stage.armature().data.bones) == 31
    note_state()
    yield from stage.look_from_the_front()
    yield from picture("tutorial-1-skeleton", 1)


def legs() -> hand.Session:
    """Step 2: the jump on root, hips and legs."""
    yield from stage.enter_pose_mode()
    yield from box(300, 100, 1000, 500)
    yield from box(600, 510, 720, 530, shift=True)  # the lowest bone of the back begins where the hips do
    assert stage.selected_bones() == LEGS, stage.selected_bones() ^ LEGS
    yield from hand.tick("motion_theater.selected_only")
    yield from hand.shot("tutorial-2-legs-selected")
    yield from add_track("step_and_jump.amc")
    entry = stage.armature().motion_theater.entries[0]
    assert set(entry.bones.split("\n")) == LEGS
    note_state()
    yield from picture("tutorial-2-legs-move", 60)


def upper_body() -> hand.Session:
    """Steps 3 and 4: the wave on the upper body up to frame 66, then the jump with a blend."""
    yield from drive.key("I", ctrl=True)
    assert not stage.selected_bones() & LEGS
    for name, value in {"cut_start": 1, "cut_end": 55, "scale_start": 1, "scale_end": 66}.items():
        yield from hand.enter_number(f"motion_theater.{name}", value)
    yield from add_track("wave.amc")
    note_state()
    yield from picture("tutorial-3-wave", 40)

    values = {"cut_start": 67, "cut_end": 113, "scale_start": 0, "scale_end": 0, "blend_depth": 10}
    for name, value in values.items():
        yield from hand.enter_number(f"motion_theater.{name}", value)
    yield from add_track("step_and_jump.amc")
    note_state()
    yield from picture("tutorial-4-blend", 66)


def filter_arms() -> hand.Session:
    """Step 5: the weighted average over seven values on both arms."""
    stage.armature().data.pose_position = "REST"
    yield from drive.key("HOME")
    yield from hand.settle()
    yield from drive.key("A", alt=True)
    yield from box(300, 600, 1010, 690)
    yield from box(600, 560, 715, 740, shift=True)
    stage.armature().data.pose_position = "POSE"
    assert stage.selected_bones() == ARMS, stage.selected_bones() ^ ARMS
    yield from choose_filter()
    yield from hand.press("motion_theater.filter(", column=0.25)
    note_state()
    yield from picture("tutorial-5-filtered", 66)


def choose_filter() -> hand.Session:
    """Click Weighted Average and 7."""
    x, y = yield from hand.find_field("motion_theater.filter_kind")
    yield from drive.click(x, y - 42)  # the third of three choices, one below the other
    ui = drive.region("UI")
    _, y = yield from hand.find_field("motion_theater.depth")
    yield from drive.click(ui.x + int(0.72 * ui.width), y)
    form = bpy.context.window_manager.motion_theater
    assert (form.filter_kind, form.depth) == ("WEIGHTED", "7"), (form.filter_kind, form.depth)


def walk(keys: dict[str, bool], targets: list[stage.State]) -> hand.Session:
    """Press Ctrl+Z, or Shift+Ctrl+Z, until every target was reached, in its turn and bit for bit."""
    presses, at = 0, stage.state()
    for target in targets:
        while True:
            yield from drive.key("Z", ctrl=True, **keys)
            yield 0.3
            presses += 1
            now = stage.state()
            if now == target:
                break
            assert now == at, "undo or redo led to a motion that was never there"
            assert presses < 60, "a state was not reached"
        at = target
    print(f"{len(targets)} states in {presses} presses", flush=True)


def session() -> hand.Session:
    """The five steps, and back, and forth."""
    stage.install()
    yield from stage.empty_scene()
    note_state()
    yield from hand.open_tab()
    yield from hand.shot("tutorial-0-empty")
    yield from import_skeleton()
    yield from legs()
    yield from upper_body()
    yield from filter_arms()
    yield from walk({}, states[-2::-1])
    yield from hand.shot("tutorial-6-undone")
    yield from walk({"shift": True}, states[1:])
    yield from hand.shot("tutorial-7-redone")


drive.run(session())
