"""Motion Theater: motion capture as tracks on an armature.

Only registers. Without a fitting native module the extension still starts, with nothing but preferences that say what
is wrong and what to do about it.
"""

from __future__ import annotations

from types import ModuleType

from . import native


def register() -> None:
    """Called by Blender when the extension is switched on."""
    _parts().register()


def unregister() -> None:
    """Called by Blender when the extension is switched off: `register` backwards."""
    _parts().unregister()


def _parts() -> ModuleType:
    if native.problem():
        return native
    from . import registration  # imports the native module, so not before it is known to be there

    return registration
