"""Recordings for the sessions, made from the project's own clips: a folder of all kinds, and a figure of markers."""

from __future__ import annotations

import shutil
from pathlib import Path

import numpy as np

import motion_theater
from tests.gui import stage

FOLDER = Path("/tmp/recordings")
GAPS = {"lhand": (20, 26), "rfoot": (30, 60), "head": (40, 44)}
"""Markers that drop out, with the frames on which they do."""


def figure() -> motion_theater.Markers:
    """Return the joints of the walk as markers in millimetres, three of which drop out."""
    skeleton = motion_theater.read(f"{stage.TESTDATA}/human.asf").skeleton
    motion = motion_theater.read(f"{stage.TESTDATA}/walk.amc", skeleton=skeleton).motion
    ends = [motion.pose(skeleton, motion.first_frame + frame)[1] for frame in range(motion.frames)]
    x, y, z = np.moveaxis(np.stack(ends, axis=1) * skeleton.unit_m * 1000.0, -1, 0)
    positions = np.stack([x, -z, y], axis=-1)
    for name, (start, end) in GAPS.items():
        positions[skeleton.names.index(name), start:end] = np.nan
    events = [("Foot Strike", 0.2), ("Foot Off", 0.5)]
    return motion_theater.Markers(
        skeleton.names, positions, rate_hz=motion.rate_hz or 60.0, unit_m=0.001, events=events
    )


def folder() -> list[str]:
    """Write a folder of mixed recordings, two of them damaged; return the names of the files."""
    shutil.rmtree(FOLDER, ignore_errors=True)
    FOLDER.mkdir()
    for name in ("human.asf", "walk.amc", "wave.amc", "turn.amc", "step_and_jump.amc"):
        shutil.copy(f"{stage.TESTDATA}/{name}", FOLDER / name)
    skeleton = motion_theater.read(FOLDER / "human.asf").skeleton
    for name in ("walk", "wave"):
        motion = motion_theater.read(FOLDER / f"{name}.amc", skeleton=skeleton).motion
        (FOLDER / f"{name}.bvh").write_bytes(motion_theater.to_bvh(skeleton, motion))
    markers = figure()
    for kind in ("c3d", "csm", "trc"):
        (FOLDER / f"figure.{kind}").write_bytes(markers.to_bytes(kind))
    (FOLDER / "cut off.c3d").write_bytes((FOLDER / "figure.c3d").read_bytes()[:700])
    (FOLDER / "no numbers.bvh").write_text("HIERARCHY\nROOT Hips\n{\nOFFSET 0 zero 0\n}\n")
    return sorted(path.name for path in FOLDER.iterdir())
