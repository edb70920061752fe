"""The cameras of small stages: turned as the 3D View is, and far enough away to show the whole figure."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from .rect import Rect

Floats = NDArray[np.floating]

LENS = 1.9  # focal length by the height of the picture: about 30 degrees from top to bottom
NEAREST = 0.05  # metres in front of the eye; what is closer is not drawn
MARGIN = 1.12


@dataclass(frozen=True)
class Camera:
    """Maps metres to pixels, in the direction that all stages have in common."""

    target: Floats
    """(3,) the point in the middle of the picture."""
    distance: float
    """Metres from the eye to the target; without perspective only the scale depends on it."""
    picture: Rect


class Cameras:
    """Cameras that look the same way. The rows of `rotation` are the view's right, up and backward axes in the world.

    They map many points in one go. `whose` are the (n,) numbers of the cameras that see each of them.
    """

    def __init__(self, rotation: Floats, cameras: Sequence[Camera], *, has_perspective: bool = True) -> None:
        self.rotation = rotation
        self.has_perspective = has_perspective
        self._targets = np.array([camera.target for camera in cameras]).reshape(-1, 3)
        self._distances = np.array([camera.distance for camera in cameras])
        self._middles = np.array([camera.picture.middle for camera in cameras]).reshape(-1, 2)
        self._focals = LENS * np.array([camera.picture.height for camera in cameras])
        """Pixels per unit of slope."""

    def project(self, points: Floats, whose: NDArray[np.int32]) -> tuple[Floats, Floats, Floats]:
        """Return what is seen of (n, 3) points: (n, 2) pixels, NaN what is not to be seen, (n,) distances in front of
        the eye, and (n,) how many pixels long a metre is there.
        """
        seen = (points - self._targets[whose]) @ self.rotation.T
        away = self._distances[whose]
        depth = away - seen[:, 2]
        if self.has_perspective:
            with np.errstate(invalid="ignore"):
                away = depth = np.where(depth > NEAREST, depth, np.nan)
        scale = self._focals[whose] / away
        return seen[:, :2] * scale[:, None] + self._middles[whose], depth, scale


def distance_for(picture: Rect, radius: float, half_height: float) -> float:
    """Return how far away the eye is when an upright cylinder about the target just fits, however it is turned."""
    focal = LENS * max(picture.height, 1.0)
    wide = 2 * radius * focal / max(picture.width, 1.0) + radius
    high = 2 * half_height * focal / max(picture.height, 1.0) + radius
    return MARGIN * max(wide, high, 0.1)
