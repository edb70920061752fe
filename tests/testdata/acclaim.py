"""A plain reader of the project's own clips, for tests of what is in the files."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from testdata.generate import Dofs
from testdata.generate.skeleton import UNIT_M, dofs_of

FOLDER = Path(__file__).resolve().parents[2] / "testdata"


def values(text: str) -> dict[str, np.ndarray]:
    """The numbers of an AMC as they stand there: per bone an array (frames, dofs)."""
    rows: dict[str, list[list[float]]] = {}
    for line in text.splitlines():
        words = line.split()
        if len(words) > 1 and line[0] not in ":#":
            rows.setdefault(words[0], []).append([float(word) for word in words[1:]])
    return {name: np.array(frames) for name, frames in rows.items()}


def dofs(text: str) -> Dofs:
    """The same in metres and radians."""
    converted = {}
    for name, numbers in values(text).items():
        factors = [UNIT_M if dof.startswith("t") else np.pi / 180 for dof in dofs_of(name)]
        converted[name] = numbers * np.array(factors)
    return converted


def words(text: str, keyword: str) -> list[list[str]]:
    """The words behind each line of an ASF that begins with `keyword`."""
    return [line.split()[1:] for line in text.splitlines() if line.split()[:1] == [keyword]]
