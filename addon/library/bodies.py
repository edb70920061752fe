"""Whole clips as figures that can be drawn, read in the background when they come onto the stage."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import motion_theater

from ..logic.library import figures
from ..logic.library.kept import Kept
from ..logic.messages import base_name, explained
from ..tracks import MARKER_FORMATS
from . import redraw, work

if TYPE_CHECKING:
    from collections.abc import Hashable

BODIES: Kept[figures.Body | str] = Kept("Figures on the stage", 256_000_000)


def get(clip: motion_theater.LibraryClip) -> figures.Body | str | None:
    """Return the figure of a clip, or why there is none, or None if it has yet to be read."""
    if clip.error:
        return str(clip.error)
    key = _key(clip)
    known = BODIES.get(key)
    if known is None and not work.waits("figures", key):
        work.ask("figures", key, lambda: _read(clip), lambda *result: _keep(key, clip.name, *result))
    return known


def _key(clip: motion_theater.LibraryClip) -> Hashable:
    return (clip.path, clip.modified_ns, clip.size, clip.skeleton_path)


def _read(clip: motion_theater.LibraryClip) -> figures.Body:
    skeleton = motion_theater.read(clip.skeleton_path).skeleton if clip.skeleton_path else None
    figure = motion_theater.load_figure(clip.path, skeleton=skeleton)
    return figures.prepared(figure, is_markers=clip.format in MARKER_FORMATS)


def _keep(key: Hashable, name: str, body: Any, error: BaseException | None) -> None:
    if error is not None:
        body = explained(error) or f"{base_name(name)} cannot be shown: {error!r}"
    BODIES.keep(key, body, 1000 if isinstance(body, str) else body.bytes)
    redraw.everything()


def close() -> None:
    """Forget all figures."""
    BODIES.clear()
