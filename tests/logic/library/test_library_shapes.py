"""Figures on the stage: where the camera sees them, what is drawn of them, and what gaps do."""

from __future__ import annotations

from types import SimpleNamespace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from addon.logic.library import camera, cast, figures, floors, shapes
from addon.logic.library.rect import Rect

PICTURE = Rect(100, 50, 400, 300)
UPRIGHT = np.array([[1.0, 0, 0], [0, 0, 1.0], [0, -1.0, 0]])
"""Looking along Y, as in the front view: right is X, up is Z, backward is -Y."""


def seen(distance: float = 5.0, *, has_perspective: bool = True, rotation: np.ndarray = UPRIGHT) -> camera.Cameras:
    one = camera.Camera(np.array([0.0, 0.0, 1.0]), distance, PICTURE)
    return camera.Cameras(rotation, [one], has_perspective=has_perspective)


def projected(cameras: camera.Cameras, points: np.ndarray) -> np.ndarray:
    """Return pixels and depth of points that the first camera sees, (n, 3)."""
    pixels, depth, _ = cameras.project(points, np.zeros(len(points), np.int32))
    return np.column_stack([pixels, depth])


def patches(count: int = 1, radius: float = 2.0) -> floors.Patches:
    """Return floors around the origin."""
    return floors.Patches(np.zeros((count, 2)), np.full(count, radius), np.zeros(count), np.zeros((count, 2)))


def drawn(body: figures.Body, frame: float) -> np.ndarray:
    """Return the corners of a figure without its floor that can be seen."""
    shown = cast.Cast([body], 4)
    shown.place([frame], seen(), patches())
    assert np.isfinite(shown.places).all()
    assert np.isfinite(shown.colors).all()
    lines = floors.HALVES * 6
    return shown.places[lines:][shown.colors[lines:, 3] > 0]


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
    found = projected(seen(), np.array([[0, 0, 1.0], [0, 0, 2.0], [1.0, 0, 1.0], [0, 3.0, 1.0]]))
    assert found[0, :2] == pytest.approx(PICTURE.middle)
    assert found[1, 1] > found[0, 1]
    assert found[2, 0] > found[0, 0]
    assert found[3, 2] > found[0, 2]


def test_perspective_makes_what_is_farther_smaller_and_without_it_nothing_changes() -> None:
    ends = np.array([[-0.5, 0, 1.0], [0.5, 0, 1.0], [-0.5, 3, 1.0], [0.5, 3, 1.0]])
    near, far = np.diff(projected(seen(), ends)[:, 0])[[0, 2]]
    assert far < 0.8 * near
    near, far = np.diff(projected(seen(has_perspective=False), ends)[:, 0])[[0, 2]]
    assert far == pytest.approx(near)


def test_what_is_behind_the_eye_is_not_drawn() -> None:
    assert np.isnan(projected(seen(), np.array([[0.0, -20.0, 1.0]]))).all()


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
    eye = camera.Cameras(rotation, [camera.Camera(np.zeros(3), away, picture)])
    around = np.linspace(0, 2 * np.pi, 32)
    rim = np.stack([radius * np.cos(around), radius * np.sin(around), np.zeros(32)], axis=1)
    pixels = projected(eye, rim)
    assert (pixels[:, 0] >= 0).all()
    assert (pixels[:, 0] <= width).all()
    if tilt < 0.05:
        pixels = projected(eye, np.array([[0, 0, -half], [0, 0, half]]))
        assert (pixels[:, 1] >= 0).all()
        assert (pixels[:, 1] <= height).all()


def test_a_body_knows_where_it_goes_and_how_large_it_is() -> None:
    body = figures.prepared(walker(), is_markers=False)
    assert body.frames == 20
    assert body.path[-1] == pytest.approx([1.9, 0.0])
    assert body.reach == pytest.approx((0.95, 0.0, 0.95))
    assert body.height == pytest.approx(1.8)
    assert len(body.ends[0]) == 2
    assert tuple(body.tints[0]) == figures.SIDES[-1]


def test_between_two_frames_a_figure_is_on_the_way() -> None:
    body = figures.prepared(walker(), is_markers=False)
    points = figures.poses([body, body], [2.5, 99.0])
    assert points[0] == pytest.approx([0.25, 0, 1.0])
    assert points[3:] == pytest.approx(body.points[-1])
    assert figures.place(body, 2.5) == pytest.approx([0.25, 0.0])


def test_a_marker_in_a_gap_is_hidden_and_the_others_stay() -> None:
    clip = walker()
    clip.points[5:8, 1] = np.nan
    body = figures.prepared(clip, is_markers=True)
    whole, gap = drawn(body, 0.0), drawn(body, 6.0)
    assert 0 < len(gap) < len(whole)
    points = figures.poses([body], [4.5])
    assert np.isfinite(points).all(), "the last sample before a gap is shown until the gap"


def test_a_clip_that_is_all_gaps_draws_nothing_and_raises_nothing() -> None:
    clip = walker()
    clip.points[:] = np.nan
    assert not len(drawn(figures.prepared(clip, is_markers=True), 3.0))


def test_figures_side_by_side_look_as_each_does_alone() -> None:
    bodies = [figures.prepared(walker(), is_markers=is_markers) for is_markers in (False, True, False)]
    pictures = [Rect(300 * number, 20, 280, 260) for number in range(3)]
    cameras = [camera.Camera(np.array([0.1, 0.0, 0.9]), 4.0 + number, place) for number, place in enumerate(pictures)]
    frames = [0.0, 3.5, 7.25]
    together = cast.Cast(bodies, 4)
    together.place(frames, camera.Cameras(UPRIGHT, cameras), patches(3))
    for number, body in enumerate(bodies):
        alone = cast.Cast([body], 4)
        alone.place(frames[number : number + 1], camera.Cameras(UPRIGHT, cameras[number : number + 1]), patches())
        ours, theirs = together.parts[number], alone.parts[0]
        assert np.array_equal(together.places[ours], alone.places[theirs])
        assert np.array_equal(together.colors[ours], alone.colors[theirs])


def test_what_is_nearer_covers_what_is_farther() -> None:
    clip = walker()
    clip.points[:, 1, 1], clip.points[:, 2, 1] = -1.0, 1.0  # the left limb comes nearer, the right one goes away
    shown = cast.Cast([figures.prepared(clip, is_markers=False)], 4)
    shown.place([0.0], seen(), patches())
    order = [corner for corner in shown.parts[0].ravel() if shown.colors[corner, 3] == 1.0]
    red, _, blue = shown.colors[order[0], :3]
    assert red > blue, "the right limb, which is orange, is drawn first"
    red, _, blue = shown.colors[order[-1], :3]
    assert red < blue


def test_shapes_are_made_of_corners_that_there_are() -> None:
    begins, ends = np.array([[0.0, 0], [5, 5]]), np.array([[10.0, 0], [5, 5]])
    mesh = shapes.joined(
        [
            shapes.strokes(begins, ends, 2.0, (1, 1, 1, 1), 6),
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
    around = patches(radius=2.5)._replace(centres=np.array([[0.3, 0.0]]))
    middles, rims, colors = floors.half_lines(around)
    is_there = colors[:, 1, 3] > 0
    across = {
        round(float(middle[0]), 6)
        for middle, rim in zip(middles[is_there], rims[is_there], strict=True)
        if middle[0] == rim[0]
    }
    assert across == {-2.0, -1.5, -1.0, -0.5, 0.0, 0.5, 1.0, 1.5, 2.0, 2.5}
    assert (np.hypot(*(rims[is_there, :2] - around.centres).T) <= 2.5 + 1e-9).all()
    tints = {tuple(color) for color in colors[is_there, 0, :3].tolist()}
    assert tints == {floors.FLOOR, *map(tuple, floors.AXES.tolist())}
