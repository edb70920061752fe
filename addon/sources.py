"""Where motion comes from: files, packed files, and the skeletons that they need.

Reading a file and bringing it into an armature's rest axes are done once and kept for the session, keyed by what the
file is, so that dragging a number in the stack only evaluates. Nothing of Blender's is kept, only the native module's
own objects.
"""

from __future__ import annotations

import base64
import hashlib
import os
import time
import zlib
from collections import OrderedDict
from collections.abc import Hashable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Generic, TypeVar

import bpy

import motion_theater

from . import rig
from .logic import axes, names
from .logic.messages import UserError, base_name, listing, misfit

if TYPE_CHECKING:
    from bpy.types import Object

    from .properties import MotionEntry, MotionStack

T = TypeVar("T")
MISSING_CHECK_S = 2.0  # a panel asks at each redraw; the disk is asked at most this often


class Cache(Generic[T]):
    """The last few values by key."""

    def __init__(self, size: int) -> None:
        self._size = size
        self._values: OrderedDict[Hashable, T] = OrderedDict()

    def get(self, key: Hashable) -> T | None:
        """Return what was kept under a key."""
        if key in self._values:
            self._values.move_to_end(key)
        return self._values.get(key)

    def keep(self, key: Hashable, value: T) -> T:
        """Keep a value, and let the one go that was not asked for the longest."""
        self._values[key] = value
        if len(self._values) > self._size:
            self._values.popitem(last=False)
        return value


@dataclass(frozen=True)
class Loaded:
    """A file that was read, and what tells its content from any other's."""

    clip: motion_theater.Clip
    key: Hashable


_clips: Cache[Loaded] = Cache(64)
_skeletons: Cache[motion_theater.Skeleton] = Cache(32)
_texts: Cache[str] = Cache(32)
_bound: Cache[motion_theater.Motion] = Cache(16)
_motions: Cache[motion_theater.Motion] = Cache(64)
_existence: dict[str, tuple[float, bool]] = {}


def read_file(path: str) -> Loaded:
    """Return a motion or skeleton file, read anew only if it changed on disk."""
    try:
        status = Path(path).stat()
        key = (path, status.st_mtime_ns, status.st_size)
        return _clips.get(key) or _clips.keep(key, Loaded(motion_theater.read(path), key))
    except OSError as error:
        raise UserError(f"{base_name(path)} cannot be read: {error.strerror or error}") from error
    except motion_theater.MotionTheaterError as error:
        raise UserError(str(error)) from error
    except ValueError as error:  # a path with a NUL byte
        raise UserError(f"{path!r} is no path of a file") from error


def skeleton_from_text(text: str) -> motion_theater.Skeleton:
    """Return the skeleton that an armature or a track carries as text: an ASF, or a BVH without motion."""
    key = hashlib.sha1(text.encode("latin-1", "replace")).hexdigest()
    known = _skeletons.get(key)
    if known is not None:
        return known
    try:
        clip = motion_theater.read_bytes(text.encode("latin-1"), name="skeleton.asf")
    except (motion_theater.MotionTheaterError, UnicodeEncodeError) as error:
        raise UserError(f"The skeleton stored with the armature cannot be read: {error}") from error
    return _skeletons.keep(key, as_skeleton(Loaded(clip, key)))


def text_of(loaded: Loaded) -> str:
    """Return the skeleton of a file, without its motion, as text that `skeleton_from_text` reads, byte for byte."""
    as_skeleton(loaded)
    known = _texts.get(loaded.key)
    return known if known is not None else _texts.keep(loaded.key, loaded.clip.skeleton_to_bytes().decode("latin-1"))


def has_own_skeleton(loaded: Loaded) -> bool:
    """Return whether a file holds a motion together with its skeleton, as a BVH does."""
    return loaded.clip.motion is not None


def load(ob: Object, entry: MotionEntry) -> Loaded:
    """Return the clip of a track, from inside the .blend if it is packed there, else from its file."""
    if entry.packed_key:
        return _load_packed(ob.motion_theater, entry.packed_key)
    if not entry.source:
        raise UserError(f"“{entry.name}” has no source: relink it")
    return read_file(absolute(ob, entry.source))


def absolute(ob: Object, path: str) -> str:
    """Return a stored path as the system knows it; `//` is relative to the .blend file that the armature lies in."""
    library = ob.library or (ob.override_library.reference.library if ob.override_library else None)
    return os.path.normpath(bpy.path.abspath(path, library=library)) if path else ""


def full_path(path: str) -> str:
    """Return a path that still holds in another folder; links in it stay as they are."""
    return str(Path(path).absolute())


def _load_packed(motion: MotionStack, key: str) -> Loaded:
    packed = motion.packed.get(key)
    if packed is None:
        raise UserError("A packed source is missing in the .blend: relink the track")
    known = _clips.get(("packed", key))
    if known is not None:
        return known
    try:
        clip = motion_theater.read_bytes(_unpacked(packed.data), name=packed.filename)
    except (motion_theater.MotionTheaterError, ValueError, zlib.error) as error:
        raise UserError(f"The packed source {packed.filename} is damaged: {error}") from error
    return _clips.keep(("packed", key), Loaded(clip, ("packed", key)))


def _unpacked(data: str) -> bytes:
    return zlib.decompress(base64.b64decode(data, validate=True))


def skeleton_of(ob: Object, entry: MotionEntry, loaded: Loaded) -> tuple[motion_theater.Skeleton, str]:
    """Return the skeleton with which a track's file is understood, and its text."""
    if has_own_skeleton(loaded):
        return as_skeleton(loaded), text_of(loaded)
    text = entry.skeleton_text or ob.motion_theater.skeleton_text
    if not text:
        raise UserError(f"The skeleton file of “{entry.name}” is not known: add the track anew")
    return skeleton_from_text(text), text


def bind(loaded: Loaded, skeleton_text: str) -> motion_theater.Motion:
    """Return the motion of a file on its own skeleton, or else on the one that a text holds."""
    if loaded.clip.motion is not None:
        return loaded.clip.motion
    key = (loaded.key, skeleton_text)
    known = _bound.get(key)
    if known is not None:
        return known
    try:
        return _bound.keep(key, loaded.clip.bind(skeleton_from_text(skeleton_text)))
    except motion_theater.MotionTheaterError as error:
        raise UserError(str(error)) from error


def matched_bones(
    motion: MotionStack, skeleton: motion_theater.Skeleton, bones: tuple[str, ...] | list[str]
) -> dict[str, str]:
    """Return for each bone of a skeleton file the armature's bone that it means, as far as there is one."""
    return names.match(skeleton.names, bones, names.decode_pairs(motion.bone_names))


def missing_bones(loaded: Loaded, matched: Mapping[str, str]) -> list[str]:
    """Return the bones that have motion in a file and are not among the matched ones."""
    return [name for name in loaded.clip.names if name not in matched]


def rest_motion(ob: Object, entry: MotionEntry, rest: rig.Rest) -> tuple[motion_theater.Motion, Loaded]:
    """Return the motion of a track as channels of the armature's bones, and the clip that it comes from."""
    loaded = load(ob, entry)
    skeleton, text = skeleton_of(ob, entry, loaded)
    motion = ob.motion_theater
    matched = matched_bones(motion, skeleton, rest.names)
    missing = missing_bones(loaded, matched)
    if missing:
        raise UserError(misfit(loaded.clip.path, missing, ob.name))
    scale = file_scale(motion, text, rest, skeleton, matched)
    up = file_up(motion, text, skeleton)
    key = (loaded.key, text, rest.key, up, motion.forward, scale, tuple(matched.items()))
    known = _motions.get(key)
    if known is None:
        file_name = {bone: name for name, bone in matched.items()}
        known = bind(loaded, text).in_rest_axes(
            [file_name.get(bone) for bone in rest.names],
            rig.axes_from_file(rest, axes.to_blender(up, motion.forward)),
            scale,
            orders=[None if mode in {"QUATERNION", "AXIS_ANGLE"} else mode for mode in rest.modes],
        )
        _motions.keep(key, known)
    return known, loaded


def file_scale(
    motion: MotionStack,
    skeleton_text: str,
    rest: rig.Rest,
    skeleton: motion_theater.Skeleton,
    matched: Mapping[str, str],
) -> float:
    """Return scene units per unit of a track's file, whose skeleton is that text.

    An armature that was imported keeps its own scale; a track with a skeleton of its own is scaled by the ratio of the
    two units, and on an armature of other origin sizes are compared.
    """
    if motion.unit_m <= 0.0:
        return rig.scale_from_rest(rest, skeleton, matched)
    if motion.skeleton_text and skeleton_text != motion.skeleton_text:
        return motion.unit_m * skeleton.unit_m / skeleton_from_text(motion.skeleton_text).unit_m
    return motion.unit_m


def file_up(motion: MotionStack, skeleton_text: str, skeleton: motion_theater.Skeleton) -> str:
    """Return the axis of a track's file that points up.

    The armature's own file is understood as it was when it was imported; so is another that stands like it.
    """
    if skeleton_text == motion.skeleton_text:
        return motion.up
    own = axes.nearest_axis(skeleton.up)
    stands_alike = motion.skeleton_text and own == axes.nearest_axis(skeleton_from_text(motion.skeleton_text).up)
    return motion.up if stands_alike else own


@dataclass(frozen=True)
class Pairing:
    """The skeleton with which a motion is understood, and what is to be said of that."""

    skeleton: Loaded
    told: str = ""


def default_skeleton() -> Loaded:
    """Return the skeleton that stands in for a motion's own. Its path is empty: it is from no file."""
    key = "default skeleton"
    text = motion_theater.DEFAULT_SKELETON_ASF.encode("ascii")
    return _clips.get(key) or _clips.keep(key, Loaded(motion_theater.read_bytes(text, name=""), key))


def find_skeleton(path: str, loaded: Loaded, chosen: Sequence[str] = (), *, may_guess: bool) -> Pairing:
    """Return the skeleton that belongs to a motion file: the first candidate that fits, those first that were chosen
    together with it; if there is none, the built-in default where that is allowed and fits, else an error that says
    what was looked at.
    """
    try:
        candidates = motion_theater.skeletons_for(path, chosen=chosen)
    except OSError as error:
        raise UserError(f"{base_name(path)} cannot be read: {error.strerror or error}") from error
    refused: list[str] = []
    for candidate in candidates:
        try:
            skeleton = read_file(candidate.path)
            bind(loaded, text_of(skeleton))
        except UserError as error:
            refused.append(str(error))
            continue
        return Pairing(skeleton, f"Took {base_name(candidate.path)}, because {candidate.reason}")
    default = default_skeleton()
    if may_guess and fits(loaded, default):
        return Pairing(default, motion_theater.DEFAULT_SKELETON_NOTICE)
    if refused:
        raise UserError(f"No skeleton fits {base_name(path)}: {refused[0]}")
    raise UserError(
        f"{base_name(path)} needs its skeleton: select the armature, or put the .asf file into the folder "
        f"(its bones: {listing(loaded.clip.names)})"
    )


def fits(loaded: Loaded, skeleton: Loaded) -> bool:
    """Return whether a motion and a skeleton belong together."""
    try:
        bind(loaded, text_of(skeleton))
    except UserError:
        return False
    return True


def as_skeleton(loaded: Loaded) -> motion_theater.Skeleton:
    """Return the skeleton of a file that should hold one."""
    if loaded.clip.skeleton is None:
        raise UserError(f"{base_name(loaded.clip.path)} holds no skeleton: choose an .asf or .bvh file")
    return loaded.clip.skeleton


def is_missing(ob: Object, entry: MotionEntry) -> bool:
    """Return whether the file of a track is not where it was. Made to be asked at each redraw."""
    if entry.kind != "TRACK" or entry.packed_key:
        return False
    path = absolute(ob, entry.source)
    checked, missing = _existence.get(path, (-MISSING_CHECK_S, False))
    if time.monotonic() - checked >= MISSING_CHECK_S:
        missing = not Path(path).is_file()
        _existence[path] = (time.monotonic(), missing)
    return missing


def pack(ob: Object, entry: MotionEntry) -> None:
    """Keep the file of a track inside the .blend. Tracks of the same file share one copy."""
    loaded = load(ob, entry)
    if entry.packed_key:
        return
    path = absolute(ob, entry.source)
    try:
        data = Path(path).read_bytes()
        motion_theater.read_bytes(data, name=path)  # what is kept must be readable: the file may have just changed
    except OSError as error:
        raise UserError(f"{base_name(path)} cannot be read: {error.strerror or error}") from error
    except motion_theater.MotionTheaterError as error:
        raise UserError(str(error)) from error
    key = hashlib.sha1(data).hexdigest()
    packed = ob.motion_theater.packed
    if packed.get(key) is None:
        item = packed.add()
        item.name = key
        item.filename = base_name(loaded.clip.path)
        item.data = base64.b64encode(zlib.compress(data, 9)).decode("ascii")
    entry.packed_key = key


def unpack(ob: Object, entry: MotionEntry, path: str) -> None:
    """Write the packed file of a track to disk and use it from there; never over another file in that place."""
    motion = ob.motion_theater
    item = motion.packed.get(entry.packed_key)
    if item is None:
        raise UserError(f"“{entry.name}” is not packed")
    data = _unpacked(item.data)
    target = Path(path)
    try:
        if target.is_file() and target.read_bytes() != data:
            raise UserError(f"{target.name} is there already with other content: choose another folder")
        target.write_bytes(data)
    except OSError as error:
        raise UserError(f"{target.name} cannot be written: {error.strerror or error}") from error
    from . import stack  # `stack` is built on this module

    key = entry.packed_key
    with stack.quietly():
        entry.source = str(target)
        entry.packed_key = ""
    _existence.clear()
    if not any(other.packed_key == key for other in motion.entries):
        motion.packed.remove(motion.packed.find(key))


def relink(ob: Object, entry: MotionEntry, path: str) -> None:
    """Let a track come from another file, and rebuild; on an error the old source stays."""
    from . import stack  # `stack` is built on this module

    before = (entry.source, entry.packed_key)
    with stack.quietly():
        entry.source, entry.packed_key = full_path(path), ""
    _existence.clear()
    try:
        stack.rebuild(ob)
    except UserError:
        with stack.quietly():
            entry.source, entry.packed_key = before
        raise
