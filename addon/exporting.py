"""From an armature with its motion to the skeleton and motion of a file, in the file's axes and units."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

import motion_theater

from . import compat, rig, scene, sources, stack
from .curves import read, sampled
from .logic import axes, names
from .logic.messages import UserError, bones, counted, listing

if TYPE_CHECKING:
    from bpy.types import Context, Object, Scene

    from .logic.axes import Floats

USUAL_UP = "Y"
USUAL_UNIT_M = 0.01
USUAL_ORDER = "YXZ"  # Zrotation Xrotation Yrotation in a BVH
TURNS = ["rz", "rx", "ry"]
MOVES = ["tx", "ty", "tz"]
MOST_FRAMES = 1_000_000
SAME_AXES = 1e-9
ROUNDING = 1e-5  # of the size of a skeleton: what single precision makes of a place


@dataclass(frozen=True)
class Request:
    """What the user asked for."""

    start: float
    end: float
    rate_hz: float = 0.0
    """Frames per second of the file; 0: those of the scene."""
    up: str = "AUTO"
    unit_m: float = 0.0
    """Metres per unit of the file; 0: those of the file that the armature came from, else centimetres."""
    keeps_axes: bool = False
    """Give bones the axes of the file that they came from, where the format has such."""


@dataclass(frozen=True)
class Exported:
    """What is to be written."""

    skeleton: motion_theater.Skeleton
    motion: motion_theater.Motion
    notices: list[str]


@dataclass(frozen=True)
class _Place:
    """How the armature lies in the file."""

    turn: Floats
    """From armature axes to file axes."""
    scale: float
    """File units per armature unit."""
    move: Floats
    up: str
    unit_m: float


def convert(context: Context, ob: Object, request: Request) -> Exported:
    """Return what a file of an armature's motion says."""
    rest = rig.read_rest(ob)
    if not rest.names:
        raise UserError(f"“{ob.name}” has no bones")
    place = _place(ob, context.scene, request)
    motion = stack.of(ob)
    template = sources.skeleton_from_text(motion.skeleton_text) if motion.skeleton_text else None
    skeleton = _skeleton(ob, rest, place, template, keeps_axes=request.keeps_axes)
    scene_hz = scene.rate_hz(context.scene)
    rate_hz = request.rate_hz or scene_hz
    frames = frames_between(request.start, request.end, scene_hz / max(rate_hz, scene_hz))
    samples = sampled.sample(ob, context.scene, rest, frames)
    turn, back = place.turn, axes.inverse(place.turn)
    rotations = [axes.multiply(axes.multiply(turn, one), back) for one in samples.rotations]
    offsets = [axes.rotate(turn, one) * place.scale for one in samples.offsets]
    keeps = [
        rest.parents[number] < 0 or any(dof in skeleton.dofs[number] for dof in MOVES) or bool(np.any(offsets[number]))
        for number in range(len(rest.names))
    ]
    made = motion_theater.Motion(
        skeleton,
        frames=len(frames),
        rotations=[np.ascontiguousarray(one) for one in rotations],
        translations=[np.ascontiguousarray(one) if keep else None for one, keep in zip(offsets, keeps, strict=True)],
        first_frame=max(1, int(np.ceil(request.start))),
        rate_hz=max(rate_hz, scene_hz),
    )
    if rate_hz < scene_hz:
        made = made.resampled(rate_hz)
    return Exported(skeleton, made, _notices(ob, samples))


def _place(ob: Object, current: Scene, request: Request) -> _Place:
    motion = stack.of(ob)
    is_imported = motion.unit_m > 0.0
    up = request.up if request.up != "AUTO" else motion.up if is_imported else USUAL_UP
    forward = motion.forward if is_imported and up == motion.up else axes.AS_IN_FILE
    own_unit_m = motion.unit_m * current.unit_settings.scale_length
    unit_m = request.unit_m or (own_unit_m if is_imported else USUAL_UNIT_M)
    location, rotation, scale = ob.matrix_world.decompose()
    into_file = axes.inverse(axes.to_blender(up, forward))
    per_unit = current.unit_settings.scale_length / unit_m
    return _Place(
        turn=axes.multiply(into_file, np.array(rotation)),
        scale=float(np.mean(np.abs(np.array(scale)))) * per_unit,
        move=axes.rotate(into_file, np.array(location)) * per_unit,
        up=up,
        unit_m=unit_m,
    )


def _skeleton(
    ob: Object,
    rest: rig.Rest,
    place: _Place,
    template: motion_theater.Skeleton | None,
    *,
    keeps_axes: bool,
) -> motion_theater.Skeleton:
    """Return the rest pose in the file's axes, with the names and channels of the file that the armature came from."""
    motion = stack.of(ob)
    file_name = names.by_bone(motion.bone_names)
    known = {name: number for number, name in enumerate(template.names)} if template else {}
    heads = axes.rotate(place.turn, rest.heads) * place.scale + place.move
    own_tails = np.array([ob.data.bones[name].tail_local for name in rest.names], np.float64)
    tails = axes.rotate(place.turn, own_tails) * place.scale + place.move
    bone_axes = np.tile((1.0, 0.0, 0.0, 0.0), (len(rest.names), 1))
    orders = [USUAL_ORDER] * len(rest.names)
    dofs = [[*MOVES, *TURNS] if parent < 0 else list(TURNS) for parent in rest.parents]
    # From the axes of the file that the armature came from to those of the file that is written.
    turn = axes.multiply(place.turn, axes.to_blender(motion.up, motion.forward))
    is_same = bool(np.abs(turn[1:]).max() < SAME_AXES)
    ratio = place.scale * motion.unit_m
    ratio = 1.0 if abs(ratio - 1.0) < ROUNDING else ratio  # the stack keeps its unit in single precision
    size = float(np.ptp(heads, axis=0).max())
    for number, name in enumerate(rest.names):
        at = known.get(file_name.get(name, name))
        if template is None or at is None:
            continue
        head, tail = np.asarray(template.heads)[at], np.asarray(template.tails)[at]
        if not is_same:
            head, tail = axes.rotate(turn, head), axes.rotate(turn, tail)
        own_head = head * ratio + place.move
        if np.abs(own_head - heads[number]).max() <= ROUNDING * size:
            heads[number] = own_head
        tails[number] = heads[number] + (tail - head) * ratio
        own = np.asarray(template.axes)[at]
        has_file_axes = bool(np.abs(own[1:]).max() == 0.0)
        if keeps_axes:
            bone_axes[number] = own if is_same else axes.multiply(turn, own)
        if keeps_axes or (has_file_axes and is_same):
            orders[number] = template.orders[at]
            dofs[number] = list(template.dofs[at]) or dofs[number]
    _join(heads, tails, rest.parents, ROUNDING * size)
    up = axes.rotate(axes.inverse(np.array(axes.TO_BLENDER[place.up])), np.array((0.0, 0.0, 1.0)))
    return motion_theater.Skeleton(
        [file_name.get(name, name) for name in rest.names],
        parents=list(rest.parents),
        heads=np.ascontiguousarray(heads),
        tails=np.ascontiguousarray(tails),
        axes=bone_axes,
        orders=orders,
        dofs=dofs,
        up=(float(up[0]), float(up[1]), float(up[2])),
        unit_m=place.unit_m,
        name=ob.name,
    )


def _join(heads: Floats, tails: Floats, parents: Sequence[int], tolerance: float) -> None:
    """Let bones that begin where their parent ends do so exactly: Blender keeps places in single precision."""
    for number, parent in enumerate(parents):
        gap = tails[parent] - heads[number]
        if parent >= 0 and 0.0 < np.abs(gap).max() <= tolerance:
            heads[number] += gap
            tails[number] += gap


def frames_between(start: float, end: float, step: float) -> Floats:
    """Return the frames from one to another, `step` apart; a last one that is missed by a hair counts."""
    if end < start:
        raise UserError("The last frame comes before the first one")
    rounding = 2.0 * float(np.spacing(np.float32(max(abs(start), abs(end)))))  # of the frames of keys
    count = int(np.floor((end - start + rounding) / step + 1e-6)) + 1
    if count > MOST_FRAMES:
        raise UserError(f"{count} frames are more than the {MOST_FRAMES} that are exported")
    return start + step * np.arange(count, dtype=np.float64)


def _notices(ob: Object, samples: sampled.Sampled) -> list[str]:
    told = []
    if not samples.is_from_curves:
        told.append("The pose was taken frame by frame, for more than F-curves moves the bones")
    return told + object_notices(ob)


def object_notices(ob: Object) -> list[str]:
    """Return what is to be said where an armature is animated as an object."""
    action = ob.animation_data.action if ob.animation_data else None
    paths = {path for path, _ in read.index(compat.bag_of(ob, action))}
    if paths.isdisjoint({"location", "rotation_euler", "rotation_quaternion"}):
        return []
    return ["The animation of the object itself is left out: it stands where it is at the current frame"]


def write(files: Sequence[tuple[str, bytes]]) -> None:
    """Write files; none is ever there in part."""
    for path, data in files:
        target = Path(path)
        try:
            part = target.with_name(f".{target.name}.part")
            try:
                part.write_bytes(data)
                part.replace(target)
            finally:
                part.unlink(missing_ok=True)
        except OSError as error:
            raise UserError(f"{target.name} cannot be written: {error.strerror or error}") from error


def told(paths: Sequence[str], exported: Exported) -> str:
    """Return the message for the user, in one line."""
    motion = exported.motion
    count = counted(motion.frames, "frame")
    files = listing([Path(path).name for path in paths])
    return f"Exported {files}: {bones(len(motion.names))}, {count} at {motion.rate_hz:.6g} Hz"
