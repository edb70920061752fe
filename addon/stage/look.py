"""Colors and sizes of the browser, those of Blender's dark interface."""

from __future__ import annotations

from ..logic.library.shapes import Color

BACKGROUND: Color = (0.085, 0.09, 0.1, 0.985)
BAR: Color = (0.13, 0.135, 0.145, 0.985)
CELL: Color = (0.085, 0.09, 0.1, 1.0)
TILE: Color = (0.145, 0.15, 0.165, 1.0)
TILE_HOVERED: Color = (0.2, 0.21, 0.23, 1.0)
LINE: Color = (0.27, 0.28, 0.3, 1.0)
BUTTON: Color = (0.22, 0.225, 0.24, 1.0)
BUTTON_HOVERED: Color = (0.31, 0.32, 0.34, 1.0)
BUTTON_OFF: Color = (0.16, 0.165, 0.175, 1.0)
FIELD: Color = (0.06, 0.065, 0.07, 1.0)
ACCENT: Color = (0.28, 0.47, 0.76, 1.0)
ACCENT_HOVERED: Color = (0.34, 0.55, 0.86, 1.0)
TEXT: Color = (0.9, 0.9, 0.91, 1.0)
TEXT_DIM: Color = (0.62, 0.63, 0.66, 1.0)
TEXT_FAINT: Color = (0.42, 0.43, 0.46, 1.0)
ALERT: Color = (1.0, 0.52, 0.42, 1.0)
STAR: Color = (1.0, 0.78, 0.25, 1.0)
MARK: Color = (1.0, 0.68, 0.26, 1.0)
USABLE: Color = (0.35, 0.68, 0.42, 1.0)
TOOLTIP: Color = (0.04, 0.042, 0.046, 0.98)

BAR_HEIGHT = 36.0
BUTTON_HEIGHT = 24.0
GAP = 8.0
RADIUS = 4.0
