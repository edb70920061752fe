"""What the sidebar shows of a marker set."""

from __future__ import annotations

from pathlib import Path

import bpy
import numpy as np
import pytest

import motion_theater
from tests import harness
from tests.panels.recorder import draw

panel = harness.module("panels.markers").MOTION_THEATER_PT_markers


@pytest.fixture
def marker_set(tmp_path: Path) -> bpy.types.Object:
    """Return a marker set of three markers, one with a gap."""
    points = np.repeat(np.array([(0, 0, 1.7), (0, 0.1, 1.5), (0, 0, 0)], np.float64)[:, None], 20, axis=1)
    points[0, 5:9] = np.nan
    path = tmp_path / "three.trc"
    path.write_bytes(motion_theater.Markers(["a", "b", "c"], points, rate_hz=100.0).to_bytes("trc"))
    bpy.ops.motion_theater.import_markers(filepath=str(path), rate="SCENE", with_lines=True)
    return harness.armature()


def test_it_shows_only_for_a_marker_set() -> None:
    assert not panel.poll(bpy.context)
    harness.import_human()
    assert not panel.poll(bpy.context)


def test_it_says_what_is_there_and_offers_what_can_be_done(marker_set: bpy.types.Object) -> None:
    assert panel.poll(bpy.context)
    layout = draw(panel, bpy.context)
    assert "3 markers at 100 Hz from three.trc" in layout.texts()
    assert "1 gap" in layout.texts()
    offered = set(layout.names("operator"))
    names = ("fill_gaps", "filter_markers", "marker_lines", "marker_events", "marker_analog")
    assert offered == {f"motion_theater.{name}" for name in names}
    assert not layout.find("motion_theater.fill_gaps", how="RIGID").properties["selected_only"]


def test_in_pose_mode_buttons_act_on_the_selected_markers(marker_set: bpy.types.Object) -> None:
    bpy.ops.object.mode_set(mode="POSE")
    layout = draw(panel, bpy.context)
    assert layout.find("motion_theater.filter_markers").properties["selected_only"]
    assert layout.find("motion_theater.fill_gaps", how="LINEAR").properties["selected_only"]


def test_the_lines_lead_to_their_marker_set(marker_set: bpy.types.Object) -> None:
    lines = marker_set.motion_theater_markers.lines
    assert lines is not None
    bpy.context.view_layer.objects.active = lines
    assert panel.poll(bpy.context)
    assert f"\n{marker_set.name}\n" in f"\n{draw(panel, bpy.context).texts()}\n"


def test_a_custom_depth_is_asked_for(marker_set: bpy.types.Object) -> None:
    bpy.context.window_manager.motion_theater.depth = "CUSTOM"
    layout = draw(panel, bpy.context)
    assert "custom_depth" in layout.names("prop")
    assert layout.find("motion_theater.filter_markers").properties["depth"] == 9
