"""What the user is told, as plain text."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from pathlib import PurePath

SHOWN_NAMES = 8


class UserError(Exception):
    """Something that the user asked for cannot be done; the text is one sentence: why, and what to do about it."""


def base_name(path: str) -> str:
    """Return the file name of a path of any system (a .blend may come from another one)."""
    return PurePath(path.replace("\\", "/")).name


def listing(names: Sequence[str]) -> str:
    """Return names as a phrase, cut off after a few."""
    shown = ", ".join(names[:SHOWN_NAMES])
    hidden = len(names) - SHOWN_NAMES
    return shown if hidden <= 0 else f"{shown} and {hidden} more"


def counted(count: int, what: str) -> str:
    """Return a number of things in words."""
    return f"{count} {what}" if count == 1 else f"{count} {what}s"


def bones(count: int) -> str:
    """Return a number of bones in words."""
    return counted(count, "bone")


def frame(value: float) -> str:
    """Return a frame number, with decimals only where it has some."""
    return f"{round(value, 3):g}" if abs(value) < 1e6 else f"{value:.0f}"


def frame_range(start: float, end: float) -> str:
    """Return a range of frames in words."""
    return f"frame {frame(start)}" if start == end else f"frames {frame(start)}-{frame(end)}"


def sentences(parts: Iterable[str]) -> str:
    """Join parts to sentences in upper case, with a full stop between them but, as in Blender, none at the end."""
    texts = [part.strip().rstrip(".") for part in parts if part.strip()]
    return ". ".join(text[0].upper() + text[1:] for text in texts)


def track_added(path: str, bone_count: int, start: float, end: float) -> str:
    """Return the message for a new track."""
    return f"Added {base_name(path)} to {bones(bone_count)}, {frame_range(start, end)}"


def filter_added(kind: str, depth: int, bone_count: int) -> str:
    """Return the message for a new filter."""
    return f"Filtered {bones(bone_count)}: {kind.lower()}, depth {depth}"


def edited_by_hand(names: Sequence[str]) -> str:
    """Return why nothing was rebuilt when curves were edited by hand."""
    return (
        f"The F-curves of {listing(names)} were edited by hand since the last rebuild: "
        "choose Keep Edits or Rebuild Over Them"
    )


def misfit(path: str, names: Sequence[str], armature: str) -> str:
    """Return why a motion does not belong on an armature."""
    verb = "is" if len(names) == 1 else "are"
    return f"{base_name(path)} does not fit “{armature}”: {listing(names)} {verb} missing in the armature"


NO_BONES_SELECTED = "No bones are selected: select bones in Pose Mode or switch off Selected Bones Only"


def explained(error: BaseException) -> str | None:
    """Return the sentence for an error that a user may meet, or None for one that is our own mistake.

    The native module's errors are told by where they come from, because this package does without it. A panic of the
    Rust core is no `Exception`; it is a mistake too, but one that must not reach the user as a traceback.
    """
    if isinstance(error, UserError):
        return str(error)
    if isinstance(error, OSError):
        name = base_name(str(error.filename)) if error.filename else "A file"
        return f"{name} cannot be used: {error.strerror or error}"
    kinds = {kind.__name__ for kind in type(error).__mro__}
    if "MotionTheaterError" in kinds:
        return str(error)
    if "PanicException" in kinds:
        return f"Motion Theater ran into an error of its own, please report it: {error}"
    return None
