"""The floor on which a figure stands: a grid that fades into the distance, and the figure's soft shadow."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from PIL import Image, ImageDraw, ImageFilter

from .camera import SUPERSAMPLING, Camera, Colour, Floats, linear
from .cones import KEY_LIGHT, RoundCone, draw_cones

BACKGROUND: Colour = (252, 252, 254)
FLOOR: Colour = (233, 236, 241)
GRID: Colour = (196, 203, 213)

GRID_M = 0.25
FADE_M = 2.3
SHADOW_TEXELS_PER_M = 90
SHADOW_HALF_M = 3.0
"""The shadow is drawn on a square map of the floor, this far to each side of the centre."""

SHADOW_DARKNESS = 0.55
SHADOW_BLUR_M = 0.025


class Stage:
    """The empty floor as one camera sees it; drawn once, then shadows and bodies are put onto copies of it."""

    def __init__(self, camera: Camera, centre: Floats) -> None:
        self.camera = camera
        self.centre = np.array([centre[0], centre[1]])
        rays = camera.rays(0, 0, camera.width * SUPERSAMPLING, camera.height * SUPERSAMPLING)
        falls = rays[..., 2] < -1e-4
        distance = np.where(falls, -camera.position[2] / np.where(falls, rays[..., 2], -1.0), 0.0)
        floor = camera.position[:2] + distance[..., None] * rays[..., :2]
        fade = np.exp(-((np.linalg.norm(floor - self.centre, axis=-1) / FADE_M) ** 2)) * falls
        # A line is as wide as a fixed share of the grid, but never narrower than a pixel.
        pixel = distance / (camera.focal * SUPERSAMPLING)
        lines = np.zeros(falls.shape)
        for axis in range(2):
            slant = pixel / np.maximum(np.abs(rays[..., 2]), 0.05) if axis == 1 else pixel
            width = np.maximum(0.004, 0.9 * slant)
            off = np.abs((floor[..., axis] / GRID_M + 0.5) % 1.0 - 0.5) * GRID_M
            lines = np.maximum(lines, np.clip(1.5 - off / width, 0.0, 1.0) * np.minimum(0.006 / width, 1.0))
        ground = linear(FLOOR) + (linear(GRID) - linear(FLOOR)) * lines[..., None]
        self.picture = linear(BACKGROUND) + (ground - linear(BACKGROUND)) * fade[..., None]
        self._fade = fade
        texel = ((floor - self.centre + SHADOW_HALF_M) * SHADOW_TEXELS_PER_M).astype(int)
        size = self._shadow_size()
        self._on_map = falls & (texel >= 0).all(axis=-1) & (texel < size).all(axis=-1)
        self._texel = np.where(self._on_map[..., None], texel, 0)

    @staticmethod
    def _shadow_size() -> int:
        return int(2 * SHADOW_HALF_M * SHADOW_TEXELS_PER_M)

    def with_body(self, body: Sequence[RoundCone]) -> tuple[Floats, Floats]:
        """The stage with a body on it and its shadow under it; and how far away the body is at each pixel."""
        picture = self.picture * (1.0 - SHADOW_DARKNESS * self._shadow(body) * self._fade)[..., None]
        return picture, draw_cones(picture, self.camera, body)

    def _shadow(self, body: Sequence[RoundCone]) -> Floats:
        size = self._shadow_size()
        texture = Image.new("L", (size, size), 0)
        pen = ImageDraw.Draw(texture)
        for cone in body:
            ends = []
            for point, radius in ((cone.start, cone.start_radius), (cone.end, cone.end_radius)):
                ground = point[:2] - KEY_LIGHT[:2] * point[2] / KEY_LIGHT[2]
                x, y = (ground - self.centre + SHADOW_HALF_M) * SHADOW_TEXELS_PER_M
                r = radius * SHADOW_TEXELS_PER_M
                ends.append((float(x), float(y), r))
                pen.ellipse((x - r, y - r, x + r, y + r), fill=255)
            (x0, y0, r0), (x1, y1, r1) = ends
            length = max(float(np.hypot(x1 - x0, y1 - y0)), 1e-6)
            nx, ny = -(y1 - y0) / length, (x1 - x0) / length
            pen.polygon(
                [
                    (x0 + nx * r0, y0 + ny * r0),
                    (x1 + nx * r1, y1 + ny * r1),
                    (x1 - nx * r1, y1 - ny * r1),
                    (x0 - nx * r0, y0 - ny * r0),
                ],
                fill=255,
            )
        soft = (
            np.asarray(texture.filter(ImageFilter.GaussianBlur(SHADOW_BLUR_M * SHADOW_TEXELS_PER_M)), dtype=float)
            / 255.0
        )
        shadow = soft[self._texel[..., 1], self._texel[..., 0]]
        return np.where(self._on_map, shadow, 0.0)
