"""A figure is where the clip is, in metres with Z up, and ready to draw."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import motion_theater as mt
from tests.native.files import OUR_PAIRS, SHARED, TESTDATA

MARKERS = np.array(
    [
        [[0.0, 0.5, 1.7], [0.0, 1.5, 1.7], [0.0, 2.5, 1.7]],
        [[0.1, 0.5, 1.7], [np.nan, np.nan, np.nan], [0.1, 2.5, 1.7]],
        [[0.1, 0.5, 0.1], [0.1, 1.5, 0.1], [0.1, 2.5, 0.1]],
    ]
)
"""(markers, frames, 3) two of a head and one of a foot, of somebody upright."""


def marker_file(folder: Path, unit_m: float = 1.0) -> Path:
    """Write the markers above."""
    names = ["LFHD", "RFHD", "TOE"]
    markers = mt.Markers(names, MARKERS / unit_m, rate_hz=100.0, first_frame=1, unit_m=unit_m, up=(0.0, 0.0, 1.0))
    path = folder / "head.csm"
    path.write_bytes(markers.to_bytes("csm"))
    return path


def test_joints_are_where_the_pose_has_them() -> None:
    pair = next(pair for pair in OUR_PAIRS if pair.amc.stem == "walk")
    skeleton, motion, _ = pair.read()
    figure = mt.load_figure(pair.amc, skeleton=skeleton)
    assert figure.points.shape == (motion.frames, len(figure.names), 3)
    assert (figure.first_frame, figure.step, figure.frames) == (motion.first_frame, 1, motion.frames)
    for frame in (0, motion.frames // 2, motion.frames - 1):
        heads, _, _ = motion.pose(skeleton, motion.first_frame + frame)
        for name, point in zip(figure.names, figure.points[frame], strict=True):
            if name in skeleton.names:
                x, y, z = np.asarray(heads)[skeleton.names.index(name)] * skeleton.unit_m
                assert point == pytest.approx([x, -z, y], abs=1e-5), name


def test_left_and_right_are_the_figures_own() -> None:
    figure = mt.load_figure(TESTDATA / "human.asf")
    middles = figure.points[0][figure.lines].mean(axis=1)
    assert (figure.sides == -1).sum() == (figure.sides == 1).sum() > 5
    assert (middles[figure.sides == -1, 0] > 0).all(), "who looks towards -Y has the left at +X"
    assert (middles[figure.sides == 1, 0] < 0).all()


def test_markers_are_in_metres_with_gaps(tmp_path: Path) -> None:
    figure = mt.load_figure(marker_file(tmp_path, unit_m=0.001))
    assert figure.points == pytest.approx(MARKERS.transpose(1, 0, 2), abs=1e-5, nan_ok=True)
    assert figure.lines.tolist() == [[0, 1]]
    assert figure.bounds == pytest.approx(np.array([[0.0, 0.5, 0.1], [0.1, 2.5, 1.7]]), abs=1e-5)


def test_a_batch_has_two_ends_and_two_colours_for_each_line(tmp_path: Path) -> None:
    figure = mt.load_figure(marker_file(tmp_path))
    segments = figure.segments(0.0)
    assert (segments.dtype, segments.shape) == (np.float32, (2, 3))
    assert segments == pytest.approx(MARKERS[:2, 0], abs=1e-5)
    assert np.isfinite(figure.segments(1.0)).all(), "a gap is no number, which a graphics card need not see"
    assert len(figure.dots(1.0)) == 2
    left, middle, right = (1.0, 0.0, 0.0, 1.0), (0.0, 1.0, 0.0, 1.0), (0.0, 0.0, 1.0, 1.0)
    assert figure.colors(left=left, middle=middle, right=right).tolist() == [list(middle)] * 2


def test_a_long_clip_is_thinned_and_keeps_its_speed() -> None:
    pair = next(pair for pair in OUR_PAIRS if pair.amc.stem == "walk")
    skeleton, _, _ = pair.read()
    whole = mt.load_figure(pair.amc, skeleton=skeleton)
    thin = mt.load_figure(pair.amc, skeleton=skeleton, longest=7)
    assert thin.frames <= 7 < whole.frames
    assert thin.rate_hz * thin.step == pytest.approx(whole.rate_hz)
    assert np.array_equal(thin.points, whole.points[:: thin.step])


def test_files_that_are_none_raise_what_reading_raises(tmp_path: Path) -> None:
    with pytest.raises(FileNotFoundError):
        mt.load_figure(tmp_path / "none.bvh")
    broken = tmp_path / "broken.bvh"
    broken.write_text("HIERARCHY\nROOT", encoding="utf-8")
    with pytest.raises(mt.ParseError):
        mt.load_figure(broken)


REAL = sorted(path for path in SHARED.glob("**/*") if path.suffix.lower() in {".bvh", ".c3d", ".csm", ".trc", ".asf"})


@pytest.mark.parametrize("path", REAL, ids=lambda path: path.name)
def test_every_real_file_stands_on_its_floor(path: Path) -> None:
    if path.stat().st_size == 0:
        with pytest.raises(mt.ParseError):
            mt.load_figure(path)
        return
    figure = mt.load_figure(path, longest=64)
    assert figure.lines.size == 0 or figure.lines.max() < len(figure.names)
    assert figure.points.shape == (figure.frames, len(figure.names), 3)
    low, high = figure.bounds
    assert (low <= high).all()
    assert (high - low).max() < 20.0, "metres, and nobody goes farther here"
    assert np.isfinite(figure.segments(figure.frames / 3)).all()
