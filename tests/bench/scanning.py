"""Scanning a library, against reading and hashing the same bytes."""

from __future__ import annotations

import re
import subprocess
import tempfile
from collections.abc import Iterator
from pathlib import Path

from tests.bench.files import ROOT
from tests.bench.timing import Row, ms
from tests.library.maker import make

CLIPS = 3000
SHARE = (0.5, 1.0)
"""Clips are this much of the takes that they are cut from: as long as those that people keep."""
THREADS = 2
RUNS = 5


def measure() -> Iterator[Row]:
    """Yield the row of the table. Both are measured in Rust, in one process and by turns."""
    with tempfile.TemporaryDirectory() as folder:
        make(Path(folder), clips=CLIPS, broken=60, share=SHARE)
        command = ["cargo", "bench", "--quiet", "--locked", "--package", "motion-theater-library", "--bench", "scan"]
        asked = [*command, "--", folder, str(THREADS), str(RUNS)]
        done = subprocess.run(asked, cwd=ROOT, stdout=subprocess.PIPE, text=True, check=True)
    told = re.findall(r"^(\w+) +([\d.]+) ms +([\d.]+) ms busy", done.stdout, re.MULTILINE)
    times = {name: float(passed) for name, passed, _ in told}
    busy = {name: float(busy) for name, _, busy in told}
    share = f"; of processor time {busy['plain'] / busy['scan']:.2f}" if busy["plain"] > 0 else ""
    detail = f"{ms(times['scan'] / 1e3)}, reading and hashing {ms(times['plain'] / 1e3)}{share}"
    what = f"{CLIPS:,} clips scanned, {THREADS} threads, against reading and hashing"
    yield Row(what, times["plain"] / times["scan"], 0.5, detail=detail)
