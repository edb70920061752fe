"""Events of a recording as markers of the timeline."""

from __future__ import annotations

from typing import TYPE_CHECKING

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
        name = " ".join(part for part in (event.subject, event.context, event.label) if part) or "Event"
        frame = scene_frame(ob, event)
        if (name, frame) not in there:
            scene.timeline_markers.new(name, frame=frame)
            there.add((name, frame))
            added += 1
    count = "1 event" if added == 1 else f"{added} events"
    return f"{count} on the timeline"


def scene_frame(ob: Object, event: motion_theater.Event) -> int:
    """Return the scene frame that is nearest to an event."""
    lies = properties.of(ob)
    file_frame = event.frame if event.frame is not None else event.time_s * lies.rate_hz + 1.0
    return round(lies.first_frame + (file_frame - lies.first_frame) * lies.frame_step)
