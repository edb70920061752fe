"""Imports one BVH in a process of its own and prints seconds, bytes of memory at most above the base, and keys.

`python -m tests.bench.one_import ours|theirs FILE`
"""

from __future__ import annotations

import os
import resource
import sys
import time
from pathlib import Path

import bpy

from tests import harness

RATE_HZ = 120
STATUS = Path("/proc/self/status")


def main(who: str, path: str) -> None:
    """Import as an empty scene of the file's rate: both keep every sample, as quaternion keys on whole frames."""
    harness.empty_file()
    bpy.context.scene.render.fps = RATE_HZ
    base = _forget_the_peak()
    start = time.perf_counter()
    if who == "ours":
        bpy.ops.motion_theater.import_motion_capture(filepath=path)
    else:
        bpy.ops.import_anim.bvh(filepath=path, rotate_mode="QUATERNION", use_fps_scale=False)
    seconds = time.perf_counter() - start
    memory = _peak() - base
    keys = sum(len(curve.keyframe_points) for curve in harness.fcurves(harness.armature()).values())
    print(f"\n{seconds} {memory} {keys}", flush=True)
    os._exit(0)  # bpy may hang on the way out of the interpreter


def _forget_the_peak() -> int:
    """Return the memory that is taken now, from which on the peak is measured: starting Blender takes more."""
    if not STATUS.is_file():
        return _peak()
    Path("/proc/self/clear_refs").write_text("5", encoding="ascii")
    return _status("VmRSS")


def _peak() -> int:
    if STATUS.is_file():
        return _status("VmHWM")
    most = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    return most if sys.platform == "darwin" else 1024 * most


def _status(name: str) -> int:
    lines = STATUS.read_text(encoding="ascii").splitlines()
    (kilobytes,) = (line.split()[1] for line in lines if line.startswith(f"{name}:"))
    return 1024 * int(kilobytes)


if __name__ == "__main__":
    main(*sys.argv[1:])
