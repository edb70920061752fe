"""A marker set holds what its file holds, shows nothing that was not seen, and can be mended."""

from __future__ import annotations

import math
from pathlib import Path

import bpy
import numpy as np
import pytest

import motion_theater
from tests import harness

axes = harness.module("logic.axes")
trajectories = harness.module("logic.trajectories")
FORMATS = ("c3d", "csm", "trc")
REAL = sorted(
    path
    for pattern in ("c3d/**/*", "csm/*", "trc/*", "other/*")
    for path in (harness.SHARED.glob(pattern) if harness.SHARED.is_dir() else ())
    if path.suffix.lower() in {".c3d", ".csm", ".trc"}
)
RATE_HZ = 120.0
FRAMES = 60
NAMES = ["head", "left:hand", "right hand", "sternum", "pelvis"]


def positions() -> np.ndarray:
    """Return (markers, frames, 3) in millimeters: a body that walks and turns, with a hand that dropped out twice."""
    at = np.arange(FRAMES) / RATE_HZ
    body = np.array([(0, 0, 1700), (200, 100, 1500), (-200, 120, 1500), (0, 130, 1400), (20, 0, 950)], np.float64)
    angle = 0.4 * np.sin(2.0 * at)
    turned = np.empty((len(body), FRAMES, 3))
    turned[:, :, 0] = body[:, :1] * np.cos(angle) - body[:, 1:2] * np.sin(angle) + 1200.0 * at
    turned[:, :, 1] = body[:, :1] * np.sin(angle) + body[:, 1:2] * np.cos(angle)
    turned[:, :, 2] = body[:, 2:] + 20.0 * np.cos(9.0 * at)
    return turned


def recording(*, with_gaps: bool = True) -> motion_theater.Markers:
    """Return the body as a recording."""
    points = positions()
    if with_gaps:
        points[1, 10:16] = points[1, 30:50] = np.nan
        points[2, :5] = np.nan
    events = [("Foot Strike", 0.1), ("Foot Off", 0.3)]
    return motion_theater.Markers(NAMES, points, rate_hz=RATE_HZ, unit_m=0.001, events=events)


def written(folder: Path, kind: str = "c3d", *, with_gaps: bool = True) -> Path:
    path = folder / f"walk.{kind}"
    path.write_bytes(recording(with_gaps=with_gaps).to_bytes(kind))  # type: ignore[arg-type]
    return path


def import_markers(path: Path, **options: object) -> bpy.types.Object:
    bpy.ops.motion_theater.import_markers(filepath=str(path), **options)
    return harness.armature()


def expected(markers: motion_theater.Markers) -> np.ndarray:
    """Return the positions of a file in meters, Z up, for the points that are positions; NaN where not seen."""
    chosen = [at for at, kind in enumerate(markers.kinds) if kind == "POSITION"]
    points = markers.positions[chosen].astype(np.float64) * markers.unit_m
    x, y, z = np.moveaxis(points, -1, 0)
    turned = {"X": (-z, y, x), "Y": (x, -z, y), "Z": (x, y, z), "-X": (z, y, -x), "-Y": (x, z, -y), "-Z": (x, -y, -z)}
    return np.stack(turned[axes.nearest_axis(markers.up)], axis=-1)


def shown(ob: bpy.types.Object, frame: float) -> np.ndarray:
    """Return (bones, 3): where Blender shows each marker on a scene frame; NaN where it shows none."""
    matrices = harness.pose(ob, frame)
    places = matrices[:, :3, 3].copy()
    places[np.abs(matrices[:, :3, :3]).max(axis=(1, 2)) == 0.0] = np.nan
    return places


def check_against_file(ob: bpy.types.Object, markers: motion_theater.Markers, *, step: float = 1.0) -> None:
    """Compare what is shown on a few dozen samples, and on all about gaps, with the file."""
    wanted = expected(markers)
    edges = {at for _, start, end in markers.gaps() for at in (start - 1, start, end - 1, end)}
    spread = range(0, markers.frames, max(1, markers.frames // 20))
    looked_at = sorted(edges | set(spread) | {markers.frames - 1})[:200]
    for sample in looked_at:
        places = shown(ob, markers.first_frame + sample * step)
        assert np.array_equal(np.isnan(places), np.isnan(wanted[:, sample])), f"sample {sample}"
        far = np.abs(places - wanted[:, sample])
        assert not (far > 1e-5).any(), f"sample {sample}: {np.nanmax(far)} m away"


@pytest.mark.parametrize("kind", FORMATS)
def test_markers_are_where_the_file_says_and_only_when_they_were_seen(tmp_path: Path, kind: str) -> None:
    path = written(tmp_path, kind)
    ob = import_markers(path, rate="SCENE")
    markers = motion_theater.read(path).markers
    assert [bone.name for bone in ob.data.bones] == markers.names
    assert np.isnan(expected(markers)).any()
    check_against_file(ob, markers)


@pytest.mark.parametrize("path", REAL, ids=lambda path: path.name)
def test_real_files_are_shown_as_they_are(path: Path) -> None:
    try:
        markers = motion_theater.read(path).markers
    except motion_theater.ParseError as error:
        assert str(error) in harness.refusal(lambda: import_markers(path))
        return
    if markers is None or "POSITION" not in markers.kinds or not markers.frames:
        assert "holds" in harness.refusal(lambda: import_markers(path))
        return
    check_against_file(import_markers(path, rate="SCENE"), markers)


def test_samples_on_sub_frames_are_kept_one_by_one(tmp_path: Path) -> None:
    path = written(tmp_path)
    ob = import_markers(path, rate="SAMPLES")
    check_against_file(ob, motion_theater.read(path).markers, step=24.0 / RATE_HZ)


def test_resampling_takes_the_moment_of_each_scene_frame(tmp_path: Path) -> None:
    bpy.context.scene.render.fps = 50
    path = written(tmp_path, with_gaps=False)
    ob = import_markers(path)
    wanted = expected(motion_theater.read(path).markers)
    keys = harness.key_rows(ob, "head", "location")[:, 0]
    assert np.array_equal(keys, np.arange(1, 1 + math.floor((FRAMES - 1) * 50 / RATE_HZ) + 1))
    for frame in keys.tolist():
        at = (frame - 1) * RATE_HZ / 50
        low = math.floor(at)
        between = wanted[:, low] + (wanted[:, min(low + 1, FRAMES - 1)] - wanted[:, low]) * (at - low)
        assert np.abs(shown(ob, frame) - between).max() < 1e-5


def test_a_marker_without_gaps_has_no_curves_but_its_location(tmp_path: Path) -> None:
    ob = import_markers(written(tmp_path))
    of_bone = {bone: {path for path, _ in harness.fcurves(ob) if f'"{bone}"' in path} for bone in ("head", "left:hand")}
    assert {path.rpartition(".")[2] for path in of_bone["head"]} == {"location"}
    assert {path.rpartition(".")[2] for path in of_bone["left:hand"]} == {"location", "scale"}


def test_the_rest_pose_is_a_moment_of_the_recording(tmp_path: Path) -> None:
    path = written(tmp_path)
    ob = import_markers(path)
    wanted = expected(motion_theater.read(path).markers)
    frame = int(np.argmax(np.count_nonzero(~np.isnan(wanted[:, :, 0]), axis=0)))
    heads = np.array([bone.head_local for bone in ob.data.bones])
    assert np.abs(heads - wanted[:, frame]).max() < 1e-5


@pytest.mark.parametrize("up", ["X", "Y", "Z", "-X", "-Y", "-Z"])
def test_the_axis_that_the_user_chooses_points_up(tmp_path: Path, up: str) -> None:
    ob = import_markers(written(tmp_path, with_gaps=False), up=up, rate="SCENE")
    raw = positions()[:, 0] * 0.001
    places = shown(ob, 1)
    assert np.abs(places[:, 2] - raw[:, "XYZ".index(up[-1])] * (-1 if up[0] == "-" else 1)).max() < 1e-5
    lengths = [np.linalg.norm(points[1:] - points[:-1], axis=1) for points in (places, raw)]
    assert np.abs(lengths[0] - lengths[1]).max() < 1e-5
    turned = [np.linalg.det(points[1:4] - points[0]) for points in (places, raw)]
    assert turned[0] == pytest.approx(turned[1], abs=1e-5)  # turned, not mirrored


@pytest.mark.parametrize(("up", "forward"), [("Z", "X"), ("Z", "-Y"), ("Y", "-X"), ("-X", "Z"), ("Z", "Z")])
def test_the_axis_along_which_the_user_says_it_looks_comes_to_the_viewer(tmp_path: Path, up: str, forward: str) -> None:
    ob = import_markers(written(tmp_path, with_gaps=False), up=up, forward=forward, rate="SCENE")
    raw = positions()[:, 0] * 0.001
    along = {axis: raw[:, "XYZ".index(axis[-1])] * (-1 if axis[0] == "-" else 1) for axis in (up, forward)}
    places = shown(ob, 1)
    assert np.abs(places[:, 2] - along[up]).max() < 1e-5
    if up != forward:  # nobody looks upward: then nothing is turned
        assert np.abs(-places[:, 1] - along[forward]).max() < 1e-5
    turned = [np.linalg.det(points[1:4] - points[0]) for points in (places, raw)]
    assert turned[0] == pytest.approx(turned[1], abs=1e-5)
    message = ob.motion_theater_markers.message
    assert f"Facing: {forward}, as you chose" in message
    assert message.count("Facing") == 1


def test_what_the_file_says_of_itself_is_said_with_reasons_until_the_user_chooses(tmp_path: Path) -> None:
    path = written(tmp_path)
    facing = motion_theater.read(path).markers.facing()
    assert f"Facing: {facing.reason}" in import_markers(path).motion_theater_markers.message
    # Which way is front depends on which way is up.
    assert "Facing" not in import_markers(path, up="X").motion_theater_markers.message
    bpy.ops.motion_theater.import_motion_capture(filepath=str(path), forward="X")
    assert "Facing: X, as you chose" in harness.armature().motion_theater_markers.message


def test_names_that_are_alike_or_empty_are_kept_apart(tmp_path: Path) -> None:
    path = tmp_path / "same.c3d"
    markers = motion_theater.Markers(["a", "a", ""], positions()[:3], rate_hz=RATE_HZ, unit_m=0.001)
    path.write_bytes(markers.to_bytes("c3d"))
    ob = import_markers(path, rate="SCENE")
    assert len({bone.name for bone in ob.data.bones}) == 3
    check_against_file(ob, motion_theater.read(path).markers)


def test_lines_follow_the_markers_and_vanish_with_them(tmp_path: Path) -> None:
    ob = import_markers(written(tmp_path), rate="SCENE", with_lines=True)
    lines = ob.motion_theater_markers.lines
    assert {tuple(edge.vertices) for edge in lines.data.edges} == {(1, 3), (2, 3)}
    for frame, hidden in ((1, 1), (12, 1), (20, 0), (40, 1)):
        places = shown(ob, frame)
        evaluated = lines.evaluated_get(bpy.context.evaluated_depsgraph_get())
        vertices = np.array([vertex.co for vertex in evaluated.data.vertices])
        assert np.count_nonzero(np.isnan(places[:, 0])) == hidden
        assert np.abs(vertices - places[~np.isnan(places[:, 0])]).max() < 1e-5
    drivers = [curve.driver for curve in lines.animation_data.drivers]
    assert drivers
    assert all(driver.is_simple_expression for driver in drivers), "works where scripts are not allowed"
    message = harness.refusal(lambda: bpy.ops.motion_theater.marker_lines())
    assert "has its lines" in message


def test_lines_can_be_drawn_later(tmp_path: Path) -> None:
    at_once = import_markers(written(tmp_path), rate="SCENE", with_lines=True).motion_theater_markers.lines
    ob = import_markers(written(tmp_path), rate="SCENE")
    bpy.ops.motion_theater.marker_lines()
    later = ob.motion_theater_markers.lines
    assert [tuple(edge.vertices) for edge in later.data.edges] == [tuple(edge.vertices) for edge in at_once.data.edges]


@pytest.mark.parametrize("how", ["LINEAR", "CUBIC", "RIGID"])
@pytest.mark.parametrize("longest", [6, 20])
def test_gaps_are_filled_as_the_core_does(tmp_path: Path, how: str, longest: int) -> None:
    path = written(tmp_path)
    ob = import_markers(path, rate="SCENE")
    filled, gaps = motion_theater.read(path).markers.filled(how=how, longest=longest)  # type: ignore[arg-type]
    assert len(gaps) == (1 if longest == 6 else 2)
    bpy.ops.motion_theater.fill_gaps(how=how, longest=longest)
    check_against_file(ob, filled)
    assert f"Filled {len(gaps)} of 2 gaps" in ob.motion_theater_markers.message
    assert np.isnan(shown(ob, 1)[2]).all(), "nothing is filled before the first sample"


def test_a_marker_that_is_hidden_when_its_gaps_are_filled_is_shown_at_once(tmp_path: Path) -> None:
    ob = import_markers(written(tmp_path), rate="SCENE")
    assert np.isnan(shown(ob, 12)[1]).all()
    bpy.ops.motion_theater.fill_gaps(how="LINEAR", longest=20)
    assert not np.isnan(shown(ob, 12)[1]).any()


def test_a_gap_of_all_markers_at_once_is_filled(tmp_path: Path) -> None:
    points = positions()
    points[:, 20:25] = np.nan
    path = tmp_path / "all.c3d"
    path.write_bytes(motion_theater.Markers(NAMES, points, rate_hz=RATE_HZ, unit_m=0.001).to_bytes("c3d"))
    ob = import_markers(path, rate="SAMPLES")
    bpy.ops.motion_theater.fill_gaps(how="LINEAR", longest=5)
    assert len(harness.key_rows(ob, "head", "location")) == FRAMES
    filled, _ = motion_theater.read(path).markers.filled(how="LINEAR", longest=5)
    check_against_file(ob, filled, step=24.0 / RATE_HZ)


@pytest.mark.parametrize("kind", ["MEDIAN", "AVERAGE", "WEIGHTED"])
def test_filters_work_on_selected_markers_between_gaps(tmp_path: Path, kind: str) -> None:
    path = written(tmp_path)
    ob = import_markers(path, rate="SCENE")
    harness.select(ob, ["left:hand"])
    bpy.ops.motion_theater.filter_markers(kind=kind, depth=5, selected_only=True)
    markers = motion_theater.read(path).markers
    check_against_file(ob, markers.filtered(kind=kind, depth=5, markers=["left:hand"]))  # type: ignore[arg-type]


def test_events_are_markers_of_the_timeline_each_once(tmp_path: Path) -> None:
    import_markers(written(tmp_path), rate="RESAMPLE", with_events=True)
    bpy.ops.motion_theater.marker_events()
    found = sorted((marker.frame, marker.name) for marker in bpy.context.scene.timeline_markers)
    assert found == [(1 + round(0.1 * 24), "Foot Strike"), (1 + round(0.3 * 24), "Foot Off")]


@pytest.mark.parametrize("path", [path for path in REAL if path.name == "FP_Type1.c3d"], ids=lambda path: path.name)
def test_analog_channels_are_curves_of_custom_properties(path: Path) -> None:
    ob = import_markers(path, rate="SCENE", with_analog=True)
    markers = motion_theater.read(path).markers
    curves = harness.fcurves(ob)
    channel = markers.analog[0]
    curve = curves[f'["{channel.name}"]', 0]
    each = markers.analog_samples_per_frame
    for sample in (0, 1, each, len(channel.samples) - 1):
        value = channel.samples[sample]
        assert curve.evaluate(markers.first_frame + sample / each) == pytest.approx(value, rel=1e-5, abs=1e-5)
    harness.pose(ob, markers.first_frame)
    assert ob[channel.name] == pytest.approx(channel.samples[0], rel=1e-5, abs=1e-5)


def test_a_file_without_markers_changes_nothing() -> None:
    before = harness.snapshot()
    message = harness.refusal(lambda: import_markers(harness.TESTDATA / "walk.amc"))
    assert message == "walk.amc holds no markers: choose a .c3d, .csm or .trc file"
    assert harness.snapshot() == before


def test_the_filter_of_stacks_refuses_marker_sets_whose_gaps_it_would_cross(tmp_path: Path) -> None:
    import_markers(written(tmp_path))
    assert not bpy.ops.motion_theater.filter.poll()


def test_operators_of_marker_sets_refuse_other_armatures() -> None:
    harness.import_human()
    assert not bpy.ops.motion_theater.fill_gaps.poll()
    assert not bpy.ops.motion_theater.filter_markers.poll()
