"""Clean motions after a trip through a file, and what is measured on them."""

from __future__ import annotations

from functools import cache

import numpy as np

from testdata.generate import Dofs, Pose, clean_clip, forward
from testdata.generate.body import sole
from testdata.generate.write import amc

from . import acclaim

CLIPS = {"step_and_jump": 113, "wave": 120, "walk": 612, "turn": 210}
"""Every clip and how many frames it has."""

RATE_HZ = 60.0


@cache
def clean(name: str) -> Dofs:
    """The clean clip."""
    return clean_clip(name)


@cache
def clean_pose(name: str) -> Pose:
    """The pose of the clean clip, written with six digits and read again."""
    return forward(acclaim.dofs(amc(name, clean(name))))


@cache
def recorded_pose(name: str) -> Pose:
    """The pose of the committed file."""
    return forward(acclaim.dofs((acclaim.FOLDER / f"{name}.amc").read_text()))


def soles(pose: Pose) -> np.ndarray:
    """Heel, ball and tip of both feet: (frames, 6, 3)."""
    return np.concatenate([sole(pose, "l"), sole(pose, "r")], axis=1)


def heading(rotation: np.ndarray) -> np.ndarray:
    """Where a bone faces on the floor, in degrees and without jumps; 0 is +Z, positive to the left."""
    faces: np.ndarray = np.degrees(np.unwrap(np.arctan2(rotation[:, 0, 2], rotation[:, 2, 2])))
    return faces


def correlation(some: np.ndarray, others: np.ndarray) -> float:
    """Between -1 and 1: whether two curves rise and fall together."""
    return float(np.corrcoef(some, others)[0, 1])
