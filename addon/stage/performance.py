"""The figures on the stages: where each stands, and the camera that sees it."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from ..logic.library import camera, figures, floors
from ..logic.library.cast import Cast
from . import paint

if TYPE_CHECKING:
    from ..logic.library.rect import Rect
    from .canvas import Canvas
    from .view import Window

CAPS = {1: 7, 4: 4, 9: 4}
"""By the number of stages: points of the half circle at the end of a limb."""


class Performance:
    """Figures on stages of their own that turn with the 3D View, all computed and brought over at once."""

    def __init__(self) -> None:
        self._moving: paint.Moving | None = None
        self._home: tuple[np.ndarray, float] | None = None
        """Where the view was at the beginning: what it turned about, and from how far."""

    def draw(
        self,
        canvas: Canvas,
        window: Window,
        cast: Sequence[tuple[Rect, figures.Body, float]],
        *,
        cap: int,
        follows: bool,
    ) -> None:
        """Draw figures, each in its picture and at its frame, counted from 0."""
        if self._home is None:
            self._home = (window.location.copy(), window.distance)
        if not cast:
            return
        bodies, frames = [body for _, body, _ in cast], [frame for *_, frame in cast]
        patches = _followed(bodies, frames) if follows else _from_afar(bodies)
        seen = [
            self._camera(window, picture, body, centre, radius)
            for (picture, body, _), centre, radius in zip(cast, patches.centres, _radii(bodies, follows), strict=True)
        ]
        moving = self._moving_of(bodies, cap)
        cameras = camera.Cameras(window.rotation, seen, has_perspective=window.has_perspective)
        moving.cast.place(frames, cameras, patches)
        moving.renew()
        for number, (picture, *_) in enumerate(cast):
            canvas.within(picture)
            canvas.figure(moving, number)
        canvas.within(None)

    def _moving_of(self, bodies: Sequence[figures.Body], cap: int) -> paint.Moving:
        """Return what was made of these figures before, or make it anew."""
        known = self._moving
        if known is None or known.cast.cap != cap or known.cast.bodies != tuple(bodies):
            known = self._moving = paint.Moving(Cast(bodies, cap))
        return known

    def _camera(
        self, window: Window, picture: Rect, body: figures.Body, centre: np.ndarray, radius: float
    ) -> camera.Camera:
        """Return the camera of a stage: as the view is turned, moved and zoomed since the stage was opened."""
        home, distance = self._home or (window.location, window.distance)
        away = camera.distance_for(picture, radius, body.height / 2)
        zoom = window.distance / distance if distance > 0 else 1.0
        middle = np.array([centre[0], centre[1], body.floor + body.height / 2])
        target = middle + (window.location - home) * (away / distance if distance > 0 else 1.0)
        return camera.Camera(target, away * zoom, picture)


def _radii(bodies: Sequence[figures.Body], follows: bool) -> list[float]:
    """Return how far from the middle what must be seen of each figure reaches."""
    return [body.radius if follows else body.reach[2] + body.radius for body in bodies]


def _followed(bodies: Sequence[figures.Body], frames: Sequence[float]) -> floors.Patches:
    """Return floors that pass below figures in the middle."""
    return floors.Patches(
        centres=np.zeros((len(bodies), 2)),
        radii=np.array([max(1.15 * body.radius, 0.62 * body.height) for body in bodies]),
        levels=np.array([body.floor for body in bodies]),
        origins=np.array([-figures.place(body, frame) for body, frame in zip(bodies, frames, strict=True)]),
    )


def _from_afar(bodies: Sequence[figures.Body]) -> floors.Patches:
    """Return floors that hold all that the figures pass through."""
    return floors.Patches(
        centres=np.array([body.reach[:2] for body in bodies]),
        radii=1.05 * np.array(_radii(bodies, follows=False)),
        levels=np.array([body.floor for body in bodies]),
        origins=np.zeros((len(bodies), 2)),
    )
