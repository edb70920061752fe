"""Reading a BVH: against the physical limit on the same bytes, two threads against one, and against pybvh."""

from __future__ import annotations

import importlib
import tempfile
import warnings
from collections.abc import Iterator
from pathlib import Path

import motion_theater as mt
from tests.bench.files import take
from tests.bench.limit import against_the_limit, times_ms
from tests.bench.timing import Row, medians_s, ms
from tests.bench.write_bvh import write_bvh


def measure() -> Iterator[Row]:
    """Yield the rows of the table."""
    measured = take()
    with tempfile.TemporaryDirectory() as folder:
        bvh = measured.bvh or write_bvh(measured, Path(folder) / "same.bvh")
        yield from against_the_limit("BVH", times_ms(bvh))
        yield _against_pybvh(bvh)


def _against_pybvh(bvh: Path) -> Row:
    """Both give the joints and all angles as arrays; ours works out unit, up axis and quaternions besides."""

    def ours() -> object:
        motion = mt.read(bvh).motion
        assert motion is not None
        return [(motion.angles(bone), motion.translations(bone)) for bone in range(len(motion.names))]

    pybvh = importlib.import_module("pybvh")
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        ours_s, theirs_s = medians_s(ours, lambda: pybvh.read_bvh_file(bvh))
    return Row(
        "BVH file to arrays of all angles, against pybvh",
        theirs_s / ours_s,
        2.5,
        detail=f"{ms(ours_s)}, {ms(theirs_s)}",
    )
