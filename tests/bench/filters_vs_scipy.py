"""The filters against scipy's, in one run: ratios of medians.

scipy works on one thread and gets the same array; both allocate their result. Before anything is timed the interiors
are compared: windows at the ends shrink here, while scipy continues the signal. Ratios above 1: faster than scipy.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator

import numpy as np
from scipy import ndimage

import motion_theater as mt
from tests.bench.timing import Row, medians_s, ms

SHAPES = ((1, 24_000), (90, 267), (1, 27_000_000), (3000, 9000))
DEPTHS = (3, 5, 7)
TARGETS: dict[mt.FilterKind, float] = {"MEDIAN": 8.0, "AVERAGE": 1.5, "WEIGHTED": 2.0}
SCIPY_NAMES: dict[mt.FilterKind, str] = {
    "MEDIAN": "median_filter",
    "AVERAGE": "uniform_filter1d",
    "WEIGHTED": "convolve1d",
}
TOLERANCE = 1e-12


def pascal_row(entries: int) -> mt.Floats:
    """The row of Pascal's triangle with that many entries, over its sum."""
    row = np.ones(1)
    while len(row) < entries:
        row = np.convolve(row, (0.5, 0.5))
    return row


def scipy_filter(kind: mt.FilterKind, depth: int) -> Callable[[mt.Floats], mt.Floats]:
    """The function of scipy that equals ours on the interior."""
    if kind == "MEDIAN":
        return lambda values: ndimage.median_filter(values, size=(1, depth))
    if kind == "AVERAGE":
        return lambda values: ndimage.uniform_filter1d(values, depth, axis=1)
    weights = pascal_row(depth)
    return lambda values: ndimage.convolve1d(values, weights, axis=1)


def measure() -> Iterator[Row]:
    """Yield one row per shape, kind and depth."""
    rng = np.random.default_rng(2004)
    for channels, frames in SHAPES:
        values = np.sin(np.arange(frames) * 0.01) + 0.1 * rng.standard_normal((channels, frames))
        for kind, target in TARGETS.items():
            for depth in DEPTHS:
                yield _compare(values, kind, depth, target)


def _compare(values: mt.Floats, kind: mt.FilterKind, depth: int, target: float) -> Row:
    def ours() -> mt.Floats:
        return mt.filter_values(values, kind=kind, depth=depth)

    def theirs() -> mt.Floats:
        return filtered(values)

    filtered = scipy_filter(kind, depth)
    inside = np.s_[:, depth // 2 : -(depth // 2)]
    largest = float(np.abs(ours()[inside] - theirs()[inside]).max())
    if largest > TOLERANCE:
        raise SystemExit(f"{kind} {depth} differs from {SCIPY_NAMES[kind]} by {largest:.3g}")
    ours_s, theirs_s = medians_s(ours, theirs)
    channels, frames = values.shape
    what = f"{kind.capitalize()} {depth}, {channels} x {frames:,} values, against {SCIPY_NAMES[kind]}"
    return Row(what, theirs_s / ours_s, target, detail=f"{ms(ours_s)}, {ms(theirs_s)}")
