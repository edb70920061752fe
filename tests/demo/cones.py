"""Bodies made of round cones: where a ray meets them, and how they look in two lights.

A round cone is what two spheres and the skin stretched over them enclose.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from .camera import SUPERSAMPLING, Camera, Colour, Floats, linear


def _direction(x: float, y: float, z: float) -> Floats:
    vector = np.array([x, y, z])
    unit: Floats = vector / np.linalg.norm(vector)
    return unit


KEY_LIGHT = _direction(0.20, -0.75, 0.85)
FILL_LIGHT = _direction(-0.9, 0.1, 0.35)

CONTOUR_FROM_M, CONTOUR_OVER_M = 0.03, 0.05
"""A limb that passes in front of another by more than this is set off by a dark line, fully so after that much more."""


@dataclass(frozen=True)
class RoundCone:
    """A limb between two spheres."""

    start: Floats
    end: Floats
    start_radius: float
    end_radius: float
    colour: Colour


def draw_cones(picture: Floats, camera: Camera, cones: Sequence[RoundCone]) -> Floats:
    """Draw round cones into `picture`, nearer ones over farther ones, with a line where one passes over another.

    Returns how far away the nearest is at each pixel, infinite where there is none.
    """
    height, width = picture.shape[:2]
    depth = np.full((height, width), np.inf)
    normals = np.zeros((height, width, 3))
    owners = np.zeros((height, width), dtype=int)
    for index, cone in enumerate(cones):
        left, top, right, bottom = _bounds(cone, camera, width, height)
        if left >= right or top >= bottom:
            continue
        distance, normal = _hit(cone, camera.position, camera.rays(left, top, right, bottom))
        part = depth[top:bottom, left:right]
        nearer = distance < part
        part[nearer] = distance[nearer]
        normals[top:bottom, left:right][nearer] = normal[nearer]
        owners[top:bottom, left:right][nearer] = index
    body = np.isfinite(depth)
    if body.any():
        colours = np.stack([linear(cone.colour) for cone in cones])
        light = _shade(normals[body], colours[owners[body]], camera)
        picture[body] = light * (1.0 - 0.5 * _contours(depth)[body])[:, None]
    return depth


def _bounds(cone: RoundCone, camera: Camera, width: int, height: int) -> tuple[int, int, int, int]:
    """Left, top, right and bottom of the part of the picture that holds the cone; empty if none does."""
    ends = np.stack([cone.start, cone.end])
    pixels, depths = camera.project(ends)
    radii = np.array([cone.start_radius, cone.end_radius]) * camera.focal * SUPERSAMPLING / depths * 1.08 + 2
    low = np.floor((pixels - radii[:, None]).min(axis=0)).astype(int)
    high = np.ceil((pixels + radii[:, None]).max(axis=0)).astype(int)
    left, top = max(int(low[0]), 0), max(int(low[1]), 0)
    right, bottom = min(int(high[0]), width), min(int(high[1]), height)
    return left, top, right, bottom


def _hit(cone: RoundCone, origin: Floats, rays: Floats) -> tuple[Floats, Floats]:
    """Distance (infinite for a miss) and normal where each ray first meets the cone.

    With `p` a point seen from the start, `y` its place along the axis, `s` the sine of the taper and `r` the start's
    radius, the skin between the spheres is where (1 - s^2) |p|^2 - y^2 + 2 r s y - r^2 = 0: quadratic along a ray.
    """
    axis = cone.end - cone.start
    length = float(np.linalg.norm(axis))
    radius = cone.start_radius
    best = np.full(rays.shape[:2], np.inf)
    normal = np.zeros(rays.shape)
    from_start = origin - cone.start
    if length > abs(radius - cone.end_radius):
        axis = axis / length
        s = (radius - cone.end_radius) / length
        c2 = 1 - s * s
        along, place = rays @ axis, from_start @ axis
        a = c2 - along**2
        b = c2 * (rays @ from_start) - place * along + radius * s * along
        c = c2 * (from_start @ from_start) - place**2 + 2 * radius * s * place - radius**2
        root = b * b - a * c
        real = (root > 0) & (a > 1e-9)
        t = np.where(real, (-b - np.sqrt(np.where(real, root, 0.0))) / np.where(real, a, 1.0), np.inf)
        centre = np.where(real, (place + np.where(real, t, 0.0) * along - s * radius) / c2, -1.0)
        skin = real & (centre > 0) & (centre < length)
        best[skin] = t[skin]
        points = from_start + t[skin, None] * rays[skin]
        normal[skin] = (points - centre[skin, None] * axis) / (radius - s * centre[skin])[:, None]
    for point, size in ((cone.start, cone.start_radius), (cone.end, cone.end_radius)):
        offset = origin - point
        b = rays @ offset
        root = b * b - offset @ offset + size * size
        t = np.where(root > 0, -b - np.sqrt(np.maximum(root, 0.0)), np.inf)
        nearer = t < best
        best[nearer] = t[nearer]
        normal[nearer] = (offset + t[nearer, None] * rays[nearer]) / size
    return best, normal


def _shade(normal: Floats, colour: Floats, camera: Camera) -> Floats:
    """The light of surfaces that face along `normal`."""
    towards = -camera.axes[2]
    key = np.clip(normal @ KEY_LIGHT, 0.0, 1.0)
    fill = np.clip(normal @ FILL_LIGHT, 0.0, 1.0)
    sky = 0.5 + 0.5 * normal[:, 2]
    facing = np.clip(normal @ towards, 0.0, 1.0)
    gloss = np.clip(normal @ _direction(*(KEY_LIGHT + towards)), 0.0, 1.0) ** 36
    light = (0.2 + 0.16 * sky + 0.72 * key + 0.16 * fill) * (0.72 + 0.28 * facing)
    shaded: Floats = colour * light[:, None] + 0.07 * gloss[:, None]
    return shaded


def _contours(depth: Floats) -> Floats:
    """1 where a limb passes well behind its neighbour pixel, which sets an arm off from the trunk; else 0."""
    rows, columns = (np.flatnonzero(np.isfinite(depth).any(axis=axis)) for axis in (1, 0))
    body = np.s_[rows[0] : rows[-1] + 1, columns[0] : columns[-1] + 1]
    # Where there is no body there is no contour either: the empty pixels count as behind.
    inner = np.pad(depth[body], 1, constant_values=np.inf)
    nearest = np.minimum.reduce([inner[:-2, 1:-1], inner[2:, 1:-1], inner[1:-1, :-2], inner[1:-1, 2:]])
    seen = np.isfinite(inner[1:-1, 1:-1]) & np.isfinite(nearest)
    gap = np.where(seen, inner[1:-1, 1:-1], 0.0) - np.where(seen, nearest, 0.0)
    edge = np.zeros(depth.shape)
    edge[body] = np.clip((gap - CONTOUR_FROM_M) / CONTOUR_OVER_M, 0.0, 1.0)
    return edge
