"""The library in the window, with mouse and keys: scan, stop, search, hover, four at a time, marks, a track.

At the end it is browsed at random for a while (MT_BROWSE_SECONDS); no data-block may come or go by that. What our part
of the redraws and of the main thread took is printed.
"""

from __future__ import annotations

import importlib
import os
import random
import shutil
import sys
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

sys.path.insert(0, str(Path(__file__).resolve().parents[2]))

import bpy
import drive

from tests.gui import hand, stage

CLIPS = int(os.environ.get("MT_LIBRARY_CLIPS", "3000"))
BROWSE_S = float(os.environ.get("MT_BROWSE_SECONDS", "20"))
FOLDER = Path("/tmp/mocap")
NAMED = ("walk", "wave", "turn", "step_and_jump")
SKELETONS = -(-CLIPS // 100)
FRAMES = 40
"""Of the many clips that are cut from the four."""


def ours(name: str) -> Any:
    """Return a module of the installed add-on."""
    return importlib.import_module(f"{stage.MODULE}.{name}")


def make_clips() -> None:
    """Cut thousands of clips from our own, each with other content, in folders by subject; some are broken."""
    shutil.rmtree(FOLDER, ignore_errors=True)
    sources = {name: Path(stage.TESTDATA, f"{name}.amc").read_text().split("\n1\n", 1) for name in NAMED}
    for number in range(CLIPS):
        name = NAMED[number % len(NAMED)]
        folder = FOLDER / f"subject {number // 100:02d}"
        if number % 100 == 0:
            folder.mkdir(parents=True)
            shutil.copy(f"{stage.TESTDATA}/human.asf", folder / f"{number // 100:02d}.asf")
        target = folder / f"{number // 100:02d}_{number % 100:02d}_{name}.amc"
        if number < len(NAMED):
            shutil.copy(f"{stage.TESTDATA}/{name}.amc", target)
            continue
        head, frames = sources[name]
        text = f"# {number}\n{head}\n1\n{frames.split(f'{chr(10)}{FRAMES + 1}{chr(10)}', 1)[0]}\n"
        target.write_text(text if number % 50 != 7 else text.replace("lfemur", "lfemur x", 1))


def data_blocks() -> dict[str, list[tuple[str, int]]]:
    """Return name and number of users of every data-block there is."""
    kinds = [name for name in dir(bpy.data) if isinstance(getattr(bpy.data, name), bpy.types.bpy_prop_collection)]
    return {kind: sorted((block.name_full, block.users) for block in getattr(bpy.data, kind)) for kind in kinds}


def at(x: float, y: float) -> tuple[int, int]:
    """Return a place of the 3D View in the window."""
    view = drive.region("WINDOW")
    return int(view.x + x), int(view.y + y)


def looking() -> Any:
    """Return what the browser shows."""
    return ours("stage.overlay").current.view


def tile(index: int) -> tuple[int, int]:
    """Return the middle of a tile of the grid."""
    remembered = ours("stage.grid_view").Remembered
    return at(*looking().grid.tile(index, remembered.scroll).middle)


def button(name: str) -> hand.Session:
    """Click a button of the browser."""
    view = looking()
    placed = getattr(view, "transport", view).placed
    (area,) = [one.area for one in placed if one.button.name == name]
    yield from drive.click(*at(*area.middle))


def told(what: str) -> None:
    """Print what redraws took since the last time, and forget it."""
    took = sorted(ours("stage.overlay").current.draw_s)
    work = ours("library.work")
    if took:
        median, most, worst = (1e3 * took[int(share * (len(took) - 1))] for share in (0.5, 0.95, 1.0))
        print(
            f"{what}: {len(took)} redraws, our part {median:.2f} ms, 95 of 100 below {most:.2f} ms, "
            f"at worst {worst:.2f} ms",
            flush=True,
        )
    print(f"{what}: the longest slice of the main thread {1e3 * work.longest_slice_s:.1f} ms", flush=True)
    ours("stage.overlay").current.draw_s.clear()


def until(done: Callable[[], bool], seconds: float = 240.0) -> hand.Session:
    """Wait for something of the background."""
    end = time.monotonic() + seconds
    while not done():
        assert time.monotonic() < end, "it did not come to an end"
        yield 0.2


def scan() -> hand.Session:
    """Add the folder as a newcomer does, stop the scan with Esc, and let it be completed."""
    session, scanning = ours("library.session"), ours("library.scanning")
    yield from hand.shot("library-1-empty")
    yield from hand.press("motion_theater.library_folder_add")
    yield from hand.settle(2)
    place = yield from hand.find_field("params.directory", kind="UI", of="FILE_BROWSER", column=0.3)
    yield from hand.write(place, str(FOLDER))
    yield from hand.tap("RET")
    yield from hand.settle(1)
    x, y = yield from hand.find_operator("file.execute", kind="EXECUTE", of="FILE_BROWSER", column=0.92)
    for value in ("PRESS", "RELEASE"):
        drive.window().event_simulate(type="LEFTMOUSE", value=value, x=x, y=y)
        yield 0.05
    while not (scanning.is_running() and scanning.progress()[0] > 0.05):
        yield 0.02
    drive.screenshot("library-2-scanning")
    drive.window().event_simulate(type="ESC", value="PRESS", x=x, y=y)
    yield 0.1
    drive.window().event_simulate(type="ESC", value="RELEASE", x=x, y=y)
    yield from until(lambda: not scanning.is_running(), 30.0)
    print("after Esc:", session.state.message, flush=True)
    bpy.ops.motion_theater.library_scan("INVOKE_DEFAULT")
    yield from until(lambda: not scanning.is_running())
    yield from until(lambda: session.state.total == CLIPS + SKELETONS, 30.0)
    print("the scan:", session.state.message, flush=True)
    yield from hand.shot("library-3-panel")


def opening() -> hand.Session:
    """Open the library as after the start of Blender, with nothing read, and wait until pictures are drawn and move."""
    canvas, textures = ours("stage.canvas"), ours("stage.textures")
    draw, seen = canvas.Canvas.draw, dict[str, float]()

    def noting(self: Any) -> None:
        draw(self)
        shown = {id(texture) for _, layers in self._clips for layer in layers for texture, _ in layer.pictures}
        for _, number in textures.TEXTURES.keys_of(lambda texture: id(texture) in shown):
            seen.setdefault("still" if number < 0 else "strip", time.monotonic())

    canvas.Canvas.draw = noting
    view = drive.region("WINDOW")
    drive.move(view.x + view.width // 3, view.y + view.height // 4)
    yield 0.5
    ours("library.closing").close()
    begin = time.monotonic()
    with bpy.context.temp_override(window=drive.window(), area=drive.area(), region=view):
        bpy.ops.motion_theater.library_browse("INVOKE_DEFAULT")
    for step in range(400):
        if len(seen) == 2:
            break
        if looking().grid.count:
            x, y = tile_of_view()
            drive.move(x + step % 3, y)
        yield 0.05
    canvas.Canvas.draw = draw
    assert len(seen) == 2, f"drawn was {list(seen)}"
    still, strip = (1e3 * (seen[what] - begin) for what in ("still", "strip"))
    print(f"opening: first still after {still:.0f} ms, first strip after {strip:.0f} ms", flush=True)
    told("opening")
    yield from hand.settle(2)


def grid() -> hand.Session:
    """Browse: scroll, search, look at a moving picture."""
    session = ours("library.session")
    yield from opening()
    drive.screenshot("library-4-grid")
    for _ in range(20):
        yield from wheel("WHEELDOWNMOUSE", tile_of_view())
    drive.screenshot("library-5-scrolled")
    told("grid, scrolling")
    place = tile_of_view()
    for step in range(20):
        drive.move(place[0] + step % 3, place[1])
        yield 0.1
    drive.screenshot("library-6-hover")
    told("grid, moving under the mouse")
    hand.mouse = place
    yield from hand.tap("F", ctrl=True)
    yield from hand.type_text("wave")
    yield from until(lambda: len(session.state.ids) == CLIPS // 4, 10.0)
    yield from hand.settle(2)
    drive.screenshot("library-7-search")
    yield from hand.tap("A", ctrl=True)
    yield from hand.type_text("turnip")
    yield from until(lambda: not len(session.state.ids), 10.0)
    drive.screenshot("library-8-nothing")
    yield from hand.tap("A", ctrl=True)
    yield from hand.type_text("00")
    yield from hand.tap("RET")
    yield from hand.settle(2)


def tile_of_view() -> tuple[int, int]:
    """Return the middle of the first tile that is seen as a whole."""
    view = looking()
    remembered = ours("stage.grid_view").Remembered
    whole = [
        index
        for index in view.grid.visible(remembered.scroll)
        if view.grid.view.y <= view.grid.tile(index, remembered.scroll).y
        and view.grid.tile(index, remembered.scroll).top <= view.grid.view.top
    ]
    return tile(whole[0])


def wheel(kind: str, place: tuple[int, int]) -> hand.Session:
    """Turn the wheel by a notch."""
    drive.window().event_simulate(type=kind, value="PRESS", x=place[0], y=place[1])
    yield 0.05


def four() -> hand.Session:
    """Play four at a time; turn the view, page on and back, then nine."""
    yield from drive.click(*tile(1))  # the first is the skeleton
    hand.mouse = tile(1)
    yield from hand.tap("FOUR")
    yield 4.0
    drive.screenshot("library-9-four")
    told("four playing")
    view = drive.region("WINDOW")
    x, y = view.x + view.width // 3, view.y + int(0.7 * view.height)
    drive.window().event_simulate(type="MIDDLEMOUSE", value="PRESS", x=x, y=y)
    for step in range(10):
        drive.move(x + 12 * step, y - 2 * step)
        yield 0.1
    drive.window().event_simulate(type="MIDDLEMOUSE", value="RELEASE", x=x + 108, y=y - 18)
    yield 0.5
    yield from button("PAGE_ON")
    yield 1.5
    drive.screenshot("library-10-turned")
    yield from button("PAGE_BACK")
    yield from button("NINE")
    yield 2.0
    drive.screenshot("library-11-nine")
    told("nine playing")


def one() -> hand.Session:
    """Open the first clip, mark a piece with keys and mouse, note it as usable, and add it as a track."""
    session = ours("library.session")
    yield from button("ONE")
    yield 1.5
    view = looking()
    body = view.body()
    hand.mouse = at(*view.area.middle)
    yield from drive.key("SPACE", at=hand.mouse)
    assert not view.clock.is_playing
    for key, share in (("I", 0.3), ("O", 0.8)):
        bar = view.transport.timeline.bar
        yield from drive.click(*at(bar.x + share * bar.width, bar.middle[1]))
        yield from drive.key(key, at=hand.mouse)
    bar, marks = view.transport.timeline.bar, view.marks()
    begin = at(view.transport.timeline.x(marks.range[0]), bar.middle[1])
    yield from drive.drag(*begin, begin[0] + int(0.1 * bar.width), begin[1])
    first, last = view.marks().range
    assert abs(first - 0.4 * body.frames) < 0.02 * body.frames, (first, body.frames)
    assert abs(last - 0.8 * body.frames) < 0.02 * body.frames, (last, body.frames)
    yield from button("USABLE")
    yield from button("PLAY")
    yield 2.0
    drive.screenshot("library-12-marks")
    told("one playing")
    yield from button("ADD")
    yield 1.0
    drive.screenshot("library-13-added")
    entry = stage.armature().motion_theater.entries[-1]
    assert (entry.cut_start, entry.cut_end) == (first, last), (entry.cut_start, entry.cut_end)
    print(session.state.message, flush=True)


def leave() -> hand.Session:
    """Go back with Esc until the browser is closed, and look at the track."""
    overlay = ours("stage.overlay")
    for _ in range(6):
        if overlay.current is None:
            break
        yield from drive.key("ESC", at=at(*looking().area.middle))
        yield 0.3
    assert overlay.current is None
    yield from stage.look_from_the_front()
    yield from hand.shot("library-14-track")
    yield from drive.key("Z", ctrl=True)
    yield 0.5
    assert not stage.armature().motion_theater.entries, "one Ctrl+Z does not take the track away"


def drop() -> hand.Session:
    """Drag a picture out of the drawer into the view."""
    yield from hand.press("motion_theater.library_browse", column=0.25)
    yield from hand.settle(2)
    x, y = tile(1)
    free = looking().bounds
    to = at(free.middle[0], (looking().area.top + free.top) / 2)
    drive.move(x, y)
    yield 0.2
    drive.window().event_simulate(type="LEFTMOUSE", value="PRESS", x=x, y=y)
    for step in range(1, 11):
        drive.move(x + (to[0] - x) * step / 10, y + (to[1] - y) * step / 10)
        yield 0.1
    drive.screenshot("library-15-dragging")
    drive.window().event_simulate(type="LEFTMOUSE", value="RELEASE", x=to[0], y=to[1])
    yield 1.0
    drive.screenshot("library-16-dropped")
    assert len(stage.armature().motion_theater.entries) == 1


def browse() -> hand.Session:
    """Do anything that only looks, at random, for a while."""
    overlay = ours("stage.overlay")
    chance = random.Random(4)
    before, end, steps = data_blocks(), time.monotonic() + BROWSE_S, 0
    keys = ("SPACE", "FOUR", "NINE", "ONE", "PAGE_DOWN", "PAGE_UP", "RIGHT_ARROW", "DOWN_ARROW", "HOME", "I", "O", "P")
    while time.monotonic() < end:
        if overlay.current is None:
            yield from hand.press("motion_theater.library_browse", column=0.25)
        area = looking().area
        place = at(area.x + chance.random() * area.width, area.y + chance.random() * area.height)
        drive.move(*place)
        yield 0.05
        what = chance.random()
        if what < 0.5:
            yield from wheel(chance.choice(("WHEELDOWNMOUSE", "WHEELUPMOUSE")), place)
        elif what < 0.97:
            hand.mouse = place
            yield from hand.tap(chance.choice(keys))
        else:
            yield from drive.key("ESC", at=place)
        steps += 1
    assert data_blocks() == before, "browsing changed the data-blocks"
    print(f"browsed for {BROWSE_S:.0f} s in {steps} steps: the data-blocks are the same", flush=True)
    if overlay.current is not None:
        told("browsing")
    for where, name in (("library.rows", "ROWS"), ("library.pictures", "STILLS"), ("library.pictures", "STRIPS"),
                        ("library.bodies", "BODIES"), ("stage.textures", "TEXTURES")):  # fmt: skip
        cache = getattr(ours(where), name)
        print(f"{cache.name}: at most {cache.peak / 1e6:.1f} of {cache.limit / 1e6:.0f} MB", flush=True)


def session() -> hand.Session:
    """All of it."""
    make_clips()
    stage.install()
    yield from stage.empty_scene()
    yield from hand.open_tab()
    yield from scan()
    bpy.ops.motion_theater.import_skeleton(filepath=f"{stage.TESTDATA}/human.asf")
    stage.keep_step("Imported")
    yield from hand.settle()
    yield from grid()
    yield from four()
    yield from one()
    yield from leave()
    yield from drop()
    yield from browse()


drive.run(session())
