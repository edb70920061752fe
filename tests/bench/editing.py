"""One edit of one track: against the bare writing of the keys that change."""

from __future__ import annotations

import tempfile
from collections.abc import Iterator
from itertools import cycle
from pathlib import Path

import bpy
import numpy as np
from numpy.typing import NDArray

from tests import harness
from tests.bench.files import TESTDATA
from tests.bench.timing import Row, medians_s, ms

FRAMES = 5000
CUTS = (1, 3)

Coordinates = dict[tuple[str, int], NDArray[np.float32]]


def measure() -> Iterator[Row]:
    """Yield the row of the table: a track of 30 bones over 5,000 frames, whose cut is moved by two frames and back.

    The keys stay where they are, all values of moving channels change. The reference has the values ready and knows
    which curves change; it writes them and lets Blender recompute the handles.
    """
    with tempfile.TemporaryDirectory() as folder:
        harness.empty_file()
        bpy.context.scene.render.fps = 120
        ob = harness.import_human()
        bpy.ops.motion_theater.add_track(
            filepath=str(_long_clip(Path(folder))), cut_start=CUTS[0], cut_end=FRAMES, scale_start=1, scale_end=FRAMES
        )
        (entry,) = ob.motion_theater.entries
        states: dict[int, Coordinates] = {}
        for cut in (CUTS[1], CUTS[0]):
            entry.cut_start = cut
            states[cut] = _coordinates(ob)
        curves = harness.fcurves(ob)
        before, after = states[CUTS[0]], states[CUTS[1]]
        changing = [(curves[at], (before[at], after[at])) for at in before if not np.array_equal(before[at], after[at])]

        cuts = cycle(reversed(CUTS))

        def edit() -> None:
            entry.cut_start = next(cuts)

        def write(state: int) -> None:
            for curve, coordinates in changing:
                curve.keyframe_points.foreach_set("co", coordinates[state])
                curve.keyframe_points.handles_recalc()

        def write_other_state() -> None:
            write(0 if entry.cut_start == CUTS[1] else 1)

        def prepare() -> None:
            """Give the curves what the last edit left, or it would notice that somebody else wrote them."""
            write(1 if entry.cut_start == CUTS[1] else 0)

        ours_s, theirs_s = medians_s(edit, write_other_state, prepare=prepare)
        prepare()
        edit()
        prepare()
    assert not ob.motion_theater.hand_edited, ob.motion_theater.message
    keys = sum(len(coordinates[0]) // 2 for _, coordinates in changing)
    detail = f"{ms(ours_s)}, bare writing {ms(theirs_s)}; {len(changing)} curves, {keys:,} keys"
    yield Row("One edit of one track, 30 bones x 5,000 frames", ours_s / theirs_s, 1.3, at_most=True, detail=detail)


def _long_clip(folder: Path) -> Path:
    """Write a clip of 5,000 frames: the walk, there and back again until it is long enough."""
    text = (TESTDATA / "walk.amc").read_text(encoding="ascii")
    head, _, body = text.partition("\n1\n")
    frames: list[list[str]] = [[]]
    for line in body.splitlines():
        if line.isdigit():
            frames.append([])
        else:
            frames[-1].append(line)
    there_and_back = cycle([*frames, *frames[-2:0:-1]])
    lines = [head]
    for number, frame in zip(range(1, FRAMES + 1), there_and_back, strict=False):
        lines += [str(number), *frame]
    path = folder / "long.amc"
    path.write_text("\n".join(lines) + "\n", encoding="ascii")
    return path


def _coordinates(ob: bpy.types.Object) -> Coordinates:
    read = harness.module("curves.read")
    return {at: read.coordinates(curve) for at, curve in harness.fcurves(ob).items()}
