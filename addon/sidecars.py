"""Sidecars (`.i3d`): what people say of a clip, in a small text beside it."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING

import motion_theater

from .logic.messages import UserError, explained

if TYPE_CHECKING:
    from motion_theater import Sidecar


def beside(clip: str) -> Sidecar:
    """Return the sidecar beside a clip, or a new one with what the clip tells."""
    return opened(lambda: motion_theater.sidecar_for(clip))


def opened(way: Callable[[], Sidecar]) -> Sidecar:
    """Return the sidecar that a way of opening one gives, and say in words why it does not."""
    try:
        return way()
    except (OSError, motion_theater.MotionTheaterError) as error:
        raise UserError(explained(error) or str(error)) from error


def save(sidecar: Sidecar, values: Mapping[str, str]) -> bool:
    """Write values by the names of fields, with who changed it and when; return whether there was anything to write."""
    try:
        for name, value in values.items():
            sidecar.set(name, value)
        if not sidecar.is_edited:
            return False
        sidecar.stamp()
        sidecar.save()
    except (OSError, motion_theater.MotionTheaterError) as error:
        raise UserError(explained(error) or str(error)) from error
    return True


def is_cleaned_word(value: str) -> bool:
    """Return whether *Cleaned* may be that."""
    try:
        motion_theater.sidecar_cleaned(value)
    except motion_theater.ParameterError:
        return False
    return True
