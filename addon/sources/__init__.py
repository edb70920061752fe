"""Where motion comes from: files, packed files, and the skeletons that they need.

Reading a file and bringing it into an armature's rest axes are done once and kept for the session, keyed by what the
file is, so that dragging a number in the stack only evaluates. Nothing of Blender's is kept, only the native module's
own objects.
"""

from __future__ import annotations

from .files import Loaded, as_skeleton, bind, has_own_skeleton, read_file, skeleton_from_text, text_of
from .packing import drop_unused, load, pack, write_out
from .pairing import Pairing, find_skeleton
from .paths import absolute, full_path, is_missing, look_again
from .tracks import matched_bones, missing_bones, rest_motion

__all__ = [
    "Loaded",
    "Pairing",
    "absolute",
    "as_skeleton",
    "bind",
    "drop_unused",
    "find_skeleton",
    "full_path",
    "has_own_skeleton",
    "is_missing",
    "load",
    "look_again",
    "matched_bones",
    "missing_bones",
    "pack",
    "read_file",
    "rest_motion",
    "skeleton_from_text",
    "text_of",
    "write_out",
]
