"""Files inside the .blend: tracks that no longer need their files on disk."""

from __future__ import annotations

import base64
import hashlib
import zlib
from pathlib import Path
from typing import TYPE_CHECKING

import motion_theater

from ..logic.messages import UserError, base_name
from .files import Loaded, read_file, read_once
from .paths import absolute

if TYPE_CHECKING:
    from bpy.types import Object

    from ..properties import MotionEntry, MotionStack, PackedSource


def load(ob: Object, entry: MotionEntry) -> Loaded:
    """Return the clip of a track, from inside the .blend if it is packed there, else from its file."""
    if entry.packed_key:
        return _load_packed(ob.motion_theater, entry.packed_key)
    if not entry.source:
        raise UserError(f"“{entry.name}” has no source: relink it")
    return read_file(absolute(ob, entry.source))


def _load_packed(motion: MotionStack, key: str) -> Loaded:
    packed = motion.packed.get(key)
    if packed is None:
        raise UserError("A packed source is missing in the .blend: relink the track")
    try:
        return read_once(("packed", key), lambda: _unpacked(packed), packed.filename)
    except motion_theater.MotionTheaterError as error:
        raise _damaged(packed, error) from error


def _unpacked(packed: PackedSource) -> bytes:
    try:
        return zlib.decompress(base64.b64decode(packed.data, validate=True))
    except (ValueError, zlib.error) as error:
        raise _damaged(packed, error) from error


def _damaged(packed: PackedSource, error: Exception) -> UserError:
    return UserError(f"The packed source {packed.filename} is damaged: {error}")


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


def write_out(ob: Object, entry: MotionEntry, path: str) -> None:
    """Write the packed file of a track to disk; never over another file in that place."""
    item = ob.motion_theater.packed.get(entry.packed_key)
    if item is None:
        raise UserError(f"“{entry.name}” is not packed")
    data = _unpacked(item)
    target = Path(path)
    try:
        if target.is_file() and target.read_bytes() != data:
            raise UserError(f"{target.name} is there already with other content: choose another folder")
        target.write_bytes(data)
    except OSError as error:
        raise UserError(f"{target.name} cannot be written: {error.strerror or error}") from error


def drop_unused(motion: MotionStack, key: str) -> None:
    """Remove a packed file that no track comes from any more."""
    if not any(entry.packed_key == key for entry in motion.entries):
        motion.packed.remove(motion.packed.find(key))
