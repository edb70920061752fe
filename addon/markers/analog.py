"""Analog channels of a recording as animated custom properties of the marker set."""

from __future__ import annotations

from typing import TYPE_CHECKING

import bpy
import numpy as np

from .. import compat
from ..curves import read, write
from ..logic.keys import NEAREST
from ..logic.messages import counted
from . import properties

if TYPE_CHECKING:
    from bpy.types import Object
    from numpy.typing import NDArray

    import motion_theater

GROUP = "Analog"
LONGEST_NAME = 63  # bytes, of a custom property


def add(ob: Object, recorded: motion_theater.Markers) -> str:
    """Add every analog channel as a custom property with its F-curve; return what is to be said about it.

    Every sample becomes a key, on sub-frames; of samples that are nearer than Blender tells keys apart, every n-th.
    """
    channels = recorded.analog
    if not channels:
        return "The file holds no analog channels"
    lies = properties.of(ob)
    step = lies.frame_step / max(recorded.analog_samples_per_frame, 1)
    every = max(1, int(np.ceil(2.0 * NEAREST / step)))
    action = ob.animation_data.action if ob.animation_data else None
    if action is None:
        action = bpy.data.actions.new(ob.name)
        compat.ensure_bag(ob, action)
        compat.assign(ob, action)
    bag = compat.ensure_bag(ob, action)
    curves = read.index(bag)
    taken: set[str] = set()
    for number, channel in enumerate(channels, 1):
        samples = channel.samples
        name = _unique(channel.name.strip() or f"Analog {number}", taken)
        ob[name] = float(samples[0]) if len(samples) else 0.0
        ob.id_properties_ui(name).update(description=_description(channel))
        slot = (f'["{bpy.utils.escape_identifier(name)}"]', 0)
        curve = curves.get(slot) or write.new_curve(bag, curves, GROUP, slot)
        write.write_keys(curve, write.Wanted(_keys(samples[::every], lies.first_frame, step * every)))
    count = counted(len(channels), "analog channel")
    thinned = f", every {every} samples" if every > 1 else ""
    return f"{count} as custom properties{thinned}"


def _keys(samples: NDArray[np.float64], first: int, step: float) -> NDArray[np.float32]:
    keys = np.empty(2 * len(samples), np.float32)
    keys[0::2] = first + np.arange(len(samples)) * step
    keys[1::2] = np.nan_to_num(samples, posinf=0.0, neginf=0.0)
    return keys


def _description(channel: motion_theater.AnalogChannel) -> str:
    unit = f"in {channel.unit}" if channel.unit else ""
    return ", ".join(part for part in (channel.description, unit) if part)


def _unique(name: str, taken: set[str]) -> str:
    """Return a name that no other channel has, as short as Blender wants it."""
    number, unique = 1, _cut(name, LONGEST_NAME)
    while unique in taken:
        number += 1
        suffix = f" {number}"
        unique = _cut(name, LONGEST_NAME - len(suffix)) + suffix
    taken.add(unique)
    return unique


def _cut(name: str, length: int) -> str:
    return name.encode()[:length].decode(errors="ignore")
