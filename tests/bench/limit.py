"""The physical limit of reading numbers, and our readers beside it: measured in Rust, in one process."""

from __future__ import annotations

import re
import subprocess
from collections.abc import Iterator
from pathlib import Path

from tests.bench.files import ROOT
from tests.bench.timing import Row


def times_ms(*files: Path) -> dict[str, float]:
    """Return the median of each line of `core/benches/read.rs` by its name: `numbers` is the limit."""
    command = ["cargo", "bench", "--quiet", "--locked", "--package", "motion-theater-core", "--bench", "read", "--"]
    done = subprocess.run([*command, *files], cwd=ROOT, stdout=subprocess.PIPE, text=True, check=True)
    return {name: float(time) for name, time in re.findall(r"^(\w+) +([\d.]+) ms", done.stdout, re.MULTILINE)}


def against_the_limit(name: str, times: dict[str, float]) -> Iterator[Row]:
    """Yield the rows of a format: one thread against the limit, two threads against one."""
    numbers, alone, together = times["numbers"], times[name.lower()], times["threads"]
    detail = f"{alone:.3g} ms, its numbers alone {numbers:.3g} ms"
    yield Row(f"{name} bytes read, one thread, share of the limit", numbers / alone, 0.5, detail=detail)
    detail = f"{together:.3g} ms, one {alone:.3g} ms"
    yield Row(f"{name} bytes read, two threads against one", alone / together, 1.6, detail=detail)
