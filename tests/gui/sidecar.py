"""What people say of a clip, typed into the dialog: cancelled, refused, saved."""

from __future__ import annotations

import shutil
import sys
import tempfile
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2]))

import bpy
import drive

from tests.gui import hand, stage

MIDDLE = (700, 500)


def edit(**typed: str) -> hand.Session:
    """Open the dialog over the 3D View, with values as if they were typed."""
    drive.move(*MIDDLE)
    hand.mouse = MIDDLE
    yield 0.2
    place = {"area": drive.area("VIEW_3D"), "region": drive.region("WINDOW", "VIEW_3D")}
    with bpy.context.temp_override(window=drive.window(), **place):
        bpy.ops.motion_theater.sidecar_edit("INVOKE_DEFAULT", **typed)
    yield from hand.settle()


def session() -> hand.Session:
    """Edit the sidecar of the active track's clip."""
    folder = Path(tempfile.mkdtemp())
    for source, name in (("human.asf", "02.asf"), ("wave.amc", "02_03.amc")):
        shutil.copy(Path(stage.TESTDATA) / source, folder / name)
    sidecar = folder / "02_03.i3d"
    stage.install()
    yield from stage.empty_scene()
    bpy.ops.motion_theater.add_track(filepath=str(folder / "02_03.amc"))
    yield from hand.open_tab()

    yield from edit()
    drive.screenshot("sidecar-new")
    yield from drive.key("ESC")
    yield 0.5
    assert not sidecar.exists(), "Esc must not write"

    yield from edit(cleaned="maybe", comment="typed")
    yield from drive.key("RET")
    yield 1.0
    drive.screenshot("sidecar-refused")
    assert not sidecar.exists()
    for _ in range(2):  # the message, and the dialog that opened again with what was typed
        yield from drive.key("ESC")
        yield 0.5

    sidecar.write_bytes(b"Akteur: J\xf6rg\r\nweather rain\r\n")
    yield from edit(cleaned="Ja")
    drive.screenshot("sidecar-edit")
    yield from drive.key("RET")
    yield 1.0
    drive.screenshot("sidecar-saved")
    lines = sidecar.read_bytes().split(b"\r\n")
    assert lines[:2] == [b"Akteur: J\xf6rg", b"Cleaned: Ja"], lines
    assert lines[-2:] == [b"weather rain", b""], lines


drive.run(session())
