"""Where on the timeline a track lies."""

from __future__ import annotations

import math

ASSUMED_RATE_HZ = 120.0  # of motion files that do not say theirs: most Acclaim motion was recorded so
SAME_FRAME = 1e-6  # as in the core: two frames nearer than this are one


def extent(
    *,
    first: int,
    frames: int,
    file_hz: float,
    scene_hz: float,
    cut: tuple[int | None, int | None] = (None, None),
    scale: tuple[int | None, int | None] = (None, None),
    on_whole_frames: bool = True,
) -> tuple[float, float]:
    """Return the first and last scene frame of a track, without its blends.

    A frame of the file lies where it was recorded: at `first + (frame - first) * scene_hz / file_hz`. Cutting keeps
    that place; a scale frame replaces it. The clip's own end comes to the nearest whole frame, so that it lasts as long
    as it was recorded.
    """
    last = first + frames - 1
    start, end = (
        first + (frame - first) * scene_hz / file_hz
        for frame in (
            first if cut[0] is None else max(cut[0], first),
            last if cut[1] is None else min(cut[1], last),
        )
    )
    if scale != (None, None):
        start = math.floor(start + 0.5) if scale[0] is None else scale[0]
        end = math.floor(end + 0.5) if scale[1] is None else scale[1]
    elif on_whole_frames:
        start = math.ceil(start - SAME_FRAME)
        is_files_end = cut[1] is None or cut[1] >= last
        end = max(math.floor(end - SAME_FRAME + 0.5) if is_files_end else math.floor(end + SAME_FRAME), start)
    return float(start), float(end)
