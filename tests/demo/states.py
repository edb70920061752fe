"""What the demo shows: one motion per state of the tutorial, and what its timeline says."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from .camera import Colour, Floats

HANDS = ("lfingers", "rfingers")
FEET = ("ltoes", "rtoes")


GRAVITY = 9.81


@dataclass(frozen=True)
class Span:
    """A stretch of a timeline, in frames; `blend` is the crossfade over its start, from one frame to another."""

    label: str
    start: int
    end: int
    blend: tuple[int, int] | None = None


@dataclass(frozen=True)
class Row:
    """One line of a timeline: which bones, and what moves them when."""

    label: str
    spans: tuple[Span, ...]


@dataclass(frozen=True)
class State:
    """The animation after a step of the tutorial. Positions are metres, Z up; arrays (frames, bones, 3)."""

    title: str
    caption: str
    names: Sequence[str]
    parents: Sequence[int]
    heads: Floats
    tails: Floats
    highlighted: frozenset[str]
    """Bones that this step changed: they are drawn in `tint`."""
    tint: Colour
    rows: tuple[Row, ...] = ()
    shows_before: bool = False
    """Draw the trails of the state before as well, so that one sees what became of them."""

    @property
    def frames(self) -> int:
        """How many frames it has."""
        return len(self.heads)

    def trail(self, bone: str) -> Floats:
        """Where the bone's tip goes (frames, 3)."""
        return self.tails[:, list(self.names).index(bone)]


def hand_accelerations(state: State, rate_hz: float) -> Floats:
    """The acceleration of each hand per frame (hands, frames), in g: noise and spikes stand out in it."""
    hands = np.stack([state.trail(bone) for bone in HANDS])
    second = np.linalg.norm(np.diff(hands, 2, axis=1), axis=-1) * rate_hz**2 / GRAVITY
    return np.pad(second, ((0, 0), (1, 1)), mode="edge")
