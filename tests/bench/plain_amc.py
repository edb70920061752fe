"""AMC as one would read it in plain Python: what `make bench` compares the reader with, and a witness in the tests."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from pathlib import Path

Frame = dict[str, list[float]]


def read_amc(path: Path) -> list[Frame]:
    """Return per frame the values of each bone, as they stand in the file."""
    frames: list[Frame] = []
    with path.open(encoding="utf-8") as lines:
        for line in lines:
            words = line.split()
            if not words or words[0].startswith(("#", ":")):
                continue
            if len(words) == 1 and words[0].isdigit():
                frames.append({})
            else:
                frames[-1][words[0]] = [float(word) for word in words[1:]]
    return frames
