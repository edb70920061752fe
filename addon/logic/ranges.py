"""What becomes of the frame range of the scene when motion is added."""

from __future__ import annotations

import math
from typing import Literal

Choice = Literal["EXTEND", "FIT", "KEEP"]


def scene_range(choice: Choice, scene: tuple[int, int], motion: tuple[float, float]) -> tuple[int, int]:
    """Return the first and last frame of the scene after a motion was added.

    EXTEND, the default, only ever makes the range longer: the new motion plays whole, and nothing that played before is
    cut off. A scene cannot begin before frame 0, so keys before it stay outside.
    """
    if choice == "KEEP":
        return scene
    first, last = max(math.floor(motion[0]), 0), max(math.ceil(motion[1]), 0)
    if choice == "FIT":
        return first, last
    return min(scene[0], first), max(scene[1], last)
