"""What the scripts of this folder share: a Blender that knows nothing but what is installed in it.

Blender finds its user folder in BLENDER_USER_RESOURCES, which must be set when bpy is imported.
"""

from __future__ import annotations

import json
import os
import sys
from importlib.machinery import ModuleSpec, PathFinder
from pathlib import Path
from typing import Any

import bpy

EXTENSION = "bl_ext.user_default.motion_theater"


class OnlyInstalled:
    """Finds our native module in the user folder alone: a wheel in this Python's own packages does not count."""

    @staticmethod
    def find_spec(name: str, path: object = None, target: object = None) -> ModuleSpec | None:
        """Answer for `motion_theater`, and refuse it where the extension did not bring it."""
        if name != "motion_theater":
            return None
        user_folder = os.environ["BLENDER_USER_RESOURCES"]
        found = PathFinder.find_spec(name, [entry for entry in sys.path if entry.startswith(user_folder)])
        if found is None:
            raise ModuleNotFoundError(f"No module named {name!r}", name=name)
        return found


sys.meta_path.insert(0, OnlyInstalled)


def finish(facts: dict[str, Any]) -> None:
    """Hand the facts over and end at once: bpy may hang on the way out of the interpreter."""
    Path(os.environ["MT_FACTS"]).write_text(json.dumps(facts), encoding="utf-8")
    sys.stdout.flush()
    os._exit(0)


def is_enabled() -> bool:
    """Return whether the extension is loaded."""
    import addon_utils  # is there only once bpy is

    return bool(addon_utils.check(EXTENSION)[1])


def set_enabled(*, enabled: bool) -> None:
    """Do what the checkbox in the preferences does."""
    import addon_utils

    (addon_utils.enable if enabled else addon_utils.disable)(EXTENSION, default_set=True)


def install(package: str) -> None:
    """Install the zip and enable it. Blender reports success even when it refuses: look at what became of it."""
    bpy.ops.extensions.package_install_files(
        filepath=package, repo="user_default", enable_on_install=True, overwrite=True
    )
