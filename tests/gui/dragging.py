"""Dragging a number of the stack with the mouse moves the character while dragging, and is one undo step."""

from __future__ import annotations

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2]))

import drive

from tests.gui import hand, stage

STEPS = 12


def session() -> hand.Session:
    """Drag Scale To of the active track, look at the motion on the way, undo and redo."""
    yield from stage.prepared()
    before = stage.state()
    entry = stage.armature().motion_theater.entries[1]
    x, y = yield from hand.find_field("entries[1].scale_end")
    drive.move(x, y)
    yield 0.2
    window = drive.window()
    window.event_simulate(type="LEFTMOUSE", value="PRESS", x=x, y=y)
    on_the_way = []
    for step in range(1, STEPS + 1):
        drive.move(x + 4 * step, y)
        yield 0.25
        on_the_way.append(stage.state())
    drive.screenshot("dragging")
    window.event_simulate(type="LEFTMOUSE", value="RELEASE", x=x + 4 * STEPS, y=y)
    yield 0.5
    after = stage.state()
    distinct = len({tuple(sorted(state.items())) for state in on_the_way} - {tuple(sorted(before.items()))})
    print(f"dragged Scale To from 66 to {entry.scale_end}; {distinct} different motions on the way", flush=True)
    assert distinct >= 3, "the motion did not follow the mouse"
    assert after == on_the_way[-1]
    yield from drive.key("Z", ctrl=True)
    yield 0.5
    assert stage.state() == before, "one Ctrl+Z does not bring back what was before the drag"
    assert stage.armature().motion_theater.entries[1].scale_end == 66
    yield from drive.key("Z", ctrl=True, shift=True)
    yield 0.5
    assert stage.state() == after, "redo differs from what was dragged"


drive.run(session())
