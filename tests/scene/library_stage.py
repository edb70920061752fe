"""A library of a few clips for the tests, and a stand-in for the window that the browser's views lie in."""

from __future__ import annotations

import shutil
from pathlib import Path
from typing import Any

import bpy
import numpy as np

from tests import harness
from tests.scene.test_bvh import OWN

session, work, rows = (harness.module(f"library.{name}") for name in ("session", "work", "rows"))
canvas, view = harness.module("stage.canvas"), harness.module("stage.view")
rect = harness.module("logic.library.rect")

NAMES = ["broken.bvh", "human.asf", "own.bvh", "turn.amc", "walk.amc", "wave.amc"]
MARKERS = """$firstframe 1
$rate 60
$order A B C D
$points
1 0 0 1000 100 0 1000 0 100 1000 50 50 1500
2 0 0 1010 100 0 1010 0 100 1010 50 50 1510
3 0 0 1020 DROPOUT 0 100 1020 50 50 1520
"""


def make_clips(folder: Path) -> Path:
    """Fill a folder with a skeleton, motions on it, a BVH, and a file that is damaged."""
    folder.mkdir(parents=True, exist_ok=True)
    for name in ("human.asf", "walk.amc", "wave.amc", "turn.amc"):
        shutil.copy(harness.TESTDATA / name, folder / name)
    (folder / "own.bvh").write_text(OWN)
    (folder / "broken.bvh").write_text(OWN.replace("OFFSET 10", "OFFSET ten"))
    return folder


def scanned(folder: Path) -> None:
    """Add a folder to the library as a user does, and wait for everything that it sets off."""
    bpy.ops.motion_theater.library_folder_add(directory=str(make_clips(folder)))
    settle()


def settle() -> None:
    """Wait until nothing is under way."""
    assert work.wait(60.0), "the background did not come to an end"


def shown() -> list[str]:
    """Return the names of the clips in the list."""
    return [clip.name for clip in session.library().clips([int(clip_id) for clip_id in session.state.ids])]


def choose(name: str) -> Any:
    """Select a clip by its name."""
    session.choose(shown().index(name))
    settle()
    rows.active()
    settle()
    return rows.active()


class Host:
    """Notes what a view asks of its window."""

    def __init__(self) -> None:
        self.views: list[Any] = []
        self.calls: list[tuple[str, dict[str, object]]] = []
        self.menus: list[str] = []
        self.left = 0
        self.reasons: dict[str, str] = {}

    def run(self, operator: str, **options: object) -> None:
        self.calls.append((operator, options))

    def menu(self, name: str) -> None:
        self.menus.append(name)

    def show(self, shown: Any) -> None:
        self.views.append(shown)

    def leave(self) -> None:
        self.left += 1

    def reason(self, operator: str) -> str:
        return self.reasons.get(operator, "")

    def paste(self) -> str:
        return "pasted"


class Screen:
    """A 3D View of 1200 by 800 pixels with a browser's view over it, at a time that the test sets."""

    def __init__(self, make: Any) -> None:
        self.host = Host()
        self.view = make(self.host)
        self.now = 100.0
        self.mouse = (600.0, 300.0)
        self.distance = 10.0
        self.rotation = np.eye(3)
        self.sheet: Any = None

    def draw(self) -> Any:
        """Draw, and once more after everything that was asked for has come."""
        for _ in range(4):
            self.sheet = canvas.Canvas(1.0)
            self.view.draw(self.sheet, self._window())
            if work.is_idle():
                break
            settle()
        return self.sheet

    def _window(self) -> Any:
        whole = rect.Rect(0, 0, 1200, 800)
        return view.Window(
            whole, whole, 1.0, self.mouse, True, self.now, self.rotation, np.zeros(3), self.distance, True
        )

    def press(self, kind: str, *, value: str = "PRESS", **more: Any) -> bool:
        """Press a key or a button of the mouse where it is."""
        x, y = self.mouse
        return bool(self.view.take(view.Input(kind, value, x, y, True, self.now, **more)))

    def move(self, x: float, y: float) -> bool:
        """Move the mouse."""
        self.mouse = (x, y)
        return self.press("MOUSEMOVE", value="NOTHING")

    def button(self, name: str) -> None:
        """Click a button that can be used."""
        placed = getattr(self.view, "transport", self.view).placed
        (one,) = [one for one in placed if one.button.name == name]
        assert not one.button.reason, one.button.reason
        self.mouse = one.area.middle
        assert self.press("LEFTMOUSE")
        self.press("LEFTMOUSE", value="RELEASE")

    def texts(self) -> list[str]:
        """Return all that is written."""
        return [text.text for _, layers in self.sheet._clips for layer in layers for text in layer.texts]


def data_blocks() -> dict[str, list[str]]:
    """Return the names of all data-blocks, by kind."""
    kinds = [name for name in dir(bpy.data) if isinstance(getattr(bpy.data, name), bpy.types.bpy_prop_collection)]
    return {kind: sorted(block.name_full for block in getattr(bpy.data, kind)) for kind in kinds}
