"""A Blender of its own that uses a library while others do: `python -m tests.scene.library_child NAME`.

It searches, pages, and rates, tags and uses clips whose names begin with NAME, and prints what it wrote as JSON. Any
error ends it with words, and a call that blocks longer than the library waits for other programs ends it with a trace.
"""

from __future__ import annotations

import faulthandler
import json
import os
import random
import sys
from typing import Any

import bpy

from tests import harness
from tests.scene import library_stage as library

BUSY_S = 20.0
"""So long the library waits for other programs that write."""
ROUNDS = 25
PAGE = 30
SEARCHES = ("", "bvh", "rest rate>=1", "rating>=1 used:no", "tag:both", "-broken:yes duration<9", "missing:no used:1h")
session = library.session


def look(chance: random.Random) -> None:
    """Search, and look at a page of what is found."""
    fields().search = chance.choice(SEARCHES)
    fields().sort = chance.choice(("name", "path", "used", "rating", "duration"))
    done()
    found = session.state.ids
    first = chance.randrange(max(1, len(found)))
    for clip_id in found[first : first + PAGE]:
        library.rows.get(int(clip_id))
        harness.module("library.pictures").icon(int(clip_id))
    done()


def write(name: str, chance: random.Random, wrote: dict[int, Any]) -> bool:
    """Write all that can be said of a clip with fields and operators, and use it; return whether there was one."""
    fields().search = f"name:{name} broken:no missing:no"
    done()
    if not len(session.state.ids):
        return False
    session.choose(chance.randrange(len(session.state.ids)))
    library.rows.active()
    done()
    clip, form = library.rows.active(), fields()
    last = chance.randrange(2, 30)
    form.rating, form.is_favourite, form.tags = last % 5 + 1, bool(last % 2), f"both, {name} {last}"
    form.subject = f"{name} {last}"
    bpy.ops.motion_theater.library_mark_usable(clip=clip.id, clear=True)
    for first in (1, 2):
        bpy.ops.motion_theater.library_mark_usable(clip=clip.id, first=first, last=last)
    bpy.ops.motion_theater.library_import(clip=clip.id)
    done()
    wrote[clip.id] = [last % 5 + 1, bool(last % 2), sorted(["both", f"{name} {last}"]), f"{name} {last}"]
    return True


def done() -> None:
    """Wait for the background, and end where something went wrong."""
    library.settle()
    state = session.state
    if state.trouble or state.misunderstood or state.is_alarming:
        sys.exit(state.trouble or state.misunderstood or state.message)


def fields() -> Any:
    """Return the fields of the sidebar."""
    return bpy.context.window_manager.motion_theater_library


def main() -> None:
    """Use the library for some rounds."""
    name = sys.argv[1]
    chance = random.Random(name)
    wrote: dict[int, Any] = {}
    harness.empty_file()
    session.ensure_open()
    print("begun", flush=True)
    rounds = 0
    while rounds < ROUNDS:
        faulthandler.dump_traceback_later(BUSY_S, exit=True)
        look(chance)
        rounds += write(name, chance, wrote)
    faulthandler.cancel_dump_traceback_later()
    harness.module("library.closing").close()
    print("wrote", json.dumps(wrote), flush=True)
    os._exit(0)  # after an undo without a window, the bpy module may crash while the interpreter ends


if __name__ == "__main__":
    main()
