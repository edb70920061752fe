"""Where on the timeline a track lies."""

from __future__ import annotations


ASSUMED_RATE_HZ = 120.0  # of motion files that do not say theirs: most Acclaim motion was recorded so


def extent(
    *,
    first: int,
    frames: int,
    file_hz: float,
    scene_hz: float,
    cut: tuple[int | None, int | None] = (None, None),
    scale: tuple[int | None, int | None] = (None, None),
) -> tuple[float, float]:
    """Return the first and last scene frame of a track, without its blends.

    A frame of the file lies where it was recorded: at `first + (frame - first) * scene_hz / file_hz`. Cutting keeps
    that place; a scale frame replaces it.
    """

    def placed(frame: int) -> float:
        return first + (frame - first) * scene_hz / file_hz

    last = first + frames - 1
    start = placed(first if cut[0] is None else max(cut[0], first))
    end = placed(last if cut[1] is None else min(cut[1], last))
    return (
        start if scale[0] is None else float(scale[0]),
        end if scale[1] is None else float(scale[1]),
    )
