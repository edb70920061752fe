"""Which skeleton a motion file is understood with, where it has none of its own."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import motion_theater

from ..logic.messages import UserError, base_name, listing
from .files import Loaded, bind, read_file, read_once, text_of


@dataclass(frozen=True)
class Pairing:
    """The skeleton with which a motion is understood, and what is to be said of that."""

    skeleton: Loaded
    told: str = ""


def _default_skeleton() -> Loaded:
    """Return the skeleton that stands in for a motion's own. Its path is empty: it is from no file."""
    return read_once("default skeleton", lambda: motion_theater.DEFAULT_SKELETON_ASF.encode("ascii"), name="")


def find_skeleton(path: str, loaded: Loaded, chosen: Sequence[str] = (), *, may_guess: bool) -> Pairing:
    """Return the skeleton that belongs to a motion file: the first candidate that fits, those first that were chosen
    together with it; if there is none, the built-in default where that is allowed and fits, else an error that says
    what was looked at.
    """
    try:
        candidates = motion_theater.skeletons_for(path, chosen=chosen)
    except OSError as error:
        raise UserError(f"{base_name(path)} cannot be read: {error.strerror or error}") from error
    refused: list[str] = []
    for candidate in candidates:
        try:
            skeleton = read_file(candidate.path)
            bind(loaded, text_of(skeleton))
        except UserError as error:
            refused.append(str(error))
            continue
        return Pairing(skeleton, f"Took {base_name(candidate.path)}, because {candidate.reason}")
    default = _default_skeleton()
    if may_guess and _fits(loaded, default):
        return Pairing(default, motion_theater.DEFAULT_SKELETON_NOTICE)
    if refused:
        raise UserError(f"No skeleton fits {base_name(path)}: {refused[0]}")
    raise UserError(
        f"{base_name(path)} needs its skeleton: select the armature, or put the .asf file into the folder "
        f"(its bones: {listing(loaded.clip.names)})"
    )


def _fits(loaded: Loaded, skeleton: Loaded) -> bool:
    """Return whether a motion and a skeleton belong together."""
    try:
        bind(loaded, text_of(skeleton))
    except UserError:
        return False
    return True
