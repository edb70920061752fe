"""Reading C3D files: against reading and copying the same bytes, and against ezc3d."""

from __future__ import annotations

import importlib
import subprocess
from collections.abc import Iterator
from functools import partial
from pathlib import Path

import motion_theater as mt
from tests.bench.files import ROOT, SHARED
from tests.bench.timing import Row, medians_s, ms


def measure() -> Iterator[Row]:
    """Yield the rows of the table; none where the collection of real files is not at hand."""
    files = [path for path in sorted(SHARED.glob("c3d/**/*")) if path.suffix.lower() == ".c3d" and path.stat().st_size]
    if not files:
        return
    yield _against_copying()
    yield _against_ezc3d(files)


def _against_copying() -> Row:
    """Measured in Rust, in one process: all files, and the share that reading them reaches."""
    command = ["cargo", "bench", "--quiet", "--locked", "--package", "motion-theater-core", "--bench", "read_c3d"]
    done = subprocess.run(command, cwd=ROOT, stdout=subprocess.PIPE, text=True, check=True)
    copy_us, read_us, *_ = done.stdout.strip().splitlines()[-1].split()
    copy_s, read_s = float(copy_us) * 1e-6, float(read_us) * 1e-6
    detail = f"{ms(read_s)}, copying {ms(copy_s)}"
    return Row("C3D files read, all of the collection, share of copying", copy_s / read_s, 0.6, detail=detail)


def read_everything(path: Path) -> None:
    """Read a file and ask for all of its values, as ezc3d always decodes them."""
    markers = mt.read(path).markers
    assert markers is not None
    _ = markers.positions, markers.residuals, [channel.samples for channel in markers.analog]


def _against_ezc3d(files: list[Path]) -> Row:
    """ezc3d cannot read some files; the slowest of the others in comparison counts."""
    ezc3d = importlib.import_module("ezc3d")
    ratios = {}
    for path in files:
        try:
            ezc3d.c3d(str(path))
        except (RuntimeError, ValueError, TypeError, OSError):
            continue
        ours_s, theirs_s = medians_s(partial(read_everything, path), partial(ezc3d.c3d, str(path)))
        ratios[path] = theirs_s / ours_s, f"{ms(ours_s)}, {ms(theirs_s)}"
    worst = min(ratios, key=lambda path: ratios[path][0])
    ratio, detail = ratios[worst]
    return Row(
        "C3D file read and decoded, against ezc3d, the worst of all",
        ratio,
        5,
        detail=f"of {len(ratios)}, {worst.name}: {detail}",
    )
