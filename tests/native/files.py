"""Where the files to read are: ours, and the collection of real ones where it is at hand."""

from __future__ import annotations

import json
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import motion_theater as mt

ROOT = Path(__file__).resolve().parents[2]
TESTDATA = ROOT / "testdata"
SHARED = ROOT.parent / "shared/data"


@dataclass(frozen=True)
class Pair:
    """A skeleton, a motion for it, and what an independent reader says of them (nothing for our own)."""

    asf: Path
    amc: Path
    facts: dict[str, Any]

    @property
    def name(self) -> str:
        """Return what stands for the pair in the list of tests."""
        return f"{self.amc.parent.name}-{self.amc.stem}"

    def read(self) -> tuple[mt.Skeleton, mt.Motion, mt.Clip]:
        """Read both files."""
        skeleton = mt.read(self.asf).skeleton
        assert skeleton is not None
        clip = mt.read(self.amc, skeleton=skeleton)
        assert clip.motion is not None
        return skeleton, clip.motion, clip


def _real_pairs() -> list[Pair]:
    table = SHARED / "facts.json"
    if not table.is_file():
        return []
    files = json.loads(table.read_text(encoding="utf-8"))["files"]
    pairs = []
    for name, entry in files.items():
        if name.startswith("asf_amc/") and "skeleton" in entry:
            (facts,) = (value for key, value in entry.items() if key.startswith("AMCParser"))
            amc = SHARED / name
            pairs.append(Pair(amc.parent / entry["skeleton"], amc, facts))
    return pairs


OUR_PAIRS = [Pair(TESTDATA / "human.asf", amc, {}) for amc in sorted(TESTDATA.glob("*.amc"))]
REAL_PAIRS = _real_pairs()
