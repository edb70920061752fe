"""Texts are written in English and translated by Blender.

Labels and tooltips of properties, operators and panels are looked up by Blender itself. Sentences with numbers or
names in them go through `text`, with a named field for each value, so that a translator can reorder them.
"""

from __future__ import annotations

import bpy

# Per language what Blender's own catalogues lack: {"de_DE": {("*", "Add Motion Track"): "..."}}.
CATALOGUES: dict[str, dict[tuple[str, str], str]] = {}


def text(message: str, **values: object) -> str:
    """Return a sentence of the interface in the user's language, with its fields filled in."""
    return bpy.app.translations.pgettext_iface(message).format(**values)


def register(package: str) -> None:
    """Hand the catalogues to Blender."""
    bpy.app.translations.register(package, CATALOGUES)


def unregister(package: str) -> None:
    """Take them back."""
    bpy.app.translations.unregister(package)
