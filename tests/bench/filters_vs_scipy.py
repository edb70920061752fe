"""The filters against scipy's, in one run: ratios of medians.

    python tests/bench/filters_vs_scipy.py

scipy works on one thread and gets the same array; both allocate their result. Before anything is timed the interiors
are compared: windows at the ends shrink here, while scipy continues the signal. Ratios above 1: faster than scipy.
"""

from __future__ import annotations

import time
from collections.abc import Callable
from statistics import median
from typing import Literal

import motion_theater
import numpy as np
from numpy.typing import NDArray
from scipy import ndimage

Floats = NDArray[np.float64]
Kind = Literal["MEDIAN", "AVERAGE", "WEIGHTED"]

SHAPES = ((1, 24_000), (90, 267), (1, 27_000_000), (3000, 9000))
DEPTHS = (3, 5, 7)
TARGETS: dict[Kind, float] = {"MEDIAN": 8.0, "AVERAGE": 1.5, "WEIGHTED": 2.0}
SCIPY_NAMES: dict[Kind, str] = {"MEDIAN": "median_filter", "AVERAGE": "uniform_filter1d", "WEIGHTED": "convolve1d"}

LEAST_RUNS = 7
SECONDS_PER_CASE = 0.2
TOLERANCE = 1e-12


def pascal_row(entries: int) -> Floats:
    """The row of Pascal's triangle with that many entries, over its sum."""
    row = np.ones(1)
    while len(row) < entries:
        row = np.convolve(row, (0.5, 0.5))
    return row


def scipy_filter(kind: Kind, depth: int) -> Callable[[Floats], Floats]:
    """The function of scipy that equals ours on the interior."""
    if kind == "MEDIAN":
        return lambda values: ndimage.median_filter(values, size=(1, depth))
    if kind == "AVERAGE":
        return lambda values: ndimage.uniform_filter1d(values, depth, axis=1)
    weights = pascal_row(depth)
    return lambda values: ndimage.convolve1d(values, weights, axis=1)


def median_seconds(first: Callable[[], object], second: Callable[[], object]) -> tuple[float, float]:
    """Median durations of both, run by turns so that other load on the machine meets both alike."""
    durations: tuple[list[float], list[float]] = ([], [])
    deadline = time.perf_counter() + SECONDS_PER_CASE
    while len(durations[0]) < LEAST_RUNS or time.perf_counter() < deadline:
        for run, seconds in zip((first, second), durations, strict=True):
            start = time.perf_counter()
            run()
            seconds.append(time.perf_counter() - start)
    return median(durations[0]), median(durations[1])


def main() -> None:
    """Print one line per kind, depth and shape."""
    rng = np.random.default_rng(2004)
    print(f"{'filter':10} {'depth':>5} {'channels x frames':>18} {'ours ms':>10} {'scipy ms':>10} {'ratio':>7} {'target':>7}")
    for shape in SHAPES:
        values = np.sin(np.arange(shape[1]) * 0.01) + 0.1 * rng.standard_normal(shape)
        for kind, target in TARGETS.items():
            for depth in DEPTHS:
                theirs = scipy_filter(kind, depth)
                inside = np.s_[:, depth // 2 : -(depth // 2)]
                difference = motion_theater.filter_values(values, kind=kind, depth=depth)[inside] - theirs(values)[inside]
                largest = float(np.abs(difference).max())
                if largest > TOLERANCE:
                    raise SystemExit(f"{kind} {depth} differs from {SCIPY_NAMES[kind]} by {largest:.3g}")
                ours_s, theirs_s = median_seconds(
                    lambda values=values, kind=kind, depth=depth: motion_theater.filter_values(
                        values, kind=kind, depth=depth
                    ),
                    lambda values=values, theirs=theirs: theirs(values),
                )
                print(
                    f"{kind:10} {depth:5} {shape[0]:>6} x {shape[1]:>9} {ours_s * 1e3:10.4f} {theirs_s * 1e3:10.4f}"
                    f" {theirs_s / ours_s:7.1f} {target:7.1f}"
                )


if __name__ == "__main__":
    main()
