"""The clips by name: how each is made, how long it is, and where its recording went wrong."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from .gait import walk
from .jump import step_and_jump
from .kinematics import Dofs
from .noise import Spike, recorded
from .rotations import Floats
from .turn import turn
from .wave import wave

RATE_HZ = 60.0


@dataclass(frozen=True)
class Clip:
    """One clip: `make` gives the clean motion at the times of its frames."""

    make: Callable[[Floats], Dofs]
    frames: int
    about: str
    spikes: tuple[Spike, ...]

    @property
    def times(self) -> Floats:
        """The seconds of its frames, from 0."""
        return np.arange(self.frames) / RATE_HZ


CLIPS: dict[str, Clip] = {
    "step_and_jump": Clip(
        step_and_jump,
        113,
        "a step forward with each foot, then a jump from both",
        (
            Spike(21, "lradius", "rx", 16.0),
            Spike(38, "rhumerus", "rz", -12.0),
            Spike(59, "rradius", "rx", 20.0),
            Spike(80, "lhumerus", "rz", -9.0),
            Spike(83, "rhand", "rx", -22.0),
            Spike(95, "lwrist", "ry", 18.0),
            Spike(101, "rradius", "rx", 25.0),
        ),
    ),
    "wave": Clip(
        wave,
        120,
        "the right hand waves, the rest of the body stands",
        (
            Spike(17, "lhumerus", "rz", 11.0),
            Spike(33, "rradius", "rx", -18.0),
            Spike(46, "rhand", "rz", 24.0),
            Spike(71, "lradius", "rx", 13.0),
            Spike(90, "rhumerus", "rx", 15.0),
        ),
    ),
    "walk": Clip(
        walk,
        612,
        "10.2 s of walking straight ahead at 1.3 m/s",
        (
            Spike(44, "lhumerus", "rx", 15.0),
            Spike(131, "rradius", "rx", 21.0),
            Spike(190, "lhand", "rx", -25.0),
            Spike(277, "rwrist", "ry", 17.0),
            Spike(352, "rhumerus", "rz", -10.0),
            Spike(433, "lradius", "rx", 12.0),
            Spike(509, "ltibia", "rx", 8.0),
            Spike(580, "rhumerus", "ry", 13.0),
        ),
    ),
    "turn": Clip(
        turn,
        210,
        "a turn on the spot by 180 degrees to the left, in eight steps",
        (
            Spike(36, "rhumerus", "rx", -14.0),
            Spike(88, "lradius", "rx", 19.0),
            Spike(117, "lhumerus", "rz", 12.0),
            Spike(151, "rhand", "rz", 20.0),
            Spike(184, "rradius", "rx", -9.0),
        ),
    ),
}


def clean_clip(name: str) -> Dofs:
    """The motion as planned, without noise and spikes."""
    clip = CLIPS[name]
    return clip.make(clip.times)


def recorded_clip(name: str) -> Dofs:
    """The motion as the file holds it, before its numbers are rounded."""
    return recorded(name, clean_clip(name), CLIPS[name].spikes)
