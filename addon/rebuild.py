"""The one way from a stack to its action: evaluate the recipe, then write what changes.

The action that is written is plain and carries, as a custom property, a hash of what was written for each bone
(`logic.record`). Everything that can fail comes before the first change.
"""

from __future__ import annotations

from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

import numpy as np

import motion_theater

from . import compat, rig, scene, sources
from .curves import base as base_curves
from .curves import overruled, read
from .curves.result import Result
from .curves.write import Wanted
from .logic import axes, names, plan
from .logic import keys as key_arrays
from .logic.extent import ASSUMED_RATE_HZ, extent
from .logic.messages import UserError, edited_by_hand, listing

if TYPE_CHECKING:
    import bpy
    from bpy.types import Object

    from .properties import MotionEntry, MotionStack


FRAMES = ("cut_start", "cut_end", "scale_start", "scale_end")


class EntryError(UserError):
    """What keeps one entry of the stack from being evaluated."""

    def __init__(self, entry: int, text: str) -> None:
        super().__init__(text)
        self.entry = entry


@dataclass
class Base:
    """What lies below the entries: for each bone the curves of the base, or those that were kept."""

    of_base: read.Index
    of_kept: dict[int, read.Index] = field(default_factory=dict)
    kept: dict[int, int] = field(default_factory=dict)

    def below(self, bone: int) -> read.Index:
        """Return the curves below the entries that act on a bone."""
        return self.of_kept[self.kept[bone]] if bone in self.kept else self.of_base


def rebuild(ob: Object, current_scene: bpy.types.Scene, *, over_edits: bool) -> list[str]:
    """Rebuild the action of an armature; return what the user should know. Raises UserError with nothing changed."""
    reason = rig.writable_reason(ob)
    if reason:
        raise UserError(reason)
    motion: MotionStack = ob.motion_theater
    rest = rig.read_rest(ob)
    the_plan = plan.plan([as_plan_entry(entry) for entry in motion.entries], rest.names)
    _refuse_axis_angle(rest, the_plan.touched)
    below = _base(ob, motion, the_plan)
    steps = [_native_step(ob, motion, rest, step) for step in the_plan.steps]
    base = [
        channel
        for bone in sorted(the_plan.touched)
        for name in base_curves.channels_of(rest.modes[bone])
        if (channel := base_curves.base_channel(below.below(bone), bone, rest.names[bone], name)) is not None
    ]
    native_rig = _native_rig(motion, rest, scene.rate_hz(current_scene))
    result = Result(ob)
    touched = {rest.names[bone] for bone in the_plan.touched}
    bones = [(number, name) for number, name in enumerate(rest.names) if name in touched or name in result.digests]
    with ThreadPoolExecutor(1) as worker:  # the native module works without the interpreter; Blender is read meanwhile
        evaluating = worker.submit(motion_theater.evaluate, native_rig, base, [native for native, _ in steps])
        result.prefetch(name for _, name in bones)
        try:
            evaluation = evaluating.result()
        except motion_theater.MotionTheaterError as error:
            raise UserError(str(error)) from error
    wanted = _wanted(rest, bones, below, evaluation)
    edited = [] if over_edits else result.edited(wanted, below.of_base)
    if edited:
        motion.hand_edited = names.join(edited)
        raise UserError(edited_by_hand(edited))
    locked = result.update(wanted, touched, motion)
    motion.hand_edited = ""
    told = _tell(motion, the_plan, evaluation, [loaded for _, loaded in steps], locked, scene.rate_hz(current_scene))
    return told + overruled.notices(ob, touched)


def as_plan_entry(entry: MotionEntry) -> plan.Entry:
    """Return an entry's settings as plain values."""
    bones = None if entry.all_bones else tuple(names.split(entry.bones))
    if entry.kind == "TRACK":
        options: dict[str, object] = {
            name: plan.frame_or_none(getattr(entry, name)) for name in (*FRAMES, "blend_depth")
        }
        options |= {
            name: getattr(entry, name)
            for name in ("preserve", "preserve_rotation", "preserve_height", "discard", "blend", "sampling", "keys")
        }
        options["rate_hz"] = entry.rate_hz or None
    else:
        options = {"kind": entry.filter_kind, "depth": entry.depth, "channels": entry.filter_channels}
    return plan.Entry(entry.kind, entry.name, entry.enabled, bones, options)


def _refuse_axis_angle(rest: rig.Rest, touched: set[int]) -> None:
    bones = [rest.names[bone] for bone in sorted(touched) if rest.modes[bone] == "AXIS_ANGLE"]
    if bones:
        raise UserError(
            f"{listing(bones)}: the rotation mode Axis Angle cannot hold motion tracks; choose Quaternion or Euler"
        )


def _base(ob: Object, motion: MotionStack, the_plan: plan.Plan) -> Base:
    bag = compat.bag_of(ob, motion.base_action, slot_name=motion.base_slot)
    below = Base(read.index(bag), kept=the_plan.kept)
    for number in set(the_plan.kept.values()):
        entry = motion.entries[number]
        if entry.action is None:
            raise EntryError(number, f"The action with the kept edits of “{entry.name}” was removed")
        below.of_kept[number] = read.index(compat.bag_of(ob, entry.action))
    return below


def _native_step(
    ob: Object, motion: MotionStack, rest: rig.Rest, step: plan.Step
) -> tuple[motion_theater.Track | motion_theater.Filter, sources.Loaded | None]:
    """Return one entry as the native module takes it, and the clip of a track."""
    entry = motion.entries[step.entry]
    options: dict[str, Any] = dict(as_plan_entry(entry).options)
    try:
        if entry.kind == "FILTER":
            plan.check_depth(entry.depth)
            return motion_theater.Filter(label=entry.name, bones=step.bones, **options), None
        clip_motion, loaded = sources.rest_motion(ob, entry, rest)
        return motion_theater.Track(clip_motion, label=entry.name, bones=step.bones, **options), loaded
    except (UserError, motion_theater.MotionTheaterError) as error:
        raise EntryError(step.entry, str(error)) from error


def _native_rig(motion: MotionStack, rest: rig.Rest, rate_hz: float) -> motion_theater.Rig:
    if not motion.skeleton_text:
        return rig.native_rig(rest, rate_hz=rate_hz)
    skeleton = sources.skeleton_from_text(motion.skeleton_text)
    matched = sources.matched_bones(motion, skeleton, rest.names)
    file_axes, file_orders = rig.file_frame(rest, skeleton, matched, axes.to_blender(motion.up, motion.forward))
    return rig.native_rig(rest, rate_hz=rate_hz, file_axes=file_axes, file_orders=file_orders)


def _wanted(
    rest: rig.Rest,
    bones: Sequence[tuple[int, str]],
    below: Base,
    evaluation: motion_theater.Evaluation,
) -> dict[str, list[Wanted | None]]:
    """Return by bone what its curves are to be, in the order of `read.of_bone`; None: no curve."""
    results = {(channel.bone, channel.channel): channel for channel in evaluation.channels}
    wanted: dict[str, list[Wanted | None]] = {}
    for number, name in bones:
        curves = below.below(number)
        row: list[Wanted | None] = []
        for channel, components in read.CHANNELS.items():
            data_path, result = read.path(name, channel), results.get((number, channel))
            row += [_wanted_curve(curves.get((data_path, at)), result, at) for at in range(components)]
        wanted[name] = row
    return wanted


def _wanted_curve(
    curve: bpy.types.FCurve | None, result: motion_theater.ResultChannel | None, component: int
) -> Wanted | None:
    if result is None:
        if curve is None:
            return None
        kept = read.keys(curve)
        return Wanted(kept["co"], kept, kept_before=np.inf)
    row = result.coordinates[component]
    has_kept = False
    if curve is not None and len(curve.keyframe_points):
        at = key_arrays.frames(read.coordinates(curve))
        has_kept = bool(at[0] < result.start - key_arrays.NEAREST / 2 or at[-1] > result.end + key_arrays.NEAREST / 2)
    if not has_kept and result.interpolation is None:
        return Wanted(row)
    made = key_arrays.made(row, result.interpolation)
    if curve is None or not has_kept:
        return Wanted(row, made)
    spliced = key_arrays.spliced(read.keys(curve), made, result.start, result.end)
    return Wanted(spliced["co"], spliced, kept_before=result.start, kept_after=result.end)


def _tell(
    motion: MotionStack,
    the_plan: plan.Plan,
    evaluation: motion_theater.Evaluation,
    clips: Sequence[sources.Loaded | None],
    locked: Sequence[str],
    scene_hz: float,
) -> list[str]:
    """Leave with each entry what the panel shows of it; return all notices."""
    by_entry: dict[int, list[str]] = {}
    for number, text in the_plan.notices:
        by_entry.setdefault(number, []).append(text)
    for notice in evaluation.notices:
        by_entry.setdefault(the_plan.steps[notice.entry].entry, []).append(notice.text)
    for number, entry in enumerate(motion.entries):
        entry.notices = names.join(dict.fromkeys(by_entry.get(number, ())))
        entry.error = ""
    for step, loaded in zip(the_plan.steps, clips, strict=True):
        if loaded is not None:
            entry = motion.entries[step.entry]
            entry.clip_frames, entry.clip_first = loaded.clip.frames, loaded.clip.first_frame
            entry.clip_rate_hz = loaded.clip.rate_hz or 0.0
            frame = {name: plan.frame_or_none(getattr(entry, name)) for name in FRAMES}
            entry.result_start, entry.result_end = extent(
                first=loaded.clip.first_frame,
                frames=loaded.clip.frames,
                file_hz=entry.rate_hz or loaded.clip.rate_hz or ASSUMED_RATE_HZ,
                scene_hz=scene_hz,
                cut=(frame["cut_start"], frame["cut_end"]),
                scale=(frame["scale_start"], frame["scale_end"]),
                on_whole_frames=entry.keys == "FRAMES",
            )
    notices = list(dict.fromkeys(text for number in sorted(by_entry) for text in by_entry[number]))
    if locked:
        notices.append(f"Locked F-curves were left as they are: {listing(locked)}")
    return notices
