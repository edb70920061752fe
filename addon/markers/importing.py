"""From a file of markers to a marker set."""

from __future__ import annotations

from pathlib import PurePath
from typing import TYPE_CHECKING, Literal

import bpy
import numpy as np

from .. import compat, scene, sources
from ..logic import axes, names, trajectories
from ..logic.extent import ASSUMED_RATE_HZ
from ..logic.messages import UserError, base_name, counted, frame_range, sentences
from ..logic.rates import usual
from ..properties import FRAME_LIMIT
from . import analog, build, events, keys, lines, properties

if TYPE_CHECKING:
    from bpy.types import Context, Object

    import motion_theater

    from ..logic.ranges import Choice

MOST_MARKERS = 2048  # five times what the largest studios record; Blender's Edit Mode takes minutes for more
Rate = Literal["RESAMPLE", "SCENE", "SAMPLES"]


def import_markers(
    context: Context,
    clip: motion_theater.Clip,
    *,
    rate: Rate = "RESAMPLE",
    rate_hz: float = 0.0,
    scene_range: Choice = "EXTEND",
    scale: float = 1.0,
    up: str = "AUTO",
    forward: str = axes.AS_IN_FILE,
    with_lines: bool = False,
    with_events: bool = False,
    with_analog: bool = False,
) -> str:
    """Make a marker set of a clip with markers; return the message for the user.

    `rate_hz` goes before the file's own rate, `up` and `forward` are axes of the file. Run inside
    `scene.unchanged_on_error`.
    """
    chosen, told = _points(clip)
    recorded = clip.markers
    own_rate = rate_hz or recorded.rate_hz
    rate_hz = usual(own_rate or ASSUMED_RATE_HZ)
    if not own_rate:
        told.append(f"The file does not say its rate: {rate_hz:g} Hz assumed")
    if rate == "SCENE":
        scene.set_rate(context.scene, rate_hz)
    step = 1.0 if rate == "SCENE" else scene.rate_hz(context.scene) / rate_hz
    sampling = trajectories.sampling(
        samples=recorded.frames, first=float(recorded.first_frame), step=step, on_whole_frames=rate != "SAMPLES"
    )
    if abs(sampling.frames[0]) > FRAME_LIMIT or abs(sampling.frames[-1]) > FRAME_LIMIT:
        raise UserError(f"{base_name(clip.path)} ends on frame {sampling.frames[-1]:.0f}, beyond Blender's last one")
    unit = recorded.unit_m * scale / context.scene.unit_settings.scale_length
    chosen_up = axes.nearest_axis(recorded.up) if up == "AUTO" else up

    ob, bones, dropped = _make(context, clip, chosen, sampling, unit, trajectories.from_axes(chosen_up, forward))
    remembered = properties.of(ob)
    remembered.source = sources.full_path(clip.path)
    remembered.names = names.encode_pairs(zip((recorded.names[at] for at in chosen), bones, strict=True))
    remembered.unit_m, remembered.rate_hz = unit, rate_hz
    remembered.up, remembered.forward = chosen_up, forward
    remembered.first_frame, remembered.frame_step = recorded.first_frame, step
    remembered.key_step = step if rate == "SAMPLES" else 1.0

    if with_lines:
        told.append(lines.add(context, ob, bones, _pairs(recorded, chosen)))
    if with_analog:
        told.append(analog.add(ob, recorded))
    if with_events:
        told.append(events.add(context.scene, ob, recorded))
    scene.apply_range(context.scene, scene_range, float(sampling.frames[0]), float(sampling.frames[-1]))
    first = f"Imported {base_name(clip.path)}: {counted(len(bones), 'marker')}"
    span = frame_range(float(sampling.frames[0]), float(sampling.frames[-1]))
    message = sentences([f"{first}, {span}", dropped, *told, *_inferred(clip, scale, up, forward)])
    remembered.message = message
    return message


def _points(clip: motion_theater.Clip) -> tuple[list[int], list[str]]:
    """Return which points of a file are markers, and what is to be said about the others."""
    name = base_name(clip.path)
    recorded = clip.markers
    if recorded is None:
        raise UserError(f"{name} holds no markers: choose a .c3d, .csm or .trc file")
    chosen = [at for at, kind in enumerate(recorded.kinds) if kind == "POSITION"]
    if not chosen or not recorded.frames:
        what = "analog channels but no markers" if recorded.analog else "no markers"
        raise UserError(f"{name} holds {what if not chosen else 'no frames'}")
    if len(chosen) > MOST_MARKERS:
        raise UserError(f"{name} has {len(chosen)} markers: more than {MOST_MARKERS} are not imported")
    others = len(recorded.kinds) - len(chosen)
    computed = f"Left out {counted(others, 'point')} of the file that are angles, forces or other computed values"
    return chosen, [computed] if others else []


def _make(
    context: Context,
    clip: motion_theater.Clip,
    chosen: list[int],
    sampling: trajectories.Sampling,
    unit: float,
    from_axis: tuple[tuple[int, float], ...],
) -> tuple[Object, list[str], str]:
    """Make armature and curves; return the armature, its bones, and what is to be said about dropouts."""
    recorded = clip.markers
    positions, valid = recorded.positions, recorded.valid
    if len(chosen) < len(positions):
        positions, valid = positions[chosen], valid[chosen]
    if np.isinf(positions).any():  # a damaged file; Blender would draw nothing at all
        valid &= np.isfinite(positions).all(axis=2)
    places = trajectories.rest_places(positions, valid)
    places = np.stack([places[:, axis] * (sign * unit) for axis, sign in from_axis], axis=1)
    ob, bones = build.build(context, PurePath(base_name(clip.path)).stem, [recorded.names[at] for at in chosen], places)
    # Bones keep 32 bits of their rest place; the curves make up for what was lost.
    places = np.array([ob.data.bones[bone].head_local for bone in bones], np.float64)
    action = bpy.data.actions.new(ob.name)
    bag = compat.ensure_bag(ob, action)
    compat.assign(ob, action)
    curves: dict = {}
    gaps, with_gaps, never = 0, 0, 0
    for number, bone in enumerate(bones):
        seen = sampling.seen(valid[number])

        def along(component: int, number: int = number) -> trajectories.Floats:
            axis, sign = from_axis[component]
            moved = sampling.values(positions[number, :, axis]) * np.float64(sign * unit)
            return moved - places[number, component]

        keys.write_trajectory(bag, curves, bone, sampling.frames, along, seen)
        found = trajectories.gaps(seen)
        gaps, with_gaps, never = gaps + found, with_gaps + bool(found), never + (not seen.any())
    return ob, bones, sentences([_dropouts(gaps, with_gaps), f"{counted(never, 'marker')} never seen" if never else ""])


def _dropouts(gaps: int, markers: int) -> str:
    return f"{counted(gaps, 'gap')} in {counted(markers, 'marker')}" if gaps else ""


def _inferred(clip: motion_theater.Clip, scale: float, up: str, forward: str) -> list[str]:
    """Return what was inferred, with reasons: the file's own notices, but for what the user chose instead."""
    told = [f"Up axis: {up}, as you chose"] if up != "AUTO" else []
    told += [f"Facing: {forward}, as you chose"] if forward != axes.AS_IN_FILE else []
    told += [f"Scaled by {scale:g}"] if scale != 1.0 else []
    is_stale = ("Up axis", "Facing") if up != "AUTO" else ("Facing",) if forward != axes.AS_IN_FILE else ()
    return told + [notice for notice in clip.notices if not notice.startswith(is_stale)]


def _pairs(recorded: motion_theater.Markers, chosen: list[int]) -> list[tuple[int, int]]:
    """Return the pairs of neighbors as numbers of the chosen markers."""
    number = {at: number for number, at in enumerate(chosen)}
    return [(number[a], number[b]) for a, b in recorded.neighbours() if a in number and b in number]
