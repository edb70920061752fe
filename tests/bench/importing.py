"""From files to an animated armature: against Blender's own BVH importer on the same motion."""

from __future__ import annotations

import os
import shutil
import tempfile
from collections.abc import Iterator
from pathlib import Path

import bpy

from tests import harness
from tests.bench.files import take
from tests.bench.timing import Row, medians_s, ms
from tests.bench.write_bvh import write_bvh

RATE_HZ = 120


def measure() -> Iterator[Row]:
    """Yield the row of the table. Both keep every sample, on whole frames, as quaternion keys with valid handles."""
    measured = take()
    with tempfile.TemporaryDirectory() as folder:
        # Copies whose time of change is new each time, so that nothing comes from a cache of ours.
        asf, amc = (Path(shutil.copy(path, folder)) for path in (measured.asf, measured.amc))
        bvh = measured.bvh or write_bvh(measured, Path(folder) / "same.bvh")

        def prepare() -> None:
            harness.empty_file()
            bpy.context.scene.render.fps = RATE_HZ
            for path in (asf, amc):
                os.utime(path)

        def ours() -> None:
            bpy.ops.motion_theater.import_skeleton(filepath=str(asf))
            bpy.ops.motion_theater.add_track(filepath=str(amc))

        def theirs() -> None:
            bpy.ops.import_anim.bvh(filepath=str(bvh), rotate_mode="QUATERNION", use_fps_scale=False)

        prepare()
        ours()
        our_keys = _keys()
        prepare()
        theirs()
        their_keys = _keys()
        ours_s, theirs_s = medians_s(ours, theirs, prepare=prepare)
    detail = f"{ms(ours_s)} for {our_keys:,} keys, {ms(theirs_s)} for {their_keys:,}"
    yield Row("Files to animated armature, against Blender's BVH importer", theirs_s / ours_s, 7, detail=detail)


def _keys() -> int:
    return sum(len(curve.keyframe_points) for curve in harness.fcurves(harness.armature()).values())
