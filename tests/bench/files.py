"""The files that are measured: a real take where it is at hand, else a clip of our own."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
SHARED = ROOT.parent / "shared/data"
TESTDATA = ROOT / "testdata"


@dataclass(frozen=True)
class Take:
    """A motion with its skeleton, and the same take as BVH where there is one."""

    amc: Path
    asf: Path
    bvh: Path | None


def take() -> Take:
    """Return the take to measure: 2,751 frames of 30 bones in the collection of real files."""
    real = Take(SHARED / "asf_amc/cmu01/01_01.amc", SHARED / "asf_amc/cmu01/01.asf", SHARED / "bvh/cmu_mb_01_01.bvh")
    return real if real.amc.is_file() else Take(TESTDATA / "walk.amc", TESTDATA / "human.asf", None)
