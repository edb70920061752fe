"""What every session in the window begins with, and how two states of the motion are compared."""

from __future__ import annotations

import shutil
from pathlib import Path

import addon_utils
import bpy
import drive
import numpy as np

from tests.gui import hand

PROJECT = Path("/project")
TESTDATA = str(PROJECT / "testdata")
MODULE = "bl_ext.user_default.motion_theater"
KEY_FIELDS = {"co": 2, "handle_left": 2, "handle_right": 2}

State = dict[str, bytes]


def install() -> None:
    """Install the built extension, as *Install from Disk* does, in place of what an earlier session left.

    Blender unpacks a wheel only if it has none of that version yet, so an older build is taken away first. The user
    folder belongs to the windowed Blender of the tests alone.
    """
    shutil.rmtree(bpy.utils.user_resource("EXTENSIONS"), ignore_errors=True)
    package = max(PROJECT.glob("dist/motion_theater-*-linux-x64.zip"))
    bpy.ops.extensions.package_install_files(
        filepath=str(package), repo="user_default", enable_on_install=True, overwrite=True
    )
    assert addon_utils.check(MODULE)[1], "the extension was not enabled: see the messages above"
    assert hasattr(bpy.types, "MOTION_THEATER_PT_stack"), "the native module was not loaded: see the messages above"


def empty_scene(rate_hz: int = 60) -> hand.Session:
    """Delete what a new file holds, with the keys a user would press; the scene runs at the clips' rate."""
    bpy.context.preferences.view.filebrowser_display_type = "SCREEN"
    bpy.context.scene.render.fps = rate_hz
    yield from drive.key("A")
    yield from drive.key("DEL")
    yield 0.3
    assert not bpy.data.objects, "the scene is not empty"


def armature() -> bpy.types.Object:
    """Return the armature of the scene."""
    return next(ob for ob in bpy.context.scene.objects if ob.type == "ARMATURE")


def state() -> State:
    """Return the motion of all armatures, bit for bit; nothing for an empty scene."""
    found: State = {}
    for ob in bpy.context.scene.objects:
        found[ob.name] = ob.type.encode()
        action = ob.animation_data.action if ob.animation_data else None
        bags = [bag for layer in action.layers for strip in layer.strips for bag in strip.channelbags] if action else []
        for curve in (curve for bag in bags for curve in bag.fcurves):
            points = curve.keyframe_points
            for field, width in KEY_FIELDS.items():
                values = np.empty(width * len(points), np.float32)
                points.foreach_get(field, values)
                found[f"{ob.name} {curve.data_path} {curve.array_index} {field}"] = values.tobytes()
        for number, entry in enumerate(ob.motion_theater.entries):
            found[f"{ob.name} entry {number}"] = f"{entry.name} {entry.kind} {entry.enabled}".encode()
    return found


def enter_pose_mode() -> hand.Session:
    """Press Ctrl+Tab over the 3D View."""
    yield from drive.key("TAB", ctrl=True)
    yield 0.5
    assert bpy.context.mode == "POSE"


def look_from_the_front() -> hand.Session:
    """Press Numpad 1 and Home."""
    yield from drive.key("NUMPAD_1")
    yield 0.6
    yield from drive.key("HOME")
    yield 0.6


def selected_bones() -> set[str]:
    """Return the names of the selected bones."""
    return {bone.name for bone in armature().pose.bones if bone.select}


def keep_step(name: str) -> None:
    """End a preparation made by script as one undo step."""
    bpy.ops.ed.undo_push(message=name)


def prepared() -> hand.Session:
    """Install, empty the scene, import the skeleton and add two tracks: where the other sessions begin."""
    install()
    yield from empty_scene()
    bpy.ops.motion_theater.import_skeleton(filepath=f"{TESTDATA}/human.asf")
    bpy.ops.motion_theater.add_track(filepath=f"{TESTDATA}/step_and_jump.amc")
    bpy.ops.motion_theater.add_track(
        filepath=f"{TESTDATA}/wave.amc", cut_start=1, cut_end=55, scale_start=1, scale_end=66
    )
    yield from look_from_the_front()
    yield from enter_pose_mode()
    yield from hand.open_tab()
    keep_step("Prepared")
