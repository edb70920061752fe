"""What is said of a clip of the library, in the window: typed into the sidebar with *Also to the Sidecar*, edited in
the dialog, cancelled, refused by a full disk; and the views that show what was used and liked."""

from __future__ import annotations

import importlib
import shutil
import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

sys.path.insert(0, str(Path(__file__).resolve().parents[2]))

import bpy
import drive

from tests.gui import hand, stage

DISK = Path("/tmp/small-disk")
CLIPS = ("human.asf", "walk.amc", "wave.amc", "turn.amc")
PANEL_COLUMN = 0.75
BY_HAND = b"Akteur: J\xf6rg\r\nweather rain\r\n"


def ours(name: str) -> Any:
    """Return a module of the installed add-on."""
    return importlib.import_module(f"{stage.MODULE}.{name}")


def until(done: Callable[[], bool], seconds: float = 30.0) -> hand.Session:
    """Wait for something of the background."""
    end = time.monotonic() + seconds
    while not done():
        assert time.monotonic() < end, "it did not come to an end"
        yield 0.2


def make_disk() -> None:
    """Put clips on a disk of their own, of a megabyte."""
    subprocess.run(["umount", "-q", DISK], check=False)
    DISK.mkdir(exist_ok=True)
    subprocess.run(["mount", "-t", "tmpfs", "-o", "size=1m", "tmpfs", DISK], check=True)
    for name in CLIPS:
        shutil.copy(f"{stage.TESTDATA}/{name}", DISK / name)


def fill_disk() -> None:
    """Leave no room on the disk."""
    with (DISK / "filler").open("wb", buffering=0) as filler:
        try:
            while True:
                filler.write(b"." * 4096)
        except OSError:
            pass


def choose(name: str) -> hand.Session:
    """Select a clip."""
    session = ours("library.session")
    names = [clip.name for clip in session.library().clips([int(clip_id) for clip_id in session.state.ids])]
    session.choose(names.index(name))
    yield 0.5
    yield from hand.settle(2)


def write(field: str, text: str) -> hand.Session:
    """Type into a field of the sidebar."""
    place = yield from hand.find_field(field, column=PANEL_COLUMN)
    yield from hand.write(place, text)
    yield 0.5


def notes() -> hand.Session:
    """Type with the box ticked: the sidecar is made, and has what was typed."""
    sidecar = DISK / "walk.i3d"
    yield from choose("walk.amc")
    yield from hand.tick("also_sidecar")
    yield from write("description", "straight on")
    yield from until(sidecar.exists)
    yield from hand.shot("notes-1-sidecar")
    assert b"Comment: straight on\n" in sidecar.read_bytes()
    yield from write("description", "")
    yield from until(lambda: b"Comment:\n" in sidecar.read_bytes())
    yield from write("tags", "good, slow")


def dialog() -> hand.Session:
    """Edit the sidecar of a clip in the dialog: cancelled, refused, saved; the library knows at once."""
    session, sidecar = ours("library.session"), DISK / "wave.i3d"
    sidecar.write_bytes(BY_HAND)
    yield from choose("wave.amc")
    yield from hand.press("motion_theater.sidecar_edit")
    yield from hand.settle()
    drive.screenshot("notes-2-dialog")
    yield from drive.key("ESC")
    yield 0.5
    assert sidecar.read_bytes() == BY_HAND, "Esc must not write"
    number = session.state.active_id
    drive.move(700, 500)
    place = {"area": drive.area("VIEW_3D"), "region": drive.region("WINDOW", "VIEW_3D")}
    yield 0.2
    with bpy.context.temp_override(window=drive.window(), **place):
        bpy.ops.motion_theater.sidecar_edit("INVOKE_DEFAULT", clip=number, cleaned="Ja", group="steps")
    yield from hand.settle()
    yield from drive.key("RET")
    yield 1.0
    yield from hand.shot("notes-3-saved")
    assert sidecar.read_bytes().endswith(b"weather rain\r\n")
    clip = session.library().clips([number])[0]
    assert (clip.subject, clip.session_group, clip.cleaned) == ("J\xf6rg", "steps", True)


def full_disk() -> hand.Session:
    """Type on a full disk: the panel says what is wrong, the file is what it was, and the library has the edit."""
    session, sidecar = ours("library.session"), DISK / "wave.i3d"
    before = sidecar.read_bytes()
    fill_disk()
    yield from write("subject", "ann")
    yield from until(lambda: session.state.is_alarming)
    yield from hand.shot("notes-4-full-disk")
    print(session.state.message, flush=True)
    assert "No space left" in session.state.message
    assert sidecar.read_bytes() == before
    assert session.library().clips([session.state.active_id])[0].subject == "ann"
    yield from mark_usable()
    assert sidecar.read_bytes() == before
    (DISK / "filler").unlink()
    yield from write("subject", "eva")
    yield from until(lambda: b"Akteur: eva\r\n" in sidecar.read_bytes())
    assert not session.state.is_alarming


def mark_usable() -> hand.Session:
    """Note a piece in the browser on the full disk: the message is there too."""
    overlay = ours("stage.overlay")
    yield from hand.press("motion_theater.library_play", column=0.5)
    yield from until(lambda: overlay.current is not None and overlay.current.view.body() is not None)
    view, region = overlay.current.view, drive.region("WINDOW")
    middle, bar = view.area.middle, view.transport.timeline.bar
    place = (int(region.x + middle[0]), int(region.y + middle[1]))
    yield from drive.key("SPACE", at=place)
    yield from drive.click(int(region.x + bar.middle[0]), int(region.y + bar.middle[1]))
    for key in ("O", "U"):
        yield from drive.key(key, at=place)
    yield from until(lambda: "No space left" in overlay.current.said[0])
    drive.screenshot("notes-5-full-disk-on-the-stage")
    while overlay.current is not None:
        yield from drive.key("ESC")


def views() -> hand.Session:
    """Bring a clip in, and find it again among the recently used ones."""
    session = ours("library.session")
    yield from choose("turn.amc")
    yield from hand.press("motion_theater.library_import", column=PANEL_COLUMN)
    yield 1.0
    place = yield from hand.find_field(".show", column=0.2)
    yield from drive.click(*place)
    yield from hand.settle(2)
    drive.screenshot("notes-6-show")
    yield from drive.key("R", at=place)
    yield from until(lambda: len(session.state.ids) == 1)
    yield from hand.shot("notes-7-recently-used")
    assert session.state.filters == {"used": "30d"}


def session() -> hand.Session:
    """All of it."""
    make_disk()
    stage.install()
    yield from stage.empty_scene()
    yield from hand.open_tab()
    library, scanning = ours("library.session"), ours("library.scanning")
    bpy.ops.motion_theater.library_folder_add(directory=str(DISK))
    yield from until(lambda: not scanning.is_running() and library.state.total == len(CLIPS))
    yield from notes()
    yield from dialog()
    yield from full_disk()
    yield from views()


drive.run(session())
