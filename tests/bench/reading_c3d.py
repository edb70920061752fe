"""Reading C3D files: against reading and copying the same bytes, and against ezc3d."""

from __future__ import annotations

import importlib
import re
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
    yield from _against_copying()
    yield _against_ezc3d(files)


def _against_copying() -> Iterator[Row]:
    """Measured in Rust, in one process: the file that reaches the least share, and all of them.

    Reading finds the parameters and where each number lies; what is made of them when asked for is in the details:
    markers with their names, unit and up axis, and everything as arrays.
    """
    command = ["cargo", "bench", "--quiet", "--locked", "--package", "motion-theater-core", "--bench", "read_c3d"]
    done = subprocess.run(command, cwd=ROOT, stdout=subprocess.PIPE, text=True, check=True)
    rows = re.findall(r"^ *\d* +([\d.]+) +([\d.]+) +([\d.]+) +([\d.]+) +[\d.]+  (.+)$", done.stdout, re.MULTILINE)
    *files, together = [(name, *map(float, times)) for *times, name in rows]
    worst = min(files, key=lambda row: row[1] / row[2])
    for what, (name, copy, read, named, arrays) in {
        "the worst of all": worst,
        "all of the collection": together,
    }.items():
        shares = f"with names and unit {copy / named:.2f}, as arrays {copy / arrays:.2f}"
        detail = f"{name}: {read:.1f} us, copying {copy:.1f} us; {shares}"
        yield Row(f"C3D read, {what}, share of copying", copy / read, 0.6, detail=detail)


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
