"""Pictures on the graphics card, brought there a few at a time so that no redraw waits for them."""

from __future__ import annotations

import time
from collections.abc import Hashable
from typing import TYPE_CHECKING, Any

import gpu
import numpy as np

from ..logic.library.kept import Kept

if TYPE_CHECKING:
    from numpy.typing import NDArray

BUDGET_S = 0.0012  # what bringing pictures over may take of one redraw; at least one is brought
TEXTURES: Kept[gpu.types.GPUTexture] = Kept("Pictures on the graphics card", 64_000_000)

_spent = 0.0


def begin_redraw() -> None:
    """Start counting the time anew."""
    global _spent
    _spent = 0.0


def get(key: Hashable, picture: NDArray[np.uint8]) -> gpu.types.GPUTexture | None:
    """Return a picture (height, width, 4) as a texture, or None if it must wait for the next redraw."""
    global _spent
    known = TEXTURES.get(key)
    if known is not None or _spent > BUDGET_S:
        return known
    begin = time.perf_counter()
    height, width = picture.shape[:2]
    values: Any = np.multiply(picture, 1 / 255, dtype=np.float32).reshape(-1)
    buffer = gpu.types.Buffer("FLOAT", (height * width * 4,), values)
    texture = gpu.types.GPUTexture((width, height), format="RGBA8", data=buffer)
    _spent += time.perf_counter() - begin
    return TEXTURES.keep(key, texture, picture.nbytes)


def close() -> None:
    """Give all textures back."""
    TEXTURES.clear()
