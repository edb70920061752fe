"""Stills and moving strips of clips, as they come into sight: ready for textures, and as icons of the sidebar."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import bpy.utils.previews
import numpy as np

from ..logic.library.kept import Kept
from . import redraw, session, work

if TYPE_CHECKING:
    from numpy.typing import NDArray

ICON = 128  # pixels of the larger side of a picture in the sidebar
ICONS_AT_MOST = 600


@dataclass(frozen=True)
class Strip:
    """A moving picture."""

    frames: NDArray[np.uint8]
    """(frames, height, width, 4), rows from the top."""
    rate_hz: float


STILLS: Kept[NDArray[np.uint8]] = Kept("Stills", 64_000_000)
STRIPS: Kept[Strip] = Kept("Moving strips", 96_000_000)
NOTHING = np.empty((0, 0, 4), np.uint8)
"""Stands for a picture that there is not."""
ENTRY_BYTES = 500  # what keeping a picture takes besides its pixels, and knowing that there is none

_icons: Any = None


def still(clip_id: int) -> NDArray[np.uint8] | None:
    """Return the picture of a clip; None if it has yet to be fetched, empty if there is none."""
    known = STILLS.get(clip_id)
    key = ("still", clip_id)
    if known is None and not work.waits("pictures", key):
        work.ask("pictures", key, lambda: session.library().still(clip_id), lambda *got: _keep_still(clip_id, *got))
    return known


def strip(clip_id: int) -> Strip | None:
    """Return the moving picture of a clip; None if it has yet to be fetched, without frames if there is none."""
    known = STRIPS.get(clip_id)
    key = ("strip", clip_id)
    if known is None and not work.waits("pictures", key):
        work.ask("pictures", key, lambda: session.library().strip(clip_id), lambda *got: _keep_strip(clip_id, *got))
    return known


def forget_missing() -> None:
    """Ask again for pictures that were not there: they may have been made by now."""
    for clip_id in STILLS.keys_of(lambda picture: not picture.size):
        STILLS.forget(clip_id)
    for clip_id in STRIPS.keys_of(lambda kept: not len(kept.frames)):
        STRIPS.forget(clip_id)


def icon(clip_id: int) -> int:
    """Return the icon of a clip's still for the sidebar, or 0 as long as there is none."""
    global _icons
    if _icons is None:
        _icons = bpy.utils.previews.new()
    name = str(clip_id)
    if name in _icons:
        return int(_icons[name].icon_id)
    picture = still(clip_id)
    if picture is None or not picture.size:
        return 0
    preview = _icons.new(name)
    small = _squared(picture)
    preview.image_size = (small.shape[1], small.shape[0])
    preview.image_pixels_float.foreach_set(np.ascontiguousarray(small[::-1], np.float32).reshape(-1) / 255.0)
    return int(preview.icon_id)


def drop_icons() -> None:
    """Give the icons back to Blender."""
    global _icons
    if _icons is not None:
        bpy.utils.previews.remove(_icons)
        _icons = None


def _squared(picture: NDArray[np.uint8]) -> NDArray[np.uint8]:
    """Return a picture no larger than an icon, square, with its middle kept."""
    step = max(1, -(-max(picture.shape[:2]) // ICON))
    height, width = (length // step for length in picture.shape[:2])
    blocks = picture[: height * step, : width * step].reshape(height, step, width, step, 4)
    small = blocks.mean(axis=(1, 3)).astype(np.uint8)
    side = max(small.shape[:2])
    square = np.zeros((side, side, 4), np.uint8)
    top, left = (side - small.shape[0]) // 2, (side - small.shape[1]) // 2
    square[top : top + small.shape[0], left : left + small.shape[1]] = small
    return square


def _keep_still(clip_id: int, picture: Any, error: BaseException | None) -> None:
    shown = NOTHING if picture is None or error is not None else picture
    STILLS.keep(clip_id, shown, shown.nbytes + ENTRY_BYTES)
    if _icons is not None and len(_icons) > ICONS_AT_MOST:
        drop_icons()  # here and not while a panel is drawn, which may show them
    redraw.everything()


def _keep_strip(clip_id: int, preview: Any, error: BaseException | None) -> None:
    there = preview is not None and error is None
    kept = Strip(preview.frames, preview.rate_hz) if there else Strip(NOTHING[None][:0], 0.0)
    STRIPS.keep(clip_id, kept, kept.frames.nbytes + ENTRY_BYTES)
    redraw.everything()


def close() -> None:
    """Forget all pictures."""
    drop_icons()
    STILLS.clear()
    STRIPS.clear()
