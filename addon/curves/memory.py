"""Keys seen in Blender's own memory.

`foreach_get` takes about 20 ns for each key; an edit of a long take reads all keys of a character to notice what was
edited by hand, and that would cost as much as writing them. Blender keeps the keys of an F-curve in one array, and
`as_pointer` says where each key lies: a strided view of that array is read at the speed of memory.

How a key is laid out is nobody's promise, so nothing is assumed: the first, the middle and the last key are compared
with what Blender itself says of them, and where anything differs there is no view.
"""

from __future__ import annotations

import ctypes
from typing import TYPE_CHECKING, Any

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import NDArray

FEWEST_KEYS = 64
"""Below this, asking Blender is as fast."""
_HANDLE = 12  # bytes: a key is its left handle, itself and its right handle, three float32 each
_SMALLEST_KEY = 3 * _HANDLE


def coordinates(points: Any) -> NDArray[np.float32] | None:
    """Return frame and value of all keys by turns, copied; None where the keys cannot be seen."""
    count = len(points)
    if count < FEWEST_KEYS:
        return None
    probes = (0, count // 2, count - 1)
    start = points[0].as_pointer()
    stride = points[1].as_pointer() - start
    if stride < _SMALLEST_KEY or any(points[at].as_pointer() != start + at * stride for at in probes):
        return None
    keys = (ctypes.c_char * (count * stride)).from_address(start)
    # Two float32 seen as one complex number: numpy copies a column of single items four times as fast as rows of two.
    view: NDArray[np.complex64] = np.ndarray(count, np.complex64, keys, _HANDLE, (stride,))
    copied = view.copy().view(np.float32)
    if any(tuple(copied[2 * at : 2 * at + 2]) != tuple(points[at].co) for at in probes):
        return None
    return copied
