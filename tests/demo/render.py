"""A small renderer for bodies made of round cones: rays, a depth buffer, two lights, a floor with a shadow.

A round cone is what two spheres and the skin stretched over them enclose. Positions are metres, Z up. Images are
float arrays (height, width, 3) of linear light until `to_image`.
"""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray
from PIL import Image, ImageDraw, ImageFilter

Floats = NDArray[np.float64]
Colour = tuple[int, int, int]

SUPERSAMPLING = 2
"""Pictures are drawn this much larger and reduced, so that edges are smooth."""

KEY_LIGHT = np.array([0.20, -0.75, 0.85]) / np.linalg.norm([0.20, -0.75, 0.85])
FILL_LIGHT = np.array([-0.9, 0.1, 0.35]) / np.linalg.norm([-0.9, 0.1, 0.35])

BACKGROUND: Colour = (252, 252, 254)
FLOOR: Colour = (233, 236, 241)
GRID: Colour = (196, 203, 213)

GRID_M = 0.25
SHADOW_TEXELS_PER_M = 90
SHADOW_HALF_M = 3.0


def linear(colour: Colour) -> Floats:
    """The light of a colour on screen."""
    return (np.array(colour, dtype=float) / 255.0) ** 2.2


@dataclass(frozen=True)
class RoundCone:
    """A limb between two spheres."""

    start: Floats
    end: Floats
    start_radius: float
    end_radius: float
    colour: Colour


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


class Stage:
    """The empty floor as one camera sees it; drawn once, then shadows and bodies are put onto copies of it."""

    def __init__(self, camera: Camera, centre: Floats) -> None:
        self.camera = camera
        self.centre = np.array([centre[0], centre[1]])
        rays = camera.rays(0, 0, camera.width * SUPERSAMPLING, camera.height * SUPERSAMPLING)
        falls = rays[..., 2] < -1e-4
        distance = np.where(falls, -camera.position[2] / np.where(falls, rays[..., 2], -1.0), 0.0)
        floor = camera.position[:2] + distance[..., None] * rays[..., :2]
        fade = np.exp(-((np.linalg.norm(floor - self.centre, axis=-1) / 2.3) ** 2)) * falls
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

    def with_body(self, body: list[RoundCone]) -> tuple[Floats, Floats]:
        """The stage with a body on it and its shadow under it; and how far away the body is at each pixel."""
        picture = self.picture * (1.0 - 0.55 * self._shadow(body) * self._fade)[..., None]
        return picture, draw_cones(picture, self.camera, body)

    def _shadow(self, body: list[RoundCone]) -> Floats:
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
        soft = np.asarray(texture.filter(ImageFilter.GaussianBlur(0.025 * SHADOW_TEXELS_PER_M)), dtype=float) / 255.0
        shadow = soft[self._texel[..., 1], self._texel[..., 0]]
        return np.where(self._on_map, shadow, 0.0)


def draw_cones(picture: Floats, camera: Camera, cones: list[RoundCone]) -> Floats:
    """Draw round cones into `picture`, nearer ones over farther ones, with a line where one passes over another.

    Returns how far away the nearest is at each pixel, infinite where there is none.
    """
    height, width = picture.shape[:2]
    depth = np.full((height, width), np.inf)
    layer = np.zeros((height, width, 3))
    for cone in cones:
        box = _bounds(cone, camera, width, height)
        if box is None:
            continue
        left, top, right, bottom = box
        distance, normal = _hit(cone, camera.position, camera.rays(left, top, right, bottom))
        part = depth[top:bottom, left:right]
        nearer = distance < part
        part[nearer] = distance[nearer]
        layer[top:bottom, left:right][nearer] = _shade(normal[nearer], cone.colour, camera)
    body = np.isfinite(depth)
    layer *= (1.0 - 0.5 * _contours(depth))[..., None]
    picture[body] = layer[body]
    return depth


def _bounds(cone: RoundCone, camera: Camera, width: int, height: int) -> tuple[int, int, int, int] | None:
    ends = np.stack([cone.start, cone.end])
    pixels, depths = camera.project(ends)
    radii = np.array([cone.start_radius, cone.end_radius]) * camera.focal * SUPERSAMPLING / depths * 1.08 + 2
    low = np.floor((pixels - radii[:, None]).min(axis=0)).astype(int)
    high = np.ceil((pixels + radii[:, None]).max(axis=0)).astype(int)
    left, top = max(int(low[0]), 0), max(int(low[1]), 0)
    right, bottom = min(int(high[0]), width), min(int(high[1]), height)
    return (left, top, right, bottom) if left < right and top < bottom else None


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


def _shade(normal: Floats, colour: Colour, camera: Camera) -> Floats:
    key = np.clip(normal @ KEY_LIGHT, 0.0, 1.0)
    fill = np.clip(normal @ FILL_LIGHT, 0.0, 1.0)
    sky = 0.5 + 0.5 * normal[:, 2]
    facing = np.clip(-normal @ camera.axes[2], 0.0, 1.0)
    gloss = np.clip(normal @ _halfway(camera), 0.0, 1.0) ** 36
    light = 0.2 + 0.16 * sky + 0.72 * key + 0.16 * fill
    shaded = linear(colour) * (light * (0.72 + 0.28 * facing))[:, None]
    lit: Floats = shaded + 0.07 * gloss[:, None]
    return lit


def _halfway(camera: Camera) -> Floats:
    half = KEY_LIGHT - camera.axes[2]
    unit: Floats = half / np.linalg.norm(half)
    return unit


def _contours(depth: Floats) -> Floats:
    """1 where a limb passes well behind its neighbour pixel, which sets an arm off from the trunk."""
    inner = np.where(np.isfinite(depth), depth, 0.0)
    edge = np.zeros(depth.shape)
    for axis in (0, 1):
        for step in (1, -1):
            neighbour = np.roll(inner, step, axis=axis)
            gap = inner - neighbour
            edge = np.maximum(edge, np.clip((gap - 0.03) / 0.05, 0.0, 1.0) * (neighbour > 0))
    return edge


def to_image(picture: Floats) -> Image.Image:
    """The finished picture, supersampling taken out."""
    height, width = (size // SUPERSAMPLING for size in picture.shape[:2])
    small = picture.reshape(height, SUPERSAMPLING, width, SUPERSAMPLING, 3).mean(axis=(1, 3))
    screen = np.clip(small, 0.0, 1.0) ** (1 / 2.2) * 255.0 + 0.5
    return Image.fromarray(screen.astype(np.uint8))
