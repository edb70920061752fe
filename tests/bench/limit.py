"""The physical limit of reading numbers, and our readers beside it: measured in Rust, in one process."""

from __future__ import annotations

import re
import subprocess
from pathlib import Path

from tests.bench.files import ROOT


def times_ms(*files: Path) -> dict[str, float]:
    """Return the median of each line of `core/benches/read.rs` by its name: `numbers` is the limit."""
    command = ["cargo", "bench", "--quiet", "--locked", "--package", "motion-theater-core", "--bench", "read", "--"]
    done = subprocess.run([*command, *files], cwd=ROOT, stdout=subprocess.PIPE, text=True, check=True)
    return {name: float(time) for name, time in re.findall(r"^(\w+) +([\d.]+) ms", done.stdout, re.MULTILINE)}
