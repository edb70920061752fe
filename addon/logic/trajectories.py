"""Trajectories of markers as arrays: turned upright, placed on the timeline, with their gaps."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from . import axes

Floats = NDArray[np.floating[Any]]
Flags = NDArray[np.bool_]

SAME_SAMPLE = 1e-6  # samples from a whole frame to its nearest sample that count as none


def from_axes(up: str, forward: str = axes.AS_IN_FILE) -> tuple[tuple[int, float], ...]:
    """Return from which of the file's axes Blender's X, Y and Z are taken, with their signs.

    These are the turns that skeletons get too; only moving numbers about, they cost no digit.
    """
    turned = axes.rotate(axes.to_blender(up, forward), np.eye(3))
    sources = np.abs(turned).argmax(axis=0)
    return tuple((int(axis), float(np.sign(turned[axis, component]))) for component, axis in enumerate(sources))


@dataclass(frozen=True)
class Sampling:
    """Which samples of a file make which keys."""

    frames: NDArray[np.float64]
    """Scene frames on which keys are set."""
    before: NDArray[np.intp] | None
    """For each key the sample before it, or None where key and sample are the same thing."""
    share: NDArray[np.float64] | None
    """How far each key is on the way to the next sample; 0 on a sample."""

    def seen(self, valid: Flags) -> Flags:
        """Return on which keys a marker is seen: between two samples only if it was seen on both."""
        if self.before is None or self.share is None:
            return valid
        after = np.minimum(self.before + 1, len(valid) - 1)
        both: Flags = valid[self.before] & ((self.share == 0.0) | valid[after])
        return both

    def values(self, samples: Floats) -> Floats:
        """Return one coordinate on all keys, on the straight way between samples; nothing sensible where not seen."""
        if self.before is None or self.share is None:
            return samples
        first = samples[self.before].astype(np.float64)
        step = samples[np.minimum(self.before + 1, len(samples) - 1)] - first
        on_way: Floats = np.where(self.share == 0.0, first, first + step * self.share)
        return on_way


def sampling(*, samples: int, first: float, step: float, on_whole_frames: bool) -> Sampling:
    """Return where the keys of a file lie whose samples are `step` scene frames apart, the first one on `first`.

    Keys on whole frames lie within the recording; a recording that is shorter than a frame has its first sample.
    """
    if not on_whole_frames or (step == 1.0 and first == int(first)):
        return Sampling(first + np.arange(samples, dtype=np.float64) * step, None, None)
    last = first + (samples - 1) * step
    frames = np.arange(np.ceil(first - SAME_SAMPLE * step), np.floor(last + SAME_SAMPLE * step) + 1.0) + 0.0  # no -0
    if not len(frames):
        return Sampling(np.array([np.floor(first + 0.5)]), np.zeros(1, np.intp), np.zeros(1))
    at = np.clip((frames - first) / step, 0.0, samples - 1.0)
    nearest = np.round(at)
    at = np.where(np.abs(at - nearest) <= SAME_SAMPLE * np.maximum(1.0, nearest), nearest, at)
    before = np.floor(at)
    return Sampling(frames, before.astype(np.intp), at - before)


def without_holes(frames: NDArray[np.float64], step: float) -> NDArray[np.float64]:
    """Return ascending frames with those that are missing between them, where they usually are `step` apart."""
    missing = np.round(np.diff(frames) / step).astype(np.intp) - 1
    holes = np.flatnonzero(missing > 0)
    if not len(holes):
        return frames
    filled = [frames[hole] + step * np.arange(1, missing[hole] + 1) for hole in holes]
    return np.sort(np.concatenate([frames, *filled]))


def snapped(frames: NDArray[np.float64], samples: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return frames with the exact one of a sample (ascending) where that is meant: keys have 32 bits."""
    if not len(samples):
        return frames
    right = np.clip(np.searchsorted(samples, frames), 0, len(samples) - 1)
    left = np.maximum(right - 1, 0)
    nearest = np.where(np.abs(samples[left] - frames) < np.abs(samples[right] - frames), samples[left], samples[right])
    meant = np.abs(nearest - frames) <= 2.0 * np.spacing(np.abs(frames).astype(np.float32)) + SAME_SAMPLE
    return np.where(meant, nearest, frames)


def around(
    frames: NDArray[np.float64], samples: NDArray[np.float64]
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Return the samples before and after each frame, which are one where it lies on a sample, or beyond all."""
    if not len(samples):
        return frames, frames
    last = len(samples) - 1
    before = np.clip(np.searchsorted(samples, frames, "right") - 1, 0, last)
    return samples[before], samples[np.clip(np.searchsorted(samples, frames, "left"), 0, last)]


def as_in_file(positions: NDArray[np.float64], up: str, forward: str = axes.AS_IN_FILE) -> NDArray[np.float64]:
    """Return (..., 3) positions of Blender in the axes of a file that was imported with these."""
    turned = np.empty_like(positions)
    for component, (axis, sign) in enumerate(from_axes(up, forward)):
        turned[..., axis] = positions[..., component] * sign
    return turned


def changes(seen: Flags) -> NDArray[np.intp]:
    """Return the keys on which a marker comes into sight or drops out, after the first key."""
    return np.flatnonzero(seen[1:] != seen[:-1]) + 1


def gaps(seen: Flags) -> int:
    """Return how many gaps a marker has between two samples."""
    at = np.flatnonzero(seen)
    return int(np.count_nonzero(np.diff(at) > 1)) if len(at) else 0


def fullest(valid: Flags) -> int:
    """Return the first frame of (markers, frames) on which the most markers are seen."""
    return int(np.argmax(np.count_nonzero(valid, axis=0)))


def rest_places(positions: Floats, valid: Flags) -> NDArray[np.float64]:
    """Return (markers, 3): where each marker is on the frame on which the most are seen, or when it is first seen.

    A marker that is never seen is at the origin.
    """
    frame = fullest(valid)
    first = np.argmax(valid, axis=1)
    chosen = np.where(valid[:, frame], frame, first)
    places = positions[np.arange(len(positions)), chosen].astype(np.float64)
    places[~valid.any(axis=1)] = 0.0
    return places
