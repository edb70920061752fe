"""The drawing of the demo, on clips of the generator: no Blender needed."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from testdata.generate import clean_clip, forward, recorded_clip
from testdata.generate.kinematics import Dofs
from testdata.generate.skeleton import BONES

from . import draw
from .camera import SUPERSAMPLING, Camera, Colour, to_image
from .cones import RoundCone, draw_cones
from .figure import mannequin
from .panel import stage_for
from .stage import Stage
from .states import Row, Span, State, hand_accelerations

ORANGE: Colour = (232, 122, 38)
GREY: Colour = (150, 160, 176)
FRAMES = 13


def _state(title: str, dofs: Dofs, highlighted: frozenset[str] = frozenset(), shows_before: bool = False) -> State:
    pose = forward(dofs)
    names = ["root", *(bone.name for bone in BONES)]
    parents = [-1, *(names.index(bone.parent) for bone in BONES)]
    ends = []
    for points in (pose.heads, pose.tails):
        stacked = np.stack([points[name] for name in names], axis=1)[:FRAMES]
        ends.append(np.stack([stacked[..., 0], -stacked[..., 2], stacked[..., 1]], axis=-1))
    rows = (Row("All", (Span("one", 1, 6), Span("two", 7, FRAMES, (5, 7)))),)
    return State(title, "What it shows", names, parents, ends[0], ends[1], highlighted, ORANGE, rows, shows_before)


@pytest.fixture(scope="module")
def states() -> list[State]:
    """Two states of few frames: one with noise, one without."""
    before = _state("Before", recorded_clip("wave"))
    return [before, _state("After", clean_clip("wave"), frozenset({"rhumerus", "rradius"}), shows_before=True)]


def _camera() -> Camera:
    return Camera(np.array([0.0, 0.0, 1.0]), 5.0, 0.0, 0.0, 60, 60, 100.0)


def _cone(y: float, colour: Colour, radius: float = 0.3) -> RoundCone:
    return RoundCone(np.array([-0.5, y, 1.0]), np.array([0.5, y, 1.0]), radius, radius, colour)


def test_a_round_cone_is_as_far_away_as_geometry_says() -> None:
    picture = np.zeros((60 * SUPERSAMPLING, 60 * SUPERSAMPLING, 3))
    depth = draw_cones(picture, _camera(), [_cone(0.0, ORANGE)])
    middle = 30 * SUPERSAMPLING
    # The ray through the middle pixel is half a pixel off the axis.
    assert depth[middle, middle] == pytest.approx(5.0 - 0.3, abs=1e-3)
    assert np.isinf(depth[2, middle])


@pytest.mark.parametrize("order", [(0, 1), (1, 0)])
def test_the_nearer_limb_hides_the_farther_in_any_order(order: tuple[int, int]) -> None:
    cones = [_cone(-1.0, ORANGE, 0.2), _cone(1.0, GREY, 0.2)]
    picture = np.zeros((60 * SUPERSAMPLING, 60 * SUPERSAMPLING, 3))
    draw_cones(picture, _camera(), [cones[i] for i in order])
    red, _, blue = picture[30 * SUPERSAMPLING, 30 * SUPERSAMPLING]
    assert red > 3 * blue


def test_a_body_casts_its_shadow_on_the_floor() -> None:
    camera = Camera(np.array([0.0, 0.0, 0.5]), 5.0, 0.0, 20.0, 120, 90, 150.0)
    stage = Stage(camera, np.zeros(3))
    body = [RoundCone(np.array([0.0, 0.0, 0.2]), np.array([0.0, 0.0, 1.2]), 0.1, 0.1, GREY)]
    picture, depth = stage.with_body(body)
    floor = np.isinf(depth)
    darker = stage.picture[floor].sum(axis=-1) - picture[floor].sum(axis=-1)
    assert darker.min() > -1e-12
    assert darker.max() > 0.5


def test_only_highlighted_bones_have_the_tint(states: list[State]) -> None:
    def orange_pixels(state: State) -> int:
        stage = stage_for([state], 120, 160)
        heads, tails = (dict(zip(state.names, ends[0], strict=True)) for ends in (state.heads, state.tails))
        body = mannequin(heads, tails, state.highlighted, state.tint, GREY)
        image = np.asarray(to_image(stage.with_body(body)[0]), dtype=int)
        return int((image[..., 0] - image[..., 2] > 60).sum())

    assert orange_pixels(states[0]) == 0
    assert orange_pixels(states[1]) > 50


def test_noise_stands_out_in_the_acceleration_of_the_hands(states: list[State]) -> None:
    noisy, clean = (hand_accelerations(state, 60.0) for state in states)
    assert noisy.shape == (2, FRAMES)
    assert noisy.mean() > 2 * clean.mean()


def test_the_same_states_give_the_same_picture(states: list[State], tmp_path: Path) -> None:
    for name in ("one.png", "two.png"):
        draw.picture(states, tmp_path / name)
    assert (tmp_path / "one.png").read_bytes() == (tmp_path / "two.png").read_bytes()


def test_the_preview_plays_all_states_at_their_own_speed(states: list[State], tmp_path: Path) -> None:
    draw.preview(states, tmp_path / "preview.gif", 60)
    with Image.open(tmp_path / "preview.gif") as preview:
        durations = []
        for frame in range(getattr(preview, "n_frames", 1)):
            preview.seek(frame)
            durations.append(preview.info["duration"])
    # Twelve steps of 1/60 s last 200 ms; the last picture stays for a while.
    assert sum(durations[:-1]) == 200
    assert durations[-1] > 500
