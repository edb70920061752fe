"""Files read: clips, their skeletons as text, and motions bound to them. What was read is kept for the session."""

from __future__ import annotations

import hashlib
from collections.abc import Callable, Hashable
from dataclasses import dataclass
from pathlib import Path

import motion_theater

from ..logic.messages import UserError, base_name
from .cache import Cache


@dataclass(frozen=True)
class Loaded:
    """A file that was read, and what tells its content from any other's."""

    clip: motion_theater.Clip
    key: Hashable


_clips: Cache[Loaded] = Cache(64)
_skeletons: Cache[motion_theater.Skeleton] = Cache(32)
_texts: Cache[str] = Cache(32)
_bound: Cache[motion_theater.Motion] = Cache(16)


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


def read_once(key: Hashable, data: Callable[[], bytes], name: str) -> Loaded:
    """Return the clip that bytes hold, which are asked for only if nothing is kept under the key.

    Errors are those of the reader and of what gives the bytes.
    """
    return _clips.get(key) or _clips.keep(key, Loaded(motion_theater.read_bytes(data(), name=name), key))


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


def as_skeleton(loaded: Loaded) -> motion_theater.Skeleton:
    """Return the skeleton of a file that should hold one."""
    if loaded.clip.skeleton is None:
        raise UserError(f"{base_name(loaded.clip.path)} holds no skeleton: choose an .asf or .bvh file")
    return loaded.clip.skeleton


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
