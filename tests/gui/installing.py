"""Switching the extension on, off and on again in the window leaves nothing behind."""

from __future__ import annotations

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2]))

import bpy
import drive

from tests.gui import hand, stage


def ours() -> set[str]:
    """Return the names of our classes that Blender knows."""
    return {name for name in dir(bpy.types) if name.startswith("MOTION_THEATER_")}


def session() -> hand.Session:
    """Install, use, disable, look, enable, use."""
    stage.install()
    there = ours()
    yield from stage.empty_scene()
    bpy.ops.motion_theater.import_skeleton(filepath=f"{stage.TESTDATA}/human.asf")
    bpy.ops.motion_theater.add_track(filepath=f"{stage.TESTDATA}/wave.amc")
    yield from hand.open_tab()
    before = stage.state()

    bpy.ops.preferences.addon_disable(module=stage.MODULE)
    yield from hand.settle()
    assert not ours(), ours()
    assert not hasattr(bpy.types.Object, "motion_theater")
    ob = stage.armature()
    assert ob.animation_data.action, "the motion does not play without the extension"
    yield from hand.shot("installing-disabled")

    bpy.ops.preferences.addon_enable(module=stage.MODULE)
    yield from hand.open_tab()
    assert ours() == there
    assert stage.state() == before, "the stack did not survive disabling and enabling"
    yield from hand.press("motion_theater.entry_duplicate", column=0.83)
    assert len(ob.motion_theater.entries) == 2
    yield from hand.shot("installing-enabled")


drive.run(session())
