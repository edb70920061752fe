"""Markers, joints and objects go out as recordings that give them back."""

from __future__ import annotations

from pathlib import Path

import bpy
import numpy as np
import pytest

import motion_theater
from tests import harness
from tests.scene.test_markers import (
    FORMATS,
    FRAMES,
    NAMES,
    RATE_HZ,
    REAL,
    expected,
    import_markers,
    positions,
    recording,
    shown,
    written,
)

TOLERANCE_M = 1e-5
operators = bpy.ops.motion_theater
with_analog = [path for path in REAL if path.name == "FP_Type1.c3d"]


def exported(folder: Path, kind: str = "c3d", **options: object) -> motion_theater.Markers:
    """Export what is active or selected, and read the file."""
    path = folder / f"out.{kind}"
    getattr(operators, f"export_{kind}")(filepath=str(path), **options)
    return motion_theater.read(path).markers


def in_metres(markers: motion_theater.Markers) -> np.ndarray:
    """Return (markers, frames, 3) of a file, in its own axes."""
    return markers.positions.astype(np.float64) * markers.unit_m


def assert_same(some: motion_theater.Markers, others: np.ndarray) -> None:
    """Compare the places in a file with others, in metres and the same axes: gaps are gaps."""
    places = in_metres(some)
    assert np.array_equal(np.isnan(places), np.isnan(others))
    assert np.nanmax(np.abs(places - others)) <= TOLERANCE_M


def message(capfd: pytest.CaptureFixture[str]) -> str:
    """Return what an operator reported; Blender prints it."""
    return capfd.readouterr().out


@pytest.mark.parametrize("rate", ["SCENE", "SAMPLES"])
@pytest.mark.parametrize("kind", FORMATS)
def test_a_marker_set_comes_back_with_places_gaps_names_and_rate(tmp_path: Path, kind: str, rate: str) -> None:
    original = motion_theater.read(written(tmp_path)).markers
    import_markers(tmp_path / "walk.c3d", rate=rate)
    markers = exported(tmp_path, kind, up="AUTO") if kind != "csm" else exported(tmp_path, kind)
    assert np.isnan(original.positions).any()
    assert_same(markers, in_metres(original))
    assert markers.rate_hz == pytest.approx(RATE_HZ, rel=1e-6)
    assert (markers.frames, markers.first_frame, markers.unit_m) == (FRAMES, 1, 0.001)
    plain = [name.replace(" ", "_") for name in NAMES]
    assert markers.names == (NAMES if kind == "c3d" else plain)


@pytest.mark.parametrize("rate", ["SCENE", "SAMPLES"])
@pytest.mark.parametrize("path", REAL, ids=lambda path: path.name)
def test_real_recordings_come_back(path: Path, rate: str, tmp_path: Path) -> None:
    try:
        original = motion_theater.read(path).markers
    except motion_theater.ParseError:
        return
    if original is None or "POSITION" not in original.kinds or not original.frames:
        return
    import_markers(path, rate=rate, with_events=True)
    chosen = [at for at, kind in enumerate(original.kinds) if kind == "POSITION"]
    markers = exported(tmp_path)
    assert markers.names == [original.names[at] for at in chosen]
    wanted = in_metres(original)[chosen]
    assert (markers.frames, markers.first_frame) == (original.frames, max(1, original.first_frame))
    assert np.array_equal(np.isnan(in_metres(markers)), np.isnan(wanted))
    far = np.abs(in_metres(markers) - wanted)
    assert not (far > np.maximum(TOLERANCE_M, np.abs(wanted) * 1e-6)).any(), np.nanmax(far)
    moments = [(event.label, event.context, event.subject) for event in original.events]
    kept = [(event.label, event.context, event.subject) for event in markers.events]
    assert sorted(set(kept)) == sorted(set(moments) & set(kept))


def test_events_keep_their_moment_and_their_words(tmp_path: Path) -> None:
    given = [("Foot Strike", 0.1, "Left", "Anna"), ("Foot Off", 0.3137, "Right", "")]
    path = tmp_path / "walk.c3d"
    made = motion_theater.Markers(NAMES, positions(), rate_hz=RATE_HZ, unit_m=0.001, events=given)
    path.write_bytes(made.to_bytes("c3d"))
    import_markers(path, rate="SAMPLES", with_events=True)
    found = [(event.label, event.time_s, event.context, event.subject) for event in exported(tmp_path).events]
    assert [(one[0], *one[2:]) for one in found] == [(one[0], *one[2:]) for one in given]
    assert [one[1] for one in found] == pytest.approx([0.1, 0.3137], abs=1e-6)


def test_events_that_were_moved_or_added_are_where_the_timeline_has_them(tmp_path: Path) -> None:
    import_markers(written(tmp_path), rate="SCENE", with_events=True)
    moved = bpy.context.scene.timeline_markers["Foot Off"]
    moved.frame = 40
    bpy.context.scene.timeline_markers.new("Clap", frame=11)
    bpy.context.scene.timeline_markers.new("Later", frame=2000)
    found = {event.label: event.time_s for event in exported(tmp_path).events}
    assert found == pytest.approx({"Foot Strike": 0.1, "Clap": 10 / RATE_HZ, "Foot Off": 39 / RATE_HZ}, abs=1e-6)
    assert not exported(tmp_path, with_events=False).events


@pytest.mark.parametrize("rate", ["SCENE", "SAMPLES"])
@pytest.mark.parametrize("path", with_analog, ids=lambda path: path.name)
def test_analog_channels_come_back(path: Path, rate: str, tmp_path: Path) -> None:
    original = motion_theater.read(path).markers
    import_markers(path, rate=rate, with_analog=True)
    markers = exported(tmp_path)
    assert markers.analog_samples_per_frame == original.analog_samples_per_frame
    assert [channel.unit for channel in markers.analog] == [channel.unit for channel in original.analog]
    for channel, known in zip(markers.analog, original.analog, strict=True):
        assert channel.name == known.name
        size = float(np.abs(known.samples).max())
        assert np.abs(channel.samples - known.samples).max() <= 1e-5 * size
    assert not exported(tmp_path, with_analog=False).analog


@pytest.mark.parametrize("kind", ["csm", "trc"])
def test_what_a_format_has_no_place_for_is_said(tmp_path: Path, kind: str, capfd: pytest.CaptureFixture[str]) -> None:
    ob = import_markers(written(tmp_path), rate="SCENE", with_events=True)
    ob["Force"] = 1.0
    ob.keyframe_insert('["Force"]', frame=1)
    exported(tmp_path, kind)
    said = message(capfd)
    assert f"A {kind.upper()} file has no place for 2 events and 1 analog channel" in said
    assert "became _ in right hand" in said


def test_what_of_the_file_is_not_in_the_scene_is_said(tmp_path: Path, capfd: pytest.CaptureFixture[str]) -> None:
    import_markers(written(tmp_path), rate="SCENE")
    exported(tmp_path)
    said = message(capfd)
    assert "Exported out.c3d: 5 markers, 60 frames at 120 Hz, 2 gaps in 1 marker" in said
    assert "Not in the scene, so not written: 2 events" in said


def test_edits_and_filled_gaps_go_out(tmp_path: Path) -> None:
    import_markers(written(tmp_path), rate="SCENE")
    operators.fill_gaps(how="LINEAR", longest=20)
    filled, _ = motion_theater.read(tmp_path / "walk.c3d").markers.filled(how="LINEAR", longest=20)
    assert_same(exported(tmp_path), in_metres(filled))


@pytest.mark.parametrize("up", ["X", "Y", "Z", "-X", "-Y", "-Z"])
def test_up_and_unit_are_chosen(tmp_path: Path, up: str) -> None:
    ob = import_markers(written(tmp_path, with_gaps=False), rate="SCENE", up="Y")
    markers = exported(tmp_path, up=up, unit="0.01")
    assert markers.unit_m == 0.01
    back = import_markers(tmp_path / "out.c3d", rate="SCENE", up=up)
    for frame in (1, 30, 60):
        assert np.abs(shown(back, frame) - shown(ob, frame)).max() <= TOLERANCE_M


@pytest.mark.parametrize(("up", "forward"), [("Z", "X"), ("Y", "-X"), ("-X", "Y")])
def test_a_set_that_was_turned_to_the_viewer_is_written_as_in_its_file(tmp_path: Path, up: str, forward: str) -> None:
    import_markers(written(tmp_path), rate="SCENE", up=up, forward=forward)
    original = in_metres(motion_theater.read(tmp_path / "walk.c3d").markers)
    assert_same(exported(tmp_path), original)


def test_range_and_rate_are_chosen(tmp_path: Path) -> None:
    import_markers(written(tmp_path), rate="SCENE", with_events=True)
    original = in_metres(motion_theater.read(tmp_path / "walk.c3d").markers)
    part = exported(tmp_path, range="CUSTOM", frame_start=11, frame_end=40)
    assert (part.frames, part.first_frame) == (30, 11)
    assert_same(part, original[:, 10:40])
    assert [event.time_s for event in part.events] == pytest.approx([0.1, 0.3], abs=1e-6)
    finer = exported(tmp_path, rate_hz=240.0)
    assert (finer.frames, finer.rate_hz) == (2 * FRAMES - 1, 240.0)
    seen = ~np.isnan(in_metres(finer)[:, :, 0])
    assert np.array_equal(seen[:, 0::2], ~np.isnan(original[:, :, 0]))
    assert np.array_equal(seen[:, 1::2], seen[:, :-2:2] & seen[:, 2::2]), "between two samples only if both were seen"
    coarse = exported(tmp_path, rate_hz=60.0)
    assert (coarse.frames, coarse.rate_hz) == (FRAMES // 2, 60.0)
    assert np.nanmax(np.abs(in_metres(coarse) - original[:, ::2])) < 2e-3


def test_an_armature_that_was_moved_goes_out_where_it_stands(tmp_path: Path) -> None:
    ob = import_markers(written(tmp_path), rate="SCENE")
    ob.location, ob.scale = (1.0, 2.0, 3.0), (2.0, 2.0, 2.0)
    bpy.context.view_layer.update()
    original = expected(motion_theater.read(tmp_path / "walk.c3d").markers)
    assert_same(exported(tmp_path), original * 2.0 + (1.0, 2.0, 3.0))


def test_constraints_decide_over_markers_too_and_the_current_frame_stays(tmp_path: Path) -> None:
    ob = import_markers(written(tmp_path), rate="SCENE")
    target = bpy.data.objects.new("Target", None)
    bpy.context.scene.collection.objects.link(target)
    target.location = (5.0, 6.0, 7.0)
    ob.pose.bones["head"].constraints.new("COPY_LOCATION").target = target
    bpy.context.scene.frame_set(7)
    wanted = in_metres(motion_theater.read(tmp_path / "walk.c3d").markers)
    wanted[NAMES.index("head")] = (5.0, 6.0, 7.0)
    assert_same(exported(tmp_path), wanted)
    assert bpy.context.scene.frame_current == 7


def test_selected_markers_only(tmp_path: Path) -> None:
    ob = import_markers(written(tmp_path), rate="SCENE")
    harness.select(ob, ["pelvis", "head"])
    assert exported(tmp_path, selected_only=True).names == ["head", "pelvis"]
    harness.select(ob, [])
    assert "No bones are selected" in harness.refusal(lambda: exported(tmp_path, selected_only=True))


@pytest.mark.parametrize("kind", FORMATS)
def test_joints_of_an_armature_are_markers(tmp_path: Path, kind: str) -> None:
    ob = harness.import_human()
    harness.add("walk.amc")
    markers = exported(tmp_path, kind)
    last = {bone.name for bone in ob.data.bones if not bone.children and bone.name != "root"}
    names = [name for bone in ob.data.bones for name in (bone.name, *([f"{bone.name}_End"] * (bone.name in last)))]
    assert markers.names == names
    back = import_markers(tmp_path / f"out.{kind}", rate="SCENE", up="Y" if kind == "trc" else "Z")
    bones = {name: number for number, name in enumerate(ob.pose.bones.keys())}
    for frame in (1, 20):
        matrices, places = harness.pose(ob, frame), shown(back, frame)
        bpy.context.view_layer.update()
        for place, name in zip(places, names, strict=True):
            bone = bones[name.removesuffix("_End")]
            local = [0.0, ob.data.bones[bone].length if name.endswith("_End") else 0.0, 0.0, 1.0]
            assert np.abs(matrices[bone] @ local - [*place, 1.0]).max() < 1e-4, name


def test_tails_have_the_names_of_their_bones(tmp_path: Path) -> None:
    harness.import_human()
    ob = harness.add("walk.amc")
    markers = exported(tmp_path, joints="TAILS")
    assert markers.names == [bone.name for bone in ob.data.bones]
    bpy.context.scene.frame_set(int(markers.first_frame))
    at = markers.names.index("lfoot") if "lfoot" in markers.names else 1
    tail = ob.pose.bones[markers.names[at]].tail
    assert np.abs(in_metres(markers)[at, 0] - np.array(tail)).max() < 1e-4


def test_objects_are_markers_and_one_without_size_is_not_seen(tmp_path: Path) -> None:
    scene = bpy.context.scene
    scene.frame_start, scene.frame_end, scene.render.fps = 1, 11, 25
    root = bpy.data.objects.new("Root", None)
    ball = bpy.data.objects.new("Ball", None)
    for ob in (root, ball):
        scene.collection.objects.link(ob)
        ob.select_set(True)
    ball.parent = root
    ball.location = (0.5, 0.0, 0.0)
    for frame, height in ((1, 1.0), (11, 2.0)):
        root.location.z = height
        root.keyframe_insert("location", frame=frame)
    for frame, size in ((1, 1.0), (5, 0.0), (8, 1.0)):
        ball.scale = (size,) * 3
        ball.keyframe_insert("scale", frame=frame)
    curves = harness.fcurves(ball)
    for curve in curves.values():
        for key in curve.keyframe_points:
            key.interpolation = "CONSTANT"
    markers = exported(tmp_path)
    assert markers.names == ["Ball", "Root"] or markers.names == ["Root", "Ball"]
    assert (markers.rate_hz, markers.frames, markers.unit_m) == (25.0, 11, 0.001)
    places = dict(zip(markers.names, in_metres(markers), strict=True))
    assert np.flatnonzero(np.isnan(places["Ball"][:, 0])).tolist() == [4, 5, 6]
    for frame in (1, 4, 9):
        scene.frame_set(frame)
        for ob in (root, ball):
            assert np.abs(places[ob.name][frame - 1] - np.array(ob.matrix_world.translation)).max() < TOLERANCE_M


def test_nothing_to_export_is_told_before() -> None:
    assert not operators.export_c3d.poll()


def test_a_set_made_by_a_script_comes_back_without_its_file(tmp_path: Path) -> None:
    path = written(tmp_path)
    import_markers(path, rate="SCENE", with_events=True)
    path.unlink()
    markers = exported(tmp_path)
    assert_same(markers, in_metres(recording()).astype(np.float64))
    assert [event.label for event in markers.events] == ["Foot Strike", "Foot Off"]
