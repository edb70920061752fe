"""From what is in the scene to a recording of markers: a marker set, the joints of an armature, or objects."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Literal

import numpy as np

import motion_theater

from .. import exporting, scene, sources
from ..logic import axes, names, trajectories
from ..logic.messages import UserError, base_name, counted, listing
from ..logic.rates import usual
from . import edit, places, properties, signals

if TYPE_CHECKING:
    from bpy.types import Context, Object

    from ..logic.axes import Floats

Kind = Literal["c3d", "csm", "trc"]
UP = {"c3d": "Z", "csm": "Z", "trc": "Y"}
"""Which way is up in a format, where nobody says otherwise."""
UNIT_M = 0.001
NAMED_UNITS_M = (0.001, 0.01, 0.0254, 0.1, 0.3048, 1.0)
SAME_UNIT = 1e-6  # a .blend keeps the unit of a file in single precision
MOST_SAMPLES_PER_FRAME = 10_000
UNWRITABLE = re.compile(r"[\s,$]")  # in names of text formats


@dataclass(frozen=True)
class Request:
    """What the user asked for."""

    kind: Kind
    start: float
    end: float
    rate_hz: float = 0.0
    """Frames per second of the file; 0: those of the keys of a marker set, of the scene for anything else."""
    up: str = "AUTO"
    unit_m: float = 0.0
    """Metres per unit of the file; 0: those of the file that a marker set came from, else millimetres."""
    joints: Literal["HEADS", "TAILS"] = "HEADS"
    """What of an armature: heads and the last ends of chains, or the tail of each bone."""
    selected_only: bool = False
    with_events: bool = True
    with_analog: bool = True


@dataclass
class Recording:
    """What is to be written."""

    markers: motion_theater.Markers
    notices: list[str] = field(default_factory=list)

    def told(self, path: str) -> str:
        """Return what was written, in one line."""
        markers = self.markers
        gaps = markers.gaps()
        parts = [
            counted(len(markers.names), "marker"),
            f"{counted(markers.frames, 'frame')} at {markers.rate_hz:.6g} Hz",
            f"{counted(len(gaps), 'gap')} in {counted(len({gap[0] for gap in gaps}), 'marker')}" if gaps else "",
            counted(len(markers.events), "event") if markers.events else "",
            counted(len(markers.analog), "analog channel") if markers.analog else "",
        ]
        return f"Exported {base_name(path)}: {', '.join(part for part in parts if part)}"


def record(context: Context, source: Object | Sequence[Object], request: Request) -> Recording:
    """Return what a file of a marker set, of an armature's joints, or of objects says."""
    if isinstance(source, Sequence):
        return _of_objects(context, source, request)
    return _of_set(context, source, request) if properties.is_set(source) else _of_joints(context, source, request)


def _of_set(context: Context, ob: Object, request: Request) -> Recording:
    bones = edit.chosen(ob, selected_only=request.selected_only)
    if not bones:
        raise UserError(f"“{ob.name}” has no markers")
    lies, scene_hz = properties.of(ob), scene.rate_hz(context.scene)
    own_hz = usual(scene_hz / lies.key_step)
    rate_hz = request.rate_hz or own_hz
    unit_m = lies.unit_m * context.scene.unit_settings.scale_length
    known_unit = next((known for known in NAMED_UNITS_M if abs(unit_m / known - 1.0) < SAME_UNIT), UNIT_M)
    up = lies.up if request.up == "AUTO" and request.kind != "csm" else request.up
    forward = lies.forward if up == lies.up else axes.AS_IN_FILE
    first = lies.first_frame + (request.start - lies.first_frame) * rate_hz / scene_hz
    frames = exporting.frames_between(request.start, request.end, scene_hz / max(rate_hz, own_hz))
    points = places.of_set(context, ob, bones, frames)
    file_names = names.by_bone(lies.names)
    recorded = _source(ob)
    found = signals.moments(context.scene, ob, recorded)
    analog = signals.signals(ob)
    made = _markers(
        context,
        [file_names.get(bone, bone) for bone in bones],
        points,
        _Lie(request, max(rate_hz, own_hz), rate_hz, first, up, request.unit_m or known_unit, forward),
        found,
    )
    result = Recording(made)
    if analog and request.kind == "c3d" and request.with_analog:
        result.markers = _with_analog(context, made, analog, request.start, result.notices)
    result.notices += exporting.object_notices(ob)
    result.notices += _left_out(request, result.markers, found, analog, recorded)
    return result


def _of_joints(context: Context, ob: Object, request: Request) -> Recording:
    up = UP[request.kind] if request.up == "AUTO" else request.up
    wanted = exporting.Request(request.start, request.end, request.rate_hz, up, request.unit_m or UNIT_M)
    exported = exporting.convert(context, ob, wanted)
    skeleton, motion = exported.skeleton, exported.motion
    poses = [motion.pose(skeleton, motion.first_frame + frame)[:2] for frame in range(motion.frames)]
    heads, tails = (np.stack([pose[which] for pose in poses], axis=1) for which in (0, 1))
    chosen = [ob.data.bones.find(bone) for bone in edit.chosen(ob, selected_only=request.selected_only)]
    length = np.linalg.norm(np.asarray(skeleton.tails) - np.asarray(skeleton.heads), axis=1)
    is_last = ~np.isin(np.arange(len(length)), skeleton.parents) & (length > exporting.ROUNDING * skeleton.height)
    joints: list[tuple[str, Floats]] = []
    for bone in chosen:
        name = skeleton.names[bone]
        if request.joints == "TAILS":
            joints.append((name, tails[bone]))
            continue
        joints.append((name, heads[bone]))
        if is_last[bone]:
            joints.append((f"{name}_End", tails[bone]))
    found = signals.moments(context.scene, None, None)
    made = motion_theater.Markers(
        [name for name, _ in joints],
        np.stack([place for _, place in joints]),
        rate_hz=motion.rate_hz,
        first_frame=motion.first_frame,
        unit_m=skeleton.unit_m,
        up=skeleton.up,
        events=_events(context, request, found, motion.first_frame, float(motion.rate_hz or 1.0)),
    )
    return Recording(made, exported.notices + _left_out(request, made, found, [], None))


def _of_objects(context: Context, objects: Sequence[Object], request: Request) -> Recording:
    scene_hz = scene.rate_hz(context.scene)
    rate_hz = request.rate_hz or scene_hz
    frames = exporting.frames_between(request.start, request.end, scene_hz / max(rate_hz, scene_hz))
    points = places.of_objects(context, objects, frames)
    found = signals.moments(context.scene, None, None)
    lie = _Lie(request, max(rate_hz, scene_hz), rate_hz, request.start, request.up, request.unit_m or UNIT_M)
    made = _markers(context, [ob.name for ob in objects], points, lie, found)
    return Recording(made, _left_out(request, made, found, [], None))


@dataclass(frozen=True)
class _Lie:
    """How sampled points lie in the file."""

    request: Request
    sampled_hz: float
    rate_hz: float
    first: float
    up: str
    unit_m: float
    forward: str = axes.AS_IN_FILE


def _markers(
    context: Context, file_names: list[str], points: Floats, lie: _Lie, found: list[signals.Moment]
) -> motion_theater.Markers:
    """Return points in the world, sampled from the first frame on, as the markers of a file."""
    up = UP[lie.request.kind] if lie.up == "AUTO" else lie.up
    scale = context.scene.unit_settings.scale_length / lie.unit_m
    positions = trajectories.as_in_file(points, up, lie.forward) * scale
    if lie.rate_hz < lie.sampled_hz:
        finer = motion_theater.Markers(file_names, np.ascontiguousarray(positions), rate_hz=lie.sampled_hz)
        positions = finer.resampled(lie.rate_hz).positions.astype(np.float64, copy=False)
    first = max(1, round(lie.first))
    axis = axes.rotate(axes.inverse(np.array(axes.TO_BLENDER[up])), np.array((0.0, 0.0, 1.0)))
    return motion_theater.Markers(
        file_names,
        np.ascontiguousarray(positions),
        rate_hz=lie.rate_hz,
        first_frame=first,
        unit_m=lie.unit_m,
        up=(float(axis[0]), float(axis[1]), float(axis[2])),
        events=_events(context, lie.request, found, first, lie.rate_hz),
    )


def _events(
    context: Context, request: Request, found: list[signals.Moment], first: int, rate_hz: float
) -> list[tuple[str, float, str, str]]:
    """Return the events of a file whose first frame, of this number, is the first one of the range."""
    if request.kind != "c3d" or not request.with_events:
        return []
    begin, scene_hz = (first - 1) / rate_hz, scene.rate_hz(context.scene)
    return [
        (moment.label, begin + (moment.frame - request.start) / scene_hz, moment.context, moment.subject)
        for moment in found
        if _is_within(request, moment)
    ]


def _is_within(request: Request, moment: signals.Moment) -> bool:
    return request.start - 0.5 <= moment.frame <= request.end + 0.5


def _with_analog(
    context: Context,
    markers: motion_theater.Markers,
    analog: list[signals.Signal],
    start: float,
    notices: list[str],
) -> motion_theater.Markers:
    """Return markers with analog channels, at a whole number of samples for each frame."""
    scene_hz, rate_hz = scene.rate_hz(context.scene), float(markers.rate_hz or 1.0)
    spacing = min(signal.spacing() for signal in analog)
    exact = scene_hz / rate_hz / spacing
    each = min(max(1, round(exact)), MOST_SAMPLES_PER_FRAME)
    if abs(exact - each) > 1e-3 * each:
        notices.append(f"The analog channels were brought to {usual(each * rate_hz):.6g} Hz")
    frames = start + np.arange(markers.frames * each, dtype=np.float64) * (scene_hz / rate_hz / each)
    channels = [(one.name, one.description, one.unit, np.ascontiguousarray(one.values(frames))) for one in analog]
    return markers.with_analog(channels, each)


def _source(ob: Object) -> motion_theater.Markers | None:
    """Return what the file of a marker set holds, where it still is there."""
    try:
        return sources.read_file(sources.absolute(ob, properties.of(ob).source)).clip.markers
    except UserError:
        return None


def _left_out(
    request: Request,
    written: motion_theater.Markers,
    found: list[signals.Moment],
    analog: list[signals.Signal],
    recorded: motion_theater.Markers | None,
) -> list[str]:
    """Return what of the scene, and of the file that a marker set came from, is not in the new file."""
    told = []
    events = sum(_is_within(request, moment) for moment in found)
    if request.kind == "c3d":
        outside = len(found) - events
        if request.with_events and outside:
            told.append(f"Left out {counted(outside, 'event')} outside of the range")
    else:
        missing = [counted(events, "event")] * bool(events) + [counted(len(analog), "analog channel")] * bool(analog)
        if missing:
            told.append(f"A {request.kind.upper()} file has no place for {' and '.join(missing)}")
        odd = [name for name in written.names if UNWRITABLE.search(name)]
        if odd:
            told.append(f"Blanks, commas and dollar signs became _ in {listing(odd)}")
    if recorded is not None and request.kind == "c3d":
        computed = sum(kind != "POSITION" for kind in recorded.kinds)
        lost = [
            counted(computed, "computed point") if computed else "",
            "residuals and cameras" if (recorded.residuals > 0.0).any() or recorded.cameras.any() else "",
            _missing(len(recorded.events), len(found), "event"),
            _missing(len(recorded.analog), len(analog), "analog channel"),
        ]
        if any(lost):
            told.append(f"Not in the scene, so not written: {', '.join(part for part in lost if part)}")
    return told


def _missing(in_file: int, in_scene: int, what: str) -> str:
    return counted(in_file - in_scene, what) if in_file > in_scene else ""
