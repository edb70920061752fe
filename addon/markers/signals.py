"""Events and analog channels as the scene has them: markers of the timeline, and animated custom properties."""

from __future__ import annotations

import re
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from ..curves import read
from ..logic import trajectories
from . import events, keys

if TYPE_CHECKING:
    from bpy.types import FCurve, Object, Scene

    import motion_theater

    from ..logic.axes import Floats

CUSTOM_PROPERTY = re.compile(r'\["(.+)"\]')
UNIT_AT_THE_END = re.compile(r"(?:(.*), )?in ([^,]+)")  # as `analog` describes a channel


@dataclass(frozen=True)
class Moment:
    """An event, and the scene frame, not always whole, at which it is."""

    frame: float
    label: str
    context: str = ""
    subject: str = ""


def moments(scene: Scene, ob: Object | None, recorded: motion_theater.Markers | None) -> list[Moment]:
    """Return the markers of the timeline as events, in the order of time.

    A marker that came from the recording of a marker set, and still is where it came to, has the event's own moment and
    words.
    """
    known: dict[tuple[str, int], Moment] = {}
    if ob is not None and recorded is not None:
        for event in recorded.events:
            moment = Moment(events.moment(ob, event), event.label, event.context, event.subject)
            known.setdefault((events.name_of(event), round(moment.frame)), moment)
    found = [
        known.get((marker.name, marker.frame)) or Moment(float(marker.frame), marker.name)
        for marker in scene.timeline_markers
    ]
    return sorted(found, key=lambda moment: moment.frame)


@dataclass(frozen=True)
class Signal:
    """An animated custom property."""

    name: str
    description: str
    unit: str
    curve: FCurve

    def values(self, frames: Floats) -> Floats:
        """Return its values at scene frames; before the first key and after the last those of these."""
        row = read.coordinates(self.curve)
        at = row[0::2].astype(np.float64)
        values: Floats = np.interp(trajectories.snapped(frames, at), at, row[1::2])
        return values

    def spacing(self) -> float:
        """Return how many scene frames lie between two of its keys; 1 where there are not two."""
        at = read.coordinates(self.curve)[0::2].astype(np.float64)
        return float((at[-1] - at[0]) / (len(at) - 1)) if len(at) > 1 else 1.0


def signals(ob: Object) -> list[Signal]:
    """Return the animated custom properties of an object."""
    found = []
    for (path, _), curve in keys.curves_of(ob).items():
        name = CUSTOM_PROPERTY.fullmatch(path)
        if name is None or curve.is_empty or not len(curve.keyframe_points):
            continue
        plain = re.sub(r"\\(.)", r"\1", name.group(1))
        if isinstance(ob.get(plain), int | float):
            found.append(Signal(plain, *_described(ob, plain), curve))
    return found


def _described(ob: Object, name: str) -> tuple[str, str]:
    """Return description and unit of a custom property."""
    text = str(ob.id_properties_ui(name).as_dict().get("description") or "")
    parts = UNIT_AT_THE_END.fullmatch(text)
    return (parts.group(1) or "", parts.group(2)) if parts else (text, "")
