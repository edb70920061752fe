"""From markers in memory to a marker set: against the bare writing of as many keys."""

from __future__ import annotations

from collections.abc import Iterator

import bpy
import numpy as np

import motion_theater as mt
from tests import harness
from tests.bench.timing import Row, medians_s, ms

MARKERS, FRAMES = 400, 20_000
RATE_HZ = 120.0
RUNS = 3
GAPS = 5
"""In each marker, of a hundredth of the frames each."""


def measure() -> Iterator[Row]:
    """Yield a row without gaps and one with. The clip is read already; ours makes the armature besides the curves."""
    for what, gaps in (("without gaps", 0), (f"{GAPS} gaps in each", GAPS)):
        clip = mt.read_bytes(_recording(gaps), name="recording.c3d")
        assert clip.markers is not None
        numbers = np.ascontiguousarray(clip.markers.positions.transpose(0, 2, 1))
        seen = clip.markers.valid

        def ours(clip: mt.Clip = clip) -> None:
            harness.module("markers").import_markers(bpy.context, clip, rate="SCENE")

        def theirs(numbers: np.ndarray = numbers, seen: np.ndarray = seen) -> None:
            _write_bare(numbers, seen)

        ours_s, theirs_s = medians_s(ours, theirs, prepare=harness.empty_file, runs=RUNS)
        name = f"{MARKERS} markers x {FRAMES:,} frames, {what}"
        detail = f"{ms(ours_s)}, bare writing {ms(theirs_s)}"
        yield Row(name, ours_s / theirs_s, 1.3, at_most=True, detail=detail)


def _recording(gaps: int) -> bytes:
    rng = np.random.default_rng(2004)
    positions = rng.standard_normal((MARKERS, 1, 3)) + np.sin(np.arange(FRAMES) * 0.01)[None, :, None]
    for marker in range(MARKERS if gaps else 0):
        for start in rng.integers(1, FRAMES - FRAMES // 100 - 1, gaps):
            positions[marker, start : start + FRAMES // 100] = np.nan
    names = [f"M{number}" for number in range(MARKERS)]
    return mt.Markers(names, positions, rate_hz=RATE_HZ, up=(0.0, 0.0, 1.0)).to_bytes("c3d")


def _write_bare(numbers: np.ndarray, seen: np.ndarray) -> None:
    """Write linear keys where markers are seen, and constant ones on their scale where they come and go."""
    compat, frames = harness.module("compat"), np.arange(1, FRAMES + 1, dtype=np.float32)
    ob = bpy.data.objects.new("bare", bpy.data.armatures.new("bare"))
    bpy.context.scene.collection.objects.link(ob)
    action = bpy.data.actions.new("bare")
    bag = compat.ensure_bag(ob, action)
    compat.assign(ob, action)
    for marker, (of_marker, valid) in enumerate(zip(numbers, seen, strict=True)):
        bone, is_whole = f'pose.bones["M{marker}"]', bool(valid.all())
        at = frames if is_whole else frames[valid]
        for component, values in enumerate(of_marker):
            _write_curve(bag, f"{bone}.location", component, at, values if is_whole else values[valid], 1)
        if not is_whole:
            changes = np.concatenate(([0], np.flatnonzero(valid[1:] != valid[:-1]) + 1))
            for component in range(3):
                _write_curve(bag, f"{bone}.scale", component, frames[changes], valid[changes], 0)


def _write_curve(
    bag: bpy.types.ActionChannelbag, path: str, component: int, at: np.ndarray, values: np.ndarray, interpolation: int
) -> None:
    curve = bag.fcurves.new(path, index=component)
    curve.auto_smoothing = "NONE"
    keys = np.empty(2 * len(at), np.float32)
    keys[0::2], keys[1::2] = at, values
    points = curve.keyframe_points
    points.add(len(at))
    points.foreach_set("co", keys)
    points.foreach_set("interpolation", np.full(len(at), interpolation, np.uint8))
    points.handles_recalc()
