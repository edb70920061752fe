"""A small stage's camera: turned as the 3D View is, and far enough away to show the whole figure."""

from __future__ import annotations

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
    """Maps metres to pixels. The rows of `rotation` are the view's right, up and backward axes in the world."""

    rotation: Floats
    target: Floats
    """(3,) the point in the middle of the picture."""
    distance: float
    """Metres from the eye to the target; without perspective only the scale depends on it."""
    picture: Rect
    has_perspective: bool = True

    @property
    def focal(self) -> float:
        """Pixels per unit of slope."""
        return LENS * self.picture.height

    def project(self, points: Floats) -> tuple[Floats, Floats]:
        """Return (n, 2) pixels and (n,) distances in front of the eye of (n, 3) points; NaN what is not to be seen."""
        seen = (points - self.target) @ self.rotation.T
        depth = self.distance - seen[:, 2]
        with np.errstate(invalid="ignore"):
            depth = np.where(depth > NEAREST, depth, np.nan) if self.has_perspective else depth
        scale = self.focal / (depth if self.has_perspective else np.full_like(depth, self.distance))
        pixels = seen[:, :2] * scale[:, None] + np.array(self.picture.middle)
        return pixels, depth

    def pixels_per_metre(self, depth: Floats) -> Floats:
        """Return how large a metre is at (n,) distances from the eye."""
        return self.focal / (depth if self.has_perspective else np.full_like(depth, self.distance))


def distance_for(picture: Rect, radius: float, half_height: float) -> float:
    """Return how far away the eye is when an upright cylinder about the target just fits, however it is turned."""
    focal = LENS * max(picture.height, 1.0)
    wide = 2 * radius * focal / max(picture.width, 1.0) + radius
    high = 2 * half_height * focal / max(picture.height, 1.0) + radius
    return MARGIN * max(wide, high, 0.1)
