"""From a BVH to an animated armature: against Blender's own importer on the same file, time and memory.

Each import has a process of its own: memory that a process once took it seldom gives back. The large file is the real
one with its frames repeated. Blender itself keeps every key twice, in the Action and in what is evaluated of it, of
72 bytes each: that alone is most of what both take.
"""

from __future__ import annotations

import subprocess
import sys
import tempfile
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from statistics import median

from tests.bench.files import ROOT, take
from tests.bench.timing import Row
from tests.bench.write_bvh import write_bvh

RUNS = 3
LARGE_BYTES = 50_000_000


@dataclass(frozen=True)
class Import:
    """What one import took."""

    seconds: float
    memory_mb: float
    keys: int


def measure() -> Iterator[Row]:
    """Yield two rows for each size: how many times as fast, and which share of the memory above the base."""
    measured = take()
    with tempfile.TemporaryDirectory() as folder:
        small = measured.bvh or write_bvh(measured, Path(folder) / "small.bvh")
        large = repeated(small, Path(folder) / "large.bvh", LARGE_BYTES)
        for bvh in (small, large):
            ours, theirs = [], []
            for _ in range(RUNS):
                ours.append(_import("ours", bvh))
                theirs.append(_import("theirs", bvh))
            ours_s, theirs_s = (median(run.seconds for run in runs) for runs in (ours, theirs))
            size = f"{bvh.stat().st_size / 1e6:.0f} MB"
            detail = f"{ours_s:.3g} s for {ours[0].keys:,} keys, {theirs_s:.3g} s for {theirs[0].keys:,}"
            yield Row(f"BVH of {size} to armature, against Blender's importer", theirs_s / ours_s, 8, detail=detail)
            ours_mb, theirs_mb = (median(run.memory_mb for run in runs) for runs in (ours, theirs))
            detail = f"{ours_mb:.0f} MB, {theirs_mb:.0f} MB"
            what = f"BVH of {size} to armature, peak memory, share of Blender's"
            yield Row(what, ours_mb / theirs_mb, 0.5, at_most=True, detail=detail)


def repeated(bvh: Path, path: Path, size: int) -> Path:
    """Write a BVH with the rows of another one, again and again until it has at least that size."""
    head, _, rest = bvh.read_text(encoding="latin-1").partition("MOTION")
    lines = [line for line in rest.splitlines() if line.strip()]
    frame_time, rows = lines[1], lines[2:]
    block = "\n".join(rows) + "\n"
    times = -(-size // len(block))
    with path.open("w", encoding="latin-1") as text:
        text.write(f"{head}MOTION\nFrames: {times * len(rows)}\n{frame_time}\n")
        for _ in range(times):
            text.write(block)
    return path


def _import(who: str, bvh: Path) -> Import:
    command = [sys.executable, "-m", "tests.bench.one_import", who, str(bvh)]
    done = subprocess.run(command, cwd=ROOT, stdout=subprocess.PIPE, text=True, check=True)
    seconds, memory, keys = done.stdout.splitlines()[-1].split()
    return Import(float(seconds), float(memory) / 1e6, int(keys))
