"""Reading an AMC: against the physical limit on the same bytes, and against plain Python."""

from __future__ import annotations

from collections.abc import Iterator

import motion_theater as mt
from tests.bench.files import Take, take
from tests.bench.limit import against_the_limit, times_ms
from tests.bench.plain_amc import read_amc
from tests.bench.timing import Row, Task, medians_s, ms


def measure() -> Iterator[Row]:
    """Yield the rows of the table."""
    measured = take()
    yield from _against_the_limit(measured)
    yield from _against_plain_python(measured)


def _against_the_limit(measured: Take) -> Iterator[Row]:
    """The limit: the same numbers, read from a text that holds nothing else."""
    yield from against_the_limit("AMC", times_ms(measured.amc, measured.asf))


def _against_plain_python(measured: Take) -> Iterator[Row]:
    """Plain Python gives lists of numbers; ours keeps one table, and in the second row gives arrays of rotations."""
    skeleton = mt.read(measured.asf).skeleton

    def rotations() -> object:
        motion = mt.read(measured.amc, skeleton=skeleton).motion
        assert motion is not None
        return [motion.rotations(bone) for bone in range(len(motion.names))]

    tasks: dict[str, Task] = {
        "AMC file read, against plain Python": lambda: mt.read(measured.amc),
        "AMC file to rotations on its skeleton, against plain reading": rotations,
    }
    for what, ours in tasks.items():
        ours_s, theirs_s = medians_s(ours, lambda: read_amc(measured.amc))
        yield Row(what, theirs_s / ours_s, 20, detail=f"{ms(ours_s)}, {ms(theirs_s)}")
