"""One figure on its stage with the trails of its hands and feet."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
from PIL import Image, ImageDraw

from .camera import SUPERSAMPLING, Camera, Colour, Floats, to_image
from .figure import mannequin
from .stage import Stage
from .states import FEET, HANDS, State

PLAIN: Colour = (150, 160, 176)
BEFORE: Colour = (214, 56, 52)
"""Trails of the state before."""

QUIET: Colour = (96, 106, 122)
"""Trails of bones that this step left as they were."""

TRAIL_FRAMES = 30
HIDDEN_BEHIND_M = 0.06
"""A trail this far behind the body's surface is hidden: the bone itself lies under the surface."""

AZIMUTH_DEG = -46.0
ELEVATION_DEG = 9.0
DISTANCE_M = 7.5
PROBE_FOCAL = 1000.0
ROOM = 14
"""Pixels between the figure and the edge of its panel."""


def fitting_camera(points: Floats, width: int, height: int) -> Camera:
    """A camera that sees all of `points` (any number, 3), with a little room around."""
    middle = (points.min(axis=0) + points.max(axis=0)) / 2
    probe = Camera(middle, DISTANCE_M, AZIMUTH_DEG, ELEVATION_DEG, width, height, PROBE_FOCAL)
    pixels, _ = probe.project(points)
    low, high = pixels.min(axis=0) / SUPERSAMPLING, pixels.max(axis=0) / SUPERSAMPLING
    size = high - low
    focal = PROBE_FOCAL * min((width - 2 * ROOM) / size[0], (height - 3 * ROOM) / size[1])
    # Look at the middle of what is seen rather than of what is there.
    shift = ((low + high) / 2 - np.array([width / 2, height / 2])) / PROBE_FOCAL * DISTANCE_M
    target = middle + shift[0] * probe.axes[0] - shift[1] * probe.axes[1]
    return Camera(target, DISTANCE_M, AZIMUTH_DEG, ELEVATION_DEG, width, height, focal)


def stage_for(states: Sequence[State], width: int, height: int) -> Stage:
    """The stage on which all states are seen alike, with room for all that they do."""
    points = np.concatenate([_points(state) for state in states], axis=1)
    return Stage(fitting_camera(points.reshape(-1, 3), width, height), points[..., :2].mean(axis=(0, 1)))


def stages_along(states: Sequence[State], moments: Sequence[int], width: int, height: int) -> list[Stage]:
    """One stage per moment, whose camera has moved along with the body so that it can be nearer."""
    points = np.concatenate([_points(state) for state in states], axis=1)
    travel = states[0].heads[:, :1] * np.array([1.0, 1.0, 0.0])
    camera = fitting_camera((points - travel).reshape(-1, 3), width, height)
    places = [travel[moment, 0] for moment in moments]
    return [Stage(replace(camera, target=camera.target + place), place) for place in places]


def _points(state: State) -> Floats:
    return np.concatenate([state.heads, state.tails], axis=1)


def figure(stage: Stage, state: State, frame: int, before: State | None = None) -> Image.Image:
    """The state at a frame, counted from 0."""
    heads = dict(zip(state.names, state.heads[frame], strict=True))
    tails = dict(zip(state.names, state.tails[frame], strict=True))
    picture, depth = stage.with_body(mannequin(heads, tails, state.highlighted, state.tint, PLAIN))
    height, width = depth.shape
    layer = Image.new("RGBA", (width, height))
    pen = ImageDraw.Draw(layer)
    since = slice(max(0, frame - TRAIL_FRAMES), frame + 1)
    if before is not None:
        for bone in HANDS:
            _trail(pen, stage.camera, depth, before.trail(bone)[since], BEFORE, 2)
    for bone in (*FEET, *HANDS):
        colour = state.tint if bone in state.highlighted else QUIET
        _trail(pen, stage.camera, depth, state.trail(bone)[since], colour, 3)
    image = to_image(picture).convert("RGBA")
    image.alpha_composite(layer.resize(image.size, Image.Resampling.BOX))
    return image.convert("RGB")


def _trail(
    pen: ImageDraw.ImageDraw, camera: Camera, depth: Floats, path: Floats, colour: Colour, thickness: int
) -> None:
    """A line that fades towards its older end and passes behind the body."""
    height, width = depth.shape
    pixels, _ = camera.project(path)
    distance = np.linalg.norm(path - camera.position, axis=-1)
    for i in range(len(path) - 1):
        (x0, y0), (x1, y1) = pixels[i], pixels[i + 1]
        x, y = min(max(int((x0 + x1) / 2), 0), width - 1), min(max(int((y0 + y1) / 2), 0), height - 1)
        if distance[i] < depth[y, x] + HIDDEN_BEHIND_M:
            alpha = int(225 * ((i + 1) / len(path)) ** 1.4)
            pen.line([float(x0), float(y0), float(x1), float(y1)], fill=(*colour, alpha), width=thickness)
