"""Ending the library: threads, scan, pictures and the browser's drawing, when the extension is switched off."""

from __future__ import annotations

from ..stage import overlay, paint, textures, words
from . import bodies, pictures, rows, scanning, session, work


def close() -> None:
    """Leave nothing running and nothing held."""
    overlay.close()
    scanning.close()
    work.close()
    rows.close()
    pictures.close()
    bodies.close()
    textures.close()
    paint.close()
    words.close()
    session.close()
