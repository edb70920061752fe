"""Marker sets: recorded points as one armature, a bone for each marker.

A bone is what an animator can select, see by its name, and attach things to. Its location curves hold the recording;
where a marker dropped out it has no keys, and its scale is zero.
"""

from .importing import import_markers
from .properties import is_set, set_of

__all__ = ["import_markers", "is_set", "set_of"]
