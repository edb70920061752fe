"""Figures on the stage: where the camera sees them, what is drawn of them, and what gaps do."""

from __future__ import annotations

from types import SimpleNamespace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from addon.logic.library import camera, figures, shapes
from addon.logic.library.rect import Rect

PICTURE = Rect(100, 50, 400, 300)
UPRIGHT = np.array([[1.0, 0, 0], [0, 0, 1.0], [0, -1.0, 0]])
"""Looking along Y, as in the front view: right is X, up is Z, backward is -Y."""


def seen(distance: float = 5.0, *, has_perspective: bool = True) -> camera.Camera:
    return camera.Camera(UPRIGHT, np.array([0.0, 0.0, 1.0]), distance, PICTURE, has_perspective)


def walker(frames: int = 20) -> SimpleNamespace:
    """Return a stick of two limbs that goes 0.1 m a frame along X."""
    points = np.zeros((frames, 3, 3), np.float32)
    points[:, :, 0] = 0.1 * np.arange(frames)[:, None]
    points[:, :, 2] = [1.0, 0.0, 1.8]
    return SimpleNamespace(
        points=points,
        lines=np.array([[0, 1], [0, 2]], np.int32),
        sides=np.array([-1, 1], np.int8),
        rate_hz=60.0,
        first_frame=1,
        floor=0.0,
    )


def test_the_target_is_in_the_middle_and_up_is_up() -> None:
    pixels, depth = seen().project(np.array([[0, 0, 1.0], [0, 0, 2.0], [1.0, 0, 1.0], [0, 3.0, 1.0]]))
    assert pixels[0] == pytest.approx(PICTURE.middle)
    assert pixels[1][1] > pixels[0][1]
    assert pixels[2][0] > pixels[0][0]
    assert depth[3] > depth[0]


def test_perspective_makes_what_is_farther_smaller_and_without_it_nothing_changes() -> None:
    ends = np.array([[-0.5, 0, 1.0], [0.5, 0, 1.0], [-0.5, 3, 1.0], [0.5, 3, 1.0]])
    near, far = np.diff(seen().project(ends)[0][:, 0])[[0, 2]]
    assert far < 0.8 * near
    near, far = np.diff(seen(has_perspective=False).project(ends)[0][:, 0])[[0, 2]]
    assert far == pytest.approx(near)


def test_what_is_behind_the_eye_is_not_drawn() -> None:
    pixels, _ = seen().project(np.array([[0.0, -20.0, 1.0]]))
    assert np.isnan(pixels).all()


@given(
    st.floats(0.1, 20),
    st.floats(0.1, 5),
    st.integers(60, 900),
    st.integers(60, 900),
    st.floats(0, 6.3),
    st.floats(0, 1.4),
)
def test_a_figure_fits_into_its_picture_however_the_view_is_turned(
    radius: float, half: float, width: int, height: int, turn: float, tilt: float
) -> None:
    picture = Rect(0, 0, width, height)
    right = np.array([np.cos(turn), np.sin(turn), 0.0])
    back = np.array([np.sin(turn) * np.cos(tilt), -np.cos(turn) * np.cos(tilt), np.sin(tilt)])
    rotation = np.stack([right, np.cross(back, right), back])
    away = camera.distance_for(picture, radius, half)
    eye = camera.Camera(rotation, np.zeros(3), away, picture)
    around = np.linspace(0, 2 * np.pi, 32)
    rim = np.stack([radius * np.cos(around), radius * np.sin(around), np.zeros(32)], axis=1)
    pixels, _ = eye.project(rim)
    assert (pixels[:, 0] >= 0).all()
    assert (pixels[:, 0] <= width).all()
    if tilt < 0.05:
        pixels, _ = eye.project(np.array([[0, 0, -half], [0, 0, half]]))
        assert (pixels[:, 1] >= 0).all()
        assert (pixels[:, 1] <= height).all()


def test_a_body_knows_where_it_goes_and_how_large_it_is() -> None:
    body = figures.prepared(walker(), is_markers=False)
    assert body.frames == 20
    assert body.path[-1] == pytest.approx([1.9, 0.0])
    assert body.reach == pytest.approx((0.95, 0.0, 0.95))
    assert body.height == pytest.approx(1.8)
    assert len(body.ends[0]) == 2
    assert tuple(body.colors[0, 1, :3]) == figures.SIDES[-1]


def test_between_two_frames_a_figure_is_on_the_way() -> None:
    body = figures.prepared(walker(), is_markers=False)
    points, place = figures.pose(body, 2.5)
    assert points[0] == pytest.approx([0.25, 0, 1.0])
    assert place == pytest.approx([0.25, 0.0])
    assert figures.pose(body, 99.0)[0] == pytest.approx(body.points[-1])


def test_a_marker_in_a_gap_is_hidden_and_the_others_stay() -> None:
    clip = walker()
    clip.points[5:8, 1] = np.nan
    body = figures.prepared(clip, is_markers=True)
    whole, gap = (figures.drawn(body, frame, seen(), np.zeros(3)) for frame in (0.0, 6.0))
    assert 0 < len(gap.begins) < len(whole.begins)
    assert np.isfinite(shapes.capsules(gap).places).all()
    points, _ = figures.pose(body, 4.5)
    assert np.isfinite(points).all(), "the last sample before a gap is shown until the gap"


def test_a_clip_that_is_all_gaps_draws_nothing_and_raises_nothing() -> None:
    clip = walker()
    clip.points[:] = np.nan
    body = figures.prepared(clip, is_markers=True)
    assert not len(figures.drawn(body, 3.0, seen(), np.zeros(3)).begins)


def test_shapes_are_made_of_corners_that_there_are() -> None:
    begins, ends = np.array([[0.0, 0], [5, 5], [np.nan, 0]]), np.array([[10.0, 0], [5, 5], [1, 1]])
    radii, colors = np.full(3, 2.0), np.ones((3, 4))
    mesh = shapes.joined(
        [
            shapes.capsules(shapes.strokes(begins, ends, radii, radii, colors)),
            shapes.rectangles([(0, 0, 30, 20)], [4.0], [(1, 1, 1, 1)]),
            shapes.polygon([(0, 0), (10, 0), (5, 8)], (1, 0, 0, 1)),
            shapes.EMPTY,
        ]
    )
    assert mesh.triangles.min() == 0
    assert mesh.triangles.max() == len(mesh.places) - 1
    assert len(mesh.places) == len(mesh.colors)
    assert np.isfinite(mesh.places).all()


def test_a_rectangle_covers_its_area_and_fades_over_one_pixel() -> None:
    mesh = shapes.rectangles([(10, 20, 30, 40)], [0.0], [(0.2, 0.4, 0.6, 1.0)])
    inner, faded = mesh.places[mesh.colors[:, 3] == 1.0], mesh.places[mesh.colors[:, 3] == 0.0]
    assert inner.min(0).tolist() == [10, 20]
    assert inner.max(0).tolist() == [40, 60]
    assert (np.abs(faded - np.clip(faded, [10, 20], [40, 60])) <= shapes.RIM).all()


def test_the_floor_has_lines_each_metre_and_the_axes_of_the_origin() -> None:
    patch = figures.floor(seen(9.0), np.array([0.3, 0.0]), 2.0, 0.0, np.zeros(2))
    tints = {tuple(color[:3]) for color in patch.colors.reshape(-1, 4).astype(np.float32).round(3).tolist()}
    assert {tuple(axis) for axis in np.array(figures.AXES, np.float32).round(3).tolist()} <= tints
