"""Skeleton -> armature, and armature -> what the native module needs to know of it."""

from __future__ import annotations

from .bones import bones_of_collection, selected_bones, writable_reason
from .build import build_armature
from .rest import Rest, axes_from_file, file_frame, native_rig, read_rest, scale_from_rest

__all__ = [
    "Rest",
    "axes_from_file",
    "bones_of_collection",
    "build_armature",
    "file_frame",
    "native_rig",
    "read_rest",
    "scale_from_rest",
    "selected_bones",
    "writable_reason",
]
