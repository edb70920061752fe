"""Texts are written in English and translated by Blender.

Labels and tooltips of properties, operators and panels are looked up by Blender itself. Sentences with numbers or
names in them go through `text`, with a named field for each value, so that a translator can reorder them. Nobody has
translated them yet: the first catalogue is handed over with `bpy.app.translations.register`.
"""

from __future__ import annotations

import bpy


def text(message: str, **values: object) -> str:
    """Return a sentence of the interface in the user's language, with its fields filled in."""
    return bpy.app.translations.pgettext_iface(message).format(**values)
