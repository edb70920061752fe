"""Finds buttons of the window as a person does, by looking under the mouse, and presses them with mouse and keys.

Blender can copy the Python command of the button under the mouse, or the data path of a field: that is how a button
is told from its neighbours here, wherever the layout put it. Everything that waits is a generator for `drive.run`.
"""

from __future__ import annotations

from collections.abc import Callable, Generator
from pathlib import Path

import bpy
import drive

Session = Generator[float, None, None]
Finding = Generator[float, None, tuple[int, int]]

STEP = 8  # pixels between two looks; the lowest button is 18 high
REST = (8, 8)  # a corner where the mouse covers and highlights nothing
DIGITS = ("ZERO", "ONE", "TWO", "THREE", "FOUR", "FIVE", "SIX", "SEVEN", "EIGHT", "NINE")
PUNCTUATION = {".": "PERIOD", "/": "SLASH", "-": "MINUS", "_": "MINUS", ":": "SEMI_COLON", ",": "COMMA", " ": "SPACE"}


class NotFoundError(AssertionError):
    """A button that a person would look for is not there."""


def settle(times: int = 3) -> Session:
    """Wait until panels have slid to their places."""
    for _ in range(times):
        drive.redraw()
        yield 0.3


def shot(name: str, *, rest: bool = True) -> Session:
    """Take a picture of the window once it stands still."""
    if rest:
        drive.move(*REST)
        yield 0.2
    yield from settle()
    drive.screenshot(name)


def open_tab() -> Session:
    """Show the sidebar's tab Motion."""
    yield from drive.open_sidebar("Motion")
    yield from settle()


def under_mouse(kind: str, of: str) -> str:
    """Return the command or the data path of the button under the mouse, or nothing."""
    manager = bpy.context.window_manager
    with bpy.context.temp_override(window=drive.window(), area=drive.area(of), region=drive.region(kind, of)):
        if bpy.ops.ui.copy_python_command_button.poll():
            bpy.ops.ui.copy_python_command_button()
            return str(manager.clipboard)
        if bpy.ops.ui.copy_data_path_button.poll():
            bpy.ops.ui.copy_data_path_button(full_path=True)
            return str(manager.clipboard)
    return ""


def find(fits: Callable[[str], bool], what: str, kind: str, of: str, column: float) -> Finding:
    """Return where a button is: looks at what is shown, then from the top of the panel downwards."""
    place = yield from _look(fits, kind, of, column)
    if place is None:
        yield from scroll("WHEELUPMOUSE", kind, of, notches=40)
    for _ in range(6):
        if place is not None:
            return place
        place = yield from _look(fits, kind, of, column)
        if place is None:
            yield from scroll("WHEELDOWNMOUSE", kind, of)
    raise NotFoundError(f"no button for {what}")


def _look(
    fits: Callable[[str], bool], kind: str, of: str, column: float
) -> Generator[float, None, tuple[int, int] | None]:
    """Pass the mouse once down a region, in a column that is given as a share of its width."""
    region = drive.region(kind, of)
    x = int(region.x + column * region.width)
    for y in range(region.y + region.height - STEP, region.y, -STEP):
        drive.move(x, y)
        yield 0.02
        if fits(under_mouse(kind, of)):
            return x, y - STEP // 2  # it was met at its upper edge
    return None


def scroll(wheel: str, kind: str = "UI", of: str = "VIEW_3D", notches: int = 12) -> Session:
    """Turn the mouse wheel over a region."""
    region = drive.region(kind, of)
    x, y = region.x + region.width // 2, region.y + region.height // 2
    drive.move(x, y)
    yield 0.05
    for _ in range(notches):
        drive.window().event_simulate(type=wheel, value="PRESS", x=x, y=y)
        yield 0.01
    yield from settle(2)


def find_operator(command: str, *, kind: str = "UI", of: str = "VIEW_3D", column: float = 0.6) -> Finding:
    """Return where the button of an operator is; `command` may go on with the start of its arguments."""
    place = yield from find(lambda text: text.startswith(f"bpy.ops.{command}"), command, kind, of, column)
    return place


def find_field(name: str, *, kind: str = "UI", of: str = "VIEW_3D", column: float = 0.6) -> Finding:
    """Return where the field of a property is, by the end of its data path."""
    place = yield from find(lambda text: text.endswith(name), name, kind, of, column)
    return place


def press(command: str, *, kind: str = "UI", of: str = "VIEW_3D", column: float = 0.6) -> Session:
    """Click the button of an operator."""
    x, y = yield from find_operator(command, kind=kind, of=of, column=column)
    yield from drive.click(x, y)
    yield 0.3


def tick(name: str) -> Session:
    """Click a checkbox."""
    x, y = yield from find_field(name)
    yield from drive.click(x, y)


def tap(name: str, *, text: str = "", **modifiers: bool) -> Session:
    """Press and release a key where the mouse is."""
    window = drive.window()
    x, y = mouse
    extra = {"unicode": text} if text else {}
    window.event_simulate(type=name, value="PRESS", x=x, y=y, **extra, **modifiers)
    yield 0.03
    window.event_simulate(type=name, value="RELEASE", x=x, y=y, **modifiers)
    yield 0.03


def write(place: tuple[int, int], text: str) -> Session:
    """Double-click a field, type over what it holds, and press Enter."""
    global mouse
    mouse = place
    drive.move(place[0] - 3, place[1])
    yield 0.1
    drive.move(*place)
    yield 0.1
    window = drive.window()
    for value in ("PRESS", "RELEASE", "PRESS", "RELEASE"):
        window.event_simulate(type="LEFTMOUSE", value=value, x=place[0], y=place[1])
        yield 0.05
    yield 0.2
    yield from tap("A", ctrl=True)
    yield from type_text(text) if text else tap("DEL")
    yield from tap("RET")
    yield 0.3


def type_text(text: str) -> Session:
    """Type characters."""
    for character in text:
        key = DIGITS[int(character)] if character.isdecimal() else PUNCTUATION.get(character, character.upper())
        yield from tap(key, text=character)


def enter_number(name: str, value: int) -> Session:
    """Type a number into a field of the sidebar."""
    place = yield from find_field(name)
    yield from write(place, str(value))


def choose_file(folder: str, filename: str) -> Session:
    """In the file browser, type the folder where it is another one, type the name, and press the button."""
    yield from settle(2)
    if Path(drive.area("FILE_BROWSER").spaces.active.params.directory.decode()) != Path(folder):
        place = yield from find_field("params.directory", kind="UI", of="FILE_BROWSER", column=0.3)
        yield from write(place, folder)
        yield from tap("RET")  # the first one only completes the path
        yield from settle(2)
    bottom = drive.region("EXECUTE", "FILE_BROWSER")
    yield from write((bottom.x + bottom.width // 3, bottom.y + bottom.height // 2), filename)
    yield from press("file.execute", kind="EXECUTE", of="FILE_BROWSER", column=0.92)
    yield from settle()


mouse: tuple[int, int] = REST
"""Where the last click was: simulated keys carry a place."""
