"""Events of a recording as markers of the timeline."""

from __future__ import annotations

from typing import TYPE_CHECKING

from ..logic.messages import counted
from . import properties

if TYPE_CHECKING:
    from bpy.types import Object, Scene

    import motion_theater


def add(scene: Scene, ob: Object, recorded: motion_theater.Markers) -> str:
    """Add the events of a recording to the timeline, each once; return what is to be said about it."""
    if not recorded.events:
        return "The file holds no events"
    there = {(marker.name, marker.frame) for marker in scene.timeline_markers}
    added = 0
    for event in recorded.events:
        name, frame = name_of(event), round(moment(ob, event))
        if (name, frame) not in there:
            scene.timeline_markers.new(name, frame=frame)
            there.add((name, frame))
            added += 1
    return f"{counted(added, 'event')} on the timeline"


def name_of(event: motion_theater.Event) -> str:
    """Return what an event is called on the timeline."""
    return " ".join(part for part in (event.subject, event.context, event.label) if part) or "Event"


def moment(ob: Object, event: motion_theater.Event) -> float:
    """Return the scene frame, not always whole, at which an event of a marker set's file is."""
    lies = properties.of(ob)
    file_frame = event.frame if event.frame is not None else event.time_s * lies.rate_hz + 1.0
    return float(lies.first_frame + (file_frame - lies.first_frame) * lies.frame_step)
