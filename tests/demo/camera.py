"""A perspective camera, and how its pictures are made: linear light, supersampled.

Positions are metres, Z up. Pictures are float arrays (height, width, 3) of linear light until `to_image`.
"""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray
from PIL import Image

Floats = NDArray[np.float64]
Colour = tuple[int, int, int]

SUPERSAMPLING = 2
"""Pictures are drawn this much larger and reduced, so that edges are smooth."""

GAMMA = 2.2


def linear(colour: Colour) -> Floats:
    """The light of a colour on screen."""
    light: Floats = (np.array(colour, dtype=float) / 255.0) ** GAMMA
    return light


@dataclass(frozen=True)
class Camera:
    """A perspective view on `target`, from `distance` metres away; angles in degrees, sizes in final pixels."""

    target: Floats
    distance: float
    azimuth_deg: float
    elevation_deg: float
    width: int
    height: int
    focal: float
    """Pixels per metre at one metre's distance."""
    axes: Floats = field(init=False)
    """Rows: to the right, up and forwards as seen."""
    position: Floats = field(init=False)

    def __post_init__(self) -> None:
        azimuth, elevation = np.radians([self.azimuth_deg, self.elevation_deg])
        forward = np.array(
            [-np.sin(azimuth) * np.cos(elevation), np.cos(azimuth) * np.cos(elevation), -np.sin(elevation)]
        )
        right = np.array([np.cos(azimuth), np.sin(azimuth), 0.0])
        object.__setattr__(self, "axes", np.stack([right, np.cross(right, forward), forward]))
        object.__setattr__(self, "position", self.target - self.distance * forward)

    def project(self, points: Floats) -> tuple[Floats, Floats]:
        """Pixels (..., 2) of points (..., 3) in the supersampled picture, and their depths."""
        seen = (points - self.position) @ self.axes.T
        scale = self.focal * SUPERSAMPLING
        x = seen[..., 0] / seen[..., 2] * scale + self.width * SUPERSAMPLING / 2
        y = -seen[..., 1] / seen[..., 2] * scale + self.height * SUPERSAMPLING / 2
        return np.stack([x, y], axis=-1), seen[..., 2]

    def rays(self, left: int, top: int, right: int, bottom: int) -> Floats:
        """Unit directions through the pixels of a part of the supersampled picture."""
        scale = self.focal * SUPERSAMPLING
        x = (np.arange(left, right) + 0.5 - self.width * SUPERSAMPLING / 2) / scale
        y = (np.arange(top, bottom) + 0.5 - self.height * SUPERSAMPLING / 2) / scale
        grid = np.stack([*np.meshgrid(x, -y), np.ones((len(y), len(x)))], axis=-1) @ self.axes
        directions: Floats = grid / np.linalg.norm(grid, axis=-1, keepdims=True)
        return directions


def to_image(picture: Floats) -> Image.Image:
    """The finished picture, supersampling taken out."""
    parts = [picture[y::SUPERSAMPLING, x::SUPERSAMPLING] for y in range(SUPERSAMPLING) for x in range(SUPERSAMPLING)]
    light = np.clip(sum(parts[1:], parts[0]) / len(parts), 0.0, 1.0)
    return Image.fromarray((light ** (1 / GAMMA) * 255.0 + 0.5).astype(np.uint8))
