"""A marker set in the window: points that can be clicked, their names and lines, gaps filled and noise filtered."""

from __future__ import annotations

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2]))

import bpy
import drive
from bpy_extras import view3d_utils

from tests.gui import hand, stage

IN_GAP = 41


def on_screen(bone: str) -> tuple[int, int]:
    """Return where a marker is in the window."""
    ob, region = stage.armature(), drive.region("WINDOW")
    place = ob.matrix_world @ ob.pose.bones[bone].head
    seen = view3d_utils.location_3d_to_region_2d(region, drive.area().spaces.active.region_3d, place)
    return region.x + int(seen.x), region.y + int(seen.y)


def message() -> str:
    """Return what the panel says."""
    return str(stage.armature().motion_theater_markers.message)


def session() -> hand.Session:
    """Import, look, select, fill, filter, undo."""
    stage.install()
    from tests.gui import recordings  # needs the native module, which comes with the extension

    yield from stage.empty_scene()
    recordings.folder()
    scene = bpy.context.scene
    bpy.ops.motion_theater.import_markers(
        filepath=str(recordings.FOLDER / "figure.c3d"), rate="SCENE", with_lines=True, with_events=True
    )
    stage.keep_step("Imported")
    yield from stage.look_from_the_front()
    yield from hand.open_tab()
    yield from hand.shot("markers-imported")

    yield from stage.enter_pose_mode()
    scene.frame_set(10)
    yield from hand.settle()
    yield from drive.click(*on_screen("lhand"))
    yield 0.3
    assert stage.selected_bones() == {"lhand"}, stage.selected_bones()
    yield from hand.shot("markers-selected")
    scene.frame_set(IN_GAP)
    yield from hand.shot("markers-gap")

    before = stage.state()
    yield from drive.key("A")
    yield from hand.press("motion_theater.fill_gaps(how='CUBIC'", column=0.5)
    assert "Filled 2 of 3 gaps" in message(), message()
    yield from hand.shot("markers-filled")
    filled = stage.state()
    yield from hand.press("motion_theater.filter_markers(")
    assert message().startswith("Filtered"), message()
    assert stage.state() != filled
    yield from hand.shot("markers-filtered")
    for expected in (filled, before):
        yield from drive.key("Z", ctrl=True)
        yield 0.6
        assert stage.state() == expected, "one Ctrl+Z for one action"


drive.run(session())
