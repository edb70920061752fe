"""Whether the native module that does the work is there, and is the one this add-on was written for."""

from __future__ import annotations

import importlib
import tomllib
from functools import cache
from pathlib import Path
from typing import TYPE_CHECKING

import bpy

from .translations import text

if TYPE_CHECKING:
    from bpy.types import Context

MANIFEST = Path(__file__).with_name("blender_manifest.toml")


@cache
def problem() -> tuple[str, ...]:
    """Return what keeps the native module from being used and what to do about it, in sentences; empty if nothing.

    The answer holds for the session: a native module is never reloaded, so only a restart of Blender can change it.
    """
    wanted = tomllib.loads(MANIFEST.read_text(encoding="utf-8"))["version"]
    try:
        found = importlib.import_module("motion_theater").__version__
    except ImportError as error:
        return (
            text("The native module of Motion Theater cannot be loaded"),
            str(error),
            text("Install the extension file that was made for this operating system"),
        )
    return version_problem(wanted, found)


def version_problem(wanted: str, found: str) -> tuple[str, ...]:
    """Return what to do if the loaded native module is not of the add-on's own version.

    It happens after an update in a running Blender: the Python files are new, the native module is still the old one.
    """
    if wanted == found:
        return ()
    return (
        text("Motion Theater was updated to {wanted}, but version {found} is still loaded", wanted=wanted, found=found),
        text("Restart Blender to use the new version"),
    )


class MotionTheaterTrouble(bpy.types.AddonPreferences):
    """Stands in for the preferences while the native module cannot be used."""

    bl_idname = __package__

    def draw(self, context: Context) -> None:
        """Say what is wrong."""
        box = self.layout.box()
        for number, line in enumerate(problem()):
            box.label(text=line, icon="BLANK1" if number else "ERROR", translate=False)


def register() -> None:
    """Make the problem known where a user looks for it."""
    bpy.utils.register_class(MotionTheaterTrouble)
    print("Motion Theater:", ". ".join(problem()))


def unregister() -> None:
    """Take it away."""
    bpy.utils.unregister_class(MotionTheaterTrouble)
