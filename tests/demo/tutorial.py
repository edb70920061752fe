"""The tutorial in five steps, from an empty scene to filtered motion: `python -m tests.demo.tutorial --out out`.

Leaves `tutorial.blend`, `tutorial.png` and `tutorial.gif`, and prints what it did and how long each step took.
"""

from __future__ import annotations

import argparse
import os
import sys
import time
from collections.abc import Callable, Iterable
from pathlib import Path

import bpy
import numpy as np

from tests import harness

from . import draw
from .camera import Colour
from .states import Row, Span, State

LEGS = ("root", "lhipjoint", "rhipjoint")
"""The bones on which clip A begins; the legs hang below the hip joints."""

LAST_FRAME = 113
JOIN = 67
"""The frame from which the upper body takes clip A again."""

BLEND_DEPTH = 10
BLENDED = (JOIN - BLEND_DEPTH, JOIN)
"""The frames that are blended: the wave ends just before the join, so there is nothing to blend with after it."""

FILTER_DEPTH = 7

TEAL: Colour = (0, 140, 150)
ORANGE: Colour = (232, 122, 38)
PURPLE: Colour = (112, 76, 196)

LEGS_ROW = Row("Legs", (Span("A: step and jump", 1, LAST_FRAME),))
UPPER_ROW = Row("Upper", (Span("B: wave", 1, JOIN - 1), Span("A", JOIN, LAST_FRAME, BLENDED)))
ARMS_ROW = Row("Arms", (Span(f"weighted average, depth {FILTER_DEPTH}", 1, LAST_FRAME),))


def main(arguments: list[str] | None = None) -> None:
    """Run the tutorial and leave its results in the folder that is asked for."""
    parser = argparse.ArgumentParser(description="Run the five steps of the tutorial.")
    parser.add_argument("--out", type=Path, default=Path("out"), help="the folder for the results")
    out = parser.parse_args(arguments).out.resolve()
    out.mkdir(parents=True, exist_ok=True)

    harness.empty_file()
    print(f"Blender {bpy.app.version_string}, an empty scene")
    states = run()
    for name, make in (
        ("tutorial.blend", lambda path: bpy.ops.wm.save_as_mainfile(filepath=str(path), compress=True)),
        ("tutorial.png", lambda path: draw.picture(states, path)),
        ("tutorial.gif", lambda path: draw.preview(states, path)),
    ):
        began = time.perf_counter()
        make(out / name)
        size = (out / name).stat().st_size
        print(f"{name}: {size / 1e6:.2f} MB in {time.perf_counter() - began:.1f} s")


def run() -> list[State]:
    """The five steps; returns the animation after the second, fourth and fifth."""
    clip_a, clip_b = (str(harness.TESTDATA / name) for name in ("step_and_jump.amc", "wave.amc"))
    operators = bpy.ops.motion_theater

    _step("1. Import the skeleton", lambda: operators.import_skeleton(filepath=str(harness.TESTDATA / "human.asf")))
    ob = harness.armature()
    legs = [LEGS[0], *harness.below(ob, *LEGS[1:])]
    upper = [bone.name for bone in ob.data.bones if bone.name not in legs]
    arms = harness.below(ob, "lhumerus", "rhumerus")

    harness.select(ob, legs)
    _step(
        "2. Clip A (step and jump) on root, hips and legs; the scene takes its rate",
        lambda: operators.add_track(filepath=clip_a, selected_only=True, rate="SCENE"),
    )
    only_legs = _state(
        "Legs only",
        "Clip A on root, hips and legs: the upper body stands still",
        legs,
        TEAL,
        (LEGS_ROW, Row("Upper", ())),
    )

    harness.select(ob, upper)
    _step(
        "3. Clip B (wave) on the upper body, frames 1..55 over 1..66",
        lambda: operators.add_track(
            filepath=clip_b, selected_only=True, cut_start=1, cut_end=55, scale_start=1, scale_end=JOIN - 1
        ),
    )
    _step(
        f"4. Clip A on the upper body from frame {JOIN}, blend depth {BLEND_DEPTH}",
        lambda: operators.add_track(
            filepath=clip_a, selected_only=True, cut_start=JOIN, cut_end=LAST_FRAME, blend_depth=BLEND_DEPTH
        ),
    )
    joined = _state(
        "Arms added",
        f"Clip B to frame {JOIN - 1}, then clip A, blended over frames {BLENDED[0]} to {BLENDED[1]}",
        upper,
        ORANGE,
        (LEGS_ROW, UPPER_ROW),
    )

    harness.select(ob, arms)
    bpy.ops.ed.undo_push(message="Before the filter")
    before = harness.keys(ob)
    _step(
        f"5. Weighted average of depth {FILTER_DEPTH} on the arms",
        # Called from a script, an operator is an undo step only when asked for.
        lambda: operators.filter("EXEC_DEFAULT", True, kind="WEIGHTED", depth=FILTER_DEPTH, selected_only=True),
    )
    after = harness.keys(harness.armature())
    bpy.ops.ed.undo()
    undone = harness.same_keys(before, harness.keys(harness.armature()))
    bpy.ops.ed.redo()
    redone = harness.same_keys(after, harness.keys(harness.armature()))
    print(f"   undo gives the keys from before: {_yes(undone)}; redo those from after: {_yes(redone)}")
    if not (undone and redone):
        raise SystemExit("Undo and redo did not restore the motion")
    filtered = _state(
        "Arms filtered",
        f"Weighted average of depth {FILTER_DEPTH} on everything below both clavicles",
        arms,
        PURPLE,
        (LEGS_ROW, UPPER_ROW, ARMS_ROW),
        shows_before=True,
    )
    return [only_legs, joined, filtered]


def _step(title: str, action: Callable[[], object]) -> None:
    """Carry out a step and print what it was, what it said, and how long it took."""
    began = time.perf_counter()
    action()
    milliseconds = (time.perf_counter() - began) * 1000
    print(f"{title}: {milliseconds:.0f} ms")
    message = harness.armature().motion_theater.message
    if message:
        print(f"   {message}")


def _yes(fact: bool) -> str:
    return "yes" if fact else "NO"


def _state(
    title: str,
    caption: str,
    changed: Iterable[str],
    tint: Colour,
    rows: tuple[Row, ...],
    shows_before: bool = False,
) -> State:
    """The animation as it plays now, sampled on every frame."""
    ob = harness.armature()
    bones = ob.pose.bones
    heads, tails = (np.empty((LAST_FRAME, len(bones), 3)) for _ in range(2))
    buffer = np.empty(3 * len(bones), dtype=np.float32)
    for frame in range(LAST_FRAME):
        bpy.context.scene.frame_set(frame + 1)
        for ends, name in ((heads, "head"), (tails, "tail")):
            bones.foreach_get(name, buffer)
            ends[frame] = buffer.reshape(-1, 3)
    names = [bone.name for bone in bones]
    parents = [names.index(bone.parent.name) if bone.parent else -1 for bone in bones]
    return State(title, caption, names, parents, heads, tails, frozenset(changed), tint, rows, shows_before)


if __name__ == "__main__":
    main()
    # After an undo without a window the bpy module may crash while the interpreter ends.
    sys.stdout.flush()
    os._exit(0)
